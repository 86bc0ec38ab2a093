// P23: what an unpolished mirror blurs. A narrow lobe is a Gaussian: edges become the error function, and everything
// smooth tends to the sharp picture like 1 / n.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kWall = 10;  // where the wall with the edge stands

Settings many_samples() {
    Settings settings;
    settings.samples = 65536;
    settings.exact_plan = true;
    return settings;
}

/// What a mirror in z = 0 shows of a wall at z = 10 that glows for x < 0, met at right angles `offset` right of its
/// edge.
double seen_across_an_edge(double exponent, Lobe lobe, double offset) {
    Scene scene;
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 40);
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    add(scene, mirror);
    // A pane without thickness: the front of a mirror that reflects nothing.
    Mirror wall = ideal_mirror({-40, 0, kWall}, {0, 0, -1}, 80);
    wall.reflection = 0;
    wall.ambient = 1;
    add(scene, wall);
    return look(scene, {offset, 0, 5}, {0, 0, -1}, many_samples()).g;
}

TEST(P23, EdgeBlursToTheErrorFunction) {
    constexpr double kProfile = 1e-3;
    for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
        for (const double n : {1e4, 1e5}) {
            for (int step = -8; step <= 8; ++step) {
                const double angle = 0.4 * step / std::sqrt(n);
                EXPECT_NEAR(seen_across_an_edge(n, lobe, kWall * std::tan(angle)),
                            0.5 * std::erfc(angle * std::sqrt(n / 2)), kProfile)
                    << "n " << n << ", angle " << angle;
            }
        }
    }
}

TEST(P23, EdgeIsAsSteepAsTheLobeIsNarrow) {
    constexpr double kRelative = 0.01;
    for (const double n : {1e3, 1e4, 1e5}) {
        const double angle = 0.1 / std::sqrt(n);
        const double fall = seen_across_an_edge(n, Lobe::phong, -kWall * std::tan(angle)) -
                            seen_across_an_edge(n, Lobe::phong, kWall * std::tan(angle));
        const double closed = std::sqrt(n / (2 * kPi));
        EXPECT_NEAR(fall / (2 * angle), closed, kRelative * closed) << "n " << n;
    }
}

/// A mirror overhead shows a point of a floor that a lamp lights unevenly.
double smooth_picture(double exponent, Lobe lobe) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, box({0, -1, 0}, 256, 1, chalk()));
    add(scene, lamp({3, 4, 0}));
    Mirror mirror = ideal_mirror({0, 6, 0}, {0, -1, 0}, 1);
    mirror.up = {0, 0, 1};
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    add(scene, mirror);
    return look(scene, {0, 5, 0}, {0, 1, 0}, many_samples()).g;
}

TEST(P23, SmoothPictureTendsToTheSharpOneLikeOneOverTheExponent) {
    for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
        const double sharp = smooth_picture(kInfinity, lobe);
        const auto error = [&](double n) { return std::abs(smooth_picture(n, lobe) - sharp); };
        EXPECT_NEAR(std::log2(error(400) / error(1600)) / 2, 1, 0.05) << "lobe " << static_cast<int>(lobe);
        EXPECT_NEAR(std::log2(error(200) / error(800)) / 2, 1, 0.05) << "lobe " << static_cast<int>(lobe);
        EXPECT_GT(error(400), 1e-4);
    }
}

}  // namespace
}  // namespace zerkalo::laws
