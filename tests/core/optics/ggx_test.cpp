// The microfacet lobe: its rays have the density of the normals that the viewer sees, its weight makes it reciprocal.
#include "tests/core/support/random.hpp"
#include "tests/core/support/rays.hpp"
#include "tests/core/support/widths.hpp"

#include <cmath>

namespace zerkalo::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGolden = 0.61803398874989485;
constexpr double kAlphas[] = {0.05, 0.2, 0.5, 1};
constexpr int kDegrees[] = {0, 30, 60, 80};

double smith_lambda(double cosine, double alpha) {
    const double tangent = std::sqrt(1 - cosine * cosine) / cosine;
    return (std::sqrt(1 + alpha * alpha * tangent * tangent) - 1) / 2;
}

/// Light that a white world sends to the viewer, and its mean direction: what the rays, times their weights, must add
/// up to. Over half-way vectors h: f cos_i dw_i = D(h) G2 (o.h) / cos_o dw_h.
struct Moments {
    double albedo = 0, across = 0, forward = 0;
};

Moments quadrature(double alpha, double angle) {
    constexpr int kSteps = 400;
    const double ox = std::sin(angle), oz = std::cos(angle);
    Moments sum;
    for (int a = 0; a < kSteps; ++a) {
        // tan theta = alpha s / (1 - s) spreads the peak of D over the steps.
        const double s = (a + 0.5) / kSteps, theta = std::atan(alpha * s / (1 - s));
        const double cosine = std::cos(theta), sine = std::sin(theta);
        const double d_theta = cosine * cosine * alpha / ((1 - s) * (1 - s)) / kSteps;
        const double base = 1 + (alpha * alpha - 1) * cosine * cosine;
        const double density = alpha * alpha / (kPi * base * base);
        for (int b = 0; b < kSteps; ++b) {
            const double turn = 2 * kPi * (b + 0.5) / kSteps;
            const double hx = sine * std::cos(turn), oh = ox * hx + oz * cosine;
            const double ix = 2 * oh * hx - ox, iz = 2 * oh * cosine - oz;
            if (oh <= 0 || iz <= 0) continue;
            const double shadowing = 1 / (1 + smith_lambda(oz, alpha) + smith_lambda(std::min(iz, 1.0), alpha));
            const double share = density * shadowing * oh / oz * sine * d_theta * 2 * kPi / kSteps;
            sum.albedo += share, sum.across += share * ix, sum.forward += share * iz;
        }
    }
    return sum;
}

struct GgxRays {
    PointList ray;
    Floats weight;
};

class Ggx : public Widths {
protected:
    /// The rays of `count` lattice points for a viewer at that angle, in the plane y = 0 of the mirror's frame.
    static GgxRays rays(double alpha, double angle, int count) {
        Floats u, turn;
        for (int k = 0; k < count; ++k) {
            u.push_back(float((k + 0.5) / count));
            turn.push_back(float(k * kGolden - std::floor(k * kGolden) - 0.5));
        }
        return rays_at(u, turn, alpha, {std::sin(angle), 0, std::cos(angle)});
    }
    static GgxRays rays_at(const Floats& u, const Floats& turn, double alpha, const Exact3& viewer) {
        GgxRays out{PointList(u.size()), Floats(u.size())};
        const float v[3] = {float(viewer.x), float(viewer.y), float(viewer.z)};
        optics().ggx(u.data(), turn.data(), float(alpha), v, out.ray.out(), out.weight.data(),
                     static_cast<int>(u.size()));
        return out;
    }
};

TEST_P(Ggx, RaysTimesWeightsAreTheLightOfAnIndependentQuadrature) {
    constexpr int kRays = 65536;
    constexpr double kQuadratures = 1e-3;
    for (const double alpha : kAlphas) {
        for (const int degrees : kDegrees) {
            SCOPED_TRACE(testing::Message() << "alpha " << alpha << ", " << degrees << " degrees");
            const double angle = degrees * kPi / 180;
            const GgxRays seen = rays(alpha, angle, kRays);
            Moments mean;
            for (std::size_t k = 0; k < kRays; ++k) {
                const double weight = seen.ray[k].z > 0 ? double(seen.weight[k]) : 0.0;
                ASSERT_GE(weight, 0) << "ray " << k;
                ASSERT_LE(weight, 1) << "ray " << k;
                mean.albedo += weight / kRays;
                mean.across += weight * double(seen.ray[k].x) / kRays;
                mean.forward += weight * double(seen.ray[k].z) / kRays;
            }
            const Moments exact = quadrature(alpha, angle);
            EXPECT_NEAR(mean.albedo, exact.albedo, kQuadratures);
            EXPECT_NEAR(mean.across, exact.across, kQuadratures);
            EXPECT_NEAR(mean.forward, exact.forward, kQuadratures);
            EXPECT_LE(mean.albedo, 1);
        }
    }
}

// f = D G2 / (4 cos cos): the weight G2 / G1 of the viewer, times that G1, is the same with light and viewer exchanged.
TEST_P(Ggx, WeightMakesTheLobeReciprocal) {
    constexpr double kRounding = 8 * 0x1p-24;
    Random random(221);
    for (int round = 0; round < 2000; ++round) {
        const double alpha = random.uniform(0.01, 1), one = random.uniform(0.05, 1), two = random.uniform(0.05, 1);
        const float cosines[2] = {float(one), float(two)};
        const auto masked = [&](int viewer) {
            Floats out(16);
            const Floats light(16, cosines[1 - viewer]);
            optics().ggx_weight(light.data(), cosines[viewer], float(alpha), out.data(), 16);
            return double(out[0]) / (1 + smith_lambda(double(cosines[viewer]), double(float(alpha))));
        };
        ASSERT_NEAR(masked(0) / masked(1), 1, kRounding) << alpha << ", cosines " << one << " and " << two;
    }
}

TEST_P(Ggx, RaysAreUnitAndTendToTheMirrorDirection) {
    for (const double angle : {0.0, 0.4, 1.2}) {
        double widest = 100;
        for (const double alpha : {0.1, 1e-3, 1e-5, 0.0}) {
            const GgxRays seen = rays(alpha, angle, 1024);
            double away = 0;
            for (std::size_t k = 0; k < 1024; ++k) {
                ASSERT_NEAR(double(length(seen.ray[k])), 1, 1e-6) << "ray " << k << ", alpha " << alpha;
                away = std::max(away, std::hypot(double(seen.ray[k].x) + std::sin(angle), double(seen.ray[k].y)));
            }
            EXPECT_LT(away, std::max(widest / 10, 1e-6)) << "alpha " << alpha << ", angle " << angle;
            widest = away;
        }
        EXPECT_LE(widest, 4e-7);
    }
}

TEST_P(Ggx, EveryWidthGivesTheSameBits) {
    Random random(222);
    for (int round = 0; round < 20; ++round) {
        Floats u, turn;
        for (int k = 0; k < 64; ++k) {
            u.push_back(float(random.uniform(0x1p-24, 1 - 0x1p-24)));
            turn.push_back(float(random.uniform(-0.5, 0.5)));
        }
        Exact3 viewer = random.direction();
        viewer.z = std::abs(viewer.z);
        const double alpha = random.uniform(0, 1);
        const GgxRays here = rays_at(u, turn, alpha, viewer);
        GgxRays there{PointList(64), Floats(64)};
        const float v[3] = {float(viewer.x), float(viewer.y), float(viewer.z)};
        scalar().optics.ggx(u.data(), turn.data(), float(alpha), v, there.ray.out(), there.weight.data(), 64);
        expect_same_bits(here.ray.x, there.ray.x, "x");
        expect_same_bits(here.ray.y, there.ray.y, "y");
        expect_same_bits(here.ray.z, there.ray.z, "z");
        expect_same_bits(here.weight, there.weight, "weight");
    }
}

ZERKALO_OVER_ALL_WIDTHS(Ggx);

}  // namespace
}  // namespace zerkalo::test
