// The ray tree, written as it is explained: one function a kind of surface, recursion for the rest.
#include "tests/support/reference_tracer.hpp"

#include <algorithm>

namespace zerkalo::reference {

/// The terms of the local sum at one hit.
struct Tracer::Surface {
    Vector normal;  // unit, towards the side that the ray comes from
    Color color;
    double ambient = 0, diffuse = 0;
    Color specular;  // F Ks
    double shininess = 1;
};

Ray camera_ray(const Camera& camera, int width, int height, double x, double y) {
    const Vector view = normalized(from(camera.view));
    const Vector right = normalized(cross(view, usable_up(from(camera.up), from(camera.view))));
    const Vector up = cross(right, view);
    const double aspect = static_cast<double>(width) / height;
    const double half = std::tan(camera.fov / 2);
    const double half_width = camera.fov_axis == FovAxis::horizontal ? half : half * aspect;
    const double half_height = camera.fov_axis == FovAxis::horizontal ? half / aspect : half;
    const double across = (2 * (x + 0.5) / width - 1) * half_width;
    const double upward = (1 - 2 * (y + 0.5) / height) * half_height;
    return {from(camera.position), normalized(view + across * right + upward * up)};
}

Vector reflected(const Vector& d, const Vector& n) { return normalized(d - 2 * dot(d, n) * n); }

bool refracted(const Vector& d, const Vector& n, double ratio, Vector& out) {
    const Vector tangential = ratio * (d - dot(d, n) * n);
    const double rest = 1 - dot(tangential, tangential);
    if (rest < 0) return false;
    out = normalized(tangential - std::sqrt(rest) * n);
    return true;
}

double fresnel(const Vector& d, const Vector& n, double ratio) {
    // Amplitudes of both polarisations as the textbook has them, with the indices `ratio` before and 1 behind.
    const long double before = -dot(d, n), behind2 = 1 - (1 - before * before) * ratio * ratio;
    if (behind2 < 0) return 1;
    const long double behind = std::sqrt(behind2);
    const long double perpendicular = (ratio * before - behind) / (ratio * before + behind);
    const long double parallel = (before - ratio * behind) / (before + ratio * behind);
    return static_cast<double>((perpendicular * perpendicular + parallel * parallel) / 2);
}

Tracer::Tracer(const Scene& scene, const Settings& settings, unsigned lobe_samples)
    : scene_(scene), world_(scene), depth_limit_(settings.depth_limit), lobe_samples_(lobe_samples) {}

Color Tracer::radiance(const Ray& ray, Random& random) const { return trace({ray}, random); }

Color Tracer::trace(const Path& path, Random& random) const {
    if (path.depth > depth_limit_) return {};
    const Hit hit = world_.first_hit(path.ray, path.t_min);
    switch (hit.kind) {
        case HitKind::solid: return solid(path, hit, random);
        case HitKind::mirror: return mirror(path, hit, random);
        case HitKind::none: break;
    }
    return from(scene_.background);
}

Color Tracer::solid(const Path& path, const Hit& hit, Random& random) const {
    const Material& m = scene_.solids[hit.index].material;
    const Vector normal = hit.front ? hit.normal : -hit.normal;
    const Vector& d = path.ray.direction;
    Color sum = local_light(
        path, hit, {normal, from(m.color), m.ambient, m.diffuse, {m.specular, m.specular, m.specular}, m.shininess});
    double reflection = m.reflection;
    if (m.transmission > 0) {
        Vector through;
        const double ratio = hit.front ? 1 / m.refractive_index : m.refractive_index;
        const double turned_back = m.fresnel ? fresnel(d, normal, ratio) : 0;
        if (refracted(d, normal, ratio, through)) {
            const Path next{{hit.point, through}, hit.guard, path.depth + 1, path.glossy_before};
            sum = sum + m.transmission * (1 - turned_back) * trace(next, random);
            reflection += m.transmission * turned_back;
        } else {
            reflection += m.transmission;
        }
    }
    if (reflection > 0) {
        const Path next{{hit.point, reflected(d, normal)}, hit.guard, path.depth + 1, path.glossy_before};
        sum = sum + reflection * trace(next, random);
    }
    return sum;
}

Color Tracer::mirror(const Path& path, const Hit& hit, Random& random) const {
    const Mirror& m = scene_.mirrors[hit.index];
    const Color color = from(m.color);
    if (!hit.front) return local_light(path, hit, {-hit.normal, color, m.ambient, m.diffuse, {}, 1});

    const double shininess = m.shininess == kShininessOfLobe ? m.lobe_exponent : m.shininess;
    const Color specular = std::isinf(shininess) ? Color{} : m.specular * color;
    const Color local = local_light(path, hit, {hit.normal, color, m.ambient, m.diffuse, specular, shininess});
    // At the limit every ray of the lobe would be too deep, those below the horizon included.
    if (m.reflection == 0 || path.depth == depth_limit_) return local;
    return local + m.reflection * times(color, lobe_average(path, hit, random));
}

Color Tracer::lobe_average(const Path& path, const Hit& hit, Random& random) const {
    const Mirror& m = scene_.mirrors[hit.index];
    const Vector ideal = reflected(path.ray.direction, hit.normal);
    if (std::isinf(m.lobe_exponent))
        return trace({{hit.point, ideal}, hit.guard, path.depth + 1, path.glossy_before}, random);

    const unsigned count = path.glossy_before ? 1 : lobe_samples_;
    const double cos_view = -dot(path.ray.direction, hit.normal);
    Color sum;
    if (m.lobe == Lobe::ggx) {
        const double alpha = 1 / std::sqrt(2 * m.lobe_exponent + 1);
        for (const auto& [w, weight] : ggx_directions(hit.normal, -path.ray.direction, alpha, count, random)) {
            if (weight == 0) continue;
            sum = sum + weight * trace({{hit.point, w}, hit.guard, path.depth + 1, true}, random);
        }
        return 1.0 / count * sum;
    }
    for (const Vector& w : lobe_directions(ideal, m.lobe_exponent, count, random)) {
        const double cos_w = dot(w, hit.normal);
        if (cos_w <= 0) {
            if (m.lobe == Lobe::phong) sum = sum + from(scene_.background);
            continue;
        }
        const double weight = m.lobe == Lobe::max_phong ? std::min(1.0, cos_w / cos_view) : 1;
        sum = sum + weight * trace({{hit.point, w}, hit.guard, path.depth + 1, true}, random);
    }
    return 1.0 / count * sum;
}

Color Tracer::local_light(const Path& path, const Hit& hit, const Surface& surface) const {
    Color sum = surface.ambient * times(surface.color, from(scene_.ambient));
    for (int i = 0; i < scene_.light_count; ++i) {
        const Light& light = scene_.lights[i];
        const Vector way = from(light.position) - hit.point;
        const double distance = length(way);
        if (distance == 0) continue;
        const Vector to_light = normalized(way);
        const double cosine = dot(surface.normal, to_light);
        if (cosine <= 0 || !world_.visible(hit, from(light.position))) continue;

        const double share = light.falloff == Falloff::none ? 1 : 1 / (distance * distance);
        const Color irradiance = light.intensity * share * from(light.color);
        const Vector mirrored = 2 * cosine * surface.normal - to_light;
        const double highlight = std::pow(std::max(0.0, -dot(mirrored, path.ray.direction)), surface.shininess);
        sum = sum + times(irradiance, surface.diffuse * cosine * surface.color + highlight * surface.specular);
    }
    return sum;
}

}  // namespace zerkalo::reference
