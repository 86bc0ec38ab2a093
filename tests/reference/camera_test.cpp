// The camera: field of view, orientation of the picture, the fallback for `up`, and the solid angle of a sphere.
#include "tests/reference/scenes.hpp"

#include <gtest/gtest.h>

namespace zerkalo::reference {
namespace {

double angle_between(const Ray& a, const Ray& b) { return std::acos(dot(a.direction, b.direction)); }

TEST(ReferenceCamera, GivenAngleIsTheFullAngleAndTheOtherFollowsFromTheSize) {
    Camera camera;
    camera.fov = 0.9;
    const auto ray = [&](double x, double y) { return camera_ray(camera, 60, 40, x, y); };
    const auto across = [&] { return angle_between(ray(-0.5, 19.5), ray(59.5, 19.5)); };
    const auto upward = [&] { return angle_between(ray(29.5, -0.5), ray(29.5, 39.5)); };
    EXPECT_NEAR(across(), 0.9, 1e-12);
    EXPECT_NEAR(upward(), 2 * std::atan(std::tan(0.45) * 40 / 60), 1e-12);
    camera.fov_axis = FovAxis::vertical;
    EXPECT_NEAR(upward(), 0.9, 1e-12);
    EXPECT_NEAR(across(), 2 * std::atan(std::tan(0.45) * 60 / 40), 1e-12);
}

TEST(ReferenceCamera, PixelZeroIsTheTopLeftOne) {
    Camera camera;
    camera.view = {0, 0, -3};
    camera.up = {0, 0.1, 0.7};
    const Vector d = camera_ray(camera, 8, 8, 0, 0).direction;
    EXPECT_LT(d.x, 0);
    EXPECT_GT(d.y, 0);
    EXPECT_LT(d.z, 0);
}

TEST(ReferenceCamera, UpParallelToViewIsReplacedByTheAxisOfWhichTheViewHasLeast) {
    Camera camera;
    camera.view = {0, -2, 0};
    const Vector rightmost = camera_ray(camera, 9, 9, 8, 4).direction;
    const Vector topmost = camera_ray(camera, 9, 9, 4, 0).direction;
    EXPECT_GT(rightmost.z, 0.2);
    EXPECT_NEAR(rightmost.x, 0, 1e-15);
    EXPECT_GT(topmost.x, 0.2);
    camera.view = {0.1, 0.2, 0.3};
    camera.up = {-1, -2, -3};
    EXPECT_GT(camera_ray(camera, 9, 9, 4, 0).direction.x, camera_ray(camera, 9, 9, 4, 8).direction.x);
}

TEST(ReferenceCamera, SphereFillsItsSolidAngle) {
    constexpr int kSide = 700;
    constexpr double kRadius = 1.3, kDistance = 4;
    Scene scene;
    add(scene, ball({0.3, -0.2, -std::sqrt(kDistance * kDistance - 0.13)}, kRadius));
    scene.camera.fov = 1.2;
    const World world(scene);
    const double pixel = 2 * std::tan(0.6) / kSide;
    double solid_angle = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const Ray ray = camera_ray(scene.camera, kSide, kSide, x, y);
            if (world.first_hit(ray).kind == HitKind::solid)
                solid_angle += pixel * pixel * std::pow(-ray.direction.z, 3);
        }
    const double ratio = kRadius / kDistance;
    EXPECT_NEAR(solid_angle / (2 * kPi * (1 - std::sqrt(1 - ratio * ratio))), 1, 3e-4);
}

}  // namespace
}  // namespace zerkalo::reference
