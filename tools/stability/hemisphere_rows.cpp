// A mirror as hollow as can be.
#include "tools/stability/exact.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>

namespace zerkalo::stability {
namespace {

// S07: all but a hemisphere. A matte front under a lamp far up its axis shows N_z, all but for the lamp's parallax.
constexpr double kHollow = 0.1;
constexpr double kFarUp = 1e9, kNotSoFar = 2;
constexpr double kRims[] = {1 - 2e-6, 1 - 1e-4, 0.99};  // radii of the rays' rings, in R
constexpr double kTooLarge[] = {1, 1.000001, 1.5};      // apertures that no hemisphere has
constexpr int kAround = 16;

/// The largest difference of N.L from the closed form, N_z = sqrt(1 - (rho / R)^2), on the rims, both from coordinates
/// in float.
template <class Light>
double rim_error(double lamp_up, const Light& light) {
    double largest = 0;
    for (const double rim : kRims) {
        for (int k = 0; k < kAround; ++k) {
            const double angle = 0.1 + 2 * std::numbers::pi * k / kAround;
            const float x = float(rim * kHollow * std::cos(angle)), y = float(rim * kHollow * std::sin(angle));
            const double rho = std::hypot(double{x}, double{y}) / kHollow, n_z = std::sqrt((1 - rho) * (1 + rho));
            const Vec3<double> n{-x / kHollow, -y / kHollow, n_z}, p{x, y, kHollow * (1 - n_z)};
            const double error = std::abs(light(x, y) - exact::lambert(p, n, {0, 0, lamp_up}));
            if (!(error <= largest)) largest = error;
        }
    }
    return largest;
}

double s07_ours(const Stage& stage) {
    Scene scene;
    add(scene, lamp({0, 0, kFarUp}));
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 1));
    scene.camera = camera_at({0, 0, 1}, {0, 0, -1}, 0.1);
    Mirror& mirror = scene.mirrors[0];
    mirror.boundary.shape = BoundaryShape::disc;
    mirror.boundary.radius = kHollow * (1 - 1e-6);
    mirror.curvature_radius = kHollow;
    mirror.reflection = 0, mirror.diffuse = 1;
    if (stage.beyond_formats(scene, "position")) scene.lights[0].position.z = kNotSoFar;
    const double error = rim_error(scene.lights[0].position.z, [&](float x, float y) {
        return stage.look(scene, {x, y, 1}, {0, 0, -1}).r;
    });
    for (const double aperture : kTooLarge) {
        mirror.boundary.radius = aperture * kHollow;
        if (stage.refused_field(scene) != "curvature_radius") return kInfinity;
    }
    return error;
}

/// The normal from the sagitta R - sqrt(R^2 - rho^2).
float naive_normal_z(float x, float y) {
    constexpr float kR = float(kHollow);
    return std::sqrt(1 - (x * x + y * y) / (kR * kR));
}
double s07_naive() {
    double beyond = 0;
    for (const double aperture : kTooLarge) beyond += naive_normal_z(float(aperture * kHollow), 0);
    return rim_error(kFarUp, naive_normal_z) + beyond;
}

constexpr StiffCase kRows[] = {
    {"S07", "a hemisphere of radius 0.1; wider apertures", "the root of R^2 - rho^2 < 0 at the rim",
     "N_z = sqrt(1 - (rho / R)^2) down to 0.002; wider is refused", "absolute", 1e-4, s07_ours, s07_naive,
     {.refused = "position"}},
};

}  // namespace

std::span<const StiffCase> hemisphere_rows() { return kRows; }

}  // namespace zerkalo::stability
