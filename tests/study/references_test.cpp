// References: what is measured against, how far two of them are apart, and what a folder keeps of them.
#include "tools/study/references.hpp"
#include "tests/platform/scratch_folder.hpp"
#include "tools/study/error_figures.hpp"

#include <gtest/gtest.h>

namespace zerkalo::study {
namespace {

Scene staged() {
    Scene scene;
    scene.camera.position = {0.5, 0.5, 3};
    scene.light_count = scene.mirror_count = scene.solid_count = 1;
    scene.lights[0].position = {3, 3, 3};
    scene.mirrors[0].position = {0, 0, -1};
    scene.mirrors[0].boundary.width = scene.mirrors[0].boundary.height = 4;
    scene.mirrors[0].lobe_exponent = 200;
    scene.solids[0].radius = 0.5;
    return scene;
}

constexpr ImageSize kSize{48, 36};
const Renderer kRenderer{best_isa(), 1, nullptr};

double zone_of(const References& references) { return references.zone[static_cast<std::size_t>(Region::mirror)]; }

TEST(StudyReferences, TheirMeanAndTheirDistance) {
    const LightPicture a{1, 1, {0.2, 0.2, 0.2}}, b{1, 1, {0.4, 0.2, 0.0}};
    Regions regions;
    for (Mask& mask : regions) mask.assign(1, true);
    const References references = references_of(a, b, regions);
    EXPECT_DOUBLE_EQ(references.mean.rgb[0], 0.3);
    EXPECT_DOUBLE_EQ(references.mean.rgb[2], 0.1);
    EXPECT_DOUBLE_EQ(zone_of(references), rmse_of(a, b, regions[0]));
}

TEST(StudyReferences, MoreSamplesBringThemTogether) {
    const ScratchFolder folder;
    const Regions regions = regions_of(kRenderer, staged(), kSize);
    const auto zone = [&](std::int32_t samples) {
        return zone_of(
            references_of(kRenderer, staged(), kSize, {samples, 1}, regions, folder / ".", std::to_string(samples)));
    };
    const double rough = zone(64), fine = zone(1024), finest = zone(16 * 1024);
    EXPECT_GT(rough, 0);
    EXPECT_LT(fine, rough / 3);
    EXPECT_LT(finest, fine / 2);
}

TEST(StudyReferences, TheFolderKeepsThem) {
    const ScratchFolder folder;
    const Regions regions = regions_of(kRenderer, staged(), kSize);
    const ReferenceEffort effort{256, 1};
    const References made = references_of(kRenderer, staged(), kSize, effort, regions, folder / ".", "s");
    // Another scene would give another picture: only the files can give this one.
    Scene other = staged();
    other.background = {1, 1, 1};
    const References kept = references_of(kRenderer, other, kSize, effort, regions, folder / ".", "s");
    EXPECT_EQ(kept.mean.rgb, made.mean.rgb);
    const References fresh = references_of(kRenderer, other, kSize, effort, regions, folder / ".", "other");
    EXPECT_NE(fresh.mean.rgb, made.mean.rgb);
}

}  // namespace
}  // namespace zerkalo::study
