// The shares of a lobe's energy: those of their definition, the whole lobe together, in every number system.
#include "core/optics/lattice.hpp"
#include "tests/core/optics/share_of_ray.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::test {
namespace {

/// The border of the shares, as the head of shares.hpp has it.
Real80 psi(Real80 x) { return x < 0.125L ? 64 * x * x / 15 : (16 * x - 1) / 15; }

TEST(Shares, GrowFromTheRimAndAreTheWholeLobeTogether) {
    for (const int n : {1, 2, 3, 7, 8, 9, 16, 61, 64, 1000, 4096}) {
        Real80 sum = 0, before = 0;
        for (int s = 0; s < n; ++s) {
            // A single ray stands for all.
            const Real80 wanted = n == 1 ? 1 : psi((s + 1.0L) / n) - psi(Real80(s) / n), share = share_of_ray(s, n);
            ASSERT_NEAR(double(share), double(wanted), double(wanted) * 3e-7) << s << " of " << n;
            ASSERT_GE(share, before) << s << " of " << n;
            sum += share;
            before = share;
        }
        EXPECT_NEAR(double(sum), 1, 1e-6) << n;
    }
}

TEST(Shares, HoldTheirPointsInFloatDoubleAndFixedPoint) {
    for (const std::uint32_t rotation : {0u, 1u, 5u}) {
        const Sampling sampling = sampling_of(Estimator::fibonacci, rotation);
        for (const std::int32_t camera_rays : {1, 3}) {
            const LatticePart part = lattice_part(sampling, 1, camera_rays);
            for (const int n : {1, 5, 8, 16, 100, 5000}) {
                for (int s = 0; s < n; s += 1 + n / 50) {
                    const Real80 low = n == 1 ? 0 : psi(Real80(s) / n), high = n == 1 ? 1 : psi((s + 1.0L) / n);
                    const Real80 exact = low + (high - low) * part.place[s & 1] * 0x1p-20L;
                    const double u = share_point<double>(part, s, n);
                    ASSERT_NEAR(u, double(exact), double(exact) * 0x1p-50) << s << " of " << n;
                    ASSERT_NEAR(double(share_point<float>(part, s, n)), u, u * 0x1p-22) << s << " of " << n;
                    const auto fixed = share_point<FixedNumbers<1>>(part, s, n);
                    ASSERT_NEAR(std::ldexp(double(fixed.raw), -60), u, double(high - low) * 0x1p-11)
                        << s << " of " << n;
                }
            }
        }
    }
}

// Together the rays of a smooth field must not lie too far out, or too far in.
TEST(Shares, OddOnesHaveTheMirroredPlace) {
    for (std::uint32_t rotation = 0; rotation < 50; ++rotation) {
        const LatticePart part = lattice_part(sampling_of(Estimator::fibonacci, rotation), 0, 1);
        EXPECT_EQ(part.place[0] + part.place[1], 1 << kPlaceBits) << rotation;
    }
}

TEST(Shares, PartsOfALatticeAreScaledToCountAlike) {
    constexpr int kParts = 4;
    for (const int n : {4, 8, 16, 64, 1024}) {
        for (int first = 0; first < kParts; ++first) {
            Real80 sum = 0;
            for (int s = first; s < n; s += kParts) sum += share_of_ray(s, n);
            EXPECT_NEAR(double(sum * scale_of_part(Estimator::fibonacci, n, first, kParts)), 1.0 / kParts, 1e-6)
                << "from " << first << " of " << n;
        }
    }
    EXPECT_EQ(scale_of_part(Estimator::random, 16, 1, kParts), 1.0f);
}

}  // namespace
}  // namespace zerkalo::test
