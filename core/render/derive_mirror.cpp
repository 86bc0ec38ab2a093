#include "core/optics/shares.hpp"
#include "core/render/derive.hpp"
#include "core/scene/outline.hpp"

namespace zerkalo {
namespace {

constexpr double kTailBound = 0x1p-13;  // share of a lobe's energy that culling may leave out
constexpr double kUncovered = 0x1p-11;  // share beyond which a solid is not covered

double larger(double a, double b) { return a > b ? a : b; }

/// 1 - u^(1/(n+1)), the distance of a lattice ray from the lobe's axis, 1 - cos(theta).
double distance_from_axis(double u, double exponent) {
    const double e = natural_log(u) / (exponent + 1);
    // Below 2^-17 the difference would lose digits; two terms of the series are then good to e^2 / 6 < 2^-36.
    constexpr double kSeries = 0x1p-17;
    return e > -kSeries ? -e * (1 + e / 2) : 1 - exponential(e);
}

template <class F>
LobeDataOf<F> lobe_of(const Mirror& mirror, const Constants<F>& to) {
    LobeDataOf<F> lobe{};
    lobe.glossy = mirror.lobe_exponent < kInfinity;
    lobe.max_phong = mirror.lobe == Lobe::max_phong;
    lobe.ggx = mirror.lobe == Lobe::ggx;
    if (!lobe.glossy) return lobe;
    lobe.inverse_exponent = to.share(1 / (mirror.lobe_exponent + 1));
    lobe.alpha = to.component(1 / square_root(2 * mirror.lobe_exponent + 1));
    return lobe;
}

template <class F>
BoundaryDataOf<F> boundary_of(const Boundary& b, const Constants<F>& to) {
    BoundaryDataOf<F> out{};
    out.shape = b.shape;
    out.half_width = to.length(b.width / 2), out.half_height = to.length(b.height / 2);
    const bool disc = b.shape == BoundaryShape::disc;
    out.inverse_a = to.inverse(disc ? 1 / b.radius : 2 / b.width);
    out.inverse_b = to.inverse(disc ? 1 / b.radius : 2 / b.height);
    if (b.shape != BoundaryShape::polygon) return out;
    out.corner_count = b.corner_count;
    double twice_area = 0;
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const auto& p = b.corners[k];
        const auto& q = b.corners[(k + 1) % b.corner_count];
        twice_area += p.x * q.y - p.y * q.x;
    }
    for (std::int32_t k = 0; k < b.corner_count; ++k) {
        const auto& p = b.corners[k];
        const auto& q = b.corners[(k + 1) % b.corner_count];
        const double sense = twice_area > 0 ? 1 : -1;
        const double nx = sense * (q.y - p.y), ny = sense * (p.x - q.x);
        out.edges[k] = to.half_plane(nx, ny, nx * p.x + ny * p.y);
    }
    return out;
}

/// Height of the sphere above the tangent plane at the boundary's rim; 0 for a plane.
double sagitta(const Mirror& mirror) {
    const double kappa = 1 / mirror.curvature_radius;
    const double rho = farthest_point(mirror.boundary);
    return kappa * rho * rho / (1 + square_root(larger(0, 1 - kappa * kappa * rho * rho)));
}

}  // namespace

template <class F>
void derive_cone(double n, const PlanHead& plan, bool survey, const Constants<F>& to, LobeDataOf<F>& lobe) {
    // Steep normals send rays anywhere: no cone holds them.
    if (lobe.ggx) {
        lobe.cosine = to.weight(0), lobe.sine = lobe.widest_sine = to.weight(1);
        return;
    }
    const double widest = least_share(plan.sampling, plan.samples, plan.antialias);
    // Room for the rounding of lattice and frame: both far below 2^-18.
    constexpr double kRoom = 0x1p-18;
    const auto cone = [&](double u) {
        const double from_axis = distance_from_axis(u, n) * (1 + kRoom) + kRoom * kRoom;
        return from_axis < 1 ? from_axis : 1.0;
    };
    // A keyed rule throws its few rays anywhere: one that culling left out would cost a pixel 1/N, not 1/N of the tail.
    const bool keyed = is_keyed(plan.sampling.estimator);
    const double tail = keyed ? 0 : kTailBound;
    const double reached = survey && !keyed ? tail : larger(widest, tail);
    // The coverage of a solid reaches as far as the lobe does, if its rays do not.
    const bool covered = plan.sampling.estimator == Estimator::fibonacci_coverage && reached > kUncovered;
    const double cull = cone(covered ? kUncovered : reached), all = cone(widest);
    lobe.cosine = to.weight((1 - cull) * (1 - kRoom * kRoom));
    lobe.sine = to.weight(square_root(cull * (2 - cull)) * (1 + kRoom));
    lobe.widest_sine = to.weight(square_root(all * (2 - all)) * (1 + kRoom) + kRoom);
    if constexpr (F::kFixed) {
        constexpr double kSteepest = 4;
        const double sine = square_root(all * (2 - all)) * (1 + kRoom) + kRoom;
        lobe.cone.narrow = (1 - all) * kSteepest > 1 + kRoom;
        if (lobe.cone.narrow) lobe.cone = {to.ratio(sine / (1 - all)), to.ratio((1 + kRoom) / (1 - all)), true};
    }
}

template <class F>
SurfaceDataOf<F> derive_surface(const Material& m, const Rgb<double>& ambient, const Constants<F>& to) {
    const Rgb<double> white{m.specular, m.specular, m.specular};
    return {to.radiance(scaled(m.color * ambient, m.ambient)), to.weight(scaled(m.color, m.diffuse)), to.weight(white),
            to.exponent(m.shininess)};
}

template <class F>
LightDataOf<F> derive_light(const Light& light, const Constants<F>& to) {
    LightDataOf<F> out{};
    out.position = to.point(light.position);
    out.inverse_square = light.falloff == Falloff::inverse_square;
    const Rgb<double> power = scaled(light.color, light.intensity);
    out.power = to.power(power, out.inverse_square);
    const Rgb<float> rounded = Constants<FloatFormats>{}.weight(power);
    const double brightest = larger(rounded.r, larger(rounded.g, rounded.b));
    out.falloff_limit = to.inverse(brightest > 0 ? double{kBrightest} / brightest : kInfinity);
    // (1 - x)^n <= e^(-n x): beyond this n x the highlight is below the least share of full brightness.
    const double faint = natural_log(larger(1, brightest) / F::kLeastShare);
    out.highlight_limit = to.exponent(out.inverse_square ? kInfinity : faint);
    return out;
}

MirrorFrame frame_of(const Mirror& mirror) {
    const Point n = unit(mirror.normal);
    const Point right = unit(cross(usable_up(n, mirror.up), n));
    return {right, cross(n, right), n};
}

Ball ball_of(const Mirror& mirror) {
    const double rho = farthest_point(mirror.boundary), z = sagitta(mirror);
    return {mirror.position + unit(mirror.normal) * (z / 2), length({rho, z / 2, 0})};
}

void hull_of(const Mirror& mirror, Hull& hull) {
    const MirrorFrame frame = frame_of(mirror);
    const Boundary& b = mirror.boundary;
    const double z = sagitta(mirror);
    hull.count = 0;
    const auto add = [&](double x, double y) {
        const Point foot = mirror.position + frame.right * x + frame.v * y;
        hull.points[hull.count++] = foot;
        if (z != 0) hull.points[hull.count++] = foot + frame.n * z;
    };
    if (b.shape == BoundaryShape::polygon) {
        for (std::int32_t k = 0; k < b.corner_count; ++k) add(b.corners[k].x, b.corners[k].y);
        return;
    }
    const bool disc = b.shape == BoundaryShape::disc;
    const double x = disc ? b.radius : b.width / 2, y = disc ? b.radius : b.height / 2;
    add(-x, -y), add(x, -y), add(-x, y), add(x, y);
}

template <class F>
void derive_mirror(const Mirror& mirror, const Rgb<double>& ambient, const PlanHead& plan, const Constants<F>& to,
                   MirrorPlanOf<F>& out) {
    out = MirrorPlanOf<F>{};
    const MirrorFrame frame = frame_of(mirror);
    out.shape.vertex = to.point(mirror.position);
    out.shape.right = to.direction(frame.right), out.shape.v = to.direction(frame.v);
    out.shape.n = to.direction(frame.n);
    out.shape.kappa = to.curvature(1 / mirror.curvature_radius);
    out.shape.boundary = boundary_of(mirror.boundary, to);
    out.curved = out.shape.kappa != typename F::Curvature(0);
    out.lobe = lobe_of(mirror, to);
    out.lobe_exponent = mirror.lobe_exponent;

    const bool shines = mirror.shininess != kShininessOfLobe || mirror.lobe_exponent < kInfinity;
    Material m;
    m.color = mirror.color;
    m.ambient = mirror.ambient, m.diffuse = mirror.diffuse, m.specular = shines ? mirror.specular : 0;
    m.shininess = mirror.shininess != kShininessOfLobe ? mirror.shininess : shines ? mirror.lobe_exponent : 0;
    out.front = derive_surface(m, ambient, to);
    out.front.specular = to.weight(scaled(mirror.color, m.specular));
    out.back = out.front;
    out.back.specular = to.weight(Rgb<double>{0, 0, 0});
    out.reflectance = to.weight(scaled(mirror.color, mirror.reflection));
    out.reflects = plan.depth_limit > 0 && mirror.reflection > 0;
}

template SurfaceData derive_surface(const Material&, const Rgb<double>&, const Constants<FloatFormats>&);
template SurfaceDataOf<DoubleFormats> derive_surface(const Material&, const Rgb<double>&,
                                                     const Constants<DoubleFormats>&);
template SurfaceDataOf<FixedFormats> derive_surface(const Material&, const Rgb<double>&, const Constants<FixedFormats>&);
template LightData derive_light(const Light&, const Constants<FloatFormats>&);
template LightDataOf<DoubleFormats> derive_light(const Light&, const Constants<DoubleFormats>&);
template LightDataOf<FixedFormats> derive_light(const Light&, const Constants<FixedFormats>&);
template void derive_mirror(const Mirror&, const Rgb<double>&, const PlanHead&, const Constants<FloatFormats>&,
                            MirrorPlan&);
template void derive_mirror(const Mirror&, const Rgb<double>&, const PlanHead&, const Constants<DoubleFormats>&,
                            MirrorPlanOf<DoubleFormats>&);
template void derive_mirror(const Mirror&, const Rgb<double>&, const PlanHead&, const Constants<FixedFormats>&,
                            MirrorPlanOf<FixedFormats>&);
template void derive_cone(double, const PlanHead&, bool, const Constants<FloatFormats>&, LobeData&);
template void derive_cone(double, const PlanHead&, bool, const Constants<DoubleFormats>&, LobeDataOf<DoubleFormats>&);
template void derive_cone(double, const PlanHead&, bool, const Constants<FixedFormats>&,
                          LobeDataOf<FixedFormats>&);

}  // namespace zerkalo
