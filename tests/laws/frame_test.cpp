// Frames: the camera's angle of view is the full one, of the axis that it is given for; pixels are square whatever
// the picture's proportions are (formulas 2.5, 2.6 of the course work); and a mirror's outline is not turned round.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace zerkalo::laws {
namespace {

/// Half the picture's width and height at distance 1, as the plan's camera has them.
struct Halves {
    double width, height;
};

Halves halves_of(FovAxis axis, double fov, int width, int height) {
    Scene scene;
    scene.camera = camera_at({0, 0, 0}, {0, 0, -1}, fov);
    scene.camera.fov_axis = axis;
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(scene, of_size(width, height), *plan);
    const auto length_of = [](const Vec3<float>& v) { return std::hypot(double(v.x), double(v.y), double(v.z)); };
    return {length_of(plan->camera.step_x) * width, length_of(plan->camera.step_y) * height};
}

TEST(AngleOfView, IsTheGivenOneOnItsAxisAndPixelsAreSquare) {
    constexpr double kRounding = 2e-7;  // steps are floats
    for (const double fov : {0.01, 0.7, 1.5, 3.0}) {
        const double half = std::tan(fov / 2);
        for (const auto& [width, height] : {std::pair{640, 480}, std::pair{480, 640}, std::pair{1000, 10}}) {
            const Halves across = halves_of(FovAxis::horizontal, fov, width, height);
            EXPECT_NEAR(across.width / half, 1, kRounding) << fov << ", " << width << "x" << height;
            EXPECT_NEAR(across.height / half * width / height, 1, kRounding) << fov << ", " << width << "x" << height;
            const Halves upwards = halves_of(FovAxis::vertical, fov, width, height);
            EXPECT_NEAR(upwards.height / half, 1, kRounding) << fov << ", " << width << "x" << height;
            EXPECT_NEAR(upwards.width / half * height / width, 1, kRounding) << fov << ", " << width << "x" << height;
        }
    }
}

// Outlines are given with x along right = up x n and y along n x right.
TEST(MirrorFrame, HasItsXAlongUpCrossNormal) {
    Scene scene;
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 2);
    mirror.ambient = 1;
    mirror.boundary.shape = BoundaryShape::polygon;
    mirror.boundary.corner_count = 3;
    mirror.boundary.corners[0] = {0, 0};
    mirror.boundary.corners[1] = {2, 0};
    mirror.boundary.corners[2] = {2, 1};
    add(scene, mirror);
    const auto seen = [&](double x, double y) { return look(scene, {x, y, 5}, {0, 0, -1}).g == 1; };
    EXPECT_TRUE(seen(1.5, 0.25));
    EXPECT_FALSE(seen(-1.5, 0.25));
    EXPECT_FALSE(seen(1.5, -0.25));
    EXPECT_FALSE(seen(0.5, 0.5));
}

}  // namespace
}  // namespace zerkalo::laws
