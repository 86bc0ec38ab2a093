// Whitted's recursive illumination (T. Whitted, "An Improved Illumination Model for Shaded Display", 1980) with the
// coloured unpolished mirror: local light, then reflected and refracted rays, then their reflections, and so on.
#pragma once

#include "core/render/settings.hpp"
#include "tests/support/reference_lobe.hpp"
#include "tests/support/reference_world.hpp"

namespace zerkalo::reference {

/// The ray through the centre of pixel (x, y) of a picture of that size, row 0 on top.
Ray camera_ray(const Camera& camera, int width, int height, double x, double y);

/// The ideal mirror direction of `d` at the unit normal `n`.
Vector reflected(const Vector& d, const Vector& n);

/// Snell: unit `d` meets the unit normal `n` (d.n < 0) with `ratio` = index before / index behind.
/// False at total internal reflection; `out` is then untouched.
bool refracted(const Vector& d, const Vector& n, double ratio, Vector& out);

/// Fresnel: the share of unpolarised light that unit `d` loses to reflection at the unit normal `n` (d.n < 0), `ratio`
/// as above. 1 at total internal reflection.
double fresnel(const Vector& d, const Vector& n, double ratio);

/// One scene made ready. Keeps its own copy of the scene. Of the settings only `depth_limit` counts here.
class Tracer {
public:
    Tracer(const Scene& scene, const Settings& settings, unsigned lobe_samples);

    /// Radiance along a camera ray. `random` is drawn from at glossy mirrors only.
    Color radiance(const Ray& ray, Random& random) const;

    const World& world() const { return world_; }

private:
    /// What a ray carries down the tree.
    struct Path {
        Ray ray;
        double t_min = 0;
        int depth = 0;
        bool glossy_before = false;
    };
    struct Surface;

    Color trace(const Path& path, Random& random) const;
    Color solid(const Path& path, const Hit& hit, Random& random) const;
    Color mirror(const Path& path, const Hit& hit, Random& random) const;
    Color lobe_average(const Path& path, const Hit& hit, Random& random) const;
    Color local_light(const Path& path, const Hit& hit, const Surface& surface) const;

    Scene scene_;
    World world_;
    int depth_limit_;
    unsigned lobe_samples_;
};

}  // namespace zerkalo::reference
