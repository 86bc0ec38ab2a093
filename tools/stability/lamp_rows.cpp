// Lamps where no lamp should be: on a surface, a hair above it, behind a mirror, inside a solid.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 33;  // pixels a side; odd, so that one looks at the middle
constexpr double kAmbient = 0.125;

/// Matte and shining from every side, so that no light that arrives can hide.
Material greedy() {
    Material material;
    material.color = {1, 1, 1};
    material.ambient = kAmbient;
    material.diffuse = material.specular = 1;
    material.shininess = 1;
    return material;
}

Light fading_lamp(const Vec3<double>& position) {
    Light light = lamp(position);
    light.falloff = Falloff::inverse_square;
    return light;
}

/// Pixels that differ from the picture of the same scene without lamps.
int lit_pixels(const Stage& stage, Scene scene) {
    const Picture picture = stage.render(scene, kSide, kSide);
    scene.light_count = 0;
    return pixels_apart(picture, stage.render(scene, kSide, kSide));
}

// ---- On the surface

Scene lamp_on_ball() {
    Scene scene;
    add(scene, ball({0, 0, 0}, 1, greedy()));
    add(scene, fading_lamp({0, 0, 1}));
    scene.camera = camera_at({0, 0, 4}, {0, 0, -1}, 0.6);
    return scene;
}

double s36_ours(const Stage& stage) { return lit_pixels(stage, lamp_on_ball()); }

/// I K_d (N.L) / r^2, gated by a comparison that does not say no to NaN.
double s36_naive() {
    const Scene scene = lamp_on_ball();
    int lit = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const Vec3<float> o{0, 0, 4}, d{float(ray.d.x), float(ray.d.y), float(ray.d.z)};
            const naive::Roots hit = naive::sphere(o, d, {0, 0, 0}, 1);
            if (!hit.real) continue;
            const Vec3<float> p = naive::along(o, hit.first, d), way = naive::minus({0, 0, 1}, p);
            const float r2 = naive::dot(way, way);
            lit += !(naive::dot(p, way) / std::sqrt(r2) / r2 <= 0);
        }
    }
    return lit;
}

// ---- A hair above it

// In fixed point a lamp less than half a step above a surface stands on it, and lights nothing.
constexpr double kHair = 1e-20, kFixedHair = 0x1p-20;

/// A floor with its lid in y = 0 and three lamps a hair above it, one of them stronger, seen directly or in a mirror
/// that lets no blue back.
Scene lamps_on_floor(bool in_mirror, double hair, double stronger) {
    Scene scene;
    add(scene, upright(SolidKind::prism, {0, -1, 0}, 4, 1, greedy()));
    for (int k = 0; k < 3; ++k) add(scene, fading_lamp({0, hair, 0}));
    scene.lights[1].intensity = stronger;
    if (in_mirror) {
        Mirror mirror = ideal_mirror({0, 4, 0}, {0, -1, 0}, 8);
        mirror.up = {0, 0, 1};
        mirror.color = {1, 0.5, 0};
        add(scene, mirror);
    }
    scene.camera = camera_at({0, 2, 0}, {0, in_mirror ? 1.0 : -1.0, 0}, 0.6);
    return scene;
}

double s37_ours(const Stage& stage) {
    int wrong = 0;
    for (const bool in_mirror : {false, true}) {
        for (const double hair : {kHair, kFixedHair}) {
            Scene scene = lamps_on_floor(in_mirror, hair, 1e300);
            if (stage.beyond_formats(scene, "intensity")) scene = lamps_on_floor(in_mirror, hair, 1e3);
            const Picture picture = stage.render(scene, kSide, kSide);
            for (const float value : picture.rgb) wrong += !(std::isfinite(value) && value >= 0);
            const bool on_surface = stage.fixed() && hair == kHair;
            wrong += (picture.at(kSide / 2, kSide / 2).r > 1) == on_surface;
        }
    }
    return wrong;
}

double s37_naive() {
    int wrong = 0;
    for (const float tint : {1.0f, 0.5f, 0.0f}) {
        const float h = float(kHair), e = 1 / (h * h);
        wrong += !std::isfinite(tint * e);
    }
    return wrong;
}

// ---- Behind a mirror

/// A mirror with a ball on a pole before it and a lamp behind it: all that is seen lies in the mirror's shadow.
Scene lamp_behind_mirror() {
    Scene scene;
    add(scene, upright(SolidKind::cylinder, {0, -1, 0.5}, 0.1, 1, greedy()));
    add(scene, ball({0, 0.25, 0.5}, 0.25, greedy()));
    Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 4);
    mirror.diffuse = mirror.specular = 1;
    mirror.ambient = kAmbient;
    mirror.shininess = 1;
    add(scene, mirror);
    add(scene, lamp({1.2, 0.3, -0.3}));
    scene.camera = camera_at({3.2, 0.5, 2.5}, {-3.2, -0.3, -2}, 0.5);
    return scene;
}

double s38_ours(const Stage& stage) { return lit_pixels(stage, lamp_behind_mirror()); }

/// Shadow rays that ask the solids only.
double s38_naive() {
    const Scene scene = lamp_behind_mirror();
    int lit = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const Vec3<float> o{3.2f, 0.5f, 2.5f}, d{float(ray.d.x), float(ray.d.y), float(ray.d.z)}, c{0, 0.25f, 0.5f};
            const naive::Roots hit = naive::sphere(o, d, c, 0.25f);
            if (!hit.real) continue;
            const Vec3<float> p = naive::along(o, hit.first, d);
            lit += naive::dot(naive::minus(p, c), naive::minus({1.2f, 0.3f, -0.3f}, p)) > 0;
        }
    }
    return lit;
}

// ---- Inside a solid

constexpr SolidKind kConvex[] = {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                                 SolidKind::cone};

/// A solid about the origin that swallows a lamp, on a floor.
Scene swallowed_lamp(SolidKind kind) {
    Scene scene;
    add(scene, upright(SolidKind::prism, {0, -2, 0}, 8, 1, greedy()));
    const Vec3<double> base{0, kind == SolidKind::sphere ? 0.0 : -1.0, 0};
    add(scene, upright(kind, base, 1, 2, greedy()));
    add(scene, lamp({0.1, -0.2, 0.05}));
    scene.camera = camera_at({0.5, 3, 5}, {-0.1, -0.7, -1}, 0.9);
    return scene;
}

double s39_ours(const Stage& stage) {
    int lit = 0;
    for (const SolidKind kind : kConvex) lit += lit_pixels(stage, swallowed_lamp(kind));
    return lit;
}

/// Shadow rays from the lamp that look at the nearer root alone, which lies behind it.
double s39_naive() {
    const Scene scene = swallowed_lamp(SolidKind::sphere);
    int lit = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const exact::Vec p = exact::at(ray, (-1 - ray.o.y) / ray.d.y);
            if (ray.d.y >= 0 || exact::sphere(ray, {0, 0, 0}, 1).entry < exact::length(exact::minus(p, ray.o)))
                continue;
            const Vec3<float> o{0.1f, -0.2f, 0.05f};
            const Vec3<float> way = naive::minus({float(p.x), float(p.y), float(p.z)}, o);
            const naive::Roots walls = naive::sphere(o, way, {0, 0, 0}, 1);
            lit += !(walls.real && walls.first > 0 && walls.first < 1);
        }
    }
    return lit;
}

constexpr StiffCase kRows[] = {
    {"S36", "a lamp with 1/r^2 on the surface of a ball", "(N.L) / r^2 is 0 / 0 where the lamp stands",
     "it lights no point of the ball, its own place included", "lit pixels", 0, s36_ours, s36_naive},
    {"S37", "lamps with 1/r^2 at 1e-20 above a floor, seen in an orange mirror too",
     "1/r^2 is infinite, and times the blue that the mirror lacks NaN", "bright and finite, every pixel and channel",
     "wrong values", 0, s37_ours, s37_naive, {.refused = "intensity"}},
    {"S38", "a lamp behind a mirror", "shadow rays ask solids only: the lamp shines through the mirror",
     "nothing before the mirror is lit", "lit pixels", 0, s38_ours, s38_naive},
    {"S39", "a lamp inside each kind of solid", "the shadow ray's nearer root lies behind the lamp: no shadow",
     "nothing outside is lit", "lit pixels", 0, s39_ours, s39_naive},
};

}  // namespace

std::span<const StiffCase> lamp_rows() { return kRows; }

}  // namespace zerkalo::stability
