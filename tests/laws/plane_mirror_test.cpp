// A polished plane mirror is a window on the mirrored scene.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace zerkalo::laws {
namespace {

/// z -> -z. Turns about x and y change their sense; every solid is its own mirror image in its local z.
Solid behind_the_mirror(Solid solid) {
    solid.position.z = -solid.position.z;
    solid.rotation.x = -solid.rotation.x;
    solid.rotation.y = -solid.rotation.y;
    return solid;
}

/// Solids in front of z = 0 and their images behind it. A lamp in the plane itself lights both sides alike.
Scene solids_and_images() {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 1);
    for (int k = 0; k < 5; ++k) add(scene, behind_the_mirror(scene.solids[k]));
    add(scene, lamp({-12, 9, 0}));
    return scene;
}

// A far camera's rays start on the plane through the scene's centre at right angles to its view: here on the mirror
// itself, where reflected rays start as well, so that both travel the same way. To see solids and images side by side,
// that camera looks along -z from far to the right, and what it sees is a small part of a very wide picture.
constexpr double kFarCamera = 1000, kHalfAngle = 1;
constexpr int kWidth = kMaxImageSide, kHeight = 64;
constexpr int kPartWidth = 320;  // pixels, about 10 scene units

void look_from_far(Scene& scene) {
    // Centres the scene on z = 0; below the solids and seen edge-on.
    Mirror floor = ideal_mirror({0, -0.5, 0}, {0, -1, 0}, 16);
    floor.up = {0, 0, 1};
    add(scene, floor);
    scene.camera = camera_at({kFarCamera, 1, kFarCamera}, {0, 0, -1}, 2 * kHalfAngle);
}

/// The part of the wide picture around the point (0, 1, 0).
Image render_part(const Scene& scene) {
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(scene, of_size(kWidth, kHeight), *plan);
    // Not cleared: the system only lends the pages that are written.
    const std::unique_ptr<float[]> pixels(new float[std::size_t{3} * kWidth * kHeight]);
    const LinearImage whole{pixels.get(), kWidth, kHeight, std::ptrdiff_t{12} * kWidth};
    const int middle = static_cast<int>(kWidth / 2 * (1 - 1 / std::tan(kHalfAngle)));
    const int left = (middle - kPartWidth / 2) / kTileSide * kTileSide;
    Image part{kPartWidth, kHeight, {}, {}};
    for (int i = 0; i < tile_count(*plan); ++i) {
        const Rect tile = tile_at(*plan, i);
        if (tile.left < left || tile.left >= left + kPartWidth) continue;
        kernel_for(*plan, best_isa())(*plan, tile, whole, part.rays);
    }
    for (int y = 0; y < kHeight; ++y) {
        const float* row = whole.row(y) + std::ptrdiff_t{3} * left;
        part.rgb.insert(part.rgb.end(), row, row + std::ptrdiff_t{3} * kPartWidth);
    }
    return part;
}

TEST(P06, ImageIsTheMirroredSceneSeenThroughAWindowToTheLastBit) {
    Scene window = solids_and_images();
    look_from_far(window);
    Scene mirrored = window;
    add(mirrored, ideal_mirror({0, 1.25, 0}, {0, 0, 1}, 12));
    const Image seen_through = render_part(window), seen_in = render_part(mirrored);
    EXPECT_EQ(pixels_apart(seen_in, seen_through), 0);
    EXPECT_GT(seen_in.rays.reflected, 10000u);
    // The images behind the plane are in view: the law is not about an empty room.
    Scene without_images = window;
    without_images.solid_count = 5;
    EXPECT_GT(pixels_apart(render_part(without_images), seen_through), 1000);
}

TEST(P06, NearCameraSeesTheMirroredSceneToo) {
    // The window's rays were not rounded on their way: colours agree within a step but for silhouettes.
    constexpr double kSilhouetteShare = 1e-3;
    Scene window = solids_and_images();
    window.camera = camera_at({0.75, 2.25, 5}, {-0.125, -0.25, -1}, 0.8);
    Scene mirrored = window;
    mirrored.solid_count = 5;
    add(mirrored, ideal_mirror({0, 1.25, 0}, {0, 0, 1}, 100));
    const auto difference = reference::compare(picture_of(render(mirrored, of_size(160, 120))),
                                               picture_of(render(window, of_size(160, 120))), 1);
    EXPECT_LE(static_cast<double>(difference.pixels_off_by_more), kSilhouetteShare * difference.pixels);
}

TEST(P01, MirrorReflectsRaysAtTheAngleOfIncidence) {
    // A small glowing ball where the reflected ray must pass, and two radii beside it.
    constexpr double kRadius = 1e-4;
    for (const double slope : {0.1, 0.5, 1.0, 2.0, 5.0}) {
        Scene scene;
        add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 4));
        add(scene, ball({slope, 0, 1}, kRadius, glowing({1, 1, 1})));
        EXPECT_EQ(look(scene, {-slope, 0, 1}, {slope, 0, -1}).r, 1) << "slope " << slope;
        // Across the reflected ray, to both sides of it.
        for (const double side : {-1.0, 1.0}) {
            const double step = 2 * side * kRadius / std::hypot(slope, 1);
            scene.solids[0].position = {slope + step, 0, 1 - slope * step};
            EXPECT_EQ(look(scene, {-slope, 0, 1}, {slope, 0, -1}).r, 0) << "slope " << slope << ", side " << side;
        }
    }
}

}  // namespace
}  // namespace zerkalo::laws
