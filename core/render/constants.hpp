// From the doubles of set-up to the numbers of a plan: each is rounded once.
#pragma once

#include "core/geometry/frame.hpp"
#include "core/numeric/fixed.hpp"
#include "core/render/plan.hpp"

namespace zerkalo {

/// The system of one lane in which a plan with the formats F is derived.
template <class F>
struct SetUpNumbers { using type = FloatNumbers<typename F::Length>; };
template <>
struct SetUpNumbers<FixedFormats> { using type = FixedNumbers<1>; };

template <class F>
class Constants;

/// To float or double: lengths as they are, colours held at kBrightest. `origin`: what places count from.
template <class T>
class Constants<FloatingFormats<T>> {
public:
    Constants() = default;
    explicit Constants(const Point& origin) : origin_(origin) {}

    static Vec3<T> rounded(const Point& p) { return {T(p.x), T(p.y), T(p.z)}; }

    /// A place of the world, counted from the plan's origin.
    Point seen(const Point& p) const { return p - origin_; }
    T length(double x) const { return T(x); }
    Vec3<T> point(const Point& p) const { return rounded(seen(p)); }
    Vec3<T> way(const Point& p) const { return rounded(p); }
    Vec3<T> direction(const Point& p) const { return rounded(p); }
    /// Of a direction, or what one is multiplied with.
    T component(double x) const { return T(x); }
    T share(double x) const { return T(x); }
    T area(double x) const { return T(x); }
    T inverse(double x) const { return held(x); }
    T curvature(double x) const { return T(x); }
    T ratio(double x) const { return T(x); }
    T weight(double x) const { return T(x); }
    T exponent(double x) const { return held(x); }
    Rgb<T> weight(const Rgb<double>& c) const { return {bright(c.r), bright(c.g), bright(c.b)}; }
    Rgb<T> radiance(const Rgb<double>& c) const { return weight(c); }
    Rgb<T> power(const Rgb<double>& c, bool) const { return weight(c); }
    HalfPlaneOf<FloatingFormats<T>> half_plane(double nx, double ny, double c) const { return {T(nx), T(ny), T(c)}; }
    /// What the directions of camera rays are multiplied with.
    double view_scale(double) const { return 1; }
    Vec3<T> view(const Point& p) const { return rounded(p); }
    Vec3<T> far_step(const Point& p) const { return rounded(p); }
    T pull(double x) const { return T(x); }

    double length_of(T x) const { return x; }
    double unscaled(double x) const { return x; }
    Point point_of(const Vec3<T>& p) const { return Point{p.x, p.y, p.z} + origin_; }
    Point direction_of(const Vec3<T>& p) const { return {p.x, p.y, p.z}; }
    double number_of(T x) const { return x; }

private:
    static T held(double x) {
        constexpr double kLargest = std::numeric_limits<T>::max();
        return T(x < kLargest ? x : kLargest);
    }
    static T bright(double x) { return x < kBrightest ? T(x) : kBrightest; }

    Point origin_{0, 0, 0};
};

/// To fixed point: lengths times a power of two that brings the scene into the box, radiance times 2^-exposure.
template <>
class Constants<FixedFormats> {
    using F = FixedFormats;

public:
    Constants() = default;
    Constants(const Point& origin, double length_scale, std::int32_t exposure)
        : origin_(origin), scale_(length_scale), exposure_(exposure) {}

    std::int32_t exposure() const { return exposure_; }

    /// A place of the world, counted from the plan's origin.
    Point seen(const Point& p) const { return p - origin_; }

    F::Length length(double x) const { return nearest<F::Length>(x * scale_); }
    Vec3<F::Length> point(const Point& p) const { return each<F::Length>(seen(p) * scale_); }
    Vec3<F::Length> way(const Point& p) const { return each<F::Length>(p * scale_); }
    Vec3<F::Direction> direction(const Point& p) const { return each<F::Direction>(p); }
    F::Direction component(double x) const { return nearest<F::Direction>(x); }
    F::Share share(double x) const { return nearest<F::Share>(x); }
    F::Area area(double x) const { return nearest<F::Area>(x * scale_ * scale_); }
    F::Inverse inverse(double x) const { return nearest<F::Inverse>(x / scale_); }
    F::Curvature curvature(double x) const { return nearest<F::Curvature>(x / scale_); }
    F::Ratio ratio(double x) const { return nearest<F::Ratio>(x); }
    F::Weight weight(double x) const { return nearest<F::Weight>(x); }
    F::Exponent exponent(double x) const { return nearest<F::Exponent>(x); }
    Rgb<F::Weight> weight(const Rgb<double>& c) const { return {weight(c.r), weight(c.g), weight(c.b)}; }
    Rgb<F::Radiance> radiance(const Rgb<double>& c) const { return glow(c, 1); }
    /// A light's power; with the inverse square of a distance that is scaled too.
    Rgb<F::Radiance> power(const Rgb<double>& c, bool inverse_square) const {
        return glow(c, inverse_square ? scale_ * scale_ : 1);
    }
    HalfPlaneOf<F> half_plane(double nx, double ny, double c) const {
        const double size = zerkalo::length({nx, ny, 0});
        return {nearest<F::Edge>(nx / size), nearest<F::Edge>(ny / size), length(c / size)};
    }
    /// `longest`: of the camera's rays before normalising.
    double view_scale(double longest) const { return 1 / longest; }
    Vec3<F::View> view(const Point& p) const { return each<F::View>(p); }
    Vec3<F::FarStep> far_step(const Point& p) const { return each<F::FarStep>(p * scale_); }
    F::FarStep pull(double x) const { return nearest<F::FarStep>(x * scale_); }

    double length_of(F::Length x) const { return unscaled(number_of(x)); }
    double unscaled(double x) const { return x / scale_; }
    Point point_of(const Vec3<F::Length>& p) const {
        return Point{length_of(p.x), length_of(p.y), length_of(p.z)} + origin_;
    }
    Point direction_of(const Vec3<F::Direction>& p) const { return {number_of(p.x), number_of(p.y), number_of(p.z)}; }
    template <class T, Format format>
    double number_of(Fixed<T, format> x) const { return double(x.raw) / double(std::int64_t{1} << format.fraction); }

private:
    /// To nearest, ties away from zero, held at the ends of the format.
    template <class To>
    static To nearest(double x) {
        using T = typename To::Element;
        const double size = magnitude(x) * double(std::int64_t{1} << To::kFraction);
        // From 2^52 on every double is a whole number.
        const double whole = size < 0x1p52 ? double(static_cast<std::int64_t>(size + 0.5)) : size;
        const T raw = whole < double(kLargest<T>) ? static_cast<T>(whole) : kLargest<T>;
        return To::from_raw(x < 0 ? -raw : raw);
    }
    template <class To>
    static Vec3<To> each(const Point& p) { return {nearest<To>(p.x), nearest<To>(p.y), nearest<To>(p.z)}; }
    Rgb<F::Radiance> glow(const Rgb<double>& c, double factor) const {
        const double unit = factor / double(std::int64_t{1} << exposure_);
        return {nearest<F::Radiance>(c.r * unit), nearest<F::Radiance>(c.g * unit), nearest<F::Radiance>(c.b * unit)};
    }

    Point origin_{0, 0, 0};
    double scale_ = 1;
    std::int32_t exposure_ = 0;
};

}  // namespace zerkalo
