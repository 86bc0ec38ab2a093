// Lengths in vector registers before they are rounded: doubles, in steps of the format, off by 2^-21 at most.
//
// Rounding keeps the order of numbers, so the larger of many is rounded once, at the end. What the order decides besides
// (which face a ray meets) is doubtful where two are so close that they may round to one: then the integers are asked.
#pragma once

#include "core/geometry/ray.hpp"
#include "core/numeric/fixed_vectors.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

/// The format is Length's; |x| is at most its largest number, but for what lies below.
struct UnroundedLength {
    DoubleParts v;

    static ZERKALO_INLINE UnroundedLength of_steps(double steps) { return {{Doubles{} + steps, Doubles{} + steps}}; }
    static ZERKALO_INLINE UnroundedLength far_away() { return of_steps(kMostWord); }
};

ZERKALO_INLINE UnroundedLength operator-(const UnroundedLength& a) {
    return {each_part([](Doubles x) ZERKALO_INLINE_LAMBDA { return -x; }, a.v)};
}
ZERKALO_INLINE UnroundedLength min(const UnroundedLength& a, const UnroundedLength& b) {
    return {each_part([](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA { return x < y ? x : y; }, a.v, b.v)};
}
ZERKALO_INLINE UnroundedLength max(const UnroundedLength& a, const UnroundedLength& b) {
    return {each_part([](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA { return x > y ? x : y; }, a.v, b.v)};
}

/// Where a > b: the sign of b - a. The distance of the closest two that an answer depends on.
struct UnroundedOrder {
    DoubleParts below;
    Doubles closest;
};
ZERKALO_INLINE Doubles size_of(Doubles x) { return Doubles(Quads(x) & kMostLong); }
ZERKALO_INLINE Doubles smaller(Doubles x, Doubles y) { return x < y ? x : y; }

ZERKALO_INLINE UnroundedOrder operator>(const UnroundedLength& a, const UnroundedLength& b) {
    const DoubleParts below = each_part([](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA { return y - x; }, a.v, b.v);
    return {below, smaller(size_of(below.even), size_of(below.odd))};
}
ZERKALO_INLINE UnroundedOrder operator<(const UnroundedLength& a, const UnroundedLength& b) { return b > a; }
ZERKALO_INLINE UnroundedLength select(const UnroundedOrder& order, const UnroundedLength& a, const UnroundedLength& b) {
    return {each_part(
        [](Doubles m, Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA {
            return Doubles(where_negative(Quads(m), Quads(x), Quads(y)));
        },
        order.below, a.v, b.v)};
}

/// A number that was chosen by such orders.
struct UnroundedIndex {
    Words v;
    Doubles closest;

    UnroundedIndex() = default;
    ZERKALO_INLINE UnroundedIndex(Words raw, Doubles distance) : v(raw), closest(distance) {}
    ZERKALO_INLINE explicit UnroundedIndex(int k) : UnroundedIndex(all_words(k), Doubles{} + double(kMostWord)) {}
    ZERKALO_INLINE explicit UnroundedIndex(FixedFormats::Index k) : UnroundedIndex(k.raw) {}
};
ZERKALO_INLINE UnroundedIndex select(const UnroundedOrder& order, const UnroundedIndex& a, const UnroundedIndex& b) {
    const Words above = high_words({Quads(order.below.even), Quads(order.below.odd)});
    return {where_negative(above, a.v, b.v), smaller(order.closest, smaller(a.closest, b.closest))};
}

/// A fixed-point system whose lengths are not rounded yet.
struct UnroundedNumbers : FixedNumbers<kVectorWidth, Vectors> {
    using Length = UnroundedLength;
    using Index = UnroundedIndex;
};
template <>
struct UnroundedOf<FixedNumbers<kVectorWidth, Vectors>> { using type = UnroundedNumbers; };

/// As of rounded numbers: a / 0 is on a's side, of 0 / 0 the upper end.
template <class To, class A, Format FA, class B, Format FB>
    requires std::same_as<To, UnroundedLength> && SingleWord<A> && SingleWord<B>
ZERKALO_INLINE QuotientPair<To> quotients(Fixed<A, FA> first, Fixed<A, FA> second, Fixed<B, FB> divisor) {
    constexpr int kUp = FixedFormats::Length::kFraction - FA.fraction + FB.fraction;
    const DoubleParts inverse = each_part(
        [](Doubles y) ZERKALO_INLINE_LAMBDA { return double(std::int64_t{1} << kUp) / y; }, doubles_of(divisor.raw.v));
    const auto one = [&](auto a) ZERKALO_INLINE_LAMBDA {
        return UnroundedLength{each_part(
            [](Doubles x, Doubles y) ZERKALO_INLINE_LAMBDA {
                const Doubles q = x * y;
                return q < double(kMostWord) ? q : Doubles{} + double(kMostWord);
            },
            doubles_of(a), inverse)};
    };
    return {one(factor_of(first.raw)), one(factor_of(second.raw))};
}

/// Whether no lane's span holds anything, rounded or not.
ZERKALO_INLINE bool is_empty(const Span<UnroundedNumbers>& span) {
    const auto open = each_part(
        [](Doubles entry, Doubles exit) ZERKALO_INLINE_LAMBDA { return Quads(entry <= exit + 1.0); }, span.entry.v,
        span.exit.v);
    return signs_of(narrow_mask(open)) == 0;
}

/// The integers nearest to the lengths; `unsettled`: where halves are so close that these may be others.
ZERKALO_INLINE Words nearest_steps(const UnroundedLength& x, Quads& unsettled) {
    const DoubleParts within = each_part(
        [](Doubles y) ZERKALO_INLINE_LAMBDA { return y > -double(kMostWord) ? y : Doubles{} - double(kMostWord); },
        x.v);
    const DoubleParts shifted = each_part([](Doubles y) ZERKALO_INLINE_LAMBDA { return y + 0x1.8p52; }, within);
    const auto close = each_part(
        [](Doubles y, Doubles s) ZERKALO_INLINE_LAMBDA { return near_halves(y, s - 0x1.8p52); }, within, shifted);
    unsettled |= close.even | close.odd;
    return alternating(Words(shifted.even), Words(UnsignedQuads(shifted.odd) << 32));
}

/// Rounds the span. False where the integers must be asked.
template <class N>
ZERKALO_INLINE bool settle(const Span<UnroundedNumbers>& span, Span<N>& rounded) {
    // Two that are farther apart do not round to one.
    constexpr double kApart = 1 + 0x1p-19;
    Quads unsettled = Quads(smaller(span.face_in.closest, span.face_out.closest) < kApart);
    rounded.entry = fixed_of<Length<N>::kFormat>(nearest_steps(span.entry, unsettled));
    rounded.exit = fixed_of<Length<N>::kFormat>(nearest_steps(span.exit, unsettled));
    rounded.face_in = fixed_of<Index<N>::kFormat>(span.face_in.v);
    rounded.face_out = fixed_of<Index<N>::kFormat>(span.face_out.v);
    return signs_of(Words(unsettled)) == 0;
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
