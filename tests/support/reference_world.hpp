// What a ray meets first, and what a point can see: every object is asked, one after the other.
#pragma once

#include "tests/support/reference_mirror.hpp"

#include <vector>

namespace zerkalo::reference {

enum class HitKind { none, solid, mirror };

struct Hit {
    HitKind kind = HitKind::none;
    int index = 0;  // within the scene's solids or mirrors
    double t = kInfinity;
    Vector point;
    Vector normal;       // unit; outward for a solid, of the front for a mirror
    bool front = false;  // the ray comes from outside the solid, or meets the mirror's front
    double guard = 0;    // secondary rays ignore crossings nearer than this: the rounding of `point`, with reserve
};

/// The objects of a scene. Keeps no reference to the scene.
class World {
public:
    explicit World(const Scene& scene);

    /// The nearest surface strictly beyond `t_min`; equal distances: solids before mirrors, lower index first.
    Hit first_hit(const Ray& ray, double t_min = 0) const;

    /// True when no surface lies strictly between a hit point and a light.
    bool visible(const Hit& from, const Vector& light) const;

private:
    struct Object {
        std::unique_ptr<Shape> shape;
        Ball ball;
    };
    std::vector<Object> solids_;
    std::vector<MirrorSurface> mirrors_;
};

}  // namespace zerkalo::reference
