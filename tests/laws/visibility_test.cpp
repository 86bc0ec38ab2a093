// P27: a point is lit exactly where nothing stands between it and the lamp, asked of every pixel by brute force.
#include "tests/laws/staging.hpp"
#include "tests/support/reference_tracer.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// Solids of chalk and a mirror on a floor under one lamp: a pixel is black where the lamp is hidden, and only there.
Scene chalk_scene(const Vec3<double>& lamp_position) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add_five_solids(scene, 1);
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].material = chalk();
    add(scene, box({0, -0.5, 0}, 12, 0.5, chalk()));
    Mirror mirror = ideal_mirror({0.25, 1, -1}, {0.125, 0, 1}, 2);
    mirror.reflection = 0;
    mirror.diffuse = 1;
    add(scene, mirror);
    mirror.position = {2.5, 1, 2.5};
    mirror.normal = {-1, 0, -0.5};
    mirror.curvature_radius = 3;
    add(scene, mirror);
    add(scene, lamp(lamp_position));
    scene.camera = camera_at({1.2, 3.2, 8}, {-0.15, -0.3, -1}, 0.8);
    return scene;
}

enum class Answer { nothing_there, dark, lit, undecided };

/// By a ray to the lamp through everything; undecided where a hair's shift of ray or lamp changes the answer.
Answer by_brute_force(const reference::World& world, const Scene& scene, int x, int y) {
    constexpr double kShiftOfPixel = 1e-3, kShiftOfLamp = 1e-5;
    const Vec3<double>& lamp = scene.lights[0].position;
    Answer answer = Answer::undecided;
    for (int shift = 0; shift < 8; ++shift) {
        const double a = shift & 1 ? 1 : -1, b = shift & 2 ? 1 : -1, c = shift & 4 ? 1 : -1;
        const reference::Ray ray =
            reference::camera_ray(scene.camera, kWidth, kHeight, x + a * kShiftOfPixel, y + b * kShiftOfPixel);
        const reference::Hit hit = world.first_hit(ray);
        Answer now = Answer::nothing_there;
        if (hit.kind != reference::HitKind::none) {
            const reference::Vector light{lamp.x + a * kShiftOfLamp, lamp.y + b * kShiftOfLamp,
                                          lamp.z + c * kShiftOfLamp};
            const reference::Vector normal = hit.front ? hit.normal : -hit.normal;
            const bool faces = dot(normal, light - hit.point) > 0;
            now = faces && world.visible(hit, light) ? Answer::lit : Answer::dark;
        }
        if (shift > 0 && now != answer) return Answer::undecided;
        answer = now;
    }
    return answer;
}

TEST(P27, PixelIsLitWhereTheWayToTheLampIsFree) {
    for (const Vec3<double>& position : {Vec3<double>{-3, 5, 4}, {4, 1.5, 3}, {0.5, 6, -3}}) {
        const Scene scene = chalk_scene(position);
        const reference::World world(scene);
        const Image image = render(scene, of_size(kWidth, kHeight));
        int count[4] = {0, 0, 0, 0};
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const Answer answer = by_brute_force(world, scene, x, y);
                ++count[static_cast<int>(answer)];
                if (answer == Answer::undecided) continue;
                ASSERT_EQ(image.at(x, y).g > 0, answer == Answer::lit)
                    << "pixel " << x << ", " << y << ", lamp at " << position.x << ", " << position.y;
            }
        }
        EXPECT_LT(count[static_cast<int>(Answer::undecided)], kWidth * kHeight / 50);
        EXPECT_GT(count[static_cast<int>(Answer::dark)], kWidth * kHeight / 20);
        EXPECT_GT(count[static_cast<int>(Answer::lit)], kWidth * kHeight / 20);
    }
}

}  // namespace
}  // namespace zerkalo::laws
