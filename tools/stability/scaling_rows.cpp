// Scenes that are larger, or elsewhere: no length and no place is special.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include "core/geometry/algebra.hpp"

#include <algorithm>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;             // pixels a side
constexpr double kHalfView = 0.4375;  // tangent of half the angle of view

/// Changes every place of a scene.
template <class Moved>
void move_all(Scene& scene, const Moved& moved) {
    scene.camera.position = moved(scene.camera.position);
    for (Solid* s = scene.solids; s < scene.solids + scene.solid_count; ++s) s->position = moved(s->position);
    for (Light* l = scene.lights; l < scene.lights + scene.light_count; ++l) l->position = moved(l->position);
    for (Mirror* m = scene.mirrors; m < scene.mirrors + scene.mirror_count; ++m) m->position = moved(m->position);
}

void add_mesh(Scene& scene, const Vec3<double>& position) {
    const Vec3<double> a{0, 0, 0}, b{0.5, 0, 0}, c{0, 0.5, 0}, d{0, 0, 0.5};
    for (const Triangle& face : {Triangle{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) {
        scene.triangles[scene.triangle_count++] = face;
    }
    Solid mesh = ball(position, 1, Material{});
    mesh.kind = SolidKind::mesh;
    mesh.triangle_count = 4;
    add(scene, mesh);
}

/// Every kind of solid, one of glass, before a mirror, under a lamp that fades. All places lie on a grid of 1/8.
Scene everything(double curvature_radius) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    scene.camera = camera_at({0.5, 2.125, 6}, {-0.1, -0.25, -1}, 2 * std::atan(kHalfView));
    Material glass;
    glass.transmission = 0.75;
    glass.reflection = 0.25;
    add(scene, ball({0.25, 0.5, 2}, 0.5, glass));
    add(scene, upright(SolidKind::prism, {-1.25, 0, 0.5}, 0.5, 0.75, Material{}));
    add(scene, upright(SolidKind::cone, {1.25, 0, 0.5}, 0.5, 1, Material{}));
    add(scene, upright(SolidKind::cylinder, {0, 0.125, -0.5}, 0.375, 1, Material{}));
    add(scene, upright(SolidKind::pyramid, {-0.5, 1.25, 0}, 0.5, 0.75, Material{}));
    add_mesh(scene, {1, 1.5, 1});
    add(scene, lamp({-3, 5, 4}));
    scene.lights[0].falloff = Falloff::inverse_square;
    scene.lights[0].intensity = 32;
    add(scene, ideal_mirror({0, 1, -1}, {0, 0, 1}, 4));
    scene.mirrors[0].diffuse = 0.25;
    scene.mirrors[0].curvature_radius = curvature_radius;
    return scene;
}

// S59.

Scene larger(Scene scene, double s) {
    move_all(scene, [&](const Vec3<double>& p) { return p * s; });
    for (int k = 0; k < scene.solid_count; ++k) {
        scene.solids[k].radius *= s;
        scene.solids[k].height *= s;
        scene.solids[k].scale *= s;
    }
    Mirror& mirror = scene.mirrors[0];
    mirror.boundary.width *= s, mirror.boundary.height *= s;
    mirror.curvature_radius *= s;
    scene.lights[0].intensity *= s * s;
    return scene;
}

/// Pixels that differ between sizes. draw(size) -> picture.
template <class Draw>
double apart_between_sizes(const Draw& draw) {
    const Picture one = draw(1.0);
    double apart = 0;
    for (const int k : {-40, -17, -3, 1, 8, 23, 40}) apart += pixels_apart(one, draw(std::ldexp(1, k)));
    return apart;
}

double s59_ours(const Stage& stage) {
    double apart = 0;
    for (const double curvature_radius : {kInfinity, 8.0}) {
        const Scene scene = everything(curvature_radius);
        apart += apart_between_sizes([&](double s) { return stage.render(larger(scene, s), kSide, kSide); });
    }
    return apart;
}

/// A chalk ball under a lamp, seen along -z; rays start an epsilon ahead, shadow rays too.
Picture drawn(float size, Vec3<float> centre, Vec3<float> eye, Vec3<float> lamp_at, float epsilon) {
    Picture picture{kSide, kSide, {}};
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const float x = float(kHalfView * (2 * (i + 0.5) / kSide - 1));
            const float y = float(kHalfView * (1 - 2 * (j + 0.5) / kSide));
            const Vec3<float> d = naive::unit({x, y, -1});
            const auto roots = naive::sphere(eye, d, centre, size);
            float shade = 0;
            if (roots.real && roots.first > epsilon) {
                const Vec3<float> p = naive::along(eye, roots.first, d);
                const Vec3<float> l = naive::unit(naive::minus(lamp_at, p));
                const auto own = naive::sphere(p, l, centre, size);
                const bool shadowed = own.real && (own.first > epsilon || own.second > epsilon);
                const Vec3<float> n = naive::times(naive::minus(p, centre), 1 / size);
                shade = shadowed ? 0 : std::max(0.0f, naive::dot(n, l));
            }
            picture.rgb.insert(picture.rgb.end(), 3, shade);
        }
    }
    return picture;
}

constexpr float kEpsilon = 1e-4f;

double s59_naive() {
    return apart_between_sizes([](double s) {
        const float size = float(s);
        return drawn(size, {0, 0, 0}, {0, 0, 4 * size}, {3 * size, 4 * size, 5 * size}, kEpsilon);
    });
}

// S60.

constexpr double kStep = 0x1p20;
constexpr Vec3<double> kShifts[] = {{kStep, 0, 0}, {0, -kStep, 0}, {0, 0, kStep}, {kStep, kStep, -kStep}};

/// Pixels that differ between places. draw(shift) -> picture.
template <class Draw>
double apart_between_places(const Draw& draw) {
    const Picture here = draw(Vec3<double>{0, 0, 0});
    double apart = 0;
    for (const Vec3<double>& shift : kShifts) apart += pixels_apart(here, draw(shift));
    return apart;
}

double s60_ours(const Stage& stage) {
    double apart = 0;
    for (const double curvature_radius : {kInfinity, 8.0}) {
        const Scene scene = everything(curvature_radius);
        apart += apart_between_places([&](const Vec3<double>& shift) {
            Scene there = scene;
            move_all(there, [&](const Vec3<double>& p) { return p + shift; });
            return stage.render(there, kSide, kSide);
        });
    }
    return apart;
}

double s60_naive() {
    return apart_between_places([](const Vec3<double>& shift) {
        const auto there = [&](float x, float y, float z) -> Vec3<float> {
            return {float(x + shift.x), float(y + shift.y), float(z + shift.z)};
        };
        return drawn(1, there(0, 0, 0), there(0, 0, 4), there(3, 4, 5), 0);
    });
}

constexpr StiffCase kRows[] = {
    {"S59", "every kind of solid before a mirror, 2^-40 to 2^40 times as large",
     "an epsilon of 1e-4 is a length: all or nothing", "the same picture to the last bit", "pixels apart", 0,
     s59_ours, s59_naive},
    {"S60", "the same scene, 2^20 away along any axis, on a grid of 1/8",
     "hits are rounded to the grid: steps for a ball", "the same picture to the last bit", "pixels apart", 0,
     s60_ours, s60_naive},
};

}  // namespace

std::span<const StiffCase> scaling_rows() { return kRows; }

}  // namespace zerkalo::stability
