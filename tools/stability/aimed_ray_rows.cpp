// Rays aimed at edges and corners of polyhedra, against triangles by Moeller and Trumbore with the usual epsilon.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive_shapes.hpp"
#include "tools/stability/stiff_case.hpp"

#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr double kClose = 1e-3;
constexpr int kSides[] = {3, 4, 5, 6, 9, 64};

struct NaiveTriangle {
    Vec3<float> a, b, c;  // counter-clockwise seen from outside
};

/// The light of the nearest triangle, 2 where there is none. The normal is that of the outside.
float naive_light(const std::vector<NaiveTriangle>& triangles, Vec3<float> o, Vec3<float> d, Vec3<float> lamp_at) {
    constexpr float kEpsilon = 1e-6f;  // Moeller and Trumbore's own
    float nearest = std::numeric_limits<float>::infinity(), light = 2;
    for (const NaiveTriangle& triangle : triangles) {
        const float t = naive::to_triangle(o, d, triangle.a, triangle.b, triangle.c, kEpsilon);
        if (!(t < nearest)) continue;
        const Vec3<float> n =
            naive::unit(naive::cross(naive::minus(triangle.b, triangle.a), naive::minus(triangle.c, triangle.a)));
        nearest = t, light = naive::lambert(naive::along(o, t, d), n, lamp_at);
    }
    return light;
}

Vec3<double> around(double angle, double radius, double y) {
    return {radius * std::cos(angle), y, radius * std::sin(angle)};
}

/// The angle of corner k of n, or with k + 1/2 of the face after it.
double angle_of(double k, int sides) { return 2 * std::numbers::pi * k / sides; }

Solid regular(SolidKind kind, int sides, double size) {
    Solid solid = upright(kind, {0, 0, 0}, size, size, chalk());
    solid.sides = sides;
    return solid;
}

// S13: a picture of one column, every ray aimed at the upright edge at corner 0.
constexpr int kRows13 = 128;
constexpr double kSizes[] = {1, 1e-3};

struct EdgeView {
    int sides;
    double size, aside;  // aside: how far the camera stands from the corner's angle, in half sides

    Camera camera() const {
        const Vec3<double> corner = around(0, size, size / 2);
        const Vec3<double> eye = around(aside * std::numbers::pi / sides, 4 * size, size / 2);
        Camera camera = camera_at(eye, exact::minus(corner, eye), 0.2);
        camera.fov_axis = FovAxis::vertical;
        return camera;
    }
    Vec3<double> lamp_at() const { return around(0.05, 5 * size, 2 * size); }
};

/// Rays whose light is not that of either face at the edge. `column(view)`: light by row.
template <class Column>
double edge_leaks(const Column& column) {
    int leaks = 0;
    for (const int sides : kSides) {
        for (const double size : kSizes) {
            for (const double aside : {-0.35, -0.17, 0.0, 0.11, 0.23, 0.37}) {
                const EdgeView view{sides, size, aside};
                const auto light = column(view);
                const Camera camera = view.camera();
                for (int j = 0; j < kRows13; ++j) {
                    const double rise = std::tan(camera.fov / 2) * (1 - (2 * j + 1.0) / kRows13);
                    const Vec3<double> p = around(0, size, size / 2 + rise * exact::length(camera.view));
                    const double one = exact::lambert(p, around(angle_of(0.5, sides), 1, 0), view.lamp_at());
                    const double other = exact::lambert(p, around(angle_of(-0.5, sides), 1, 0), view.lamp_at());
                    leaks += !(std::abs(light(j) - one) < kClose || std::abs(light(j) - other) < kClose);
                }
            }
        }
    }
    return leaks;
}

double s13_ours(const Stage& stage) {
    return edge_leaks([&](const EdgeView& view) {
        Scene scene;
        scene.background = {2, 2, 2};
        scene.camera = view.camera();
        add(scene, regular(SolidKind::prism, view.sides, view.size));
        add(scene, lamp(view.lamp_at()));
        return [picture = stage.render(scene, 1, kRows13)](int j) { return picture.at(0, j).r; };
    });
}

double s13_naive() {
    return edge_leaks([](const EdgeView& view) {
        std::vector<NaiveTriangle> walls;
        for (int k = 0; k < view.sides; ++k) {
            const double here = angle_of(k, view.sides), next = angle_of(k + 1, view.sides);
            const Vec3<float> a = naive::rounded(around(here, view.size, 0));
            const Vec3<float> b = naive::rounded(around(next, view.size, 0));
            const Vec3<float> c = naive::rounded(around(next, view.size, view.size));
            const Vec3<float> d = naive::rounded(around(here, view.size, view.size));
            walls.push_back({a, c, b});
            walls.push_back({a, d, c});
        }
        return [walls, view](int j) {
            const Camera camera = view.camera();
            const float rise = float(std::tan(camera.fov / 2)) * (1 - float(2 * j + 1) / kRows13);
            const Vec3<float> towards = naive::rounded(exact::unit(camera.view));
            return naive_light(walls, naive::rounded(camera.position), naive::unit({towards.x, rise, towards.z}),
                               naive::rounded(view.lamp_at()));
        };
    });
}

// S14: rays aimed at the apex of a pyramid from above, and the picture from straight above.
const Vec3<double> kApexLamp{0.5, 9, 0.25};
constexpr int kAround = 60, kTopSide = 33;
constexpr double kTopFov = 0.1;  // from 5 above the apex: inside the base

/// Rays that show no face: every face is lit, the inner walls and the base are dark, the background is 2.
/// `picture(sides, camera, side)`: light by column and row.
template <class Light>
double apex_leaks(const Light& picture) {
    int leaks = 0;
    for (const int sides : kSides) {
        for (int k = 0; k < kAround; ++k) {
            const Vec3<double> eye = around(0.1 + 2.4 * k, 0.02 * k, 4 + 0.037 * k);
            const auto light = picture(sides, camera_at(eye, exact::minus({0, 1, 0}, eye), 0.01), 1);
            leaks += !(light(0, 0) > 0.1 && light(0, 0) <= 1);
        }
        const auto light = picture(sides, camera_at({0, 6, 0}, {0, -1, 0}, kTopFov), kTopSide);
        for (int j = 0; j < kTopSide; ++j) {
            for (int i = 0; i < kTopSide; ++i) leaks += !(light(i, j) > 0.1 && light(i, j) <= 1);
        }
    }
    return leaks;
}

double s14_ours(const Stage& stage) {
    return apex_leaks([&](int sides, Camera camera, int side) {
        Scene scene;
        scene.background = {2, 2, 2};
        scene.camera = camera;
        scene.camera.up = {0.1, 0.9, 0.3};
        add(scene, regular(SolidKind::pyramid, sides, 1));
        add(scene, lamp(kApexLamp));
        return [picture = stage.render(scene, side, side)](int i, int j) { return picture.at(i, j).r; };
    });
}

double s14_naive() {
    return apex_leaks([](int sides, Camera camera, int side) {
        std::vector<NaiveTriangle> walls;
        for (int k = 0; k < sides; ++k) {
            const Vec3<float> here = naive::rounded(around(angle_of(k, sides), 1, 0));
            const Vec3<float> next = naive::rounded(around(angle_of(k + 1, sides), 1, 0));
            walls.push_back({here, {0, 1, 0}, next});
        }
        camera.up = {0.1, 0.9, 0.3};
        return [walls, camera, side](int i, int j) {
            return naive_light(walls, naive::rounded(camera.position),
                               naive::rounded(exact::through_pixel(camera, side, side, i, j).d),
                               naive::rounded(kApexLamp));
        };
    });
}

constexpr StiffCase kRows[] = {
    {"S13", "rays aimed at the upright edge of a prism of 3 to 64 sides",
     "triangles: rays slip through, small ones vanish", "each ray shows one of the two faces", "leaks", 0, s13_ours,
     s13_naive},
    {"S14", "rays aimed at the apex of a pyramid of 3 to 64 sides", "triangles: rays slip through the corner",
     "each ray shows a face, seen from aside and from straight above", "leaks", 0, s14_ours, s14_naive},
};

}  // namespace

std::span<const StiffCase> aimed_ray_rows() { return kRows; }

}  // namespace zerkalo::stability
