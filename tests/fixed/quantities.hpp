// Which quantities of a number system mix: what the compiler accepts of each pair of them.
#pragma once

#include "core/numeric/fixed.hpp"

#include <array>
#include <type_traits>

namespace zerkalo::test {

template <class A, class B>
concept Adds = requires(A a, B b) { a + b; };
template <class A, class B>
concept Subtracts = requires(A a, B b) { a - b; };
template <class A, class B>
concept Multiplies = requires(A a, B b) { a * b; };
template <class A, class B>
concept Divides = requires(A a, B b) { a / b; };
template <class A, class B>
concept Compares = requires(A a, B b) { a < b; };
template <class A, class B>
concept EqualsOrNot = requires(A a, B b) { a == b; };
template <class A, class B>
concept TakesSmaller = requires(A a, B b) { min(a, b); };
template <class M, class A, class B>
concept Chooses = requires(M mask, A a, B b) { select(mask, a, b); };

template <class M, class A, class B>
constexpr bool kMixes = Adds<A, B> || Subtracts<A, B> || Compares<A, B> || EqualsOrNot<A, B> || TakesSmaller<A, B> ||
                        Chooses<M, A, B> || std::is_assignable_v<A&, B> || std::is_constructible_v<A, B>;
template <class M, class A>
constexpr bool kWorks = Adds<A, A> && Subtracts<A, A> && Compares<A, A> && EqualsOrNot<A, A> && TakesSmaller<A, A> &&
                        Chooses<M, A, A> && std::is_assignable_v<A&, A>;
/// A whole number becomes a number of any quantity where that is written down.
template <class A, class X>
constexpr bool kMixesWithPlain = Adds<A, X> || Adds<X, A> || Subtracts<A, X> || Multiplies<A, X> || Multiplies<X, A> ||
                                 Divides<A, X> || Compares<A, X> || EqualsOrNot<A, X> || TakesSmaller<A, X> ||
                                 std::is_assignable_v<A&, X> || std::is_convertible_v<X, A> ||
                                 std::is_constructible_v<X, A>;

constexpr std::array kQuantityNames = {"Length",    "Curvature", "Ratio", "Direction", "Weight", "Radiance", "LightSum",
                                       "Area",      "Square",    "View",  "Fraction",  "Share",  "FarStep",  "Volume",
                                       "Moment",    "Inverse",   "Index", "Exponent",  "Pixels"};
constexpr int kQuantities = kQuantityNames.size();

/// Bit k of `with[i]`: quantity i mixes with k; of `with_uniform[i]`: with the k that all lanes share.
struct QuantityTable {
    std::uint32_t with[kQuantities], with_uniform[kQuantities];
    bool works[kQuantities], with_plain[kQuantities];
};

template <class... A>
struct TypesOf {};
template <class N>
using QuantitiesOf = TypesOf<Length<N>, Curvature<N>, Ratio<N>, Direction<N>, Weight<N>, Radiance<N>, LightSum<N>,
                             Area<N>, Square<N>, View<N>, Fraction<N>, Share<N>, FarStep<N>, Volume<N>, Moment<N>,
                             Inverse<N>, Index<N>, Exponent<N>, Pixels<N>>;

template <class M, class A, class... B>
consteval std::uint32_t mixing_with(TypesOf<B...>) {
    std::uint32_t bits = 0, bit = 1;
    ((bits |= kMixes<M, A, B> ? bit : 0, bit <<= 1), ...);
    return bits;
}

template <class N, class... A>
consteval QuantityTable table_of(TypesOf<A...> all) {
    using M = MaskOf<N>;
    static_assert(sizeof...(A) == kQuantities);
    return {{mixing_with<M, A>(all)...},
            {mixing_with<M, A>(QuantitiesOf<Uniform<N>>())...},
            {kWorks<M, A>...},
            {(kMixesWithPlain<A, float> || kMixesWithPlain<A, double> || kMixesWithPlain<A, int> ||
              kMixesWithPlain<A, long>)...}};
}
template <class N>
consteval QuantityTable quantity_table() {
    return table_of<N>(QuantitiesOf<N>());
}

}  // namespace zerkalo::test
