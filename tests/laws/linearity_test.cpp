// Light adds up: the picture is linear in the lamps, the ambient light and the background.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

Scene lit_scene(double lobe_exponent) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    scene.ambient = {0.5, 0.75, 1};
    add_five_solids(scene, 1);
    scene.solids[0].material.reflection = 0.25;
    // A highlight is cut off where its share falls below 2^-24; wide ones never do, so they scale exactly.
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].material.shininess = 12;
    Mirror mirror = ideal_mirror({0, 1, -1}, {0, 0, 1}, 4);
    mirror.lobe_exponent = lobe_exponent;
    mirror.color = {0.9, 0.8, 0.45};
    mirror.specular = 0.3;
    mirror.shininess = 12;
    mirror.diffuse = 0.2;
    add(scene, mirror);
    add(scene, lamp({-3, 5, 4}));
    add(scene, lamp({2, 3, 6}));
    scene.lights[1].color = {1, 0.6, 0.3};
    scene.lights[1].falloff = Falloff::inverse_square;
    scene.lights[1].intensity = 20;
    scene.camera = camera_at({0.7, 2.1, 6}, {-0.1, -0.15, -1}, 0.8);
    return scene;
}

Rgb<double> times(double s, const Rgb<double>& c) { return {s * c.r, s * c.g, s * c.b}; }

TEST(P18, PowersOfTwoScaleEveryPixelExactly) {
    for (const double lobe_exponent : {kInfinity, 60.0}) {
        const Scene scene = lit_scene(lobe_exponent);
        const Image image = render(scene, of_size(64, 48));
        for (const int exponent : {-20, -1, 1, 20}) {
            const double factor = std::ldexp(1, exponent);
            Scene brighter = scene;
            brighter.background = times(factor, scene.background);
            brighter.ambient = times(factor, scene.ambient);
            for (int j = 0; j < scene.light_count; ++j) brighter.lights[j].intensity *= factor;
            const Image other = render(brighter, of_size(64, 48));
            EXPECT_EQ(pixels_apart(scaled(image, static_cast<float>(factor)), other), 0)
                << "2^" << exponent << ", lobe exponent " << lobe_exponent;
        }
    }
}

TEST(P19, TwoLampsGiveTheSumOfTheirPictures) {
    // Each pixel is a short sum, rounded after every term; both ways of summing differ in the order of the terms.
    constexpr double kRoundings = 2;
    for (const double lobe_exponent : {kInfinity, 60.0}) {
        const Scene both = lit_scene(lobe_exponent);
        Scene first = both, second = both;
        first.light_count = second.light_count = 1;
        second.lights[0] = both.lights[1];
        second.ambient = second.background = {0, 0, 0};
        const Image sum = render(both, of_size(64, 48)), a = render(first, of_size(64, 48)),
                    b = render(second, of_size(64, 48));
        for (std::size_t i = 0; i < sum.rgb.size(); ++i) {
            const double expected = static_cast<double>(a.rgb[i]) + b.rgb[i];
            ASSERT_NEAR(sum.rgb[i], expected, kRoundings * kUlp * std::max(expected, 1.0))
                << "value " << i << ", lobe exponent " << lobe_exponent;
        }
        EXPECT_GT(largest_difference(sum, a), 0.1) << "lobe exponent " << lobe_exponent;
        EXPECT_GT(largest_difference(sum, b), 0.1) << "lobe exponent " << lobe_exponent;
    }
}

}  // namespace
}  // namespace zerkalo::laws
