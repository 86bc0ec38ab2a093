// Culling changes no byte of a sharp picture or of one with few samples, and others by less than its stated bound.
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zerkalo::laws {
namespace {

constexpr double kTailBound = 0x1p-13;        // the share of a lobe that culling may leave out
constexpr std::int32_t kMostUnculled = 128;   // half of the outermost share of that many is more than the tail

Image with_exact_plan(const Scene& scene, Settings settings) {
    settings.exact_plan = true;
    return render(scene, settings);
}

/// Most that any ray of the scene can see in any channel: the local light of the brightest surface, with everything lit
/// and every highlight at its peak, or the background; then what each further bounce can add to it.
double brightest(const Scene& scene, std::int32_t depth_limit) {
    double light = 0, local = 0, background = 0, passed_on = 0;
    for (const double c : {scene.background.r, scene.background.g, scene.background.b}) {
        background = std::max(background, c);
    }
    for (int j = 0; j < scene.light_count; ++j) {
        const Light& lamp = scene.lights[j];
        light += lamp.intensity * std::max({lamp.color.r, lamp.color.g, lamp.color.b});
    }
    const double around = std::max({scene.ambient.r, scene.ambient.g, scene.ambient.b});
    for (int k = 0; k < scene.solid_count; ++k) {
        const Material& m = scene.solids[k].material;
        const double color = std::max({m.color.r, m.color.g, m.color.b});
        local = std::max(local, color * (m.ambient * around + m.diffuse * light) + m.specular * light);
        passed_on = std::max(passed_on, m.reflection + m.transmission);
    }
    if (scene.mirror_count > 1) passed_on = 1;
    double sum = 0, share = 1;
    for (std::int32_t depth = 0; depth <= depth_limit; ++depth, share *= passed_on) sum += share * local;
    return std::max(sum, background);
}

TEST(Culling, ChangesNoByteOfAPolishedMirror) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t antialias : {1, 3}) {
            Settings settings = of_size(160, 120);
            settings.antialias = antialias;
            const Scene sharp = sharpened(scene);
            EXPECT_EQ(render(sharp, settings).hash(), with_exact_plan(sharp, settings).hash()) << name;
        }
    }
}

TEST(Culling, ChangesNoByteOfAnUnpolishedMirrorUpTo1024Samples) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t samples : {1, 16, 100, kMostUnculled}) {
            Settings settings = samples > 100 ? of_size(24, 18) : of_size(64, 48);
            settings.samples = samples;
            const Image culled = render(scene, settings), exact = with_exact_plan(scene, settings);
            EXPECT_EQ(culled.hash(), exact.hash())
                << name << ", " << samples << " samples: " << pixels_apart(culled, exact) << " pixels differ";
        }
    }
}

TEST(Culling, LobesThatCanMeetNothingSendNoRayWhateverTheirRaysWeigh) {
    int scenes_with_such = 0;
    for (const auto& [name, shipped] : shipped_scenes()) {
        if (shipped.mirrors[0].lobe == Lobe::ggx) continue;
        Scene scene = shipped;
        const Settings settings = of_size(64, 48);
        scene.mirrors[0].lobe = Lobe::max_phong;
        const RayCounts weighted = render(scene, settings).rays, all = with_exact_plan(scene, settings).rays;
        scene.mirrors[0].lobe = Lobe::phong;
        const RayCounts plain = render(scene, settings).rays;
        EXPECT_EQ(weighted.lobe, plain.lobe) << name;
        EXPECT_EQ(lobe_samples_of(weighted), lobe_samples_of(all)) << name;
        EXPECT_EQ(all.weighed, 0u) << name;
        scenes_with_such += weighted.weighed > 0;
    }
    EXPECT_GE(scenes_with_such, 5);
}

TEST(Culling, ChangesNoByteWhereSolidsAreCovered) {
    for (const auto& [name, scene] : shipped_scenes()) {
        if (scene.mirrors[0].lobe == Lobe::ggx) continue;  // has no coverage
        for (const std::int32_t samples : {1, 16, kMostUnculled}) {
            Settings settings = samples > 16 ? of_size(24, 18) : of_size(64, 48);
            settings.estimator = Estimator::fibonacci_coverage;
            settings.samples = samples;
            const Image culled = render(scene, settings), exact = with_exact_plan(scene, settings);
            EXPECT_EQ(culled.hash(), exact.hash())
                << name << ", " << samples << " samples: " << pixels_apart(culled, exact) << " pixels differ";
        }
    }
}

void expect_less_than_the_tail_is_missing(const std::string& name, const Image& culled, const Image& exact,
                                          double contrast) {
    EXPECT_LE(largest_difference(culled, exact), kTailBound * contrast) << name;
}

TEST(Culling, LeavesOutLessThanItsTailOfALobeOfMoreSamples) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(32, 24);
        settings.samples = 3000;
        expect_less_than_the_tail_is_missing(name, render(scene, settings), with_exact_plan(scene, settings),
                                             brightest(scene, settings.depth_limit));
    }
}

/// A wide lobe inside two rings of glowing balls: one lies in its tail alone, the other just within the cone that holds
/// the rest, where a cone too narrow would lose more than the tail.
Scene balls_around_a_wide_lobe() {
    constexpr int kPerRing = kMaxSolids / 2;
    constexpr double kDistance = 4, kDegree = std::numbers::pi / 180;
    constexpr double kExponent = 20;  // its cone without the tail: 49.4 degrees to each side
    Scene scene;
    for (int k = 0; k < 2 * kPerRing; ++k) {
        const bool outer = k < kPerRing;
        const double tilt = (outer ? 57 : 46) * kDegree, turn = 2 * std::numbers::pi * k / kPerRing;
        Solid& ball = scene.solids[scene.solid_count++];
        ball.position = {kDistance * std::sin(tilt) * std::cos(turn), kDistance * std::sin(tilt) * std::sin(turn),
                         kDistance * std::cos(tilt)};
        ball.radius = kDistance * std::sin((outer ? 6 : 3) * kDegree);
        ball.material.color = {1, 1, 1};
        ball.material.ambient = 1;
        ball.material.diffuse = ball.material.specular = 0;
    }
    Mirror& mirror = scene.mirrors[scene.mirror_count++];
    mirror.lobe = Lobe::phong;
    mirror.lobe_exponent = kExponent;
    mirror.ambient = mirror.diffuse = 0;
    mirror.reflection = 1;
    scene.camera.position = {0, 0, 5};
    scene.camera.fov = 0.02;
    return scene;
}

TEST(Culling, LeavesOutSomethingOfAWideLobeAndLessThanItsTail) {
    Settings settings = of_size(16, 12);
    settings.samples = 30000;
    const Scene scene = balls_around_a_wide_lobe();
    const Image culled = render(scene, settings), exact = with_exact_plan(scene, settings);
    constexpr double kContrast = 1;
    expect_less_than_the_tail_is_missing("balls", culled, exact, kContrast);
    // Otherwise nothing was culled and nothing was tested.
    EXPECT_GT(pixels_apart(culled, exact), 10);
    EXPECT_GT(largest_difference(culled, exact), kTailBound / 100);
}

}  // namespace
}  // namespace zerkalo::laws
