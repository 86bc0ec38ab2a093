// Closed triangle meshes of the polyhedra that the core also knows as half-spaces: the same solid twice.
#pragma once

#include "core/scene/scene.hpp"
#include "tests/core/support/exact.hpp"

#include <vector>

namespace zerkalo::test {

/// The triangles of a prism or pyramid in its own coordinates: fans of the base and the top, two a side.
inline std::vector<Triangle> triangles_of(const Solid& solid) {
    const int n = solid.sides;
    const auto corner = [&](int k, double y) {
        const Real80 angle = 2 * kPi80 * (k % n) / n;
        return Vec3<double>{double(solid.radius * std::cos(angle)), y, double(solid.radius * std::sin(angle))};
    };
    const double top = solid.height;
    std::vector<Triangle> triangles;
    for (int k = 1; k + 1 < n; ++k) triangles.push_back({corner(0, 0), corner(k, 0), corner(k + 1, 0)});
    for (int k = 0; k < n; ++k) {
        if (solid.kind == SolidKind::pyramid) {
            triangles.push_back({corner(k + 1, 0), corner(k, 0), Vec3<double>{0, top, 0}});
            continue;
        }
        triangles.push_back({corner(k + 1, 0), corner(k, 0), corner(k, top)});
        triangles.push_back({corner(k + 1, 0), corner(k, top), corner(k + 1, top)});
    }
    if (solid.kind == SolidKind::prism) {
        for (int k = 1; k + 1 < n; ++k) triangles.push_back({corner(0, top), corner(k + 1, top), corner(k, top)});
    }
    return triangles;
}

/// The same solid as a mesh that owns all of `triangles`.
inline Solid meshed(const Solid& solid, const std::vector<Triangle>& triangles) {
    Solid mesh = solid;
    mesh.kind = SolidKind::mesh;
    mesh.triangle_count = static_cast<std::int32_t>(triangles.size());
    return mesh;
}

}  // namespace zerkalo::test
