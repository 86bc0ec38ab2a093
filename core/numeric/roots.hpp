// The roots of A t^2 + 2 B t + C = 0, given its discriminant: the only place where they are computed.
//
// Stable form: q = -(B + sign(B) sqrt(B^2 - A C)), roots C / q and q / A. No difference of nearly equal numbers is
// formed, and A = 0 gives the single root -C / (2 B) beside an infinite one, without a branch.
// Source: Press, Teukolsky, Vetterling, Flannery, Numerical Recipes, section 5.6.
// The callers bring discriminants in factored form, because B^2 - A C itself cancels.
#pragma once

#include "core/numeric/number.hpp"

namespace zerkalo::inline ZERKALO_ISA {

/// In no particular order. `near_zero` is the root that is zero when C is zero.
template <class L>
struct RootPair {
    L near_zero, other;
};

/// Unit A (a sphere met by a unit direction). `disc` >= 0.
template <class L, class B, class D>
ZERKALO_INLINE RootPair<L> roots_of_unit_quadratic(B b, D c, D disc) {
    const L minus_b = -as<L>(b);
    const L q = minus_b + flip_sign(root<L>(disc), minus_b);
    return {quotient<L>(c, q), q};
}

/// Any A, also 0 and negative. `disc` >= 0. Q: the format of B and of q, S: that of the root.
template <class L, class Q, class S, class A, class B, class C, class D>
ZERKALO_INLINE RootPair<L> roots_of_quadratic(A a, B b, C c, D disc) {
    const Q minus_b = -as<Q>(b);
    const Q q = minus_b + flip_sign(as<Q>(root<S>(disc)), minus_b);
    return {quotient<L>(c, q), quotient<L>(q, a)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
