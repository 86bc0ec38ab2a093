// The scenes of the three pictures, built by the compiler.
#pragma once

#include "tests/proofs/pictures/pictures.hpp"

namespace zerkalo::pictures {

constexpr Camera kCamera{{1.2, 2.3, 5.2}, {-1.2, -1.5, -5.8}, {0, 1, 0}, 0.733, FovAxis::horizontal};

constexpr Mirror mirror_behind(Lobe lobe, double exponent, double curvature_radius) {
    Mirror mirror;
    mirror.position = {0, 1.25, -1.6};
    mirror.boundary = {BoundaryShape::rectangle, 4.0, 2.5, 1, 0, {}};
    mirror.curvature_radius = curvature_radius;
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    mirror.color = {0.95, 0.80, 0.45};
    return mirror;
}

constexpr Solid solid_of(SolidKind kind, Vec3<double> position, double taper) {
    Solid solid;
    solid.kind = kind;
    solid.position = position;
    solid.rotation = {0, 0.35, 0};
    solid.radius = 0.5;
    solid.height = 0.9;
    solid.taper = taper;
    solid.sides = 5;
    return solid;
}

constexpr Scene sharp_scene() {
    Scene scene;
    scene.camera = kCamera;
    scene.background = {0.02, 0.03, 0.12};
    scene.light_count = scene.solid_count = scene.mirror_count = 1;
    scene.lights[0].position = {-3, 4, 0.8};
    scene.solids[0] = solid_of(SolidKind::sphere, {0, 0.6, 0}, 1);
    scene.mirrors[0] = mirror_behind(Lobe::max_phong, kInfinity, kInfinity);
    return scene;
}

constexpr Scene glossy_scene() {
    Scene scene = sharp_scene();
    scene.solids[0] = solid_of(SolidKind::prism, {0, 0, 0}, 1);
    scene.mirrors[0] = mirror_behind(Lobe::phong, 200, 9.0);
    return scene;
}

constexpr Scene everything_scene() {
    Scene scene = glossy_scene();
    scene.light_count = scene.mirror_count = 2;
    scene.lights[1] = {{3, 5, 3}, {1, 0.6, 0.3}, 20, Falloff::inverse_square};
    scene.solid_count = 6;
    scene.solids[1] = solid_of(SolidKind::pyramid, {-1.3, 0, -0.5}, 1);
    scene.solids[2] = solid_of(SolidKind::sphere, {1.2, 0.6, -0.4}, 1);
    scene.solids[2].material.transmission = 0.6;
    scene.solids[2].material.reflection = 0.2;
    scene.solids[3] = solid_of(SolidKind::cylinder, {-0.6, 0, 0.9}, 1);
    scene.solids[4] = solid_of(SolidKind::cone, {1.0, 0, 0.9}, 0);
    scene.solids[5] = solid_of(SolidKind::mesh, {-1.6, 0.2, 0.6}, 1);
    scene.solids[5].triangle_count = scene.triangle_count = 4;
    constexpr Vec3<double> a{0, 0, 0}, b{0.6, 0, 0}, c{0, 0.6, 0}, d{0, 0, 0.6};
    scene.triangles[0] = {a, c, b};
    scene.triangles[1] = {a, b, d};
    scene.triangles[2] = {a, d, c};
    scene.triangles[3] = {b, c, d};
    scene.mirrors[1] = mirror_behind(Lobe::max_phong, kInfinity, -6.0);
    scene.mirrors[1].position = {0, 1.25, 7};
    scene.mirrors[1].normal = {0, 0, -1};
    scene.mirrors[1].boundary = {BoundaryShape::disc, 1, 1, 1.2, 0, {}};
    return scene;
}

inline constexpr Scene kScenes[kPictureCount] = {sharp_scene(), glossy_scene(), everything_scene()};

}  // namespace zerkalo::pictures
