// The scenes of `zerkalo bench` keep the kernel that they are named after busy in every pixel.
#include "tools/zerkalo/bench_scenes.hpp"
#include "tests/support/reference.hpp"

#include <gtest/gtest.h>

namespace zerkalo {
namespace {

// Pixels in which a camera ray misses everything, at the centres of all of them.
int misses(Scene scene) {
    constexpr double kMark = 9;  // brighter than anything that these scenes can give
    scene.background = {kMark, kMark, kMark};
    Settings settings;
    settings.depth_limit = 0;
    int count = 0;
    for (int y = 0; y < scene.image.height; ++y) {
        for (int x = 0; x < scene.image.width; ++x) {
            count += reference_pixel(scene, settings, x, y, 1, 1).r == kMark;
        }
    }
    return count;
}

TEST(BenchScenes, EverySolidCoversTheWholeView) {
    for (const SolidKind kind : {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                                 SolidKind::cone, SolidKind::mesh}) {
        EXPECT_EQ(misses(*solid_scene(kind)), 0) << "kind " << static_cast<int>(kind);
    }
}

TEST(BenchScenes, TheMirrorCoversTheWholeView) {
    EXPECT_EQ(misses(*mirror_scene(200)), 0);
    EXPECT_EQ(misses(*mirror_scene(kInfinity)), 0);
}

TEST(BenchScenes, TheOrdinarySceneShowsBackgroundToo) {
    auto scene = ordinary_scene();
    scene->image = {64, 48};
    const int missed = misses(*scene), pixels = scene->image.width * scene->image.height;
    EXPECT_GT(missed, pixels / 10);
    EXPECT_LT(missed, pixels / 2);
}

}  // namespace
}  // namespace zerkalo
