// The N shares of a lobe's energy, one for each ray of its lattice: the smaller, the nearer to the rim of the lobe.
//
// Of equal shares the outermost ray stands alone for 1/N of the energy, in one direction: that much of a gradient is
// left, and the error falls like 1/N. These grow from nothing over the first eighth of the rays, and a ray counts for
// its share:
//
//     share s lies between psi(s / N) and psi((s + 1) / N),
//     psi(x) = x^2 / (q (2 - q)) for x < q,  (2 x - q) / (2 - q) beyond,  q = 1/8
//
// A ray may lie anywhere in its share as long as its place is drawn evenly: the mean over places is the integral. Odd
// shares have the mirrored place, or all rays together would lie too far out, or too far in, by 1/N.
// Substitutions whose derivative vanishes at an end of the interval: Korobov, "Number-Theoretic Methods in Approximate
// Analysis", 1963; Sidi, "A New Variable Transformation for Numerical Integration", 1993.
#pragma once

#include "core/numeric/fixed_lanes.hpp"
#include "core/numeric/number.hpp"
#include "core/optics/estimator.hpp"

#include <type_traits>

namespace zerkalo::inline ZERKALO_ISA {

/// Where a share begins, counted from the rim, and how large it is; the whole lobe is 15 N^2.
template <class T>
struct EnergyShare {
    T begin, size;
};

/// Share s of n. T: whole numbers, or lanes of float, which round the beginning.
template <class T>
ZERKALO_INLINE constexpr EnergyShare<T> energy_share(T s, T n) {
    const auto lesser = [](T a, T b) {
        if constexpr (std::is_integral_v<T>) {
            return a < b ? a : b;
        } else {
            return min(a, b);
        }
    };
    const T eighths = s * T(8), rim = lesser(eighths, n), still_growing = lesser(n - rim, T(8));
    return {rim * rim + n * T(2) * (eighths - rim), rim * T(16) + still_growing * (T(16) - still_growing)};
}
template <class T>
ZERKALO_INLINE constexpr T whole_lobe(T n) {
    return n * n * T(15);
}

/// Rays of n that count for less than the others.
constexpr std::int32_t rays_at_rim(Estimator rule, std::int32_t n) {
    return is_keyed(rule) || n == 1 ? 0 : (n + 7) / 8;
}

/// The largest share: that of all rays that are not at the rim.
constexpr std::int64_t full_share(std::int64_t n) { return energy_share<std::int64_t>(n - 1, n).size; }

/// How many rays with the largest share count for as much as all n.
constexpr float rays_in_all(Estimator rule, std::int32_t n) {
    return is_keyed(rule) || n == 1 ? float(n) : float(n) * (15.0f / 16);
}

/// What ray s of n at the rim counts for, of one with the largest share.
template <class R>
ZERKALO_INLINE Weight<R> weight_at_rim(std::int32_t s, std::int32_t n) {
    const std::int64_t size = energy_share<std::int64_t>(s, n).size;
    if constexpr (Formats<R>::kFixed) {
        return Weight<Uniform<R>>::from_raw(rounded_quotient<std::int32_t, 30>(size, full_share(n)));
    } else {
        using U = UniformReal<R>;
        return R(U(size) / U(full_share(n)));
    }
}

/// What a ray with the largest share of n counts for, of the whole lobe.
template <class R>
ZERKALO_INLINE Weight<R> full_weight(Estimator rule, std::int32_t n) {
    if constexpr (Formats<R>::kFixed) {
        const bool equal = is_keyed(rule) || n == 1;
        return Weight<Uniform<R>>::from_raw(equal ? rounded_quotient<std::int32_t, 30>(1, n)
                                                  : rounded_quotient<std::int32_t, 30>(16, std::int64_t{15} * n));
    } else {
        return R(1) / R(rays_in_all(rule, n));
    }
}

/// Of the rays first, first + step, ... of n together: by what their sum is multiplied to stand for all n / step of the
/// largest share.
constexpr float scale_of_part(Estimator rule, std::int32_t n, std::int32_t first, std::int32_t step) {
    double sum = double((n - first + step - 1) / step);
    for (std::int32_t s = first; s < rays_at_rim(rule, n); s += step) {
        sum -= 1 - double(energy_share<std::int64_t>(s, n).size) / double(full_share(n));
    }
    return float(double(rays_in_all(rule, n)) / (step * sum));
}

/// a / b to 2^-60, for 0 <= a < b < 2^53: ten bits at a time.
constexpr std::int64_t long_fraction(std::int64_t a, std::int64_t b) {
    std::int64_t quotient = 0;
    for (int digit = 0; digit < 6; ++digit) {
        a <<= 10;
        quotient = (quotient << 10) + a / b;
        a %= b;
    }
    return quotient;
}

/// The smallest share u of a lobe's energy that lies farther out than one of the rays of a pixel, n for each of its
/// camera rays.
constexpr double least_share(const Sampling& sampling, std::int32_t n, std::int32_t camera_rays) {
    if (is_keyed(sampling.estimator)) return 0x1p-24;
    const double rim = double(energy_share<std::int64_t>(0, n).size) / double(whole_lobe(std::int64_t{n}));
    return rim * sampling.place / kShareSteps / camera_rays;
}

/// Where in its share point s of a part lies: 1/2 in rotation 0.
ZERKALO_INLINE float place_in_share(const LatticePart& part, std::int32_t s) {
    return float(part.place[s & 1]) * 0x1p-20f;
}

/// u of point s of a part of n points: the share of the lobe's energy farther out.
template <class R>
ZERKALO_INLINE Fraction<R> share_point(const LatticePart& part, std::int32_t s, std::int32_t n) {
    if constexpr (Formats<R>::kFixed) {
        const EnergyShare<std::int64_t> share = energy_share<std::int64_t>(s, n);
        constexpr int kMore = 8;  // bits of a place in a share
        const std::int64_t inside = share.size * part.place[s & 1] >> (kPlaceBits - kMore);
        return Fraction<Uniform<R>>::from_raw(
            long_fraction((share.begin << kMore) + inside, whole_lobe(std::int64_t{n}) << kMore));
    } else {
        using U = UniformReal<R>;
        const EnergyShare<U> share = energy_share<U>(U(s), U(n));
        return R((share.begin + share.size * U(place_in_share(part, s))) / whole_lobe(U(n)));
    }
}

}  // namespace zerkalo::inline ZERKALO_ISA
