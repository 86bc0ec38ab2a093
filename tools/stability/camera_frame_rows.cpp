// The camera's frame: directions that are zero, parallel or nearly so, and the widest angles.
#include "tools/stability/exact.hpp"
#include "tools/stability/fixed_lanes_of.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>
#include <string_view>

namespace zerkalo::stability {
namespace {

template <class T>
struct Frame {
    Vec3<T> view, right, up;
};

/// Seed formulas 2.7 and 2.8.
Frame<float> naive_frame(Vec3<float> view, Vec3<float> up) {
    Frame<float> frame;
    frame.view = naive::unit(view);
    frame.right = naive::unit(naive::cross(frame.view, up));
    frame.up = naive::cross(frame.right, frame.view);
    return frame;
}

bool finite(Vec3<float> v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool finite(const Frame<float>& f) { return finite(f.view) && finite(f.right) && finite(f.up); }

Scene framed_ball() {
    Scene scene;
    add(scene, ball({0, 0, 0}, 1, chalk()));
    add(scene, lamp({3, 4, 5}));
    add(scene, ideal_mirror({0, 0, -2}, {0, 0, 1}, 4));
    scene.camera = camera_at({0, 0, 5}, {0, 0, -1}, 0.8);
    return scene;
}

// S20
double s20_ours(const Stage& stage) {
    Scene view = framed_ball(), up = view, normal = view, mirror_up = view;
    view.camera.view = up.camera.up = normal.mirrors[0].normal = mirror_up.mirrors[0].up = {0, 0, 0};
    int let_pass = stage.refused_field(view) != "view";
    let_pass += stage.refused_field(up) != "up";
    let_pass += stage.refused_field(normal) != "normal";
    let_pass += stage.refused_field(mirror_up) != "up";
    return let_pass;
}

double s20_naive() {
    const Vec3<float> zero{0, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    int bad = 0;
    for (const auto& [axis, up] : {std::pair{zero, y}, {z, zero}, {zero, y}, {z, zero}}) {
        bad += !finite(naive_frame(axis, up));
    }
    return bad;
}

// S21: up is a multiple of the view, of either sign; `serves`: the world axis with the smallest component along it.
struct Parallel {
    Vec3<double> view;
    double multiple;
    Vec3<double> serves;
};
constexpr Parallel kParallels[] = {
    {{0, -1, 0}, -1, {1, 0, 0}},         {{0, -1, 0}, 1e-9, {1, 0, 0}}, {{0, 0, -3}, 1e9, {1, 0, 0}},
    {{-2, 0, 0}, 0.5, {0, 1, 0}},        {{1, -2, -3}, 7, {1, 0, 0}},   {{0.3, -0.2, -0.7}, -1.0 / 3, {0, 1, 0}},
    {{-0.7, -0.9, 0.1}, 0.1, {0, 0, 1}},
};
constexpr int kSide = 32;

/// A ball and a smaller one beside it, which shows how the picture is turned.
constexpr Vec3<double> kBeside{0.9, 0.7, 0.8};

double s21_ours(const Stage& stage) {
    double apart = 0;
    for (const Parallel& p : kParallels) {
        Scene scene;
        add(scene, ball({0, 0, 0}, 1, chalk()));
        add(scene, ball(kBeside, 0.5, chalk()));
        add(scene, lamp({3, 4, 5}));
        scene.camera = camera_at(exact::times(exact::unit(p.view), -5), p.view, 0.8);
        scene.camera.up = p.serves;
        const Picture expected = stage.render(scene, kSide, kSide);
        scene.camera.up = exact::times(p.view, p.multiple);
        apart += pixels_apart(stage.render(scene, kSide, kSide), expected);
    }
    return apart;
}

Picture naive_two_balls(Vec3<float> view, Vec3<float> up) {
    const Frame<float> frame = naive_frame(view, up);
    const Vec3<float> eye = naive::times(frame.view, -5);
    const float half = std::tan(0.4f);
    Picture picture{kSide, kSide, {}};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = half * (float(2 * i + 1) / kSide - 1), y = half * (1 - float(2 * j + 1) / kSide);
            const Vec3<float> d = naive::unit(naive::along(naive::along(frame.view, x, frame.right), y, frame.up));
            const naive::Roots one = naive::sphere(eye, d, {0, 0, 0}, 1);
            const naive::Roots two = naive::sphere(eye, d, naive::rounded(kBeside), 0.5f);
            const float depth = one.real ? one.first : two.real ? two.first : 0;
            picture.rgb.insert(picture.rgb.end(), 3, depth);
        }
    }
    return picture;
}

double s21_naive() {
    double apart = 0;
    for (const Parallel& p : kParallels) {
        const Vec3<float> view = naive::rounded(p.view);
        apart += pixels_apart(naive_two_balls(view, naive::rounded(exact::times(p.view, p.multiple))),
                              naive_two_balls(view, naive::rounded(p.serves)));
    }
    return apart;
}

// S22: up leaves the view by 1e-7 rad.
constexpr double kTilt = 1e-7;
constexpr Vec3<double> kViews[] = {{0, 0, -1}, {1, -2, -3}, {0.3, -0.2, 0.7}, {-5, 0.1, 0.2}};

/// How far the frame is from view, view x up, and both's cross product, in roundings of a float, 2^-24.
template <class T>
double frame_error(const Vec3<double>& view, const Vec3<double>& tilt, const Frame<T>& frame) {
    const Vec3<double> right = exact::cross(view, tilt), up = exact::cross(right, view);
    double largest = 0;
    for (const auto& [is, should] : {std::pair{frame.view, view}, {frame.right, right}, {frame.up, up}}) {
        const Vec3<double> got{is.x, is.y, is.z};
        const double error = exact::length(exact::minus(got, should)) * 0x1p24;
        if (!(error <= largest)) largest = error;
    }
    return largest;
}

/// The largest error over all views; `frame(view, up)`.
template <class FrameOf>
double largest_frame_error(const FrameOf& frame) {
    double largest = 0;
    for (const Vec3<double>& any_length : kViews) {
        const Vec3<double> view = exact::unit(any_length);
        const Vec3<double> tilt = exact::unit(exact::cross(view, {0.6, 0.64, 0.48}));
        const double error = frame_error(view, tilt, frame(view, exact::along(view, kTilt, tilt)));
        if (!(error <= largest)) largest = error;
    }
    return largest;
}

double s22_ours(const Stage& stage) {
    return largest_frame_error([&](const Vec3<double>& view, const Vec3<double>& up) {
        Scene scene = framed_ball();
        scene.camera.view = view;
        scene.camera.up = up;
        const double half = std::tan(scene.camera.fov / 2);
        // In fixed point the ray of a corner has length 1 before it is normalised, in float the one of the middle.
        const double length = stage.fixed() ? std::sqrt(1 + 2 * half * half) : 1;
        return stage.prepared(scene, kSide, kSide).with_plan([&](const auto& plan) {
            const auto times = [](const auto& v, double factor) {
                return Vec3<double>{real(v.x) * factor, real(v.y) * factor, real(v.z) * factor};
            };
            const double across = length * kSide / half;
            return Frame<double>{times(plan.camera.view, length), times(plan.camera.step_x, across),
                                 times(plan.camera.step_y, across)};
        });
    });
}

double s22_naive() {
    return largest_frame_error([](const Vec3<double>& view, const Vec3<double>& up) {
        return naive_frame(naive::rounded(view), naive::rounded(up));
    });
}

// S24: nearly and more than half of all directions.
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kWidest = 179.9;
constexpr double kTooWide[] = {180, 180.1, 270, 300};

/// Pixels of the widest picture that do not tell whether their ray meets one of four balls beside the camera.
double s24_ours(const Stage& stage) {
    Scene scene;
    scene.camera = camera_at({0, 0, 0}, {0, 0, -1}, kWidest * kDegree);
    const Vec3<double> beside[] = {{5, 0, -0.5}, {-5, 0, -0.5}, {0, 5, -0.5}, {3, -3, -0.1}};
    for (const Vec3<double>& centre : beside) add(scene, ball(centre, 1, glowing({1, 1, 1})));
    const Picture picture = stage.render(scene, kSide, kSide);
    const double half = std::tan(kWidest / 2 * kDegree);
    int faults = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const Vec3<double> d =
                exact::unit({half * ((2 * i + 1.0) / kSide - 1), half * (1 - (2 * j + 1.0) / kSide), -1});
            bool met = false;
            for (const Vec3<double>& c : beside) {
                met = met || (exact::length(exact::cross(d, c)) < 1 && exact::dot(d, c) > 0);
            }
            faults += met != (picture.at(i, j).r > 0);
        }
    }
    for (const FovAxis axis : {FovAxis::horizontal, FovAxis::vertical}) {
        for (const double degrees : kTooWide) {
            scene.camera.fov = degrees * kDegree, scene.camera.fov_axis = axis;
            const char* field = axis == FovAxis::horizontal ? "horizontal_fov_deg" : "vertical_fov_deg";
            faults += stage.refused_field(scene) != field;
        }
    }
    return faults;
}

/// Angles for which the width of the picture, 2 tan(fov / 2), is no positive number.
double s24_naive() {
    int faults = 0;
    for (const double degrees : kTooWide) faults += 2 * !(std::tan(float(degrees * kDegree) / 2) > 0);
    return faults;
}

constexpr StiffCase kRows[] = {
    {"S20", "view, up, a mirror's normal or its up of length zero", "normalising divides 0 by 0: a picture of NaN",
     "refused, with the name of the field", "let pass", 0, s20_ours, s20_naive},
    {"S21", "up parallel to the view", "right = view x up is zero: no picture",
     "the picture with the world axis that serves as up, bit by bit", "pixels apart", 0, s21_ours, s21_naive},
    {"S22", "up 1e-7 rad from the view", "view x up keeps no digit: a skewed frame",
     "view, right and true up as in exact arithmetic", "2^-24", 4, s22_ours, s22_naive},
    {"S24", "full angle of view 179.9 degrees; 180 and more", "tan(90 degrees) is a negative number",
     "179.9 shows what there is; from 180 on refused", "faults", 0, s24_ours, s24_naive},
};

}  // namespace

std::span<const StiffCase> camera_frame_rows() { return kRows; }

}  // namespace zerkalo::stability
