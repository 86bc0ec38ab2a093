// Lamps as far away as the sun, at infinity, and in the plane of a mirror.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;  // pixels a side

// ---- Sunlight

constexpr exact::Vec kSun{1.0 / 3, 2.0 / 3, 2.0 / 3};  // unit, towards it
constexpr exact::Vec kBall{0, 1.5, 0};

/// A ball over a wide floor y = 0, all chalk, the lamp in the direction of the sun.
Scene ball_in_the_sun(double distance) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, upright(SolidKind::prism, {0, -1, 0}, 32, 1, chalk()));
    add(scene, ball(kBall, 1, chalk()));
    add(scene, lamp(exact::times(kSun, distance)));
    scene.camera = camera_at({-2, 4, 5}, {0.4, -0.7, -1}, 0.8);
    return scene;
}

/// What a pixel shows in parallel light; edges are where a hair would decide.
struct Sunlit {
    bool edge;
    exact::Vec p, n;
    double light;
};

Sunlit in_parallel_light(const exact::Ray& ray) {
    constexpr double kHair = 1e-3;
    const exact::Span span = exact::sphere(ray, kBall, 1);
    const double miss = exact::miss_of_sphere(ray, kBall, 1);
    if (miss < 0) {
        const exact::Vec p = exact::at(ray, span.entry), n = exact::minus(p, kBall);
        return {miss > -0.1, p, n, std::max(0.0, exact::dot(n, kSun))};
    }
    const exact::Vec p = exact::at(ray, -ray.o.y / ray.d.y);
    const double shade = exact::miss_of_sphere({p, kSun}, kBall, 1);
    return {miss < kHair || std::abs(shade) < kHair, p, {0, 1, 0}, shade < 0 ? 0 : kSun.y};
}

/// The largest difference from parallel light. shown(i, j, what is seen).
template <class Shown>
double wrong_sunlight(const Shown& shown) {
    double largest = 0;
    const Camera camera = ball_in_the_sun(1).camera;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const Sunlit seen = in_parallel_light(exact::through_pixel(camera, kSide, kSide, i, j));
            if (seen.edge) continue;
            const double error = std::abs(shown(i, j, seen) - seen.light);
            if (std::isnan(error)) return error;
            largest = std::max(largest, error);
        }
    }
    return largest;
}

double wrong_in_picture(const Stage& stage, const Scene& scene) {
    const Picture picture = stage.render(scene, kSide, kSide);
    return wrong_sunlight([&](int i, int j, const Sunlit&) { return double{picture.at(i, j).g}; });
}

constexpr double kSunAway = 1e15, kSunPower = 1e30;

double s40_ours(const Stage& stage) {
    Scene scene = ball_in_the_sun(kSunAway);
    scene.lights[0].falloff = Falloff::inverse_square;
    scene.lights[0].intensity = kSunPower;
    return wrong_in_picture(stage, scene);
}

/// Cosine and fall-off in one: I (N.w) / |w|^3, w the way to the lamp.
double s40_naive() {
    return wrong_sunlight([](int, int, const Sunlit& seen) {
        const exact::Vec to = exact::times(kSun, kSunAway);
        const Vec3<float> p{float(seen.p.x), float(seen.p.y), float(seen.p.z)};
        const Vec3<float> n{float(seen.n.x), float(seen.n.y), float(seen.n.z)};
        const Vec3<float> way = naive::minus({float(to.x), float(to.y), float(to.z)}, p);
        const float r = std::sqrt(naive::dot(way, way));
        const float light = float(kSunPower) * naive::dot(n, way) / (r * r * r);
        return seen.light > 0 ? double{std::fmax(light, 0.0f)} : 0;
    });
}

// ---- At infinity

double s41_ours(const Stage& stage) {
    double largest = 0;
    for (const double distance : {1e8, 1e10, 1e12, 1e15}) {
        largest = std::max(largest, wrong_in_picture(stage, ball_in_the_sun(distance)));
    }
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const double beyond : {1.1e15, kInfinity, -kInfinity, kNone}) {
        for (const Vec3<double>& position : {Vec3<double>{beyond, 1, 1}, {1, beyond, 1}, {1, 1, beyond}}) {
            Scene scene = ball_in_the_sun(1);
            scene.lights[0].position = position;
            largest += stage.refused_field(scene) != "position";
        }
    }
    return largest;
}

/// A point at infinity as a position: L = (l - p) / |l - p|.
double s41_naive() {
    return wrong_sunlight([](int, int, const Sunlit& seen) {
        constexpr float kFar = std::numeric_limits<float>::infinity();
        const Vec3<float> p{float(seen.p.x), float(seen.p.y), float(seen.p.z)};
        const Vec3<float> n{float(seen.n.x), float(seen.n.y), float(seen.n.z)};
        return double{naive::dot(n, naive::unit(naive::minus({kFar, kFar, kFar}, p)))};
    });
}

// ---- In the plane of a mirror

/// A mirror at any angle that would show every light on it, a lamp in its plane, seen from the front or the back.
struct InPlane {
    exact::Vec n, right, v;
    Scene scene;
};

InPlane lamp_in_plane(int turn, bool front, double lamp_right) {
    InPlane in;
    in.n = turn == 0 ? exact::Vec{0, 0, 1} : exact::unit({0.3 * turn, 0.7, 1.1 - 0.2 * turn});
    in.right = exact::unit(exact::cross({0, 1, 0}, in.n));
    in.v = exact::cross(in.n, in.right);
    Scene& scene = in.scene;
    scene.ambient = {0, 0, 0};
    Mirror mirror = ideal_mirror({0.1 * turn, 0.2, 0.3}, in.n, 4);
    mirror.diffuse = mirror.specular = mirror.shininess = 1;
    add(scene, mirror);
    const auto place = [&](double right, double v, double n) {
        return exact::plus(exact::plus(mirror.position, exact::times(in.right, right)),
                           exact::plus(exact::times(in.v, v), exact::times(in.n, n)));
    };
    add(scene, lamp(place(lamp_right, 0.4, 0)));
    const double side = front ? 1 : -1;
    scene.camera =
        camera_at(place(-1.5, 0.25, 3 * side), exact::minus(mirror.position, place(-1.5, 0.25, 3 * side)), 0.9);
    return in;
}

constexpr int kTurns = 8;
constexpr double kBesideMirror = 3.3, kOnMirror = 0.5;

double s42_ours(const Stage& stage) {
    int wrong = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        for (const bool front : {true, false}) {
            const Picture mirror = stage.render(lamp_in_plane(turn, front, kBesideMirror).scene, kSide, kSide);
            for (const float light : mirror.rgb) wrong += !(light == 0);
            // A ball beside the mirror is lit as if the mirror, now black, were not there.
            InPlane in = lamp_in_plane(turn, front, kOnMirror);
            Scene& scene = in.scene;
            scene.mirrors[0].reflection = scene.mirrors[0].diffuse = scene.mirrors[0].specular = 0;
            add(scene, ball(exact::plus(scene.mirrors[0].position, exact::times(in.n, front ? 1 : -1)), 0.5, chalk()));
            const exact::Vec beside = exact::plus(scene.mirrors[0].position, exact::times(in.right, 4));
            const exact::Vec eye = exact::plus(beside, exact::times(in.n, front ? 0.75 : -0.75));
            scene.camera = camera_at(eye, exact::minus(scene.solids[0].position, eye), 0.4);
            const Picture with = stage.render(scene, kSide, kSide);
            scene.mirror_count = 0;
            // Without the mirror another power of two brings the scene into the box of fixed point: other roundings.
            const double tolerance = stage.fixed() ? 8 * 0x1p-24 : 0;
            wrong += pixels_apart(with, stage.render(scene, kSide, kSide), tolerance);
        }
    }
    return wrong;
}

/// Unlit where N.L <= 0.
double s42_naive() {
    int lit = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        const InPlane in = lamp_in_plane(turn, true, kBesideMirror);
        const auto rounded = [](const exact::Vec& p) { return Vec3<float>{float(p.x), float(p.y), float(p.z)}; };
        const Vec3<float> n = rounded(in.n), vertex = rounded(in.scene.mirrors[0].position);
        const Vec3<float> light = rounded(in.scene.lights[0].position), o = rounded(in.scene.camera.position);
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const Vec3<float> d = rounded(exact::through_pixel(in.scene.camera, kSide, kSide, i, j).d);
                const float t = naive::dot(n, naive::minus(vertex, o)) / naive::dot(n, d);
                lit += naive::dot(n, naive::unit(naive::minus(light, naive::along(o, t, d)))) > 0;
            }
        }
    }
    return lit;
}

constexpr StiffCase kRows[] = {
    {"S40", "the sun: a lamp at 1e15 with 1e30 / r^2", "(N.L) / r^3 with r^3 = infinity: black",
     "parallel light, with its shadow", "brightness", 1e-6, s40_ours, s40_naive,
     {.refused = "position", .every_scene = true}},
    {"S41", "lamps at 1e8 to 1e15; beyond, at infinity, at NaN", "infinity / infinity",
     "parallel light to the last place that is accepted; the others are refused", "brightness", 1e-6, s41_ours,
     s41_naive, {.refused = "position", .every_scene = true}},
    {"S42", "a lamp in the plane of a mirror, beside it and on it", "N.L is rounding: half of the pixels are lit",
     "neither side is lit, and the mirror hides the lamp from nothing", "wrong pixels", 0, s42_ours, s42_naive},
};

}  // namespace

std::span<const StiffCase> sun_rows() { return kRows; }

}  // namespace zerkalo::stability
