// Left and right: rounding is symmetric in sign, so a scene and its mirror image in x = 0 give the same bits.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

/// x -> -x. Turns about y and z change their sense; every solid is its own mirror image in its local x, prisms and
/// pyramids where the number of their sides is even.
Scene other_way_round(Scene scene) {
    scene.camera.position.x = -scene.camera.position.x;
    scene.camera.view.x = -scene.camera.view.x;
    for (int j = 0; j < scene.light_count; ++j) scene.lights[j].position.x = -scene.lights[j].position.x;
    for (int k = 0; k < scene.solid_count; ++k) {
        Solid& solid = scene.solids[k];
        solid.position.x = -solid.position.x;
        solid.rotation.y = -solid.rotation.y;
        solid.rotation.z = -solid.rotation.z;
    }
    for (int m = 0; m < scene.mirror_count; ++m) {
        scene.mirrors[m].position.x = -scene.mirrors[m].position.x;
        scene.mirrors[m].normal.x = -scene.mirrors[m].normal.x;
    }
    return scene;
}

Scene lopsided_scene(double curvature_radius) {
    Scene scene = five_solids_before_mirror_aslant(curvature_radius);
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].sides = 4 + 2 * (k % 2);
    return scene;
}

TEST(P21, TheMirroredSceneGivesTheFlippedPicture) {
    for (const double curvature_radius : {kInfinity, 9.0, -9.0}) {
        const Scene scene = lopsided_scene(curvature_radius);
        const Image image = render(scene, of_size(65, 48));
        const Image other = render(other_way_round(scene), of_size(65, 48));
        EXPECT_EQ(pixels_apart(flipped(image), other), 0) << "curvature radius " << curvature_radius;
        EXPECT_GT(pixels_apart(image, other), 300) << "curvature radius " << curvature_radius;
        const Image in_double = render_double(scene, of_size(65, 48));
        EXPECT_EQ(pixels_apart(flipped(in_double), render_double(other_way_round(scene), of_size(65, 48))), 0)
            << "in double, curvature radius " << curvature_radius;
    }
}

TEST(P21, ASymmetricSceneGivesASymmetricPicture) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add(scene, ball({0, 1, 0}, 0.5, Material{}));
    for (const double side : {-1.0, 1.0}) {
        Solid cone = ball({1.25 * side, 0.5, 0.5}, 0.5, Material{});
        cone.kind = SolidKind::cone;
        cone.taper = 0.25;
        cone.rotation = {0.5, 0, -0.25 * side};
        add(scene, cone);
    }
    // One lamp, in the plane of symmetry: two would change places, and their sum its order.
    add(scene, lamp({0, 4, 3}));
    add(scene, ideal_mirror({0, 1, -1}, {0, 0, 1}, 4));
    scene.camera = camera_at({0, 2, 6}, {0, -0.125, -1}, 0.8);
    for (const int width : {64, 65}) {
        const Image image = render(scene, of_size(width, 48));
        EXPECT_EQ(pixels_apart(image, flipped(image)), 0) << "width " << width;
    }
}

}  // namespace
}  // namespace zerkalo::laws
