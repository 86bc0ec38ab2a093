// Random numbers of the tests: the same on every machine, which the distributions of the standard library are not.
// Source: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014 (SplitMix64).
#pragma once

#include "tests/core/support/exact.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace zerkalo::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// In [low, high).
    double uniform(double low, double high) { return low + (high - low) * (double(bits() >> 11) * 0x1p-53); }
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

    /// Uniform on the unit sphere (Archimedes: the height is uniform).
    Exact3 direction() {
        const double z = uniform(-1, 1), angle = uniform(0, 2 * 3.14159265358979323846);
        const double across = std::sqrt(1 - z * z);
        return {across * std::cos(angle), across * std::sin(angle), z};
    }

    /// Any bit pattern, and every fourth time one of those at which arithmetic changes its rules.
    float any_float() {
        constexpr std::uint32_t kSpecial[] = {
            0x00000000u, 0x80000000u, 0x00000001u, 0x80000001u, 0x007fffffu, 0x807fffffu, 0x00800000u, 0x80800000u,
            0x3f800000u, 0xbf800000u, 0x3f7fffffu, 0x3f800001u, 0x7f7fffffu, 0xff7fffffu, 0x7f800000u, 0xff800000u,
            0x7fc00000u, 0xffc00000u, 0x7fc12345u, 0x4b000000u, 0xcb7fffffu, 0x00ffffffu, 0x7e800000u, 0x40000000u};
        const std::uint64_t draw = bits();
        constexpr std::size_t kCount = sizeof kSpecial / sizeof kSpecial[0];
        if (draw >> 62 == 0) return std::bit_cast<float>(kSpecial[draw % kCount]);
        return std::bit_cast<float>(static_cast<std::uint32_t>(draw));
    }

private:
    std::uint64_t state_;
};

}  // namespace zerkalo::test
