// Finite input that no picture can be drawn from: light from nothing, and mirrors without an outline.
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace zerkalo::stability {
namespace {

constexpr double kAboveOne = 1 + std::numeric_limits<double>::epsilon();

// S54. A plate of which each term of Whitted's sum in turn is set out of its range, in surroundings of radiance 1.

struct Surface {
    Rgb<double> lamp{1, 1, 1}, ambient{1, 1, 1}, background{1, 1, 1};
    Material material;
};

struct BadTerm {
    const char* field;
    void (*spoil)(Surface&);
};
constexpr BadTerm kBadTerms[] = {
    {"color", [](Surface& s) { s.material.color.g = kAboveOne, s.material.ambient = 1; }},
    {"color", [](Surface& s) { s.material.color.b = -0.5, s.material.diffuse = 1; }},
    {"ambient", [](Surface& s) { s.material.ambient = kAboveOne; }},
    {"ambient", [](Surface& s) { s.material.ambient = -1e-9; }},
    {"diffuse", [](Surface& s) { s.material.diffuse = 2; }},
    {"diffuse", [](Surface& s) { s.material.diffuse = -1; }},
    {"specular", [](Surface& s) { s.material.specular = 1.5; }},
    {"specular", [](Surface& s) { s.material.specular = -0.5; }},
    {"reflection", [](Surface& s) { s.material.reflection = kAboveOne; }},
    {"reflection", [](Surface& s) { s.material.reflection = -1e-9; }},
    {"transmission", [](Surface& s) { s.material.transmission = 1.25; }},
    {"transmission", [](Surface& s) { s.material.transmission = -0.25; }},
    {"transmission", [](Surface& s) { s.material.reflection = 0.75, s.material.transmission = 0.5; }},
    {"color", [](Surface& s) { s.lamp.r = -1, s.material.diffuse = 1; }},
    {"ambient", [](Surface& s) { s.ambient.g = -1e-3, s.material.ambient = 1; }},
    {"background", [](Surface& s) { s.background.b = -1, s.material.reflection = 1; }},
};

/// How many of the surfaces with a bad term pass for good ones.
template <class Passes>
double passing(const Passes& passes) {
    int count = 0;
    for (const BadTerm& bad : kBadTerms) {
        Surface surface;
        surface.material = glowing({1, 1, 1});
        surface.material.ambient = 0;
        bad.spoil(surface);
        count += passes(surface, bad.field);
    }
    return count;
}

Scene plate(const Surface& surface) {
    Scene scene;
    scene.ambient = surface.ambient;
    scene.background = surface.background;
    add(scene, lamp({0, 0, 4}));
    scene.lights[0].color = surface.lamp;
    add(scene, upright(SolidKind::prism, {0, 0, 0}, 1, 0.5, surface.material));
    return scene;
}

double s54_ours(const Stage& stage) {
    // Each coefficient at its largest is no mistake.
    Surface good;
    good.material.color = {1, 1, 1};
    good.material.ambient = good.material.diffuse = good.material.specular = good.material.transmission = 1;
    if (!stage.render(plate(good), 4, 4).finite()) return std::size(kBadTerms) + 1;
    return passing(
        [&](const Surface& surface, const char* field) { return stage.refused_field(plate(surface)) != field; });
}

/// The sum seen along the normal, the lamp behind the eye. Nobody checks its terms.
double s54_naive() {
    return passing([](const Surface& s, const char*) {
        const Material& m = s.material;
        const auto returned = [&](double c, double lamp, double ambient, double background) {
            return c * m.ambient * ambient + lamp * (c * m.diffuse + m.specular) +
                   (m.reflection + m.transmission) * background;
        };
        const double sums[] = {returned(m.color.r, s.lamp.r, s.ambient.r, s.background.r),
                               returned(m.color.g, s.lamp.g, s.ambient.g, s.background.g),
                               returned(m.color.b, s.lamp.b, s.ambient.b, s.background.b)};
        return std::any_of(std::begin(sums), std::end(sums), [](double sum) { return sum < 0 || sum > 1; });
    });
}

// S64. Outlines of a mirror.

Boundary of_shape(BoundaryShape shape, double width, double height, double radius) {
    Boundary b;
    b.shape = shape;
    b.width = width, b.height = height, b.radius = radius;
    return b;
}

Boundary corners_at(std::initializer_list<Vec2<double>> corners) {
    Boundary b = of_shape(BoundaryShape::polygon, 1, 1, 1);
    for (const Vec2<double>& corner : corners) b.corners[b.corner_count++] = corner;
    return b;
}

struct BadOutline {
    const char* field;
    Boundary boundary;
};
std::vector<BadOutline> bad_outlines() {
    using enum BoundaryShape;
    return {
        {"boundary.width", of_shape(rectangle, 0, 1, 1)},
        {"boundary.height", of_shape(rectangle, 1, 0, 1)},
        {"boundary.width", of_shape(rectangle, -1, 1, 1)},
        {"boundary.width", of_shape(ellipse, 0, 1, 1)},
        {"boundary.height", of_shape(ellipse, 1, 0, 1)},
        {"boundary.radius", of_shape(disc, 1, 1, 0)},
        {"boundary.radius", of_shape(disc, 1, 1, -1)},
        {"boundary.points", corners_at({})},
        {"boundary.points", corners_at({{0, 0}, {1, 0}})},
        {"boundary.points", corners_at({{-1, -1}, {0, 0}, {1, 1}})},
        {"boundary.points", corners_at({{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}})},
        {"boundary.points", corners_at({{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})},                         // a bow tie
        {"boundary.points", corners_at({{0, 1}, {-0.6, -0.8}, {1, 0.3}, {-1, 0.3}, {0.6, -0.8}})},     // a star
    };
}

constexpr Vec2<double> kKite[] = {{0, -0.75}, {0.5, 0}, {0, 0.75}, {-0.5, 0}};
Boundary kite() { return corners_at({kKite[0], kKite[1], kKite[2], kKite[3]}); }
Boundary reversed_kite() { return corners_at({kKite[3], kKite[2], kKite[1], kKite[0]}); }

constexpr int kSide = 32;

double s64_ours(const Stage& stage) {
    const auto mirror_of = [](const Boundary& boundary) {
        Scene scene;
        scene.camera = camera_at({0, 0, 2}, {0, 0, -1}, 1);
        Mirror mirror = ideal_mirror({0, 0, 0}, {0, 0, 1}, 1);
        mirror.boundary = boundary;
        mirror.ambient = 1;
        add(scene, mirror);
        return scene;
    };
    int wrong = pixels_apart(stage.render(mirror_of(kite()), kSide, kSide),
                             stage.render(mirror_of(reversed_kite()), kSide, kSide));
    for (const BadOutline& bad : bad_outlines()) wrong += stage.refused_field(mirror_of(bad.boundary)) != bad.field;
    return wrong;
}

/// Left of every edge; within the half sizes; (x / a)^2 + (y / b)^2 <= 1. -1: not a number.
int inside(const Boundary& b, double x, double y) {
    if (b.shape == BoundaryShape::rectangle) return std::abs(x) <= b.width / 2 && std::abs(y) <= b.height / 2;
    if (b.shape == BoundaryShape::polygon) {
        bool left = true;
        for (int k = 0; k < b.corner_count; ++k) {
            const auto &p = b.corners[k], &q = b.corners[(k + 1) % b.corner_count];
            left = left && (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x) >= 0;
        }
        return left;
    }
    const bool disc = b.shape == BoundaryShape::disc;
    const double u = x / (disc ? b.radius : b.width / 2), v = y / (disc ? b.radius : b.height / 2);
    return u * u + v * v != u * u + v * v ? -1 : u * u + v * v <= 1;
}

/// Of a grid of points, the middle one among them.
struct Drawn {
    int in = 0, of = 0;
    bool number = true;
};
Drawn drawn(const Boundary& boundary) {
    Drawn sum;
    for (int j = -kSide / 2; j <= kSide / 2; ++j) {
        for (int i = -kSide / 2; i <= kSide / 2; ++i) {
            const int in = inside(boundary, 2.0 * i / kSide, 2.0 * j / kSide);
            sum.number = sum.number && in >= 0;
            sum.in += in > 0;
            ++sum.of;
        }
    }
    return sum;
}

/// A line of points, a single one or none is nothing: a mirror has an area.
double s64_naive() {
    int wrong = std::abs(drawn(kite()).in - drawn(reversed_kite()).in);
    for (const BadOutline& bad : bad_outlines()) {
        const Drawn sum = drawn(bad.boundary);
        wrong += !sum.number || sum.in <= kSide + 1 || sum.in == sum.of;
    }
    return wrong;
}

constexpr StiffCase kRows[] = {
    {"S54", "colours and coefficients above 1 or below 0, K_r + K_t above 1",
     "returns more light than it gets, or less than none", "refused, and the field named", "not refused", 0, s54_ours,
     s54_naive},
    {"S64", "a mirror's outline without area, crossing itself, or reversed", "draws nothing or everything",
     "refused, and the field named; either sense gives the same picture", "wrong answers", 0, s64_ours,
     s64_naive},
};

}  // namespace

std::span<const StiffCase> refusal_rows() { return kRows; }

}  // namespace zerkalo::stability
