// Solids and mirrors that share a place: a face in the mirror's plane, a ball through it, a ball that touches it.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <numbers>
#include <random>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;  // pixels a side

// ---- A mirror let into a face

/// A solid at any angle with a smaller mirror in the plane of its lid or, for a pyramid, of its base.
struct Inlay {
    exact::Vec n, middle, right;
    double height;
    Scene scene;
};

/// Rotation angles about x and z that turn the y axis to n.
Vec3<double> turn_to(const exact::Vec& n) { return {std::asin(n.z), 0, std::atan2(-n.x, n.y)}; }

Inlay inlay(int number) {
    std::mt19937 random(static_cast<std::uint32_t>(number));
    const auto between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    const bool upright_one = number % 4 == 0;
    Inlay in;
    in.n = upright_one ? exact::Vec{0, 1, 0} : exact::unit({between(-1, 1), between(-1, 1), between(-1, 1)});
    in.middle = {between(-1, 1), between(-1, 1), between(-1, 1)};
    in.height = between(0.1, 2);
    const exact::Vec up = std::abs(in.n.y) > 0.9 ? exact::Vec{0, 0, 1} : exact::Vec{0, 1, 0};
    in.right = exact::unit(exact::cross(up, in.n));
    constexpr SolidKind kKinds[] = {SolidKind::prism, SolidKind::cylinder, SolidKind::pyramid};
    const SolidKind kind = kKinds[number % 3];
    const bool by_base = kind == SolidKind::pyramid;
    const exact::Vec base = by_base ? in.middle : exact::minus(in.middle, exact::times(in.n, in.height));
    Solid solid = upright(kind, base, 2, in.height, chalk());
    solid.rotation = turn_to(by_base ? exact::times(in.n, -1) : in.n);
    add(in.scene, solid);
    add(in.scene, ideal_mirror(in.middle, in.n, 1.5));
    in.scene.mirrors[0].up = up;
    const exact::Vec towards = exact::plus(exact::times(in.n, 3), exact::times(in.right, between(-2, 2)));
    add(in.scene, lamp(exact::plus(in.middle, exact::plus(towards, {0.5, 0.25, 0.125}))));
    const double away = number % 2 ? 1 : 100;
    in.scene.camera =
        camera_at(exact::plus(in.middle, exact::times(towards, away)), exact::times(towards, -1), 0.8 / away);
    in.scene.camera.up = exact::cross(in.n, in.right);
    return in;
}

constexpr int kInlays = 60;

double s43_ours(const Stage& stage) {
    int wrong = 0;
    for (int number = 0; number < kInlays; ++number) {
        Scene scene = inlay(number).scene;
        const Picture with = stage.render(scene, kSide, kSide);
        scene.mirror_count = 0;
        wrong += pixels_apart(with, stage.render(scene, kSide, kSide));
    }
    return wrong;
}

/// The nearer of two planes, each through a point of its own: the face through a corner, the mirror through its middle.
double s43_naive() {
    int wrong = 0;
    for (int number = 0; number < kInlays; ++number) {
        const Inlay in = inlay(number);
        const auto rounded = [](const exact::Vec& p) { return Vec3<float>{float(p.x), float(p.y), float(p.z)}; };
        const Vec3<float> n = rounded(in.n), middle = rounded(in.middle), o = rounded(in.scene.camera.position);
        const Vec3<float> corner = rounded(exact::plus(in.middle, exact::times(in.right, 2)));
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const Vec3<float> d = rounded(exact::through_pixel(in.scene.camera, kSide, kSide, i, j).d);
                const float to_face = naive::dot(n, naive::minus(corner, o)) / naive::dot(n, d);
                const float to_mirror = naive::dot(n, naive::minus(middle, o)) / naive::dot(n, d);
                const Vec3<float> p = naive::minus(naive::along(o, to_mirror, d), middle);
                const bool on_mirror = std::sqrt(naive::dot(p, p)) < 0.75f;
                wrong += on_mirror && to_mirror < to_face;
            }
        }
    }
    return wrong;
}

// ---- A ball in the mirror z = 0

/// A glowing ball of radius 1 with its centre at the given height over the mirror.
Scene ball_and_mirror(double height, const Camera& camera) {
    Scene scene;
    add(scene, ball({0, 0, height}, 1, glowing({1, 1, 1})));
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 16));
    scene.camera = camera;
    return scene;
}

/// 1: the pixel sees the ball's part before the mirror, directly or reflected; -1: neither; 0: too near to an edge.
int sees_ball(const exact::Ray& ray, double height, double hair) {
    const exact::Vec centre{0, 0, height};
    const exact::Span direct = exact::sphere(ray, centre, 1);
    const double to_mirror = -ray.o.z / ray.d.z;
    if (std::abs(exact::miss_of_sphere(ray, centre, 1)) < hair) return 0;
    if (to_mirror < 0) return direct.entry < direct.exit ? 1 : -1;
    const exact::Vec p = exact::at(ray, to_mirror);
    if (direct.entry < direct.exit) {
        const double over_seam = exact::at(ray, direct.entry).z;
        if (std::abs(over_seam) < hair) return 0;
        if (over_seam > 0) return 1;
    }
    const exact::Ray reflected{p, {ray.d.x, ray.d.y, -ray.d.z}};
    if (std::abs(exact::miss_of_sphere(reflected, centre, 1)) < hair) return 0;
    const exact::Span image = exact::sphere(reflected, centre, 1);
    return image.entry < image.exit && image.entry > 0 ? 1 : -1;
}

template <class Lit>
int wrong_about_ball(const Scene& scene, double height, double hair, const Lit& lit) {
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const int sees = sees_ball(ray, height, hair);
            wrong += sees != 0 && lit(i, j, ray) != (sees > 0);
        }
    }
    return wrong;
}

constexpr double kHeights[] = {0.6, 0.2, 0, -0.2, -0.6, -0.95};
constexpr double kHair = 1e-5;
const Camera kAslant = camera_at({1, 2.5, 2}, {-1, -2.5, -2}, 0.8);

double s44_ours(const Stage& stage) {
    int wrong = 0;
    for (const double height : kHeights) {
        const Scene scene = ball_and_mirror(height, kAslant);
        const Picture picture = stage.render(scene, kSide, kSide);
        wrong += wrong_about_ball(scene, height, kHair,
                                  [&](int i, int j, const exact::Ray&) { return picture.at(i, j).g > 0; });
    }
    return wrong;
}

Vec3<float> rounded(const exact::Vec& p) { return {float(p.x), float(p.y), float(p.z)}; }

/// The mirror image as a second ball behind the mirror, whole.
double s44_naive() {
    int wrong = 0;
    for (const double height : kHeights) {
        wrong +=
            wrong_about_ball(ball_and_mirror(height, kAslant), height, kHair, [&](int, int, const exact::Ray& ray) {
                const Vec3<float> o = rounded(ray.o), d = rounded(ray.d);
                const naive::Roots hit = naive::sphere(o, d, {0, 0, float(height)}, 1);
                const bool before = hit.real && o.z + hit.first * d.z > 0;
                return before || naive::sphere(o, d, {0, 0, -float(height)}, 1).real;
            });
    }
    return wrong;
}

// ---- A ball on the mirror

/// A ball that touches the mirror, from close by under its overhang: all that is seen lies in its shadow.
Scene ball_on_mirror() {
    constexpr double kSlope = 0.02, kAway = 0.25;
    Scene scene = ball_and_mirror(1, camera_at({0, -kAway, kAway * kSlope}, {0, 1, -kSlope}, kSlope));
    scene.solids[0].material.diffuse = scene.mirrors[0].diffuse = 1;
    add(scene, lamp({0, 0, 4}));
    return scene;
}

double s45_ours(const Stage& stage) {
    const Camera wide = camera_at({0, -0.25, 0.02}, {0, 1, -0.08}, 0.2);
    const Scene meeting = ball_and_mirror(1, wide);
    const Picture outlines = stage.render(meeting, kSide, kSide);
    const int wrong =
        wrong_about_ball(meeting, 1, kHair, [&](int i, int j, const exact::Ray&) { return outlines.at(i, j).g > 0; });
    Scene scene = ball_on_mirror();
    const Picture picture = stage.render(scene, kSide, kSide);
    scene.light_count = 0;
    return wrong + pixels_apart(picture, stage.render(scene, kSide, kSide));
}

/// Shadow rays whose blocker must be farther than an epsilon: lit pixels of the mirror.
double s45_naive() {
    constexpr float kEpsilon = 1e-3f;
    const Scene scene = ball_on_mirror();
    int lit = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const Vec3<float> o = rounded(ray.o), d = rounded(ray.d), centre{0, 0, 1};
            if (d.z >= 0 || naive::sphere(o, d, centre, 1).real) continue;
            const Vec3<float> p = naive::along(o, -o.z / d.z, d);
            const naive::Roots blocker = naive::sphere(p, naive::unit(naive::minus({0, 0, 4}, p)), centre, 1);
            lit += !(blocker.real && blocker.first > kEpsilon);
        }
    }
    return lit;
}

constexpr StiffCase kRows[] = {
    {"S43", "mirrors let into a face of prisms, cylinders, pyramids at any angle",
     "two roundings of one distance: a speckled mixture",
     "the solid wins: the picture is that of the solid alone, lit pixels included", "wrong pixels", 0, s43_ours,
     s43_naive},
    {"S44", "balls that pierce a mirror, down to 1/20 of their radius",
     "a mirrored copy of the ball: the part behind the mirror comes out in front",
     "only what lies before the mirror is seen and reflected; the seam is right to 1e-5", "wrong pixels", 0, s44_ours,
     s44_naive},
    {"S45", "a ball that touches a mirror, its lamp above, seen from close by",
     "an epsilon lets light in around the contact",
     "ball and image meet without a gap, and no pixel between them is lit", "wrong pixels", 0, s45_ours, s45_naive},
};

}  // namespace

std::span<const StiffCase> contact_rows() { return kRows; }

}  // namespace zerkalo::stability
