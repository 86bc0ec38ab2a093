// The numbers of the plan as plain data: float, double, or fixed-point formats. Outside of the instruction sets'
// namespaces, so that all kernels read one plan; the arithmetic is theirs (number.hpp, fixed.hpp).
#pragma once

#include "core/numeric/checked.hpp"

#include <concepts>
#include <cstdint>
#include <limits>

namespace zerkalo {

/// W integers, or W booleans. A width of 1 is the integer itself, never this.
template <class T, int W>
struct IntLanes {
    static_assert(W > 1);
    T v[W];

    IntLanes() = default;
    /// The same in all lanes.
    ZERKALO_INLINE constexpr explicit IntLanes(T uniform) {
        for (int k = 0; k < W; ++k) v[k] = uniform;
    }
};

/// kInVectors: lanes in vector registers (vector_lanes.hpp). Like: lanes of the same kind of another type.
template <class X>
struct IntLaneTraits {
    using Element = X;
    static constexpr int kWidth = 1;
    static constexpr bool kInVectors = false;
};
template <class T, int W>
struct IntLaneTraits<IntLanes<T, W>> {
    using Element = T;
    static constexpr int kWidth = W;
    static constexpr bool kInVectors = false;
    template <class U>
    using Like = IntLanes<U, W>;
};
template <class X>
using LaneElement = typename IntLaneTraits<X>::Element;
template <class X>
constexpr int kLanesOf = IntLaneTraits<X>::kWidth;

template <class T, int W>
struct IntLanesOf { using type = IntLanes<T, W>; };
template <class T>
struct IntLanesOf<T, 1> { using type = T; };

/// W values of type T: T itself at width 1.
template <class T, int W>
using Ints = typename IntLanesOf<T, W>::type;

/// A plain integer in all lanes.
template <class X>
ZERKALO_INLINE constexpr X in_all_lanes(LaneElement<X> uniform) {
    return X(uniform);
}

/// The largest value that a format of this type holds; the smallest is its negative, so that -x always exists.
template <std::signed_integral T>
constexpr T kLargest = std::numeric_limits<T>::max();

/// What a number of fixed point measures. `unnamed`: what no other number has the bits of, and products and their sums.
enum class Quantity : std::uint8_t {
    unnamed,
    length,
    curvature,
    ratio,
    direction,
    weight,
    light,
    share,
    fraction,
    view,
    far_step
};

/// Fraction bits and quantity. Numbers mix where both agree.
struct Format {
    int fraction;
    Quantity quantity;

    ZERKALO_INLINE constexpr Format(int bits, Quantity of = Quantity::unnamed) : fraction(bits), quantity(of) {}
    friend constexpr bool operator==(const Format&, const Format&) = default;
};
/// Of a product: the fractions add up; with light it is light.
ZERKALO_INLINE constexpr Format operator+(Format a, Format b) {
    const bool is_light = a.quantity == Quantity::light || b.quantity == Quantity::light;
    return {a.fraction + b.fraction, is_light ? Quantity::light : Quantity::unnamed};
}

/// A number that is an integer times 2^-F.fraction: see fixed.hpp.
/// Rep: std::int32_t, std::int64_t or lanes of them. The raw integers never hold the most negative value.
template <class Rep, Format F>
struct Fixed {
    using Representation = Rep;
    using Element = LaneElement<Rep>;
    static constexpr Format kFormat = F;
    static constexpr int kFraction = F.fraction;
    static constexpr int kValueBits = std::numeric_limits<Element>::digits;
    static_assert(std::same_as<Element, std::int32_t> || std::same_as<Element, std::int64_t>);
    static_assert(kFraction >= 0 && kFraction < kValueBits);

    Rep raw;

    Fixed() = default;
    /// A whole number, the same in all lanes, held at the ends of the format.
    template <std::same_as<int> Whole>
    ZERKALO_INLINE constexpr explicit Fixed(Whole whole) : raw(in_all_lanes<Rep>(raw_of(whole))) {}
    /// A uniform number of the same format in all lanes.
    template <std::same_as<LaneElement<Rep>> U>
        requires(kLanesOf<Rep> > 1)
    ZERKALO_INLINE constexpr Fixed(Fixed<U, F> uniform) : raw(in_all_lanes<Rep>(uniform.raw)) {}

    /// The number with this integer; the most negative integer stands for the one above it.
    static ZERKALO_INLINE constexpr Fixed from_raw(Rep raw) {
        Fixed result{};
        if constexpr (kLanesOf<Rep> == 1) {
            result.raw = raw < -kLargest<Element> ? -kLargest<Element> : raw;
        } else {
            for (int k = 0; k < kLanesOf<Rep>; ++k) {
                result.raw.v[k] = raw.v[k] < -kLargest<Element> ? -kLargest<Element> : raw.v[k];
            }
        }
        return result;
    }
    static ZERKALO_INLINE constexpr Fixed far_away() {
        Fixed result{};
        result.raw = in_all_lanes<Rep>(kLargest<Element>);
        return result;
    }

private:
    static ZERKALO_INLINE constexpr Element raw_of(int whole) {
        constexpr Element kMost = kLargest<Element> >> kFraction;
        if (whole > kMost) return kLargest<Element>;
        if (whole < -kMost) return -kLargest<Element>;
        return checked_product<Element>(whole, Element{1} << kFraction, "a whole number");
    }
};

/// Every constant of a plan is a T: float or double.
template <class T>
struct FloatingFormats {
    static constexpr bool kFixed = false;
    static constexpr double kLeastShare = std::numeric_limits<T>::epsilon() / 2;  // of full brightness, worth adding
    using Length = T;
    using Direction = T;
    using Area = T;
    using Curvature = T;
    using Inverse = T;
    using Ratio = T;
    using Index = T;
    using Weight = T;
    using Radiance = T;
    using Exponent = T;
    using Share = T;
    using View = T;
    using FarStep = T;
    using Edge = T;
    using PixelBound = T;
};
using FloatFormats = FloatingFormats<float>;
using DoubleFormats = FloatingFormats<double>;

/// Fixed point, one number: which format a quantity has.
struct FixedFormats {
    static constexpr bool kFixed = true;
    static constexpr double kLeastShare = 0x1p-24;  // as of float
    template <int bits, Quantity quantity>
    using Word = Fixed<std::int32_t, Format{bits, quantity}>;
    using Length = Word<27, Quantity::length>;        // -16..16, step 7.5e-9
    using Direction = Word<30, Quantity::direction>;  // -2..2, step 9.3e-10
    using Area = Fixed<std::int64_t, 54>;             // -512..512: a length times a length
    using Curvature = Fixed<std::int64_t, Format{59, Quantity::curvature}>;  // -16..16; R = 2^30 keeps 30 bits
    using Inverse = Fixed<std::int64_t, 36>;          // 1 / length, to 1.3e8
    using Ratio = Word<27, Quantity::ratio>;          // of refractive indices, slopes
    using Index = Fixed<std::int32_t, 0>;
    using Weight = Word<30, Quantity::weight>;        // shares of light: 1 is exact
    using Radiance = Word<24, Quantity::light>;       // to 128, step 6e-8
    using Exponent = Fixed<std::int64_t, 24>;         // n of a cosine power, to 5e11
    using Share = Fixed<std::int64_t, Format{61, Quantity::share}>;   // 1 / (n + 1)
    using View = Fixed<std::int64_t, Format{60, Quantity::view}>;     // a camera ray before normalising
    using FarStep = Fixed<std::int64_t, Format{54, Quantity::far_step}>;  // what a pixel moves a far camera's origin
    using Edge = Direction;                           // of an outline, as unit vectors
    using PixelBound = std::int32_t;
};

}  // namespace zerkalo
