// Integer arithmetic under fixed point that must keep every digit. With ZERKALO_CHECKED_FIXED each of these operations
// ends the program, and names itself, where the result does not fit; without, it is the plain operation.
//
// Unsigned phases and hashes wrap on purpose and do not come here; numbers that are held at the ends of their format say
// so where they are (saturated).
#pragma once

#include "core/numeric/isa.hpp"

#include <concepts>
#include <limits>
#include <type_traits>

namespace zerkalo {

#if defined(ZERKALO_CHECKED_FIXED)
constexpr bool kCheckedFixed = true;
#else
constexpr bool kCheckedFixed = false;
#endif

/// Says on the standard error stream which operation lost digits, and aborts (tools/digits_lost.cpp). Exists in checked
/// builds alone.
[[noreturn]] void digits_lost(const char* operation);

/// a + b of one type.
template <std::integral T>
ZERKALO_INLINE constexpr T checked_sum(T a, std::type_identity_t<T> b, [[maybe_unused]] const char* operation) {
    if constexpr (kCheckedFixed) {
        T sum{};
        if (__builtin_add_overflow(a, b, &sum)) digits_lost(operation);
        return sum;
    } else {
        return static_cast<T>(a + b);
    }
}

/// a b of one type.
template <std::integral T>
ZERKALO_INLINE constexpr T checked_product(T a, std::type_identity_t<T> b, [[maybe_unused]] const char* operation) {
    if constexpr (kCheckedFixed) {
        T product{};
        if (__builtin_mul_overflow(a, b, &product)) digits_lost(operation);
        return product;
    } else {
        return static_cast<T>(a * b);
    }
}

/// x 2^bits of an unsigned x.
template <std::unsigned_integral T>
ZERKALO_INLINE constexpr T checked_shift(T x, int bits, [[maybe_unused]] const char* operation) {
    if constexpr (kCheckedFixed) {
        if (bits < 0 || bits >= std::numeric_limits<T>::digits) digits_lost(operation);
        if (static_cast<T>(x << bits) >> bits != x) digits_lost(operation);
    }
    return static_cast<T>(x << bits);
}

/// x in a type that may be smaller, or have no sign.
template <std::integral To, std::integral From>
ZERKALO_INLINE constexpr To checked_narrow(From x, [[maybe_unused]] const char* operation) {
    if constexpr (kCheckedFixed) {
        To same{};
        if (__builtin_add_overflow(x, From{0}, &same)) digits_lost(operation);
    }
    return static_cast<To>(x);
}

}  // namespace zerkalo
