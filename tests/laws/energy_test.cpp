// P25, P29: no pixel shows more light than the scene has, and where nothing is lost every pixel shows all of it.
#include "tests/laws/odd_scenes.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

// A few roundings of each of the terms that a pixel adds up, one for each ray of its tree.
constexpr double kRoom = 32 * kUlp;
constexpr Rgb<double> kWhite{1, 1, 1};

/// Divides the shares of a surface so that they add up to at most 1.
template <class... Share>
void spend_at_most_all(Share&... shares) {
    const double sum = (shares + ...);
    if (sum > 1) ((shares /= sum), ...);
}

/// The scene with lamps, ambient light and background of 1 together or each, and surfaces that spend no more than all.
Scene within_its_budget(Scene scene) {
    scene.ambient = scene.background = kWhite;
    for (int j = 0; j < scene.light_count; ++j) {
        scene.lights[j].falloff = Falloff::none;
        scene.lights[j].color = kWhite;
        scene.lights[j].intensity = 1.0 / scene.light_count;
    }
    for (int k = 0; k < scene.solid_count; ++k) {
        Material& m = scene.solids[k].material;
        m.color = kWhite;
        spend_at_most_all(m.ambient, m.diffuse, m.specular, m.reflection, m.transmission);
    }
    for (int k = 0; k < scene.mirror_count; ++k) {
        Mirror& m = scene.mirrors[k];
        m.color = kWhite;
        spend_at_most_all(m.ambient, m.diffuse, m.specular, m.reflection);
    }
    return scene;
}

double brightest(const Image& image) { return *std::max_element(image.rgb.begin(), image.rgb.end()); }

TEST(P25, NoPixelShowsMoreThanTheSourcesGive) {
    for (const OddScene& odd : odd_scenes()) {
        EXPECT_LE(brightest(render(within_its_budget(odd.scene), odd.settings)), 1 + kRoom) << odd.name;
    }
}

TEST(P25, InAWhiteRoomSurfacesThatGlowWithWhatTheyAbsorbAreInvisible) {
    // Each bounce passes on half: what the depth limit cuts off is 2^-17.
    constexpr int kDepth = 16;
    constexpr double kCutOff = 0x1p-17;
    std::uint64_t bounces = 0;
    for (const OddScene& odd : odd_scenes()) {
        Scene scene = within_its_budget(odd.scene);
        scene.light_count = 0;
        for (int k = 0; k < scene.solid_count; ++k) {
            Material& m = scene.solids[k].material;
            const double passed_on = m.reflection + m.transmission;
            if (passed_on > 0) m.reflection /= 2 * passed_on, m.transmission /= 2 * passed_on;
            m.ambient = passed_on > 0 ? 0.5 : 1;
        }
        for (int k = 0; k < scene.mirror_count; ++k) scene.mirrors[k].ambient = scene.mirrors[k].reflection = 0.5;
        // The back of a mirror reflects nothing and shows its ambient half alone: look at fronts only.
        if (odd.name == std::string("back-of-the-mirror") || scene.mirror_count > 1) continue;
        Settings settings = odd.settings;
        settings.depth_limit = kDepth;
        const Image image = render(scene, settings);
        EXPECT_LE(brightest(image), 1 + kRoom) << odd.name;
        EXPECT_GE(*std::min_element(image.rgb.begin(), image.rgb.end()), 1 - kCutOff - kRoom) << odd.name;
        bounces += image.rays.reflected + image.rays.refracted;
    }
    EXPECT_GT(bounces, 100000u);
}

Material fresnel_glass(double index) {
    Material glass = clear_glass(index);
    glass.fresnel = true;
    return glass;
}

TEST(P29, ClearGlassReflectsAndTransmitsAllOfItsLight) {
    // In a ball every reflection has the same share R, so the 16th ray inside still has (1 - R) R^15 when it is cut
    // off: at most this, at R = 15/16. (Between plane walls light can be caught for good.)
    const double cut_off = std::pow(15.0 / 16, 15) / 16;
    for (const double index : {1.05, 1.33, 1.5, 2.4}) {
        Scene scene;
        scene.background = kWhite;
        add(scene, ball({0, 0, -5}, 1, fresnel_glass(index)));
        scene.camera.fov = 0.5;
        Settings settings = of_size(64, 64);
        settings.depth_limit = 16;
        const Image image = render(scene, settings);
        EXPECT_LE(brightest(image), 1 + kRoom) << "index " << index;
        EXPECT_GE(*std::min_element(image.rgb.begin(), image.rgb.end()), 1 - cut_off - kRoom) << "index " << index;
        EXPECT_GT(image.rays.reflected, 10000u) << "index " << index;
    }
}

TEST(P29, SlabHeadOnSumsItsInnerReflections) {
    // R + T R T + T R^3 T + ... = 2 R / (1 + R) comes back, the rest, (1 - R) / (1 + R), goes through.
    Settings settings;
    settings.depth_limit = 16;
    for (const double index : {1.0, 1.5, 2.0, 3.0}) {
        const double r = std::pow((index - 1) / (index + 1), 2);
        const double cut_off = std::pow(r, 16);
        Scene scene;
        add(scene, box({0, -1, 0}, 8, 1, fresnel_glass(index)));
        add(scene, box({0, 5, 0}, 8, 1, glowing(kWhite)));
        EXPECT_NEAR(look(scene, {0, 3, 0}, {0, -1, 0}, settings).g, 2 * r / (1 + r), kRoom + cut_off) << index;
        scene.solids[1].position.y = -8;
        EXPECT_NEAR(look(scene, {0, 3, 0}, {0, -1, 0}, settings).g, (1 - r) / (1 + r), kRoom + cut_off) << index;
    }
}

}  // namespace
}  // namespace zerkalo::laws
