// Solids of no size, of many sides, flat as a plate and long as a needle.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive_shapes.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;  // pixels a side

/// A solid without some extent: the field that must be named, and the textbook's normal of it.
struct Sizeless {
    Solid solid;
    const char* field;
    Vec3<float> normal;
};

/// The normal of a round solid about the axis from base to top, at a point beside the base.
Vec3<float> round_normal(float radius, float height) {
    const Vec3<float> axis = naive::unit({0, height, 0}), out{radius, 0, 0};
    return naive::unit(naive::minus(out, naive::times(axis, naive::dot(out, axis))));
}

/// The normal of the first side of a prism or pyramid of four sides, from three of its corners.
Vec3<float> side_normal(SolidKind kind, float radius, float height) {
    const Vec3<float> a{radius, 0, 0}, b{0, 0, radius};
    const Vec3<float> top = kind == SolidKind::prism ? Vec3<float>{radius, height, 0} : Vec3<float>{0, height, 0};
    return naive::unit(naive::cross(naive::minus(b, a), naive::minus(top, a)));
}

std::vector<Sizeless> sizeless_solids() {
    std::vector<Sizeless> list;
    const auto with = [&](SolidKind kind, float radius, float height, const char* field, Vec3<float> normal) {
        list.push_back({upright(kind, {0, 0, 0}, radius, height, chalk()), field, normal});
    };
    with(SolidKind::sphere, 0, 1, "radius", naive::unit({0, 0, 0}));
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::cone}) {
        with(kind, 0, 1, "radius", round_normal(0, 1));
        with(kind, 1, 0, "height", round_normal(1, 0));
    }
    for (const SolidKind kind : {SolidKind::prism, SolidKind::pyramid}) {
        with(kind, 0, 1, "radius", side_normal(kind, 0, 1));
        with(kind, 1, 0, "height", side_normal(kind, 1, 0));
    }
    return list;
}

double s25_ours(const Stage& stage) {
    int wrong = 0;
    for (const Sizeless& sizeless : sizeless_solids()) {
        Scene scene;
        add(scene, sizeless.solid);
        wrong += stage.refused_field(scene) != sizeless.field;
    }
    return wrong;
}

double s25_naive() {
    int wrong = 0;
    for (const Sizeless& sizeless : sizeless_solids()) {
        wrong += !std::isfinite(naive::dot(sizeless.normal, sizeless.normal));
    }
    return wrong;
}

// ---- Prisms seen from above

constexpr double kSmall = 0x1p-9;       // circumradius
constexpr double kAbove = 16 * kSmall;  // the camera's height over the lid
constexpr double kFramed = 1.1;         // half the picture at the lid, radii

/// How far beyond the regular n-gon of circumradius 1 a point lies.
double beyond_polygon(int sides, double x, double z) {
    double beyond = -1;
    for (int k = 0; k < sides; ++k) {
        const double angle = std::numbers::pi * (2 * k + 1) / sides;
        const double out = x * std::cos(angle) + z * std::sin(angle) - std::cos(std::numbers::pi / sides);
        beyond = std::max(beyond, out);
    }
    return beyond;
}

/// Pixels on the wrong side of the regular n-gon's edges. lit(x, z): in radii, on the lid.
template <class Lit>
int wrong_in_polygon(int sides, const Lit& lit) {
    constexpr double kHair = 1e-5;
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const double x = kFramed * (2 * (i + 0.5) / kSide - 1), z = kFramed * (2 * (j + 0.5) / kSide - 1);
            const int side = exact::side_of_outline(beyond_polygon(sides, x, z), kHair);
            wrong += side != 0 && lit(i, j, x, z) != (side > 0);
        }
    }
    return wrong;
}

Scene prism_from_above(int sides, double radius, double height, double top, double above) {
    Scene scene;
    scene.camera = camera_at({0, top + above, 0}, {0, -1, 0}, 2 * std::atan(kFramed * radius / above));
    scene.camera.up = {0, 0, -1};
    add(scene, upright(SolidKind::prism, {0, top - height, 0}, radius, height, glowing({1, 1, 1})));
    scene.solids[0].sides = sides;
    return scene;
}

double s26_ours(const Stage& stage) {
    double wrong = 0;
    for (int sides = kMinSides; sides <= kMaxSides; ++sides) {
        const Picture picture = stage.render(prism_from_above(sides, kSmall, kSmall, 0, kAbove), kSide, kSide);
        wrong += wrong_in_polygon(sides, [&](int i, int j, double, double) { return picture.at(i, j).r > 0; });
    }
    for (const int sides : {2, 1, 0, -1}) {
        wrong += stage.refused_field(prism_from_above(sides, kSmall, kSmall, 0, kAbove)) != "sides";
    }
    return wrong;
}

/// The lid as a fan of triangles by Moeller and Trumbore, with the threshold of their paper.
double s26_naive() {
    double wrong = 0;
    for (int sides = kMinSides; sides <= kMaxSides; ++sides) {
        const auto corner = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            return Vec3<float>{float(kSmall * std::cos(angle)), 0, float(kSmall * std::sin(angle))};
        };
        wrong += wrong_in_polygon(sides, [&](int, int, double x, double z) {
            const Vec3<float> o{0, float(kAbove), 0};
            const Vec3<float> d = naive::unit({float(kSmall * x), float(-kAbove), float(kSmall * z)});
            for (int k = 1; k + 1 < sides; ++k) {
                if (naive::meets_triangle(o, d, corner(0), corner(k), corner(k + 1), 1e-6f)) return true;
            }
            return false;
        });
    }
    return wrong;
}

// ---- A plate of glass that is hardly there

constexpr double kPlate = 0x1p-20, kNeedle = 0x1p20;
constexpr double kIndex = 1.5;

/// A ball seen through a thin plate, and a rod seen from its end.
Scene ball_behind_plate(double unit) {
    Scene scene;
    scene.camera = camera_at({0, 2 * unit, 3 * unit}, {0, -1, -1}, 0.9);
    add(scene, ball({0, -2 * unit, -unit}, unit, glowing({1, 1, 1})));
    Material clear;
    clear.ambient = clear.diffuse = clear.specular = 0;
    clear.transmission = 1;
    clear.refractive_index = kIndex;
    add(scene, upright(SolidKind::prism, {0, 0, 0}, 16 * unit, kPlate * unit, clear));
    return scene;
}

/// Pixels that see the ball elsewhere than along the straight line.
template <class Lit>
int wrong_through_plate(const Lit& lit) {
    constexpr double kHair = 1e-5;  // the plate shifts a ray by less than its thickness
    const Scene scene = ball_behind_plate(1);
    int wrong = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const int side = exact::side_of_outline(exact::miss_of_sphere(ray, scene.solids[0].position, 1), kHair);
            wrong += side != 0 && lit(i, j, ray) != (side > 0);
        }
    }
    return wrong;
}

double s27_ours(const Stage& stage) {
    const Picture plate = stage.render(ball_behind_plate(1), kSide, kSide);
    double wrong = wrong_through_plate([&](int i, int j, const exact::Ray&) { return plate.at(i, j).r > 0; });
    constexpr double kUp = 0x1p20;
    for (const double unit : {kUp, 1 / kUp}) {
        wrong += pixels_apart(plate, stage.render(ball_behind_plate(unit), kSide, kSide));
    }
    constexpr int kSides = 6;
    constexpr double kOver = 3;
    const Picture end = stage.render(prism_from_above(kSides, 1, kNeedle, kNeedle / 2, kOver), kSide, kSide);
    return wrong + wrong_in_polygon(kSides, [&](int i, int j, double, double) { return end.at(i, j).r > 0; });
}

/// Snell at the upper face; the lower one must be farther than an epsilon away.
double s27_naive() {
    constexpr float kEpsilon = 1e-4f, kEta = 1 / float(kIndex);
    return wrong_through_plate([&](int, int, const exact::Ray& ray) {
        Vec3<float> o{float(ray.o.x), float(ray.o.y), float(ray.o.z)};
        Vec3<float> d{float(ray.d.x), float(ray.d.y), float(ray.d.z)};
        o = naive::along(o, (float(kPlate) - o.y) / d.y, d);
        const float cosine = std::sqrt(1 - kEta * kEta * (1 - d.y * d.y));
        const Vec3<float> inside{kEta * d.x, -cosine, kEta * d.z};
        const float t = -o.y / inside.y;
        if (t > kEpsilon) {
            o = naive::along(o, t, inside);
        } else {
            d = inside;
        }
        return naive::sphere(o, d, {0, -2, -1}, 1).real;
    });
}

constexpr StiffCase kRows[] = {
    {"S25", "solids with a radius or a height of 0", "the normal is 0 / 0", "each is refused and the field is named",
     "not refused", 0, s25_ours, s25_naive},
    {"S26", "prisms of radius 1/512 with 3 to 64 sides, seen from above; of 2 sides",
     "the lid's thin triangles fall below |det| < 1e-6 and are holes",
     "the outline is the regular polygon but for 1e-5 radii; fewer than 3 sides are refused", "wrong pixels", 0,
     s26_ours, s26_naive},
    {"S27", "a ball through glass 1e-6 thick; a rod 1e6 long seen from its end",
     "t > 1e-4 merges both faces: the ray never leaves the glass",
     "the plate shifts nothing, scaling by 2^20 and 2^-20 changes no bit, the rod's end is whole", "wrong pixels", 0,
     s27_ours, s27_naive},
};

}  // namespace

std::span<const StiffCase> solid_size_rows() { return kRows; }

}  // namespace zerkalo::stability
