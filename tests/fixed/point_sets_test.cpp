// The point sets of the keyed estimators in fixed point: the points of float, at every width the same integers.
#include "core/optics/point_sets.hpp"
#include "tests/fixed/fixed_values.hpp"

namespace zerkalo::test {
namespace {

constexpr Estimator kKeyed[] = {Estimator::random, Estimator::jittered, Estimator::sobol, Estimator::r2};
constexpr int kWide = 4;
using Wide = FixedNumbers<kWide>;

struct Draw {
    Estimator rule;
    std::int32_t count;
    std::uint32_t index, key, half;
};

Draw draw(Random& random, Estimator rule) {
    const int count = 1 + random.below(1 << random.below(21));
    return {rule, count, static_cast<std::uint32_t>(random.below(count)), static_cast<std::uint32_t>(random.bits()),
            random.below(2) == 0 ? 0u : 0x80000000u};
}

testing::Message text(const Draw& at) {
    return testing::Message() << name_of(at.rule) << ", point " << at.index << " of " << at.count << ", key " << at.key;
}

TEST(FixedPointSets, AreThoseOfFloatToItsLastBits) {
    // Jitter is a quotient of a sum: three roundings of 2^-24 in float.
    constexpr Real80 kRoom = 0x1p-22L;
    Random random(211);
    for (const Estimator rule : kKeyed) {
        for (int i = 0; i < 20000; ++i) {
            const Draw at = draw(random, rule);
            const auto fixed = set_point<One>(rule, at.index, at.count, {at.key, at.half});
            const auto floats = set_point<float>(rule, at.index, at.count, {at.key, at.half});
            ASSERT_LE(std::abs(real(fixed.u) - Real80(floats.u)), kRoom) << text(at);
            ASSERT_GE(real(fixed.u), 0x1p-24L) << text(at);
            ASSERT_LE(real(fixed.u), 1 - 0x1p-24L) << text(at);
            // Phases wrap: -1/2 and 1/2 of a turn are one.
            const Real80 turn = std::ldexp(Real80(fixed.turn), -32) - Real80(floats.turn);
            ASSERT_LE(std::abs(turn - std::round(turn)), kRoom) << text(at);
        }
    }
}

TEST(PointSetsInDouble, AreThoseOfFloatToItsLastBits) {
    constexpr double kRoom = 0x1p-22;
    Random random(213);
    for (const Estimator rule : kKeyed) {
        for (int i = 0; i < 20000; ++i) {
            const Draw at = draw(random, rule);
            const auto doubles = set_point<double>(rule, at.index, at.count, {at.key, at.half});
            const auto floats = set_point<float>(rule, at.index, at.count, {at.key, at.half});
            ASSERT_LE(std::abs(doubles.u - double(floats.u)), kRoom) << text(at);
            const double turn = doubles.turn - double(floats.turn);
            ASSERT_LE(std::abs(turn - std::round(turn)), kRoom) << text(at);
        }
    }
}

TEST(FixedPointSets, EveryWidthGivesTheSameIntegers) {
    Random random(212);
    for (const Estimator rule : kKeyed) {
        for (int i = 0; i < 2000; ++i) {
            const Draw at = draw(random, rule);
            Bits<Wide> index{}, key{}, half{};
            for (int k = 0; k < kWide; ++k) {
                set_lane(index, k, (at.index + static_cast<std::uint32_t>(k)) % static_cast<std::uint32_t>(at.count));
                set_lane(key, k, at.key * static_cast<std::uint32_t>(k + 1));
                set_lane(half, k, k % 2 == 0 ? at.half : 0);
            }
            const auto wide = set_point<Wide>(rule, index, at.count, {key, half});
            for (int k = 0; k < kWide; ++k) {
                const auto one =
                    set_point<One>(rule, lane_of(index, k), at.count, {lane_of(key, k), lane_of(half, k)});
                ASSERT_EQ(lane_of(wide.u.raw, k), one.u.raw) << text(at) << ", lane " << k;
                ASSERT_EQ(lane_of(wide.turn, k), one.turn) << text(at) << ", lane " << k;
            }
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
