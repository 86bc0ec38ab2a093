// The mirror of the reference tracer: a piece of a plane, or of the half sphere around its vertex, cut by an outline.
#pragma once

#include "tests/support/reference_shapes.hpp"

namespace zerkalo::reference {

class MirrorSurface {
public:
    explicit MirrorSurface(const Mirror& mirror);

    /// Offers every crossing inside the outline, with the unit normal of the front.
    void cross(const Ray& ray, Nearest& nearest) const;

    /// A ball around the whole outline, in the tangent plane at the vertex.
    Ball ball() const;

private:
    void offer_if_inside(const Ray& ray, long double t, Nearest& nearest) const;
    bool inside_outline(double x, double y) const;

    Mirror mirror_;
    Vector vertex_, normal_, right_, v_;
};

}  // namespace zerkalo::reference
