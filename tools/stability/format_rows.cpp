// Numbers at the ends of their formats: nothing wraps, nothing vanishes.
#include "tools/stability/fixed_lanes_of.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <vector>

namespace zerkalo::stability {
namespace {

// S68. Sums, differences, products and quotients of lengths at the ends of Q4.27, and inside of them by one step; and
// scenes whose coordinates are the largest power of two that a scene may have, and the next one.

__extension__ using Wide = __int128;

constexpr std::int32_t kEnd = kLargest<std::int32_t>;
constexpr std::int32_t kOne = std::int32_t{1} << 27;
constexpr std::int32_t kLengths[] = {0,         1,  -1, kOne, -kOne, kEnd / 2, kEnd / 2 + 1, -kEnd / 2, -kEnd / 2 - 1,
                                     kEnd - 1, kEnd, 1 - kEnd, -kEnd};

/// Operands, padded for the widest lanes.
struct Pairs {
    std::vector<std::int32_t> a, b;
};
Pairs pairs_of_lengths() {
    Pairs pairs;
    for (const std::int32_t a : kLengths) {
        for (const std::int32_t b : kLengths) pairs.a.push_back(a), pairs.b.push_back(b);
    }
    while (pairs.a.size() % kMostFixedLanes != 0) pairs.a.push_back(0), pairs.b.push_back(1);
    return pairs;
}

/// What four operations give, as raw integers: a + b, a - b, a times b as a direction, a over b as a direction.
struct Results {
    std::int32_t sum, difference, product, quotient;
};

/// a / b to the nearest integer, at the end of the format where it is beyond.
std::int64_t expected(Wide a, Wide b) {
    const Wide nearest = (2 * (a < 0 ? -a : a) + (b < 0 ? -b : b)) / (2 * (b < 0 ? -b : b));
    const Wide signed_nearest = (a < 0) != (b < 0) ? -nearest : nearest;
    return static_cast<std::int64_t>(std::clamp<Wide>(signed_nearest, -kEnd, kEnd));
}

/// Results that are more than a step from the exact value, held at the end of the format.
template <class Compute>
double results_beyond_a_step(const Compute& compute) {
    const Pairs pairs = pairs_of_lengths();
    int wrong = 0;
    const auto judge = [&](std::int32_t got, Wide a, Wide b) { wrong += std::abs(got - expected(a, b)) > 1; };
    for (std::size_t i = 0; i < pairs.a.size(); ++i) {
        const std::int32_t a = pairs.a[i], b = pairs.b[i];
        const Results got = compute(pairs, i);
        judge(got.sum, Wide{a} + b, 1);
        judge(got.difference, Wide{a} - b, 1);
        judge(got.product, Wide{a} * b, Wide{1} << 30);
        // By zero: the end on the dividend's side; 0 / 0 is the upper end.
        if (b != 0) judge(got.quotient, Wide{a} << 30, b);
        if (b == 0) wrong += got.quotient != (a < 0 ? -kEnd : kEnd);
    }
    return wrong;
}

template <int W>
Results in_fixed(const Pairs& pairs, std::size_t i) {
    using L = Length<FixedNumbers<W>>;
    using D = Direction<FixedNumbers<W>>;
    const std::size_t first = i / W * W;
    const int lane = static_cast<int>(i - first);
    const L a = in_lanes<L>(&pairs.a[first]), b = in_lanes<L>(&pairs.b[first]);
    const D d = in_lanes<D>(&pairs.b[first]);
    const auto raw = [&](const L& x) { return lane_of(x.raw, lane); };
    return {raw(a + b), raw(a - b), raw(as<L>(a * d)), raw(quotient<L>(a, d))};
}

/// A ball and its lamp at coordinates of that size, the camera too.
Scene scene_of_size(double size) {
    Scene scene;
    scene.camera = camera_at({size, -size, size}, {-2, 2, -2}, 0.5);
    add(scene, ball({-size / 2, size / 2, -size / 2}, size / 4, chalk()));
    add(scene, lamp({size, size, size}));
    return scene;
}

constexpr double kLargestSize = 0x1p49;  // 2^50 is beyond 1e15
constexpr int kSide = 24;

double s68_ours(const Stage& stage) {
    double wrong = pixels_apart(stage.render(scene_of_size(1), kSide, kSide),
                                stage.render(scene_of_size(kLargestSize), kSide, kSide));
    wrong += stage.refused_field(scene_of_size(2 * kLargestSize)) != "position";
    if (!stage.fixed()) return wrong;
    return wrong + worst_of_widths([](auto width) { return results_beyond_a_step(in_fixed<decltype(width)::value>); });
}

/// 32-bit integers as they are: what does not fit wraps around. Division by zero is left out here: it would trap.
double s68_naive() {
    return results_beyond_a_step([](const Pairs& pairs, std::size_t i) -> Results {
        const std::int32_t a = pairs.a[i], b = pairs.b[i];
        const auto x = static_cast<std::uint32_t>(a), y = static_cast<std::uint32_t>(b);
        const std::int64_t product = std::int64_t{a} * b + (std::int64_t{1} << 29);
        const std::int64_t quotient = b != 0 ? std::int64_t{a} * (std::int64_t{1} << 30) / b : a < 0 ? -kEnd : kEnd;
        return {static_cast<std::int32_t>(x + y), static_cast<std::int32_t>(x - y),
                static_cast<std::int32_t>(product >> 30), static_cast<std::int32_t>(quotient)};
    });
}

// S69. kappa |o|^2, the term that tells a mirror of R = 1e9 from a plane, for points o of the scene's box.

constexpr double kKappa = 1e-9;
constexpr double kFarthest = 8;
constexpr int kPoints = 64;

/// The largest error of the term in steps of a length of fixed point, 2^-27. term(area, kappa) -> its length in steps.
template <class Term>
double largest_error(const Term& term) {
    double largest = 0;
    for (const double kappa : {kKappa, -kKappa}) {
        for (int k = 0; k <= kPoints; ++k) {
            const double distance = kFarthest * k / kPoints;
            const auto area = nearest<Area<FixedNumbers<1>>>(3 * distance * distance);
            const double exact = std::ldexp(kappa * real(area), 27);
            largest = std::max(largest, std::abs(term(area, kappa) - exact));
        }
    }
    return largest;
}

double s69_ours(const Stage& stage) {
    if (!stage.fixed()) {
        return largest_error([](const Area<FixedNumbers<1>>& area, double kappa) {
            return std::ldexp(double{float(kappa) * float(real(area))}, 27);
        });
    }
    return worst_of_widths([](auto width) {
        using N = FixedNumbers<decltype(width)::value>;
        return largest_error([](const Area<FixedNumbers<1>>& area, double kappa) {
            const Curvature<N> curvature(nearest<Curvature<FixedNumbers<1>>>(kappa));
            return double(lane_of(product<Length<N>>(curvature, Area<N>(area)).raw, 0));
        });
    });
}

/// kappa in the format of the lengths, Q4.27: the nearest number is 0.
double s69_naive() {
    return largest_error([](const Area<FixedNumbers<1>>& area, double kappa) {
        const std::int64_t mantissa = std::llround(std::ldexp(kappa, 27));
        return double(mantissa * (area.raw >> 27) >> 27);
    });
}

constexpr StiffCase kRows[] = {
    {"S68", "the ends of a fixed format in + - * /; coordinates of 2^49 and 2^50", "wraps around to the other side",
     "at the end of the format, or exact to a step; the picture of size 1; refused", "wrong results", 0, s68_ours,
     s68_naive},
    {"S69", "a mirror with kappa = 1e-9: kappa |o|^2", "kappa is 0 in the format of lengths: a plane",
     "in fixed point, with 59 bits behind the point, right to half a step", "steps of 2^-27", 0.5 + 1e-6, s69_ours,
     s69_naive},
};

}  // namespace

std::span<const StiffCase> format_rows() { return kRows; }

}  // namespace zerkalo::stability
