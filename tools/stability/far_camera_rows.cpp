// Cameras far away.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 64;  // pixels a side
constexpr double kFarAway = 1e6;
constexpr double kFramed = 2.5;  // width of the picture at the sphere, radii

/// Is pixel (i, j) of a picture that frames the unit disc inside it? -1: out, 1: in, 0: within `band` of the edge.
int side_of_disc(int i, int j, double band) {
    const double x = kFramed * ((i + 0.5) / kSide - 0.5), y = kFramed * ((j + 0.5) / kSide - 0.5);
    const double beyond = std::sqrt(x * x + y * y) - 1;
    return beyond > band ? -1 : beyond < -band ? 1 : 0;
}

/// Pixels on the wrong side of the disc's edge, but for a ring of half a pixel.
template <class Lit>
double wrong_pixels(const Lit& lit) {
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const int side = side_of_disc(i, j, 0.5 * kFramed / kSide);
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
        const float x = float(kFramed * ((i + 0.5) / kSide - 0.5) / kFarAway);
        const float y = float(kFramed * ((j + 0.5) / kSide - 0.5) / kFarAway);
        return naive::sphere(eye, naive::unit({x, y, -1}), {0, 0, 0}, 1).real;
    });
}

constexpr StiffCase kRows[] = {
    {"S01", "camera at 1e6 from the unit sphere that it frames", "b^2 - 4ac is noise: a ragged disc",
     "the disc is the unit disc but for a ring of half a pixel", "wrong pixels", 0, s01_ours, s01_naive},
};

}  // namespace

std::span<const StiffCase> far_camera_rows() { return kRows; }

}  // namespace zerkalo::stability
