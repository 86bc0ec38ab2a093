// More depth adds light and never takes any; between two facing mirrors it adds a geometric series.
#include "tests/laws/odd_scenes.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

Settings depth(int limit) {
    Settings settings;
    settings.depth_limit = limit;
    return settings;
}

TEST(P10, FacingMirrorsGiveTheGeometricSeries) {
    constexpr double kGlow = 0.5, kReflection = 0.8;
    constexpr Rgb<double> kTint{0.95, 0.8, 0.45};
    Scene scene;
    for (const double side : {1.0, -1.0}) {
        Mirror mirror = ideal_mirror({0, 0, -side}, {0, 0, side}, 4);
        mirror.color = kTint;
        mirror.ambient = kGlow;
        mirror.reflection = kReflection;
        add(scene, mirror);
    }
    // Half an ulp for each product and sum of each term.
    constexpr double kUlpsPerTerm = 4 * 0x1p-24;
    for (const int limit : {0, 1, 2, 6, 40, 255}) {
        const Rgb<float> seen = look(scene, {0, 0, 0}, {0, 0, -1}, depth(limit));
        const auto expect = [&](double value, double tint) {
            const double q = tint * kReflection;
            const double closed = tint * kGlow * (1 - std::pow(q, limit + 1)) / (1 - q);
            EXPECT_NEAR(value, closed, kUlpsPerTerm * (std::min(limit, 40) + 1)) << "depth limit " << limit;
        };
        expect(seen.r, kTint.r);
        expect(seen.g, kTint.g);
        expect(seen.b, kTint.b);
    }
}

TEST(P10, SeriesOfAHalfIsExactToTheLastBit) {
    // 1/2 + 1/4 + ... : every partial sum is a float.
    constexpr int kBits = 23;
    Scene scene;
    for (const double side : {1.0, -1.0}) {
        Mirror mirror = ideal_mirror({0, 0, -side}, {0, 0, side}, 4);
        mirror.ambient = mirror.reflection = 0.5;
        add(scene, mirror);
    }
    for (int limit = 0; limit < kBits; ++limit) {
        EXPECT_EQ(look(scene, {0, 0, 0}, {0, 0, -1}, depth(limit)).g, 1 - std::ldexp(1.0f, -limit - 1)) << limit;
    }
}

TEST(P28, MoreDepthNeverDarkensAPixel) {
    for (const OddScene& odd : odd_scenes()) {
        Settings settings = odd.settings;
        settings.depth_limit = 0;
        Image before = render(odd.scene, settings);
        for (const int limit : {1, 2, 3, 6}) {
            settings.depth_limit = limit;
            const Image after = render(odd.scene, settings);
            for (std::size_t i = 0; i < after.rgb.size(); ++i) {
                ASSERT_GE(after.rgb[i], before.rgb[i]) << odd.name << ", depth limit " << limit << ", value " << i;
            }
            before = after;
        }
    }
}

TEST(Depth, LimitZeroSeesOnlyTheMirrorItself) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 4));
    EXPECT_EQ(look(scene, {0, 0, 3}, {0, 0, -1}, depth(0)).b, 0);
    EXPECT_EQ(look(scene, {0, 0, 3}, {0, 0, -1}, depth(1)).b, 0.3f);
}

}  // namespace
}  // namespace zerkalo::laws
