// The rough mirror of microfacets in whole pictures: the white furnace, the limit of perfect polish, every number type.
#include "core/scene/edit.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr int kTilts[] = {0, 30, 60, 80};

double lambda(double cosine, double alpha) {
    return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
}

/// Integral over the hemisphere of D(h) G2 / (4 cos_o), h half-way between viewer and light: midpoint rule in the
/// cosine and the azimuth of the light.
double exact_albedo(double alpha, double angle) {
    constexpr int kSteps = 800;
    const double ox = std::sin(angle), oz = std::cos(angle);
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps, across = std::sqrt(1 - z * z);
        for (int j = 0; j < kSteps / 2; ++j) {
            const double azimuth = 2 * kPi * (j + 0.5) / kSteps;  // half a turn, for both halves are alike
            const double hx = across * std::cos(azimuth) + ox, hy = across * std::sin(azimuth), hz = z + oz;
            const double facet = hz * hz / (hx * hx + hy * hy + hz * hz);
            const double base = 1 + (alpha * alpha - 1) * facet;
            sum += alpha * alpha / (kPi * base * base) / (4 * oz * (1 + lambda(oz, alpha) + lambda(z, alpha)));
        }
    }
    return 4 * kPi * sum / (kSteps * static_cast<double>(kSteps));
}

double exponent_of_width(double alpha) { return (1 / (alpha * alpha) - 1) / 2; }

Scene furnace(double alpha) {
    Scene scene;
    scene.background = {1, 1, 1};
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 100);
    mirror.lobe = Lobe::ggx;
    mirror.lobe_exponent = exponent_of_width(alpha);
    add(scene, mirror);
    return scene;
}

TEST(Ggx, WhiteFurnaceReturnsItsAlbedoAndNeverMore) {
    constexpr double kQuadratures = 1e-3;
    for (const double alpha : {0.25, 0.5, 1.0}) {
        for (const int degrees : kTilts) {
            const double angle = degrees * kPi / 180;
            Settings settings;
            settings.samples = 16384;
            const double albedo =
                look(furnace(alpha), {std::sin(angle), 0, std::cos(angle)}, {-std::sin(angle), 0, -std::cos(angle)},
                     settings).g;
            EXPECT_NEAR(albedo, exact_albedo(alpha, angle), kQuadratures) << alpha << " at " << degrees << " degrees";
            EXPECT_LE(albedo, 1 + 2 * kUlp) << alpha << " at " << degrees << " degrees";
        }
    }
}

Scene before_a_rough_mirror(double polish) {
    Scene scene = simple_scene();
    scene.mirrors[0].lobe = Lobe::ggx;
    scene.mirrors[0].lobe_exponent = exponent_of_polish(polish);
    return scene;
}

TEST(Ggx, TendsToTheSharpPictureAsItIsPolished) {
    const reference::Picture sharp = picture_of(render(before_a_rough_mirror(1), of_size(64, 48)));
    double before = 1;
    for (const double polish : {0.7, 0.9, 0.97, 0.99, 0.999}) {
        Settings settings = of_size(64, 48);
        settings.samples = 64;
        const reference::Picture rough = picture_of(render(before_a_rough_mirror(polish), settings));
        const double error = reference::compare(rough, sharp, 0).rmse;
        EXPECT_LT(error, before) << "polish " << polish;
        before = error;
    }
    EXPECT_LT(before, 2e-3);
    EXPECT_GT(before, 0) << "it was rendered as a sharp mirror";
}

TEST(Ggx, EveryInstructionSetAndRuleGivesTheSameBytes) {
    for (int rule = 0; rule <= static_cast<int>(Estimator::fibonacci); ++rule) {
        Settings settings = of_size(33, 17);
        settings.estimator = static_cast<Estimator>(rule);
        settings.samples = 5;
        const Image serial = render(before_a_rough_mirror(0.6), settings, Isa::scalar);
        for (const Isa isa : available_isas()) {
            EXPECT_EQ(render(before_a_rough_mirror(0.6), settings, isa).hash(), serial.hash()) << name_of(isa);
        }
    }
}

TEST(Ggx, FixedPointAndDoubleGiveThePictureOfFloat) {
    constexpr double kEdges = 2e-3;  // linear RMSE: a few rays in a thousand meet another surface
    for (const double polish : {0.0, 0.5, 0.9}) {
        Settings settings = of_size(64, 48);
        settings.samples = 16;
        const Scene scene = before_a_rough_mirror(polish);
        const reference::Picture floats = picture_of(render(scene, settings));
        EXPECT_LE(reference::compare(picture_of(render_fixed(scene, settings)), floats, 0).rmse, kEdges) << polish;
        EXPECT_LE(reference::compare(picture_of(render_double(scene, settings)), floats, 0).rmse, kEdges) << polish;
    }
}

TEST(Ggx, MirrorsOfDifferentLobesDoNotMixTheirRays) {
    // Two mirrors side by side, one packet over their seam: each half is the picture of its own lobe.
    const auto scene_of = [](Lobe left, Lobe right) {
        Scene scene = simple_scene();
        Mirror mirror = scene.mirrors[0];
        mirror.lobe_exponent = 40;
        mirror.boundary.width = 2;
        scene.mirror_count = 0;
        for (const double x : {-1.0, 1.0}) {
            mirror.position.x = x;
            mirror.lobe = x < 0 ? left : right;
            add(scene, mirror);
        }
        return scene;
    };
    Settings settings = of_size(64, 48);
    settings.samples = 8;
    const Image mixed = render(scene_of(Lobe::phong, Lobe::ggx), settings);
    const Image phong = render(scene_of(Lobe::phong, Lobe::phong), settings);
    const Image ggx = render(scene_of(Lobe::ggx, Lobe::ggx), settings);
    int of_neither = 0, of_one = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto seen = mixed.at(x, y), a = phong.at(x, y), b = ggx.at(x, y);
            const auto same = [&](const Rgb<float>& c) { return c.r == seen.r && c.g == seen.g && c.b == seen.b; };
            of_neither += !same(a) && !same(b);
            of_one += same(a) != same(b);
        }
    }
    EXPECT_EQ(of_neither, 0);
    EXPECT_GT(of_one, 100);
}

}  // namespace
}  // namespace zerkalo::laws
