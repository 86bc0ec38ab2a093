// Scenes of solids before a mirror that only reflects, plain and covered pictures of them, and whether these have one
// mean over the rotations of the lattice: for the laws of the estimator fibonacci+coverage.
#pragma once

#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace zerkalo::laws {

inline Settings with(Estimator estimator, int side, std::int32_t samples) {
    Settings settings = of_size(side, side);
    settings.estimator = estimator;
    settings.samples = samples;
    return settings;
}
inline Settings plain(int side, std::int32_t samples) { return with(Estimator::fibonacci, side, samples); }
inline Settings covered(int side, std::int32_t samples) { return with(Estimator::fibonacci_coverage, side, samples); }

constexpr Vec3<double> kFace{0, 0, 1};

/// A lamp, a mirror in z = 0 that only reflects and fills the picture, and a camera that sees no solid but in it.
inline Scene before_a_mirror(double exponent, Lobe lobe) {
    Scene scene;
    scene.background = {0.1, 0.3, 0.6};
    scene.camera = camera_at({0, 0, 1.5}, {0, 0, -1}, 0.8);
    add(scene, lamp({-3, 5, 3}));
    Mirror mirror = ideal_mirror({0, 0, 0}, kFace, 4);
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    mirror.diffuse = mirror.ambient = 0;
    add(scene, mirror);
    return scene;
}

inline Solid of_kind(SolidKind kind, const Vec3<double>& position) {
    Solid solid;
    solid.kind = kind;
    solid.position = position;
    solid.rotation = {0.4, 0.3, -0.5};
    solid.radius = 0.6;
    solid.height = 1.1;
    solid.taper = kind == SolidKind::cone ? 0 : 1;
    solid.sides = 6;
    solid.material.color = {0.9, 0.5, 0.2};
    return solid;
}

constexpr SolidKind kKinds[] = {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                                SolidKind::cone};

inline Scene with_one(SolidKind kind, double exponent, Lobe lobe = Lobe::phong) {
    Scene scene = before_a_mirror(exponent, lobe);
    add(scene, of_kind(kind, {0.1, -0.2, 3}));
    return scene;
}

/// Solids before and behind each other, as the mirror sees them.
inline Scene crowd(double exponent, Lobe lobe = Lobe::phong) {
    Scene scene = before_a_mirror(exponent, lobe);
    add(scene, of_kind(SolidKind::cone, {-0.8, -0.5, 2.6}));
    add(scene, of_kind(SolidKind::prism, {-0.2, -0.3, 3.6}));
    add(scene, of_kind(SolidKind::sphere, {0.4, 0.2, 2.8}));
    add(scene, of_kind(SolidKind::cylinder, {0.9, -0.4, 4.2}));
    return scene;
}

inline double rmse(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::pow(double(a.rgb[k]) - b.rgb[k], 2);
    return std::sqrt(sum / double(a.rgb.size()));
}

inline double rmse_of(const Scene& scene, const Settings& settings, const Image& truth) {
    return rmse(render(scene, settings), truth);
}

/// Sums over the first rotations of the lattice, of plain and covered pictures of one scene.
class Rotations {
public:
    static constexpr int kSide = 12, kRays = 3;

    explicit Rotations(const Scene& scene) : scene_(scene) {}

    void add_until(int count) {
        for (; count_ < count; ++count_) {
            Settings settings = plain(kSide, kRays);
            settings.rotation = count_ + 1;
            const Image one = render(scene_, settings);
            settings.estimator = Estimator::fibonacci_coverage;
            add(one, render(scene_, settings));
        }
    }

    std::size_t size() const { return apart_.size(); }
    /// By how much the means are apart, and the standard deviation of that, by value and of the mean value.
    double apart(std::size_t value) const { return apart_[value].mean(count_); }
    double deviation(std::size_t value) const { return apart_[value].deviation(count_); }
    double apart_in_mean() const { return of_mean_.mean(count_); }
    double deviation_of_mean() const { return of_mean_.deviation(count_); }
    double brightest() const { return brightest_; }

    /// Roots of the mean squares over all values.
    double rms_apart() const { return rms(&Rotations::apart); }
    double rms_deviation() const { return rms(&Rotations::deviation); }

private:
    struct Sums {
        double first = 0, second = 0;
        void add(double x) { first += x, second += x * x; }
        double mean(int count) const { return first / count; }
        double deviation(int count) const {
            return std::sqrt(std::max(0.0, second / count - mean(count) * mean(count)) / count);
        }
    };

    void add(const Image& one, const Image& two) {
        apart_.resize(one.rgb.size());
        double sum = 0;
        for (std::size_t i = 0; i < apart_.size(); ++i) {
            const double apart = double(one.rgb[i]) - double(two.rgb[i]);
            apart_[i].add(apart);
            sum += apart;
            brightest_ = std::max(brightest_, double(one.rgb[i]));
        }
        of_mean_.add(sum / double(apart_.size()));
    }
    double rms(double (Rotations::*of)(std::size_t) const) const {
        double squares = 0;
        for (std::size_t i = 0; i < size(); ++i) squares += (this->*of)(i) * (this->*of)(i);
        return std::sqrt(squares / double(size()));
    }

    const Scene& scene_;
    std::vector<Sums> apart_;
    Sums of_mean_;
    double brightest_ = 0;
    int count_ = 0;
};

/// The means over rotations come together, value by value and of the picture: what they are apart by is what so many
/// rotations leave, and falls as the root of their number, down to what the integrals may be off by.
inline void expect_unbiased(const Scene& scene, const std::string& what) {
    constexpr int kFew = 100, kMany = 1600;
    constexpr double kIntegrals = 1e-4, kDeviations = 4.5;
    Rotations rotations(scene);
    rotations.add_until(kFew);
    const double early = rotations.rms_apart();
    rotations.add_until(kMany);
    // Where few rays of all rotations have met a solid there is hardly a deviation to see: as much light as one ray in
    // so many may bring that it is missed by all of them once in a thousand pixels.
    const double integrals = kIntegrals * rotations.brightest();
    const double unseen = 7 * rotations.brightest() / (kMany * Rotations::kRays);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        EXPECT_LE(std::abs(rotations.apart(i)), kDeviations * rotations.deviation(i) + unseen + integrals)
            << what << ", value " << i;
    }
    EXPECT_LE(std::abs(rotations.apart_in_mean()), kDeviations * rotations.deviation_of_mean() + integrals) << what;
    EXPECT_LE(rotations.rms_apart(), 1.25 * rotations.rms_deviation() + integrals) << what;
    EXPECT_LE(rotations.rms_apart(), early / 3) << what;
}

}  // namespace zerkalo::laws
