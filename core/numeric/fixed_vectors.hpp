// The operators of fixed.hpp on lanes in vector registers; they give what each lane alone would give. Where one is
// missing, that of fixed.hpp serves, lane by lane.
#pragma once

#include "core/numeric/fixed.hpp"
#include "core/numeric/vector_unit.hpp"

#if defined(ZERKALO_INT_VECTORS)
namespace zerkalo::inline ZERKALO_ISA {

template <class... A>
concept InVectors = (IntLaneTraits<A>::kInVectors || ...);

template <class T>
struct FixedNumbersOf<VectorInts<T, kVectorWidth>> { using type = FixedNumbers<kVectorWidth, Vectors>; };

/// A mask of vector registers as bits, which becomes one again where it is used.
struct VectorMaskBits {
    using Bits = std::conditional_t<(kVectorWidth > 8), std::uint16_t, std::uint8_t>;
    Bits bits;

    VectorMaskBits() = default;
    static ZERKALO_INLINE VectorMask of_bits(std::uint32_t bits) {
        VectorMaskBits stored;
        stored.bits = static_cast<Bits>(bits);
        return stored;
    }
    ZERKALO_INLINE VectorMaskBits(VectorMask m) : bits(static_cast<Bits>(bits_of(m))) {}
    ZERKALO_INLINE operator VectorMask() const {
        Words own{};
        for (int k = 0; k < kVectorWidth; ++k) own[k] = 1 << k;
        return VectorMask(Words((all_words(bits) & own) != 0));
    }
};
template <>
struct StoredMaskOf<FixedNumbers<kVectorWidth, Vectors>> { using type = VectorMaskBits; };

/// The registers; of a plain integer, the same in all lanes.
template <class A>
ZERKALO_INLINE auto registers_of(const A& raw) {
    if constexpr (IntLaneTraits<A>::kInVectors) {
        return raw.v;
    } else if constexpr (std::same_as<A, std::int32_t>) {
        return all_words(raw);
    } else {
        return all_longs(raw);
    }
}
/// 64 bits of each lane, whichever there are.
ZERKALO_INLINE Longs longs_of(Words x) { return widened(x); }
ZERKALO_INLINE Longs longs_of(const Longs& x) { return x; }
/// Of a word: a uniform factor needs no odd lanes of its own.
template <class A>
ZERKALO_INLINE auto factor_of(const A& raw) {
    if constexpr (IntLaneTraits<A>::kInVectors) {
        return raw.v;
    } else {
        return raw;
    }
}
template <Format F>
ZERKALO_INLINE auto fixed_of(Words raw) { return with_format<F>(VectorWords(raw)); }
template <Format F>
ZERKALO_INLINE auto fixed_of(const Longs& raw) { return with_format<F>(VectorLongs(raw)); }

/// The nearest floats, in steps of the format.
using Floats = Vector<float, kVectorWidth>;
template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE Floats steps_of(Fixed<A, F> a) {
    return __builtin_convertvector(a.raw.v, Floats);
}
template <Format F>
ZERKALO_INLINE float steps_of(Fixed<std::int32_t, F> a) {
    return float(a.raw);
}
/// Lanes of the mask for which a float said yes.
ZERKALO_INLINE bool any_of(VectorMask mask, const Words& yes) { return (bits_of(mask) & signs_of(yes)) != 0; }

template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE auto operator+(Fixed<A, F> a, Fixed<B, F> b) {
    return fixed_of<F>(held_sum(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE auto operator-(Fixed<A, F> a, Fixed<B, F> b) {
    return fixed_of<F>(held_difference(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE auto fitting_sum(Fixed<A, F> a, Fixed<B, F> b) {
    return fixed_of<F>(fitting_sum(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE auto fitting_difference(Fixed<A, F> a, Fixed<B, F> b) {
    return fixed_of<F>(fitting_difference(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, Format F>
    requires InVectors<A>
ZERKALO_INLINE auto operator-(Fixed<A, F> a) {
    return fixed_of<F>(negative(a.raw.v));
}
template <class A, Format FA, class B, Format FB>
    requires SingleWord<A> && SingleWord<B> && SameWidth<A, B> && InVectors<A, B>
ZERKALO_INLINE auto operator*(Fixed<A, FA> a, Fixed<B, FB> b) {
    return fixed_of<FA + FB>(full_product(factor_of(a.raw), factor_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE VectorMask operator<(Fixed<A, F> a, Fixed<B, F> b) {
    return VectorMask(is_less(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE VectorMask operator==(Fixed<A, F> a, Fixed<B, F> b) {
    return VectorMask(is_equal(registers_of(a.raw), registers_of(b.raw)));
}
template <class A, class B, Format F>
    requires SameElement<A, B> && InVectors<A, B>
ZERKALO_INLINE VectorMask operator!=(Fixed<A, F> a, Fixed<B, F> b) {
    return !(a == b);
}

ZERKALO_INLINE VectorMask select(VectorMask m, VectorMask a, VectorMask b) {
    return VectorMask(chosen(m.v, a.v, b.v));
}
template <class A, class B, Format F>
    requires SameElement<A, B>
ZERKALO_INLINE auto select(VectorMask m, Fixed<A, F> a, Fixed<B, F> b) {
    return fixed_of<F>(chosen(m.v, registers_of(a.raw), registers_of(b.raw)));
}
template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE auto min(Fixed<A, F> a, Fixed<A, F> b) {
    return fixed_of<F>(a.raw.v < b.raw.v ? a.raw.v : b.raw.v);
}
template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE auto max(Fixed<A, F> a, Fixed<A, F> b) {
    return fixed_of<F>(a.raw.v > b.raw.v ? a.raw.v : b.raw.v);
}
template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE Fixed<A, F> flip_sign(Fixed<A, F> a, Fixed<A, F> sign) {
    const Words s = sign_of(sign.raw.v);
    return fixed_of<F>((a.raw.v ^ s) - s);
}

template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE Fixed<A, F> absolute(Fixed<A, F> a) {
    return fixed_of<F>(Words(magnitude_of(a.raw.v)));
}

template <class To, class A, Format F>
    requires InVectors<A>
ZERKALO_INLINE To as(Fixed<A, F> value) {
    constexpr int kShift = F.fraction - To::kFraction;
    constexpr bool kToWords = std::same_as<typename To::Element, std::int32_t>;
    if constexpr (std::same_as<typename To::Element, LaneElement<A>> && kShift == 0) {
        return with_format<To::kFormat>(value.raw);
    } else if constexpr (SingleWord<A> && kToWords) {
        return fixed_of<To::kFormat>(rescaled_words<kShift>(value.raw.v));
    } else if constexpr (kToWords) {
        static_assert(kShift > 0);
        return fixed_of<To::kFormat>(rescaled_words<kShift>(value.raw.v));
    } else if constexpr (SingleWord<A> && kShift <= 0 && kShift >= -32) {
        return fixed_of<To::kFormat>(raised_longs<-kShift>(value.raw.v));
    } else if constexpr (!SingleWord<A> && kShift > 1) {
        return fixed_of<To::kFormat>(rescaled_longs<kShift>(value.raw.v));
    } else {
        using T = typename To::Element;
        return with_format<To::kFormat>(
            each_lane([](std::int64_t x) { return rescaled<T, kShift>(x); }, value.raw));
    }
}

template <class To, class A, Format F>
    requires InVectors<A> && SingleWord<typename To::Representation> && (!SingleWord<A>)
ZERKALO_INLINE To rounded(Fixed<A, F> value) {
    return fixed_of<To::kFormat>(rounded_words<F.fraction - To::kFraction>(value.raw.v));
}

/// A word times 64 bits, rounded once.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<A, B> && SingleWord<A> && (!SingleWord<B>) &&
             ((SingleWord<typename To::Representation> && (FA + FB).fraction - To::kFraction > 32) ||
              (!SingleWord<typename To::Representation> && (FA + FB).fraction - To::kFraction <= 32))
ZERKALO_INLINE To product(Fixed<A, FA> a, Fixed<B, FB> b) {
    constexpr int kShift = (FA + FB).fraction - To::kFraction;
    if constexpr (SingleWord<typename To::Representation>) {
        return fixed_of<To::kFormat>(rescaled_product_words<kShift>(registers_of(a.raw), registers_of(b.raw)));
    } else {
        return fixed_of<To::kFormat>(rescaled_product_longs<kShift>(registers_of(a.raw), registers_of(b.raw)));
    }
}

/// 64 bits times 64 bits, rounded once; neither is negative.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<A, B> && (!SingleWord<A>) && (!SingleWord<B>) && (!SingleWord<typename To::Representation>) &&
             ((FA + FB).fraction - To::kFraction > 0 && (FA + FB).fraction - To::kFraction < 64)
ZERKALO_INLINE To share_product(Fixed<A, FA> a, Fixed<B, FB> b) {
    return fixed_of<To::kFormat>(
        rescaled_wide_product<(FA + FB).fraction - To::kFraction>(registers_of(a.raw), registers_of(b.raw)));
}

/// 64 bits times 64 bits as a word, rounded once.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<A, B> && (!SingleWord<A>) && (!SingleWord<B>) && SingleWord<typename To::Representation>
ZERKALO_INLINE To product(Fixed<A, FA> a, Fixed<B, FB> b) {
    return fixed_of<To::kFormat>(rescaled_wide_product_words<(FA + FB).fraction - To::kFraction>(
        registers_of(a.raw), registers_of(b.raw)));
}

/// As a word, by 64 bits.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<A, B> && (!SingleWord<B>) && SingleWord<typename To::Representation> &&
             (Fixed<A, FA>::kValueBits + To::kFraction - FA.fraction + FB.fraction > 63)
ZERKALO_INLINE To quotient(Fixed<A, FA> a, Fixed<B, FB> b) {
    constexpr int kShift = To::kFraction - FA.fraction + FB.fraction;
    return with_format<To::kFormat>(
        long_quotient_words<kShift>(VectorLongs(longs_of(registers_of(a.raw))), VectorLongs(registers_of(b.raw))));
}

/// A word as the quotient by a word.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<A, B> && SingleWord<B> && SingleWord<typename To::Representation> &&
             (Fixed<A, FA>::kValueBits + To::kFraction - FA.fraction + FB.fraction <= 63)
ZERKALO_INLINE To quotient(Fixed<A, FA> a, Fixed<B, FB> b) {
    constexpr int kShift = To::kFraction - FA.fraction + FB.fraction;
    if constexpr (SingleWord<A>) {
        return fixed_of<To::kFormat>(
            rounded_quotient<kShift>(registers_of(a.raw), registers_of(b.raw)));
    } else {
        static_assert(kShift == 0);
        return fixed_of<To::kFormat>(rounded_quotient(registers_of(a.raw), registers_of(b.raw)));
    }
}

/// As 64 bits: of a word by a word, for 33 more bits.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<B> && SingleWord<A> && SingleWord<B> && (!SingleWord<typename To::Representation>) &&
             (To::kFraction - FA.fraction + FB.fraction == 33)
ZERKALO_INLINE To quotient(Fixed<A, FA> a, Fixed<B, FB> b) {
    return fixed_of<To::kFormat>(long_quotient_longs(registers_of(a.raw), registers_of(b.raw)));
}

/// Two words by one.
template <class To, class A, Format FA, class B, Format FB>
    requires InVectors<B> && SingleWord<A> && SingleWord<B> && SingleWord<typename To::Representation>
ZERKALO_INLINE QuotientPair<To> quotients(Fixed<A, FA> first, Fixed<A, FA> second, Fixed<B, FB> divisor) {
    const WordPair pair = rounded_quotients<To::kFraction - FA.fraction + FB.fraction>(
        factor_of(first.raw), factor_of(second.raw), divisor.raw.v);
    return {fixed_of<To::kFormat>(pair.first), fixed_of<To::kFormat>(pair.second)};
}

template <class To, class A, Format F>
    requires InVectors<A> && SingleWord<typename To::Representation>
ZERKALO_INLINE To root(Fixed<A, F> a) {
    static_assert(F.fraction == 2 * To::kFraction, "a root has half the fraction bits");
    return fixed_of<To::kFormat>(nearest_root(a.raw.v));
}

template <class A, class B, Format F>
    requires InVectors<A>
ZERKALO_INLINE VectorMask ahead_of(Fixed<B, F> t_min, Fixed<A, F> t, Fixed<A, F> along) {
    const Words root = along.raw.v;
    return (t > t_min) & VectorMask(Words((t.raw.v < kMostWord) & (root < kMostWord) & (root > -kMostWord)));
}

template <class A, Format F>
    requires InVectors<A> && (!SingleWord<A>)
ZERKALO_INLINE Fixed<A, F> plus_where(VectorMask mask, Fixed<A, F> a, Fixed<A, F> b) {
    return fixed_of<F>(each_part(
        [](Quads x, Quads y, Quads m) ZERKALO_INLINE_LAMBDA {
            const Quads sum = Quads(UnsignedQuads(x) + UnsignedQuads(y & m));
            return where_negative(sum, Quads{} + kMostLong, sum);
        },
        a.raw.v, b.raw.v, wide_mask(mask.v)));
}

template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE Fixed<A, F> plus_where(VectorMask mask, Fixed<A, F> a, Fixed<A, F> b) {
    const Words sum = Words(UnsignedWords(a.raw.v) + UnsignedWords(b.raw.v & mask.v));
    return fixed_of<F>(where_negative(sum, all_words(kMostWord), sum));
}

template <class A, Format F>
    requires InVectors<A> && SingleWord<A>
ZERKALO_INLINE Fixed<A, F> times(Fixed<A, F> a, std::int32_t n) {
    return fixed_of<F>(a.raw.v * n);
}

}  // namespace zerkalo::inline ZERKALO_ISA
#endif
