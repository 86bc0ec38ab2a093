// The square root of a 64-bit integer, in two ways that give the same integer: with the float unit, and without one.
//
// Both make an estimate that is off by at most one, and one exact comparison settles it. ZERKALO_INTEGERS_ONLY chooses
// the second: a table and Newton's iteration y <- y (3 - x y^2) / 2 for 1 / sqrt(x), which squares the error.
#pragma once

#include "core/numeric/fixed_lanes.hpp"

#include <array>

namespace zerkalo::inline ZERKALO_ISA {

/// 2^8 / sqrt(k / 256) at the middle of each of the 192 intervals k, k + 1 from 64 on: off by 2^-8 of itself or less.
constexpr std::array<std::uint16_t, 192> kInverseRoots = [] {
    std::array<std::uint16_t, 192> table{};
    for (std::uint64_t k = 64; k < 256; ++k) {
        // The largest y with y^2 (k + 1/2) / 256 <= 2^16.
        std::uint64_t y = 256;
        while ((y + 1) * (y + 1) * (2 * k + 1) <= std::uint64_t{1} << 25) ++y;
        table[k - 64] = static_cast<std::uint16_t>(y);
    }
    return table;
}();

/// An integer at most one away from the root of x > 0 rounded down.
ZERKALO_INLINE constexpr std::uint64_t estimated_root_of_integers(std::uint64_t x) {
    const int even = leading_zeros(x) & ~1;
    const std::uint64_t m = checked_shift(x, even, "root");  // 2^62 <= m < 2^64
    std::uint64_t y = std::uint64_t{kInverseRoots[(m >> 56) - 64]} << 22;  // 1 / sqrt(m / 2^64), times 2^30
    for (int step = 0; step < 2; ++step) {
        const std::uint64_t product = checked_product(m >> 32, checked_product(y, y, "root") >> 30, "root") >> 32;
        y = checked_product(y, (std::uint64_t{3} << 30) - product, "root") >> 31;
    }
    std::uint64_t root = checked_product(m >> 32, y, "root") >> 30;
    const auto rest = static_cast<std::int64_t>(m - root * root);
    root += static_cast<std::uint64_t>(((rest >> 8) * static_cast<std::int64_t>(y)) >> 55);
    return root >> (even / 2);
}

#if !defined(ZERKALO_INTEGERS_ONLY)
/// The same by the float unit: IEEE 754 defines conversion and root to the last bit.
ZERKALO_INLINE std::uint64_t estimated_root_of_floats(std::uint64_t x) {
    // Half of x has no sign bit, which makes the conversion one instruction.
    const auto half = static_cast<double>(static_cast<std::int64_t>(x >> 1));
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(__builtin_sqrt(half + half)));
}
#endif

/// From an estimate within one of it to the integer nearest to the square root of x.
ZERKALO_INLINE constexpr std::uint64_t settled_root(std::uint64_t x, std::uint64_t estimate) {
    constexpr std::uint64_t kMost = 0xffffffffu;
    std::uint64_t root = estimate < kMost ? estimate : kMost;
    root -= root * root > x;
    std::uint64_t rest = x - root * root;
    const bool up = rest > 2 * root;
    rest -= up ? 2 * root + 1 : 0;
    root += up;
    // x = root^2 + rest, and (root + 1/2)^2 lies between the integers root^2 + root and the next one.
    return root + (rest > root ? 1u : 0u);
}

/// The integer nearest to the square root of x (which is never half-way between two).
ZERKALO_INLINE std::uint64_t nearest_root_of(std::uint64_t x) {
#if defined(ZERKALO_INTEGERS_ONLY)
    return settled_root(x, x == 0 ? 0 : estimated_root_of_integers(x));
#else
    return settled_root(x, estimated_root_of_floats(x));
#endif
}

/// 0 for x < 0.
ZERKALO_INLINE std::uint64_t nearest_root(std::int64_t x) {
    return nearest_root_of(x < 0 ? 0 : static_cast<std::uint64_t>(x));
}

}  // namespace zerkalo::inline ZERKALO_ISA
