// Cameras far away, and angles of view that are all but nothing.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 64;  // pixels a side
constexpr double kFarAway = 1e6;
constexpr double kFramed = 2.5;  // width of the picture at the sphere, radii
const Vec3<double> kLamp{3, 4, 5};

/// Where the ray of column i or row j crosses the plane through the sphere's centre, to the right or downwards.
double across(int i) { return kFramed * ((i + 0.5) / kSide - 0.5); }

/// Is pixel (i, j) of a picture that frames the unit disc inside it? -1: out, 1: in, 0: within `band` of the edge.
int side_of_disc(int i, int j, double band) {
    const double x = across(i), y = across(j);
    const double beyond = std::sqrt(x * x + y * y) - 1;
    return beyond > band ? -1 : beyond < -band ? 1 : 0;
}

constexpr double kHalfPixel = 0.5 * kFramed / kSide;

/// Pixels on the wrong side of the disc's edge, but for a ring of half a pixel.
template <class Lit>
double wrong_pixels(const Lit& lit) {
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const int side = side_of_disc(i, j, kHalfPixel);
            wrong += side != 0 && lit(i, j) != (side > 0);
        }
    }
    return wrong;
}

double s01_ours(const Stage& stage) {
    Scene scene;
    scene.camera = camera_at({0, 0, kFarAway}, {0, 0, -1}, 2 * std::atan(kFramed / 2 / kFarAway));
    add(scene, ball({0, 0, 0}, 1, glowing({1, 1, 1})));
    const Picture picture = stage.render(scene, kSide, kSide);
    return wrong_pixels([&](int i, int j) { return picture.at(i, j).r > 0; });
}

double s01_naive() {
    const Vec3<float> eye{0, 0, float(kFarAway)};
    return wrong_pixels([&](int i, int j) {
        const float x = float(across(i) / kFarAway), y = float(across(j) / kFarAway);
        return naive::sphere(eye, naive::unit({x, y, -1}), {0, 0, 0}, 1).real;
    });
}

/// A camera that frames the chalk ball at the origin from a distance; up is +y.
struct FarView {
    Vec3<double> view;  // unit
    double distance;

    Vec3<double> right() const { return exact::unit(exact::cross(view, {0, 1, 0})); }
    Vec3<double> up() const { return exact::cross(right(), view); }
    Vec3<double> eye() const { return exact::times(view, -distance); }
    double fov() const { return 2 * std::atan(kFramed / 2 / distance); }
};

Picture far_picture(const Stage& stage, const FarView& far) {
    Scene scene;
    scene.camera = camera_at(far.eye(), far.view, far.fov());
    add(scene, ball({0, 0, 0}, 1, chalk()));
    add(scene, lamp(kLamp));
    return stage.render(scene, kSide, kSide);
}

/// The ball's light at pixel (i, j) in closed form: the ray starts on the plane through the centre.
double exact_light(const FarView& far, int i, int j) {
    const Vec3<double> o = exact::plus(exact::times(far.right(), across(i)), exact::times(far.up(), -across(j)));
    const Vec3<double> d = exact::unit(exact::along(far.view, 1 / far.distance, o));
    const double b = exact::dot(o, d);
    const Vec3<double> nearest = exact::along(o, -b, d);
    const Vec3<double> p = exact::along(nearest, -std::sqrt(1 - exact::dot(nearest, nearest)), d);
    return exact::lambert(p, p, kLamp);
}

/// The same by the textbook, in float: the ray starts at the camera, b^2 - 4ac.
double naive_light(const FarView& far, int i, int j) {
    const double x = across(i) / far.distance, y = -across(j) / far.distance;
    const Vec3<float> right = naive::rounded(far.right()), up = naive::rounded(far.up());
    const Vec3<float> view = naive::rounded(far.view), eye = naive::rounded(far.eye());
    const Vec3<float> d = naive::unit(naive::along(naive::along(view, float(x), right), float(y), up));
    const naive::Roots roots = naive::sphere(eye, d, {0, 0, 0}, 1);
    if (!roots.real) return 0;
    const Vec3<float> p = naive::along(eye, roots.first, d);
    return naive::lambert(p, p, naive::rounded(kLamp));
}

/// The largest difference from the closed form inside the disc, in steps of 255; beyond it all is black.
template <class LightAt>
double steps_from_exact(const FarView& far, const LightAt& light) {
    double largest = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const int side = side_of_disc(i, j, kHalfPixel);
            if (side == 0) continue;
            const double difference = 255 * std::abs(light(i, j) - (side > 0 ? exact_light(far, i, j) : 0));
            if (!(difference <= largest)) largest = difference;
        }
    }
    return largest;
}

constexpr double kSmallStep = 0.001;  // in steps of 255: some 65 roundings of a float near 1
constexpr FarView kParallelView{{0, 0, -1}, 1e12};

double s02_ours(const Stage& stage) {
    const Picture picture = far_picture(stage, kParallelView);
    return steps_from_exact(kParallelView, [&](int i, int j) { return double{picture.at(i, j).r}; });
}
double s02_naive() {
    return steps_from_exact(kParallelView, [](int i, int j) { return naive_light(kParallelView, i, j); });
}

/// Cameras that frame the ball with so many degrees, from aslant: no component of a direction is small.
FarView narrow_view(double degrees) {
    return {exact::unit({1, -2, -3}), kFramed / 2 / std::tan(degrees / 2 * std::numbers::pi / 180)};
}

/// Neighbours inside the disc with the very same light although the closed form tells them apart; and one more where
/// the light is not that of the closed form.
template <class LightAt>
int shared_rays(const FarView& far, const LightAt& light) {
    constexpr double kApart = 1e-4;
    int shared = !(steps_from_exact(far, light) <= kSmallStep);
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i + 1 < kSide; ++i) {
            if (side_of_disc(i, j, kHalfPixel) < 1 || side_of_disc(i + 1, j, kHalfPixel) < 1) continue;
            const bool apart = std::abs(exact_light(far, i, j) - exact_light(far, i + 1, j)) > kApart;
            shared += apart && light(i, j) == light(i + 1, j);
        }
    }
    return shared;
}

double s23_ours(const Stage& stage) {
    int shared = 0;
    for (const double degrees : {1e-3, 1e-6}) {
        const FarView far = narrow_view(degrees);
        const Picture picture = far_picture(stage, far);
        shared += shared_rays(far, [&](int i, int j) { return picture.at(i, j).r; });
    }
    return shared;
}
double s23_naive() {
    int shared = 0;
    for (const double degrees : {1e-3, 1e-6}) {
        const FarView far = narrow_view(degrees);
        shared += shared_rays(far, [&](int i, int j) { return naive_light(far, i, j); });
    }
    return shared;
}

constexpr StiffCase kRows[] = {
    {"S01", "camera at 1e6 from the unit sphere that it frames", "b^2 - 4ac is noise: a ragged disc",
     "the disc is the unit disc but for a ring of half a pixel", "wrong pixels", 0, s01_ours, s01_naive},
    {"S02", "camera at 1e12 from the unit sphere that it frames", "every ray hits: all digits of b^2 - 4ac cancel",
     "the light of the orthographic picture", "steps of 255", kSmallStep, s02_ours, s02_naive},
    {"S23", "full angle of view 1e-3 and 1e-6 degrees, aslant", "directions are quantised: blocks of pixels",
     "the orthographic picture; no neighbours on the sphere share a ray", "shared rays", 0, s23_ours, s23_naive},
};

}  // namespace

std::span<const StiffCase> far_camera_rows() { return kRows; }

}  // namespace zerkalo::stability
