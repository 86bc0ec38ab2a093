// unit_of_integers() of fixed_elementary.hpp on lanes in vector registers: the same integers, lane by lane.
#pragma once

#include "core/numeric/vector_quotients.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

/// Components in 2^-30, and the length as it came.
template <class Lanes>
struct VectorUnit {
    VectorWords x, y, z;
    Lanes length;
};

/// Square root of a square sum of numbers of up to 31 bits, and 2^62 through it to nearest, at most 2^32 - 1: only of
/// 2^30 it would be one more, which no product with 31 bits tells.
struct LengthParts {
    Longs length, inverse;
};
ZERKALO_ONCE LengthParts exact_length_of(const UnsignedLongs& square) {
    const Longs length = each_part(
        [](UnsignedQuads x) ZERKALO_INLINE_LAMBDA { return nearest_root(x); }, square);
    const Longs inverse = each_part(
        [](Quads divisor) ZERKALO_INLINE_LAMBDA {
            const Doubles wide = 0x1p62 / double_of_small(divisor);
            constexpr double kMost = 0xffffffffp0;
            const Quads q = Quads((wide < kMost ? wide : Doubles{} + kMost) + 0x1p52) - 0x4330000000000000;
            const Quads product = Quads(low_product(UnsignedQuads(q), UnsignedQuads(divisor)));
            // q is right where 0 <= 2^62 + divisor / 2 - q divisor < divisor.
            const Quads rest = (std::int64_t{1} << 62) + Quads(UnsignedQuads(divisor) >> 1) - product;
            const Quads exact = q + Quads(rest < 0) - Quads(rest >= divisor);
            return exact - Quads(UnsignedQuads(exact) >> 32);
        },
        length);
    return {length, inverse};
}
/// The same by the float unit, and exactly only where that cannot tell.
ZERKALO_INLINE LengthParts length_of(const UnsignedLongs& x, const UnsignedLongs& y, const UnsignedLongs& z) {
    constexpr double kShift = 0x1p52, kMost = 0xffffffffp0;
    const UnsignedLongs square = each_part(
        [](UnsignedQuads a, UnsignedQuads b, UnsignedQuads c) ZERKALO_INLINE_LAMBDA {
            return low_product(a, a) + low_product(b, b) + low_product(c, c);
        },
        x, y, z);
    Quads unsettled{};
    const auto rounded = [&unsettled](Doubles exact) ZERKALO_INLINE_LAMBDA {
        const Doubles shifted = exact + kShift;
        unsettled |= near_halves(exact, shifted - kShift);
        return shifted;
    };
    const DoubleParts length = each_part(
        [&](UnsignedQuads sum) ZERKALO_INLINE_LAMBDA { return rounded(square_root(double_of(sum))); },
        square);
    const DoubleParts inverse = each_part(
        [&](Doubles shifted) ZERKALO_INLINE_LAMBDA {
            const Doubles wide = 0x1p62 / (shifted - kShift);
            return rounded(wide < kMost ? wide : Doubles{} + kMost);
        },
        length);
    if (signs_of(Words(unsettled)) != 0) return exact_length_of(square);
    const auto whole = [](Doubles shifted) ZERKALO_INLINE_LAMBDA { return Quads(shifted) & 0xfffffffffffff; };
    return {each_part(whole, length), each_part(whole, inverse)};
}

/// size inverse / 2^32 to nearest, in the high words.
ZERKALO_INLINE Longs share_of(const UnsignedLongs& size, const Longs& inverse) {
    return each_part(
        [](UnsignedQuads a, Quads b) ZERKALO_INLINE_LAMBDA {
            return Quads(low_product(a, UnsignedQuads(b)) + 0x80000000u);
        },
        size, inverse);
}
ZERKALO_INLINE VectorWords signed_share(const Longs& share, Words sign, Words zero) {
    return VectorWords(((high_words(share) ^ sign) - sign) & ~zero);
}

ZERKALO_ONCE VectorUnit<VectorWords> unit_of_lanes(VectorWords x, VectorWords y, VectorWords z) {
    const UnsignedWords a = magnitude_of(x.v), b = magnitude_of(y.v), c = magnitude_of(z.v);
    const UnsignedWords largest = a | b | c;
    const Words zero = Words(largest == 0);
    // No carry of the conversion reaches the next power of two where the second bit is clear.
    const auto floats = __builtin_convertvector(Words(largest & ~(largest >> 1)), Vector<float, kVectorWidth>);
    const UnsignedWords up = (157 - (UnsignedWords(floats) >> 23)) & 31u;  // the largest gets 31 bits
    const UnsignedLongs size_x = widened_unsigned(a << up), size_y = widened_unsigned(b << up),
                        size_z = widened_unsigned(c << up);
    const LengthParts parts = length_of(size_x, size_y, size_z);
    // Down again, to nearest; the highest bit is set only where nothing went up.
    const UnsignedWords length = UnsignedWords(low_words(parts.length));
    const Words moved = Words(up != 0);
    const UnsignedWords rounded = ((length >> ((up + UnsignedWords(moved)) & 31u)) + 1u) >> 1;
    const Words held = where_negative(Words(length), all_words(kMostWord), Words(length));
    const Words whole = where_negative(moved, Words(rounded), held);
    return {signed_share(share_of(size_x, parts.inverse), sign_of(x.v), zero),
            signed_share(share_of(size_y, parts.inverse), sign_of(y.v), zero),
            signed_share(share_of(size_z, parts.inverse), sign_of(z.v), zero), VectorWords(whole)};
}

ZERKALO_ONCE VectorUnit<VectorLongs> unit_of_lanes(const VectorLongs& x, const VectorLongs& y, const VectorLongs& z) {
    const auto magnitude = [](Quads p) ZERKALO_INLINE_LAMBDA { return magnitude_of(p); };
    const UnsignedLongs a = each_part(magnitude, x.v), b = each_part(magnitude, y.v), c = each_part(magnitude, z.v);
    const UnsignedLongs largest = each_part(
        [](UnsignedQuads p, UnsignedQuads q, UnsignedQuads r) ZERKALO_INLINE_LAMBDA { return p | q | r; }, a, b, c);
    // Up by 30 - e where 2^e is the largest power of two in it, or down.
    const Longs up = each_part(
        [](UnsignedQuads p) ZERKALO_INLINE_LAMBDA {
            return 1023 + 30 - Quads(UnsignedQuads(double_of(p & ~(p >> 1))) >> 52);
        },
        largest);
    const auto to_left = [](Quads shift) ZERKALO_INLINE_LAMBDA { return UnsignedQuads(shift & ~sign_of(shift)) & 63u; };
    const UnsignedLongs left = each_part(to_left, up);
    const UnsignedLongs right = each_part([&](Quads shift) ZERKALO_INLINE_LAMBDA { return to_left(-shift); }, up);
    const auto shifted = [](UnsignedQuads p, UnsignedQuads l, UnsignedQuads r) ZERKALO_INLINE_LAMBDA {
        return ((p << l) + (((UnsignedQuads{} + 1u) << r) >> 1)) >> r;
    };
    const UnsignedLongs size_x = each_part(shifted, a, left, right), size_y = each_part(shifted, b, left, right),
                        size_z = each_part(shifted, c, left, right);
    const LengthParts parts = length_of(size_x, size_y, size_z);
    const Longs whole = each_part(
        [&](Quads length, UnsignedQuads l, UnsignedQuads r) ZERKALO_INLINE_LAMBDA {
            const Quads back = Quads(shifted(UnsignedQuads(length), r, l));
            return where_negative(back, Quads{} + kMostLong, back);
        },
        parts.length, left, right);
    const Words zero = narrow_mask(
        each_part([](UnsignedQuads p) ZERKALO_INLINE_LAMBDA { return Quads(p == 0); }, largest));
    return {signed_share(share_of(size_x, parts.inverse), sign_of(high_words(x.v)), zero),
            signed_share(share_of(size_y, parts.inverse), sign_of(high_words(y.v)), zero),
            signed_share(share_of(size_z, parts.inverse), sign_of(high_words(z.v)), zero), VectorLongs(whole)};
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
