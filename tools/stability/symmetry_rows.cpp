// Scenes seen in a looking-glass, and with their axes exchanged: no side and no axis is special.
#include "tools/stability/fixed_lanes_of.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include "core/geometry/algebra.hpp"
#include "core/image/resolve.hpp"
#include "core/shapes/sphere.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 48;  // pixels a side

/// A pixel's place in a picture from -1 to 1, to the right and upwards.
struct Place {
    double x, y;
};
Place place_of(int pixel) {
    return {(2 * (pixel % kSide) + 1 - kSide) / double{kSide}, (kSide - 2 * (pixel / kSide) - 1) / double{kSide}};
}

// Rays from an eye to a ball in fixed point, raw: for both rows, and for the twin of one.

constexpr Vec3<double> kEye{0.125, 0.75, 3}, kCentre{0.3, 0.2, -0.1};
constexpr double kRadius2 = 0.81;

using OneLength = Length<FixedNumbers<1>>;
using OneDirection = Direction<FixedNumbers<1>>;

Vec3<OneLength> lengths_of(const Vec3<double>& v) {
    return {nearest<OneLength>(v.x), nearest<OneLength>(v.y), nearest<OneLength>(v.z)};
}

/// turned(v): the vector in the looking-glass, or with its axes exchanged.
struct RawRays {
    Vec3<OneLength> eye, centre;
    std::vector<std::int32_t> x, y, z;

    template <class Turned>
    explicit RawRays(const Turned& turned) : eye(lengths_of(turned(kEye))), centre(lengths_of(turned(kCentre))) {
        for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
            const Place at = place_of(pixel);
            const Vec3<double> way{0.35 * at.x, 0.35 * at.y - 0.2, -1};
            const Vec3<double> d = turned(way * (1 / std::sqrt(dot(way, way))));
            x.push_back(nearest<OneDirection>(d.x).raw);
            y.push_back(nearest<OneDirection>(d.y).raw);
            z.push_back(nearest<OneDirection>(d.z).raw);
        }
    }
};

/// A raw number as two halves, which floats hold.
void add_raw(Picture& picture, std::int32_t raw) {
    picture.rgb.insert(picture.rgb.end(), {float(raw >> 16), float(raw & 0xffff), 0});
}

struct FixedBall {
    Vec3<OneLength> centre;
    Area<FixedNumbers<1>> radius2;
};

/// Where the rays enter the ball.
template <int kLanes>
Picture ball_in_fixed_point(const RawRays& rays) {
    using N = FixedNumbers<kLanes>;
    using D = Direction<N>;
    const FixedBall ball{rays.centre, nearest<Area<FixedNumbers<1>>>(kRadius2)};
    const auto from = sphere_seen_from<N>(ball, rays.eye);
    Picture picture{kSide, kSide, {}};
    for (std::size_t first = 0; first < rays.x.size(); first += kLanes) {
        const Vec3<D> d{in_lanes<D>(&rays.x[first]), in_lanes<D>(&rays.y[first]), in_lanes<D>(&rays.z[first])};
        const auto span = sphere_span<N>(ball, from, d);
        for (int k = 0; k < kLanes; ++k) add_raw(picture, lane_of(span.entry.raw, k));
    }
    return picture;
}

/// Pixels that differ between two sets of rays, at the width that shows the most of them.
double fixed_balls_apart(const RawRays& a, const RawRays& b) {
    return worst_of_widths([&](auto width) {
        constexpr int kLanes = decltype(width)::value;
        return double(pixels_apart(ball_in_fixed_point<kLanes>(a), ball_in_fixed_point<kLanes>(b)));
    });
}

// S61. A ball, a prism and a cone from 3000 away, lit from there, and the same with x, y, z called y, z, x or z, x, y.

enum class Axes { xyz, zxy, yzx };
Vec3<double> exchanged(Axes axes, const Vec3<double>& v) {
    if (axes == Axes::xyz) return v;
    return axes == Axes::zxy ? Vec3<double>{v.z, v.x, v.y} : Vec3<double>{v.y, v.z, v.x};
}
/// The turns about x, then y, then z that exchange a solid's own axes like that.
Vec3<double> turn_of(Axes axes) {
    constexpr double kQuarter = std::numbers::pi / 2;
    if (axes == Axes::xyz) return {0, 0, 0};
    return axes == Axes::zxy ? Vec3<double>{kQuarter, 0, kQuarter} : Vec3<double>{-kQuarter, -kQuarter, 0};
}

constexpr double kFar = 3000, kLessFar = 100, kHalfWidth = 1.75;  // of the picture at the scene's middle
constexpr Vec3<double> kView{-0.267261241912424, -0.534522483824849, -0.801783725737273};  // -(1, 2, 3), unit
constexpr Vec3<double> kUp{0, 1, 0};

/// The largest step of 255 between pictures with different axes, off edges. draw(axes) -> picture; outlines: each
/// surface in a colour of its own.
template <class Draw>
double largest_step_off_edges(const Picture& outlines, const Draw& draw) {
    const auto codes_of = [](const Picture& picture) {
        std::vector<std::uint8_t> codes(picture.rgb.size());
        resolve8(picture.rgb.data(), codes.data(), codes.size());
        return codes;
    };
    const auto off_edges = [&](int x, int y) {
        const Rgb<float> own = outlines.at(x, y);
        for (int j = y - 1; j <= y + 1; ++j) {
            for (int i = x - 1; i <= x + 1; ++i) {
                const Rgb<float> other = outlines.at(i, j);
                if (other.r != own.r || other.g != own.g || other.b != own.b) return false;
            }
        }
        return true;
    };
    const std::vector<std::uint8_t> plain = codes_of(draw(Axes::xyz));
    int largest = 0;
    for (const Axes axes : {Axes::zxy, Axes::yzx}) {
        const std::vector<std::uint8_t> other = codes_of(draw(axes));
        for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
            const int x = pixel % kSide, y = pixel / kSide;
            if (x == 0 || y == 0 || x == kSide - 1 || y == kSide - 1 || !off_edges(x, y)) continue;
            for (int c = 3 * pixel; c < 3 * pixel + 3; ++c) {
                const auto at = static_cast<std::size_t>(c);
                largest = std::max(largest, std::abs(plain[at] - other[at]));
            }
        }
    }
    return largest;
}

Scene seen_from_afar(const Stage& stage, Axes axes, bool outlines) {
    Scene scene;
    const Vec3<double> eye = exchanged(axes, kView * -kFar);
    scene.camera = camera_at(eye, exchanged(axes, kView), 2 * std::atan(kHalfWidth / kFar));
    scene.camera.up = exchanged(axes, kUp);
    add(scene, lamp(eye));
    const auto place = [&](Solid solid, const Rgb<double>& own) {
        solid.position = exchanged(axes, solid.position);
        solid.rotation = turn_of(axes);
        solid.material = outlines ? glowing(own) : Material{};
        add(scene, solid);
    };
    place(ball({0.3, 0.1, 0.2}, 0.9, Material{}), {1, 0, 0});
    place(upright(SolidKind::prism, {-1.2, -0.4, 0.3}, 0.5, 0.8, Material{}), {0, 1, 0});
    place(upright(SolidKind::cone, {0.9, 0.2, -1.1}, 0.5, 1, Material{}), {0, 0, 1});
    if (stage.beyond_formats(scene, "position")) scene.lights[0].position = exchanged(axes, kView * -kLessFar);
    return scene;
}

double s61_ours(const Stage& stage) {
    const Picture outlines = stage.render(seen_from_afar(stage, Axes::xyz, true), kSide, kSide);
    const double step = largest_step_off_edges(
        outlines, [&](Axes axes) { return stage.render(seen_from_afar(stage, axes, false), kSide, kSide); });
    if (!stage.fixed()) return step;
    // In fixed point sums of products are exact, whatever their order: where rays meet, not a bit may differ.
    const auto rays_of = [](Axes axes) {
        return RawRays([axes](const Vec3<double>& v) { return exchanged(axes, v); });
    };
    const RawRays plain = rays_of(Axes::xyz);
    return step + fixed_balls_apart(plain, rays_of(Axes::zxy)) + fixed_balls_apart(plain, rays_of(Axes::yzx));
}

Vec3<float> rounded_to_float(const Vec3<double>& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// A unit ball alone, Lambert's light from the eye. `outlines`: met or not, by the exact distance of the ray's line.
Picture naive_ball(Axes axes, bool outlines) {
    const Vec3<double> right = cross(kView, kUp) * (1 / std::sqrt(dot(cross(kView, kUp), cross(kView, kUp))));
    const Vec3<double> up = cross(right, kView), eye = kView * -kFar;
    Picture picture{kSide, kSide, {}};
    for (int pixel = 0; pixel < kSide * kSide; ++pixel) {
        const Place at = place_of(pixel);
        const Vec3<double> way = kView + (right * at.x + up * at.y) * (kHalfWidth / kFar);
        const Vec3<double> d = way * (1 / std::sqrt(dot(way, way))), foot = eye - d * dot(eye, d);
        const Vec3<float> o = rounded_to_float(exchanged(axes, eye)), w = rounded_to_float(exchanged(axes, d));
        const auto roots = naive::sphere(o, w, {0, 0, 0}, 1);
        const Vec3<float> n = naive::along(o, roots.first, w);
        const float shade = roots.real ? std::max(0.0f, -naive::dot(n, w)) : 0;
        picture.rgb.insert(picture.rgb.end(), 3, outlines ? float(dot(foot, foot) <= 1) : shade);
    }
    return picture;
}

double s61_naive() {
    return largest_step_off_edges(naive_ball(Axes::xyz, true), [](Axes axes) { return naive_ball(axes, false); });
}

// S62. A lopsided scene, and the one in the looking-glass across x = 0.

Vec3<double> across(const Vec3<double>& v) { return {-v.x, v.y, v.z}; }

Picture flipped(const Picture& picture) {
    Picture out{picture.width, picture.height, {}};
    for (int pixel = 0; pixel < picture.width * picture.height; ++pixel) {
        const Rgb<float> c = picture.at(picture.width - 1 - pixel % picture.width, pixel / picture.width);
        out.rgb.insert(out.rgb.end(), {c.r, c.g, c.b});
    }
    return out;
}

/// Turns about y and z change their sense. Prisms and pyramids with an even number of sides are their own images.
Scene in_looking_glass(Scene scene) {
    scene.camera.position = across(scene.camera.position);
    scene.camera.view = across(scene.camera.view);
    scene.lights[0].position = across(scene.lights[0].position);
    scene.mirrors[0].position = across(scene.mirrors[0].position);
    scene.mirrors[0].normal = across(scene.mirrors[0].normal);
    for (Solid* s = scene.solids; s < scene.solids + scene.solid_count; ++s) {
        s->position = across(s->position);
        s->rotation = {s->rotation.x, -s->rotation.y, -s->rotation.z};
    }
    return scene;
}

Scene lopsided(double curvature_radius) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    scene.camera = camera_at({0.7, 1.1, 5}, {-0.1, -0.15, -1}, 0.8);
    add(scene, lamp({-3, 5, 4}));
    for (const SolidKind kind : {SolidKind::pyramid, SolidKind::prism, SolidKind::cylinder, SolidKind::cone}) {
        add(scene, upright(kind, {scene.solid_count * 0.9 - 1.2, -0.3, 0.1}, 0.4, 0.9, Material{}));
        scene.solids[scene.solid_count - 1].rotation = {0.3, 0.2, -0.4};
    }
    add(scene, ball({0.2, 0.9, 0.3}, 0.5, Material{}));
    add(scene, ideal_mirror({0.25, 0.5, -1}, {0.125, 0, 1}, 4));
    scene.mirrors[0].curvature_radius = curvature_radius;
    return scene;
}

RawRays rays_of(bool looking_glass) {
    return RawRays([looking_glass](const Vec3<double>& v) { return looking_glass ? across(v) : v; });
}

double s62_ours(const Stage& stage) {
    // Of the formula alone each pixel's ray is in the looking-glass, and its pixel is not.
    double apart = stage.fixed() ? fixed_balls_apart(rays_of(false), rays_of(true)) : 0;
    for (const double curvature_radius : {kInfinity, 9.0, -9.0}) {
        const Scene scene = lopsided(curvature_radius);
        apart += pixels_apart(flipped(stage.render(scene, kSide, kSide)),
                              stage.render(in_looking_glass(scene), kSide, kSide));
    }
    return apart;
}

/// The same ball with products shifted down: each is rounded towards minus infinity.
Picture ball_by_shifts(const RawRays& rays) {
    const auto down = [](std::int64_t product) { return static_cast<std::int32_t>(product >> 30); };
    const Vec3<std::int64_t> f{rays.eye.x.raw - rays.centre.x.raw, rays.eye.y.raw - rays.centre.y.raw,
                               rays.eye.z.raw - rays.centre.z.raw};
    const std::int64_t radius2 = std::llround(std::ldexp(kRadius2, 54));
    Picture picture{kSide, kSide, {}};
    for (std::size_t k = 0; k < rays.x.size(); ++k) {
        const std::int64_t along = down(f.x * rays.x[k] + f.y * rays.y[k] + f.z * rays.z[k]);
        const std::int64_t x = f.x - down(along * rays.x[k]), y = f.y - down(along * rays.y[k]);
        const std::int64_t z = f.z - down(along * rays.z[k]);
        const std::int64_t under = radius2 - (x * x + y * y + z * z);
        add_raw(picture, under < 0 ? 0 : std::int32_t(-along - std::int64_t(std::sqrt(double(under)))));
    }
    return picture;
}

double s62_naive() { return pixels_apart(ball_by_shifts(rays_of(false)), ball_by_shifts(rays_of(true))); }

constexpr StiffCase kRows[] = {
    {"S61", "solids seen from 3000 away, x, y, z exchanged", "b^2 - 4ac is noise, another one for each order of sums",
     "the same picture to a step off edges; in fixed point to the last bit", "steps of 255", 1, s61_ours, s61_naive,
     {.refused = "position"}},
    {"S62", "a lopsided scene and its image in a looking-glass, float and fixed",
     "a product shifted right is rounded towards minus infinity", "the flipped picture to the last bit",
     "pixels apart", 0, s62_ours, s62_naive},
};

}  // namespace

std::span<const StiffCase> symmetry_rows() { return kRows; }

}  // namespace zerkalo::stability
