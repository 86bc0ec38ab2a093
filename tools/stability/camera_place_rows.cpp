// Cameras where none should be: inside a solid, on its surface, on and behind a mirror.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 24;
constexpr Vec3<double> kSixViews[] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0.01}, {0, -1, 0.01}};

// S10: a camera with a lamp beside it inside a chalk ball and a chalk box sees the inner wall, N towards it.
constexpr Vec3<double> kInside{0.3, -0.2, 0.1}, kInsideLamp{-0.1, 0.3, -0.2};
constexpr double kFov = 1.5;

/// The light of the ball's inner wall where the ray from kInside along d ends.
double exact_wall_light(const Vec3<double>& d) {
    const double b = exact::dot(kInside, d);
    const Vec3<double> p = exact::along(kInside, -b + std::sqrt(b * b + 1 - exact::dot(kInside, kInside)), d);
    return exact::lambert(p, exact::times(p, -1), kInsideLamp);
}

/// The light by the first root and the normal of the outside, as for every ray that comes from outside.
double naive_wall_light(const Vec3<double>& d) {
    const Vec3<float> o = naive::rounded(kInside), dir = naive::rounded(d);
    const naive::Roots roots = naive::sphere(o, dir, {0, 0, 0}, 1);
    const Vec3<float> p = naive::along(o, roots.first, dir);
    return naive::lambert(p, p, naive::rounded(kInsideLamp));
}

double s10_ours(const Stage& stage) {
    Scene scene;
    add(scene, ball({0, 0, 0}, 1, chalk()));
    add(scene, lamp(kInsideLamp));
    add(scene, lamp({0, 5, 0}));  // outside: its light never comes in
    double largest = 0;
    for (const Vec3<double>& view : kSixViews) {
        scene.camera = camera_at(kInside, view, kFov);
        const Picture picture = stage.render(scene, kSide, kSide);
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const double error = std::abs(
                    picture.at(i, j).r - exact_wall_light(exact::through_pixel(scene.camera, kSide, kSide, i, j).d));
                if (!(error <= largest)) largest = error;
            }
        }
    }
    return largest;
}

double s10_naive() {
    double largest = 0;
    for (const Vec3<double>& view : kSixViews) {
        const Camera camera = camera_at(kInside, view, kFov);
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const Vec3<double> d = exact::through_pixel(camera, kSide, kSide, i, j).d;
                const double error = std::abs(naive_wall_light(d) - exact_wall_light(d));
                if (!(error <= largest)) largest = error;
            }
        }
    }
    return largest;
}

// S11: cameras on surfaces to the last digit, with the outward normal there.
struct OnSurface {
    Solid solid;
    Vec3<double> place, normal;
};

std::vector<OnSurface> places() {
    const Material red = glowing({1, 0, 0});
    const Vec3<double> base{0.1, -0.2, 0.3};
    const Solid sphere = ball(base, 0.7, red), tube = upright(SolidKind::cylinder, base, 0.5, 1, red);
    const Solid cone = upright(SolidKind::cone, base, 0.6, 0.9, red),
                prism = upright(SolidKind::prism, base, 0.6, 1, red);
    const Solid pyramid = upright(SolidKind::pyramid, base, 0.6, 0.9, red);
    std::vector<OnSurface> all;
    const auto stand = [&](const Solid& solid, const Vec3<double>& from_base, const Vec3<double>& outwards) {
        all.push_back({solid, exact::plus(base, from_base), exact::unit(outwards)});
    };
    for (int k = 0; k < 4; ++k) {
        const double angle = 0.3 + 1.7 * k, c = std::cos(angle), s = std::sin(angle), up = 0.15 + 0.2 * k;
        const Vec3<double> any = exact::unit({c, up - 0.4, s});
        stand(sphere, exact::times(any, 0.7), any);
        stand(tube, {0.5 * c, up, 0.5 * s}, {c, 0, s});
        stand(tube, {up / 2 * c, double(k % 2), up / 2 * s}, {0, k % 2 == 0 ? -1.0 : 1.0, 0});
        stand(cone, {0.6 * (0.9 - up) / 0.9 * c, up, 0.6 * (0.9 - up) / 0.9 * s}, {0.9 * c, 0.6, 0.9 * s});
        const double facing = (2 * k + 1) * std::numbers::pi / 4, apothem = 0.6 * std::numbers::sqrt2 / 2;
        const Vec3<double> face{std::cos(facing), 0, std::sin(facing)};
        stand(prism, exact::along({0, up, 0}, apothem, face), face);
        stand(pyramid, exact::along({0, up, 0}, apothem * (0.9 - up) / 0.9, face),
              exact::plus(exact::times(face, 0.9), {0, apothem, 0}));
    }
    return all;
}

/// Rays that do not see red below the tangent plane and the background above it. `sees(place, d)`: red?
template <class Sees>
double wrong_halves(const Sees& sees) {
    constexpr double kBand = 1e-3;  // rays so near to the tangent plane may go either way
    int wrong = 0;
    for (const OnSurface& at : places()) {
        for (const Vec3<double>& view : kSixViews) {
            const Camera camera = camera_at(at.place, view, kFov);
            const auto red = sees(at, camera);
            for (int j = 0; j < kSide; ++j) {
                for (int i = 0; i < kSide; ++i) {
                    const double rise = exact::dot(exact::through_pixel(camera, kSide, kSide, i, j).d, at.normal);
                    wrong += std::abs(rise) > kBand && red(i, j) != (rise < 0);
                }
            }
        }
    }
    return wrong;
}

double s11_ours(const Stage& stage) {
    return wrong_halves([&](const OnSurface& at, const Camera& camera) {
        Scene scene;
        add(scene, at.solid);
        scene.camera = camera;
        return [picture = stage.render(scene, kSide, kSide)](int i, int j) { return picture.at(i, j).r > 0; };
    });
}

/// Spheres by b^2 - 4ac and any root beyond 0; of the other solids nothing is said.
double s11_naive() {
    return wrong_halves([](const OnSurface& at, const Camera& camera) {
        return [&at, camera](int i, int j) {
            const Vec3<double> d = exact::through_pixel(camera, kSide, kSide, i, j).d;
            if (at.solid.kind != SolidKind::sphere) return exact::dot(d, at.normal) < 0;
            const naive::Roots roots = naive::sphere(naive::rounded(at.place), naive::rounded(d),
                                                     naive::rounded(at.solid.position), float(at.solid.radius));
            return roots.real && (roots.first > 0 || roots.second > 0);
        };
    });
}

// S12: a ball before the mirror and one behind it; the camera behind the mirror, and on its plane.
constexpr double kLeaning = 0.4;  // radians, of the mirror about y
const Vec3<double> kMirrorNormal{std::sin(kLeaning), 0, std::cos(kLeaning)},
    kMirrorRight{std::cos(kLeaning), 0, -std::sin(kLeaning)};
constexpr Rgb<double> kTint{1, 0.5, 0.25};
constexpr double kBehind[] = {1e-6, 1e-3, 1};

struct MirrorFaults {
    int wrong = 0;

    /// The back: C K_a = tint and nothing else, bit by bit.
    void behind(const Picture& picture) {
        for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
            wrong += !(picture.rgb[i] == 1 && picture.rgb[i + 1] == 0.5f && picture.rgb[i + 2] == 0.25f);
        }
    }
};

Camera behind_mirror(double distance) { return camera_at(exact::times(kMirrorNormal, -distance), kMirrorNormal, 0.8); }
/// A camera in the mirror's plane, aside from its middle.
Camera on_mirror(double aside, const Vec3<double>& view) {
    return camera_at(exact::along({0, 0.3, 0}, aside, kMirrorRight), view, 1.2);
}

/// `picture(camera, with_mirror)`.
template <class PictureOf>
double mirror_faults(const PictureOf& picture) {
    MirrorFaults faults;
    for (const double distance : kBehind) faults.behind(picture(behind_mirror(distance), true));
    for (const double aside : {-0.7, -0.3, 0.1, 0.6}) {
        for (const Vec3<double>& view : kSixViews) {
            const Camera camera = on_mirror(aside, view);
            faults.wrong += pixels_apart(picture(camera, true), picture(camera, false));
        }
    }
    return faults.wrong;
}

constexpr double kBallAt[] = {2, -2};  // along the normal

double s12_ours(const Stage& stage) {
    return mirror_faults([&](const Camera& camera, bool with_mirror) {
        Scene scene;
        scene.background = {0.1, 0.1, 0.1};
        scene.camera = camera;
        for (const double at : kBallAt) add(scene, ball(exact::times(kMirrorNormal, at), 0.5, glowing({0, 1, 0})));
        if (with_mirror) add(scene, ideal_mirror({0, 0, 0}, kMirrorNormal, 2));
        scene.mirrors[0].color = kTint, scene.mirrors[0].ambient = 1;
        return stage.render(scene, kSide, kSide);
    });
}

/// Does a ray see a ball? 0.1: the background.
float naive_ball(Vec3<float> o, Vec3<float> d) {
    for (const double at : kBallAt) {
        const naive::Roots roots = naive::sphere(o, d, naive::rounded(exact::times(kMirrorNormal, at)), 0.5f);
        if (roots.real && roots.first > 0) return 1;
    }
    return 0.1f;
}

/// t = (P - O).N / (D.N) > 0 and D - 2 N (N.D), whatever the side.
double s12_naive() {
    return mirror_faults([](const Camera& camera, bool with_mirror) {
        const Vec3<float> n = naive::rounded(kMirrorNormal), o = naive::rounded(camera.position);
        Picture picture{kSide, kSide, {}};
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const Vec3<float> d = naive::rounded(exact::through_pixel(camera, kSide, kSide, i, j).d);
                const float t = -naive::dot(o, n) / naive::dot(d, n);
                const Vec3<float> p = naive::along(o, t, d);
                const bool meets = with_mirror && t > 0 && naive::dot(p, p) < 1;
                const float light = meets ? naive_ball(p, naive::along(d, -2 * naive::dot(d, n), n)) : naive_ball(o, d);
                picture.rgb.insert(picture.rgb.end(), 3, light);
            }
        }
        return picture;
    });
}

constexpr StiffCase kRows[] = {
    {"S10", "camera and a lamp inside an opaque ball", "the first root lies behind the camera, N points outwards",
     "the inner wall, lit by the lamp inside alone, N towards the camera", "of full light", 1e-5, s10_ours, s10_naive},
    {"S11", "camera on a surface to the last digit", "the root 0 comes out as noise of either sign: acne",
     "the outer half sees the scene, the inner half the solid", "wrong pixels", 0, s11_ours, s11_naive},
    {"S12", "camera 1e-6 to 1 behind a mirror, and on its plane", "D.N is noise: it reflects from either side",
     "behind: the back's colour; on its plane: as without the mirror", "wrong pixels", 0, s12_ours, s12_naive},
};

}  // namespace

std::span<const StiffCase> camera_place_rows() { return kRows; }

}  // namespace zerkalo::stability
