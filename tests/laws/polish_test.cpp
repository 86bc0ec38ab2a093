// The polish of a mirror: 1 is the sharp mirror to the last bit, nearly 1 nearly.
#include "core/scene/edit.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

Scene before_a_mirror(double lobe_exponent) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 1);
    add(scene, lamp({-3, 5, 4}));
    Mirror mirror = ideal_mirror({0, 1, -1}, {0, 0, 1}, 4);
    mirror.lobe_exponent = lobe_exponent;
    add(scene, mirror);
    scene.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    return scene;
}

TEST(Polish, OfOneIsTheSharpMirrorExactly) {
    const Image sharp = render(before_a_mirror(kInfinity), of_size(64, 48));
    const Image polished = render(before_a_mirror(exponent_of_polish(1)), of_size(64, 48));
    EXPECT_EQ(pixels_apart(sharp, polished), 0);
    EXPECT_EQ(polished.rays.lobe, 0u);
    EXPECT_GT(polished.rays.reflected, 0u);
}

TEST(Polish, LobeOfExponentABillionIsNearlySharp) {
    // The lobe is 3e-5 rad wide: of the pixels only those on silhouettes and creases can tell.
    constexpr int kSilhouettePixels = 64 * 48 / 200;
    const reference::Picture sharp = picture_of(render(before_a_mirror(kInfinity), of_size(64, 48)));
    const reference::Picture nearly = picture_of(render(before_a_mirror(1e9), of_size(64, 48)));
    EXPECT_LE(reference::compare(nearly, sharp, 1).pixels_off_by_more, kSilhouettePixels);
    EXPECT_GT(reference::compare(nearly, sharp, 0).max, 0) << "it was rendered as a sharp mirror";
}

TEST(Polish, LessOfItBlursMore) {
    const Image sharp = render(before_a_mirror(kInfinity), of_size(64, 48));
    double before = 0;
    for (const double polish : {0.99, 0.9, 0.8, 0.6}) {
        Settings settings = of_size(64, 48);
        settings.samples = 256;
        const Image blurred = render(before_a_mirror(exponent_of_polish(polish)), settings);
        const double rmse = reference::compare(picture_of(blurred), picture_of(sharp), 0).rmse;
        EXPECT_GT(rmse, before) << "polish " << polish;
        before = rmse;
    }
}

}  // namespace
}  // namespace zerkalo::laws
