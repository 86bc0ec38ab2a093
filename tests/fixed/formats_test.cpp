// Which formats exist, what a product of them is, and what the compiler refuses.
#include "tests/fixed/fixed_values.hpp"
#include "tests/fixed/quantities.hpp"

#include <type_traits>

namespace zerkalo::test {
namespace {

template <class A, class B>
constexpr bool kRefuses = !Adds<A, B> && !Subtracts<A, B> && !Compares<A, B> && !TakesSmaller<A, B> &&
                          !std::is_convertible_v<A, B> && !std::is_convertible_v<B, A>;

template <class N>
struct Formats : testing::Test {};
using Widths = testing::Types<FixedNumbers<1>, FixedNumbers<4>, FixedNumbers<8>>;
TYPED_TEST_SUITE(Formats, Widths);

TYPED_TEST(Formats, DoNotMixWithEachOtherOrWithFloat) {
    using N = TypeParam;
    using L = Length<N>;
    using D = Direction<N>;
    static_assert(Adds<L, L> && Subtracts<L, L> && Compares<L, L> && TakesSmaller<L, L> && Multiplies<L, D>);
    static_assert(kRefuses<L, D> && kRefuses<L, Area<N>> && kRefuses<D, Area<N>> && kRefuses<Area<N>, Square<N>>);
    static_assert(kRefuses<L, float> && kRefuses<L, double> && kRefuses<D, float> && kRefuses<Area<N>, double>);
    static_assert(kRefuses<L, int> && kRefuses<D, long> && kRefuses<L, typename N::Index>);
    static_assert(!Multiplies<L, float> && !Multiplies<L, int> && !Multiplies<float, D>);
    static_assert(!Divides<L, L> && !Divides<L, float>);
    static_assert(!std::is_constructible_v<L, float> && !std::is_constructible_v<L, double>);
    static_assert(!std::is_constructible_v<L, D> && !std::is_constructible_v<float, L>);
    // A 64-bit product is rounded before it is a factor again.
    static_assert(!Multiplies<Area<N>, L> && !Multiplies<Area<N>, Area<N>>);
    SUCCEED() << "checked by the compiler";
}

TYPED_TEST(Formats, OfAProductIsTheSumOfTheFractions) {
    using N = TypeParam;
    using L = Length<N>;
    using D = Direction<N>;
    static_assert(std::is_same_v<decltype(L() * L()), Area<N>>);
    static_assert(std::is_same_v<decltype(D() * D()), Square<N>>);
    static_assert(decltype(L() * D())::kFraction == 57);
    static_assert(std::is_same_v<typename decltype(L() * D())::Element, std::int64_t>);
    // A uniform factor takes the width of the other one.
    static_assert(std::is_same_v<decltype(Len() * L()), Area<N>>);
    static_assert(std::is_same_v<decltype(L() - Len()), L>);
    SUCCEED() << "checked by the compiler";
}

TYPED_TEST(Formats, ArePlainDataOfTheirBits) {
    using N = TypeParam;
    static_assert(std::is_trivially_copyable_v<Length<N>> && std::is_trivially_default_constructible_v<Length<N>>);
    static_assert(sizeof(Length<N>) == 4 * kLanesOf<decltype(Length<N>::raw)>);
    static_assert(sizeof(Area<N>) == 8 * kLanesOf<decltype(Area<N>::raw)>);
    SUCCEED() << "checked by the compiler";
}

static_assert(!Adds<Length<FixedNumbers<4>>, Length<FixedNumbers<8>>>, "widths do not mix");
static_assert(!Multiplies<Length<FixedNumbers<4>>, Direction<FixedNumbers<8>>>, "widths do not mix");
static_assert(std::is_same_v<Uniform<FixedNumbers<8>>, FixedNumbers<1>>);

TEST(Formats, HoldWholeNumbersAndEndWhereTheyPromise) {
    EXPECT_EQ(real(Len(1)), 1);
    EXPECT_EQ(real(Dir(-1)), -1);
    EXPECT_EQ(real(Area<One>(3)), 3);
    EXPECT_EQ(real(far_away<Len>()), 16 - std::ldexp(1.0L, -27));
    EXPECT_EQ(real(far_away<Dir>()), 2 - std::ldexp(1.0L, -30));
    EXPECT_EQ(real(far_away<Area<One>>()), 512 - std::ldexp(1.0L, -54));
    EXPECT_EQ(real(Len(16)), real(far_away<Len>()));
    EXPECT_EQ(real(Len(-100)), -real(far_away<Len>()));
    EXPECT_EQ(far_away<Length<FixedNumbers<4>>>().raw.v[3], far_away<Len>().raw);
}

}  // namespace
}  // namespace zerkalo::test
