// Every lane operation is the scalar one, bit for bit, on any bit patterns: NaN, infinities, zeros and denormals too.
#include "tests/core/support/random.hpp"
#include "tests/core/support/widths.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::test {
namespace {

using probes::Binary;
using probes::PacketFacts;
using probes::Unary;

constexpr int kPatterns = ZERKALO_LAW_RAYS;
constexpr float kOne = 1;

class Lanes : public Widths {
protected:
    void SetUp() override {
        Widths::SetUp();
        Random random(1);
        for (int k = 0; k < kPatterns; ++k) {
            a.push_back(random.any_float());
            b.push_back(random.any_float());
        }
    }
    Floats a, b, got = Floats(kPatterns);
};

float from_pattern(std::uint32_t bits) { return std::bit_cast<float>(bits); }

/// The same bits. IEEE 754 leaves open which NaN an arithmetic operation gives, so there any NaN equals any.
enum class NotANumber { exact, any };
bool same(float got, float wanted, NotANumber nan) {
    if (nan == NotANumber::any && std::isnan(wanted)) return std::isnan(got);
    return bits_of_float(got) == bits_of_float(wanted);
}

template <class F>
void expect_each(const Floats& a, const Floats& got, const char* name, NotANumber nan, F f) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        ASSERT_TRUE(same(got[k], f(a[k]), nan)) << std::hex << name << " of " << bits_of_float(a[k]) << " is "
                                                << bits_of_float(got[k]) << ", not " << bits_of_float(f(a[k]));
    }
}

template <class F>
void expect_each(const Floats& a, const Floats& b, const Floats& got, const char* name, NotANumber nan, F f) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        ASSERT_TRUE(same(got[k], f(a[k], b[k]), nan))
            << std::hex << name << " of " << bits_of_float(a[k]) << " and " << bits_of_float(b[k]) << " is "
            << bits_of_float(got[k]) << ", not " << bits_of_float(f(a[k], b[k]));
    }
}

TEST_P(Lanes, UnaryOperationsAreTheScalarOnes) {
    struct Row {
        Unary op;
        const char* name;
        NotANumber nan;
        float (*scalar)(float);
    };
    const auto exact = NotANumber::exact;
    const Row rows[] = {
        {Unary::negate, "negate", exact, [](float x) { return from_pattern(bits_of_float(x) ^ 0x80000000u); }},
        {Unary::root, "square root", NotANumber::any, [](float x) { return std::sqrt(x); }},
        {Unary::magnitude, "magnitude", exact, [](float x) { return from_pattern(bits_of_float(x) & 0x7fffffffu); }},
        {Unary::round_trip, "bits and back", exact, [](float x) { return x; }},
        {Unary::shift_left_5, "shift left", exact, [](float x) { return from_pattern(bits_of_float(x) << 5); }},
        {Unary::shift_right_9, "shift right", exact, [](float x) { return from_pattern(bits_of_float(x) >> 9); }},
        {Unary::cap_at_one, "min with a uniform", exact, [](float x) { return x < kOne ? x : kOne; }},
        {Unary::raise_to_one, "max with a uniform", exact, [](float x) { return x > kOne ? x : kOne; }},
    };
    for (const Row& row : rows) {
        lanes().unary(row.op, a.data(), got.data(), kPatterns);
        expect_each(a, got, row.name, row.nan, row.scalar);
    }
}

TEST_P(Lanes, ArithmeticIsTheScalarOne) {
    struct Row {
        Binary op;
        const char* name;
        float (*scalar)(float, float);
    };
    const Row rows[] = {{Binary::add, "sum", [](float x, float y) { return x + y; }},
                        {Binary::subtract, "difference", [](float x, float y) { return x - y; }},
                        {Binary::multiply, "product", [](float x, float y) { return x * y; }},
                        {Binary::divide, "quotient", [](float x, float y) { return x / y; }}};
    for (const Row& row : rows) {
        lanes().binary(row.op, a.data(), b.data(), got.data(), kPatterns);
        expect_each(a, b, got, row.name, NotANumber::any, row.scalar);
    }
}

TEST_P(Lanes, ChoicesKeepEveryBit) {
    struct Row {
        Binary op;
        const char* name;
        float (*scalar)(float, float);
    };
    const Row rows[] = {
        {Binary::least, "min", [](float x, float y) { return x < y ? x : y; }},
        {Binary::greatest, "max", [](float x, float y) { return x > y ? x : y; }},
        {Binary::choose, "select", [](float x, float y) { return x < y ? y : x; }},
        {Binary::choose_or_one, "select or a uniform", [](float x, float y) { return x < y ? x : kOne; }},
        {Binary::one_or_choose, "a uniform or select", [](float x, float y) { return x < y ? kOne : y; }},
        {Binary::with_sign_of, "flip_sign",
         [](float x, float y) { return from_pattern(bits_of_float(x) ^ (bits_of_float(y) & 0x80000000u)); }}};
    for (const Row& row : rows) {
        lanes().binary(row.op, a.data(), b.data(), got.data(), kPatterns);
        expect_each(a, b, got, row.name, NotANumber::exact, row.scalar);
    }
}

TEST_P(Lanes, IntegersWrapLikeScalarOnes) {
    struct Row {
        Binary op;
        const char* name;
        std::uint32_t (*scalar)(std::uint32_t, std::uint32_t);
    };
    const Row rows[] = {{Binary::bits_add, "+", [](std::uint32_t x, std::uint32_t y) { return x + y; }},
                        {Binary::bits_subtract, "-", [](std::uint32_t x, std::uint32_t y) { return x - y; }},
                        {Binary::bits_multiply, "*", [](std::uint32_t x, std::uint32_t y) { return x * y; }},
                        {Binary::bits_and, "&", [](std::uint32_t x, std::uint32_t y) { return x & y; }},
                        {Binary::bits_or, "|", [](std::uint32_t x, std::uint32_t y) { return x | y; }},
                        {Binary::bits_xor, "^", [](std::uint32_t x, std::uint32_t y) { return x ^ y; }}};
    for (const Row& row : rows) {
        lanes().binary(row.op, a.data(), b.data(), got.data(), kPatterns);
        expect_each(a, b, got, row.name, NotANumber::exact,
                    [&](float x, float y) { return from_pattern(row.scalar(bits_of_float(x), bits_of_float(y))); });
    }
}

/// What a packet should say, lane by lane.
PacketFacts facts_of(const float* a, const float* b, int width) {
    PacketFacts facts{};
    facts.all_less = facts.none_less = true;
    facts.first = facts.largest = a[0];
    for (int k = 0; k < width; ++k) {
        const bool less = a[k]<b[k], positive = a[k]> 0;
        const auto set = [k](std::uint32_t& mask, bool value) { mask |= std::uint32_t{value} << k; };
        set(facts.less, less), set(facts.greater, a[k] > b[k]);
        set(facts.less_equal, a[k] <= b[k]), set(facts.greater_equal, a[k] >= b[k]);
        set(facts.equal, a[k] == b[k]), set(facts.unequal, a[k] != b[k]);
        set(facts.both, less && positive), set(facts.either, less || positive);
        set(facts.neither, !less && !positive), set(facts.chosen, less ? positive : !positive);
        facts.count_of_less += less;
        facts.any_less |= less, facts.all_less &= less, facts.none_less &= !less;
        facts.largest = facts.largest > a[k] ? facts.largest : a[k];
    }
    return facts;
}

TEST_P(Lanes, PacketSaysWhatItsLanesSay) {
    std::vector<PacketFacts> packets(static_cast<std::size_t>(kPatterns / width()));
    int numbers = 0;
    lanes().facts(a.data(), b.data(), packets.data(), kPatterns);
    for (std::size_t k = 0; k < packets.size(); ++k) {
        const std::size_t at = k * static_cast<std::size_t>(width());
        const PacketFacts& is = packets[k];
        const PacketFacts wanted = facts_of(&a[at], &b[at], width());
        SCOPED_TRACE(testing::Message() << "packet " << k << ", first lane " << a[at] << " against " << b[at]);
        ASSERT_EQ(is.less, wanted.less);
        ASSERT_EQ(is.greater, wanted.greater);
        ASSERT_EQ(is.less_equal, wanted.less_equal);
        ASSERT_EQ(is.greater_equal, wanted.greater_equal);
        ASSERT_EQ(is.equal, wanted.equal);
        ASSERT_EQ(is.unequal, wanted.unequal);
        ASSERT_EQ(is.both, wanted.both);
        ASSERT_EQ(is.either, wanted.either);
        ASSERT_EQ(is.neither, wanted.neither);
        ASSERT_EQ(is.chosen, wanted.chosen);
        ASSERT_EQ(is.count_of_less, wanted.count_of_less);
        ASSERT_EQ(is.any_less, wanted.any_less);
        ASSERT_EQ(is.all_less, wanted.all_less);
        ASSERT_EQ(is.none_less, wanted.none_less);
        ASSERT_EQ(bits_of_float(is.first), bits_of_float(wanted.first));
        if (std::any_of(&a[at], &a[at] + width(), [](float x) { return x != x; })) continue;
        ASSERT_EQ(is.largest, wanted.largest);
        ++numbers;
    }
    EXPECT_GT(numbers, 100) << "packets without a NaN";
}

// Every mask of a packet, so that no bit of count_of or bits_of is left to chance.
TEST_P(Lanes, EveryMaskIsCountedRight) {
    for (std::uint32_t mask = 0; mask < 1u << width(); ++mask) {
        float low[probes::kWidest], high[probes::kWidest] = {};
        for (int k = 0; k < probes::kWidest; ++k) low[k] = (mask >> (k % width()) & 1u) != 0 ? -1.0f : 1.0f;
        PacketFacts facts[probes::kWidest];
        lanes().facts(low, high, facts, probes::kWidest);
        ASSERT_EQ(facts[0].less, mask);
        ASSERT_EQ(facts[0].count_of_less, static_cast<std::uint32_t>(std::popcount(mask)));
    }
}

ZERKALO_OVER_ALL_WIDTHS(Lanes);

}  // namespace
}  // namespace zerkalo::test
