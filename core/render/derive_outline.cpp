#include "core/render/derive.hpp"

namespace zerkalo {
namespace {

struct OutlineWriter {
    Outline& out;
    const Constants<FloatFormats>& to;

    void corner(const Point& p) {
        const Vec3<float> rounded = to.point(p);
        out.x[out.corner_count] = rounded.x, out.y[out.corner_count] = rounded.y, out.z[out.corner_count] = rounded.z;
        ++out.corner_count;
    }
    void edge(std::int32_t from, std::int32_t end, std::int32_t left, std::int32_t right) {
        out.edges[out.edge_count++] = {static_cast<std::uint8_t>(from), static_cast<std::uint8_t>(end),
                                       static_cast<std::uint8_t>(left), static_cast<std::uint8_t>(right)};
    }
    void face(std::int32_t slab, bool low, const Point& middle) {
        out.middle[out.face_count] = to.point(middle);
        out.faces[out.face_count++] = {static_cast<std::uint8_t>(slab), low};
    }
};

/// Slabs of the sides come first, then that of base and top; an even prism's side k shares one with its opposite.
void write_faces(const Solid& solid, const Point* base, const Point* top, bool has_top, std::int32_t slab_count,
                 OutlineWriter& writer) {
    const std::int32_t n = solid.sides, side_slabs = slab_count - 1;
    Point below{0, 0, 0}, above{0, 0, 0};
    for (std::int32_t k = 0; k < n; ++k) {
        const std::int32_t next = (k + 1) % n;
        writer.face(k % side_slabs, k >= side_slabs, (base[k] + base[next] + top[k] + top[next]) * 0.25);
        below = below + base[k], above = above + top[k];
    }
    writer.face(side_slabs, true, below * (1.0 / n));
    if (has_top) writer.face(side_slabs, false, above * (1.0 / n));
}

}  // namespace

void derive_outline(const Scene& scene, const Solid& solid, const Constants<FloatFormats>& to, Outline& out) {
    out = Outline{};
    if (solid.kind != SolidKind::prism && solid.kind != SolidKind::pyramid) return;
    const std::int32_t n = solid.sides;
    if (n > kMaxOutlineSides) return;
    Hull hull;
    hull_of(scene, solid, hull);
    FacePair pairs[kMaxSides + 1];
    const std::int32_t slab_count = faces_of(solid, pairs);
    Point base[kMaxOutlineSides], top[kMaxOutlineSides];
    for (std::int32_t k = 0; k < n; ++k) base[k] = hull.points[2 * k], top[k] = hull.points[2 * k + 1];
    // Not a pyramid's, unless it is so flat that it is drawn as a prism.
    const bool has_top = length(top[1] - top[0]) > 0;
    OutlineWriter writer{out, to};
    for (std::int32_t k = 0; k < n; ++k) writer.corner(base[k]);
    for (std::int32_t k = 0; k < (has_top ? n : 1); ++k) writer.corner(top[k]);
    write_faces(solid, base, top, has_top, slab_count, writer);
    for (std::int32_t k = 0; k < n; ++k) {
        const std::int32_t next = (k + 1) % n;
        writer.edge(k, next, k, n);
        if (has_top) writer.edge(n + k, n + next, n + 1, k);
        writer.edge(k, has_top ? n + k : n, (k + n - 1) % n, k);
    }
}

}  // namespace zerkalo
