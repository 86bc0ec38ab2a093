// Decisions on the edge: the rim of a ball, two solids at one place, the last ray of a chain, a mirror below a pixel.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

// S58. Parallel rays at height r, and at the floats next to it, past balls of radius r.

constexpr float kRadii[] = {1, 3, 0.1f, 0.7f, 1.9999999f, 1234.5f};
constexpr double kDistances[] = {2, 16, 1000, 65536};  // radii, rounded to a float
constexpr Vec2<float> kSides[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/// Rays that are decided otherwise than height <= radius. met(origin, radius): does the ray along -z meet the ball?
template <class Met>
double wrong_decisions(const Met& met) {
    int wrong = 0;
    for (const float radius : kRadii) {
        const float heights[] = {std::nextafter(radius, 0.0f), radius, std::nextafter(radius, 2 * radius)};
        for (const double distance : kDistances) {
            for (const Vec2<float>& side : kSides) {
                for (const float height : heights) {
                    const Vec3<float> o{height * side.x, height * side.y, float(distance * double{radius})};
                    wrong += met(o, radius) != (height <= radius);
                }
            }
        }
    }
    return wrong;
}

double s58_ours(const Stage& stage) {
    return wrong_decisions([&](Vec3<float> o, float radius) {
        Scene scene;
        add(scene, ball({0, 0, 0}, double{radius}, glowing({1, 1, 1})));
        return stage.look(scene, {double{o.x}, double{o.y}, double{o.z}}, {0, 0, -1}).r > 0;
    });
}

double s58_naive() {
    return wrong_decisions(
        [](Vec3<float> o, float radius) { return naive::sphere(o, {0, 0, -1}, {0, 0, 0}, radius).real; });
}

// S63. Every solid twice at the same place, in two colours.

constexpr int kSide = 32;
constexpr double kHalfView = 0.4;  // tangent of half the angle of view
constexpr Vec3<double> kEye{0, 0.5, 4};
constexpr Rgb<double> kFirst{1, 0, 0}, kSecond{0, 1, 0};

/// Pixels that show the second colour; at least one where none shows the first.
double pixels_of_the_second(const Picture& picture) {
    int first = 0, second = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
        first += picture.rgb[i] > 0;
        second += picture.rgb[i + 1] > 0;
    }
    return first > 0 ? second : std::max(second, 1);
}

double s63_ours(const Stage& stage) {
    const Solid solids[] = {ball({0, 0, 0}, 1, Material{}), upright(SolidKind::prism, {0, -0.5, 0}, 1, 1, Material{}),
                            upright(SolidKind::pyramid, {0, -0.5, 0}, 1, 1.5, Material{}),
                            upright(SolidKind::cylinder, {0, -0.5, 0}, 1, 1, Material{}),
                            upright(SolidKind::cone, {0, -0.5, 0}, 1, 1.5, Material{})};
    double wrong = 0;
    for (const Solid& solid : solids) {
        // The sharp kernel, the general one, and the solids in a mirror of it.
        for (const double curvature_radius : {kInfinity, 50.0}) {
            Scene scene;
            scene.camera = camera_at(kEye, {0, -0.1, -1}, 2 * std::atan(kHalfView));
            for (const Rgb<double>& colour : {kFirst, kSecond}) {
                add(scene, solid);
                Solid& added = scene.solids[scene.solid_count - 1];
                added.rotation = {0.3, 0.2, 0.1};
                added.material = glowing(colour);
            }
            add(scene, ideal_mirror({0.5, 0, -2}, {-0.5, 0, 1}, 6));
            scene.mirrors[0].curvature_radius = curvature_radius;
            wrong += pixels_of_the_second(stage.render(scene, kSide, kSide));
        }
    }
    return wrong;
}

/// A hit counts unless it is beyond the nearest one so far: the last of equals wins.
double s63_naive() {
    Picture picture{kSide, kSide, {}};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(kHalfView * (2 * (i + 0.5) / kSide - 1));
            const float y = float(kHalfView * (1 - 2 * (j + 0.5) / kSide));
            float nearest = std::numeric_limits<float>::infinity();
            Rgb<double> seen{0, 0, 0};
            for (const Rgb<double>& colour : {kFirst, kSecond}) {
                const auto roots = naive::sphere({0, 0.5f, 4}, naive::unit({x, y - 0.1f, -1}), {0, 0, 0}, 1);
                if (!roots.real || roots.first > nearest) continue;
                nearest = roots.first;
                seen = colour;
            }
            picture.rgb.insert(picture.rgb.end(), {float(seen.r), float(seen.g), float(seen.b)});
        }
    }
    return pixels_of_the_second(picture);
}

// S65. Two facing mirrors that glow, seen from between: each reflection adds one term of a geometric series.

constexpr double kGlow = 0.5, kReflection = 0.9;
constexpr int kLimits[] = {0, 1, 2, 6, 254, 255};

/// The largest relative error of the sums up to each depth limit; infinite where more depth is darker.
template <class Seen>
double largest_error_of_sums(const Seen& seen) {
    double largest = 0, before = 0;
    for (const int limit : kLimits) {
        const double exact = kGlow * (1 - std::pow(kReflection, limit + 1)) / (1 - kReflection);
        const double sum = seen(limit);
        if (sum < before) return kInfinity;
        largest = std::max(largest, std::abs(sum - exact) / exact);
        before = sum;
    }
    return largest;
}

double s65_ours(const Stage& stage) {
    Scene scene;
    for (const double side : {-1.0, 1.0}) {
        add(scene, ideal_mirror({0, 0, side}, {0, 0, -side}, 4));
        Mirror& mirror = scene.mirrors[scene.mirror_count - 1];
        mirror.ambient = kGlow;
        mirror.reflection = kReflection;
    }
    return largest_error_of_sums([&](int limit) {
        Settings settings;
        settings.depth_limit = limit;
        return double{stage.look(scene, {0, 0, 0}, {0, 0, -1}, settings).r};
    });
}

/// The textbook's recursion: where no depth is left, the answer is black, before anything is looked at.
float colour_of_mirror(int depth) {
    if (depth <= 0) return 0;
    return float(kGlow) + float(kReflection) * colour_of_mirror(depth - 1);
}

double s65_naive() {
    return largest_error_of_sums([](int limit) { return double{colour_of_mirror(limit)}; });
}

// S70. A glowing mirror a thousandth wide at distance 1000, a quarter of a pixel, under a camera that moves.

constexpr double kWidth = 1e-3, kFar = 1e3;
constexpr int kPixels = 4;             // a side
constexpr double kPixel = 2 * kWidth;  // at the mirror
constexpr int kShifts = 16;            // of the camera, an irrational part of a pixel each
constexpr double kGolden = 0.6180339887498949;

/// The largest error of the light that all pixels together get, as a share of what they should get, times N^(3/4): with
/// N rays a pixel the error of an area with edges falls like N^(-3/4). draw(x, y, N): the sum, the camera moved aside.
template <class Draw>
double largest_flicker(const Draw& draw) {
    constexpr double kCovered = (kWidth / kPixel) * (kWidth / kPixel);  // of one pixel
    double largest = 0;
    for (const int samples : {64, 256, 1024}) {
        for (int k = 0; k < kShifts; ++k) {
            const double x = k * kGolden, y = x * kGolden;
            const double sum = draw(kPixel * (x - std::floor(x)), kPixel * (y - std::floor(y)), samples);
            largest = std::max(largest, std::abs(sum / kCovered - 1) * std::pow(samples, 0.75));
        }
    }
    return largest;
}

double sum_of_pixels(const Picture& picture) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) sum += double{picture.rgb[i]};
    return sum;
}

double s70_ours(const Stage& stage) {
    return largest_flicker([&](double x, double y, int samples) {
        Scene scene;
        scene.camera = camera_at({x, y, kFar}, {0, 0, -1}, 2 * std::atan(kPixels * kPixel / 2 / kFar));
        Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, kWidth);
        mirror.ambient = 1;
        add(scene, mirror);
        Settings settings;
        settings.antialias = samples;
        return sum_of_pixels(stage.render(scene, kPixels, kPixels, settings));
    });
}

/// One ray through each pixel's centre: the mirror is there or not.
double s70_naive() {
    return largest_flicker([](double x, double y, int) {
        int hits = 0;
        for (int j = 0; j < kPixels; ++j) {
            for (int i = 0; i < kPixels; ++i) {
                const float at_x = float(x + kPixel * (i + 0.5 - kPixels / 2.0));
                const float at_y = float(y + kPixel * (j + 0.5 - kPixels / 2.0));
                hits += std::abs(at_x) <= float(kWidth / 2) && std::abs(at_y) <= float(kWidth / 2);
            }
        }
        return hits;
    });
}

constexpr StiffCase kRows[] = {
    {"S58", "rays at a ball's rim and the floats next to it, 2 to 65536 radii away",
     "b^2 - 4ac decides by its noise", "met if and only if the height is at most the radius", "wrong decisions", 0,
     s58_ours, s58_naive},
    {"S63", "every solid twice at one place, in two colours, also in a mirror", "t <= nearest: the last one wins",
     "the first one is seen", "wrong pixels", 0, s63_ours, s63_naive},
    {"S65", "depth limits 0, 1, 2, 6, 254, 255 between two facing mirrors", "no depth left is black: one term too few",
     "limit d gives d + 1 terms of the geometric series, to 2e-6", "relative", 2e-6, s65_ours, s65_naive},
    {"S70", "a mirror 1e-3 wide at distance 1e3, a quarter of a pixel, moving", "one ray a pixel: there or not",
     "N camera rays give its area but for a share of 3 N^(-3/4)", "share N^(3/4)", 3, s70_ours, s70_naive},
};

}  // namespace

std::span<const StiffCase> edge_rows() { return kRows; }

}  // namespace zerkalo::stability
