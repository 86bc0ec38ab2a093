// Arrays of points, rays and answers in the form that the probes take.
#pragma once

#include "tests/core/probes/probes.hpp"
#include "tests/core/support/exact.hpp"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace zerkalo::test {

constexpr std::size_t kLawRays = ZERKALO_LAW_RAYS;
// Halves, tenths and their like have no tail either.
static_assert(kLawRays % (160 * probes::kWidest) == 0);

struct PointList {
    std::vector<float> x, y, z;

    PointList() = default;
    explicit PointList(std::size_t count) : x(count), y(count), z(count) {}
    void add(const Exact3& p) {
        x.push_back(static_cast<float>(p.x));
        y.push_back(static_cast<float>(p.y));
        z.push_back(static_cast<float>(p.z));
    }
    std::size_t size() const { return x.size(); }
    int count() const { return static_cast<int>(x.size()); }
    /// The float values, exactly.
    Exact3 operator[](std::size_t k) const { return {x[k], y[k], z[k]}; }
    operator probes::Points() const { return {x.data(), y.data(), z.data()}; }
    probes::PointsOut out() { return {x.data(), y.data(), z.data()}; }
};

struct RayList {
    PointList o, d;

    void add(const Exact3& origin, const Exact3& direction) {
        o.add(origin);
        d.add(direction);
    }
    /// Repeats the last ray until no width has a tail.
    void pad() {
        while (o.size() % probes::kWidest != 0) add(o[o.size() - 1], d[d.size() - 1]);
    }
    std::size_t size() const { return o.size(); }
    operator probes::Rays() const { return {o, d, o.count()}; }
};

struct SpanList {
    std::vector<float> entry, exit, face_in, face_out;

    explicit SpanList(std::size_t count) : entry(count), exit(count), face_in(count), face_out(count) {}
    std::size_t size() const { return entry.size(); }
    operator probes::SpansOut() { return {entry.data(), exit.data(), face_in.data(), face_out.data()}; }
};

/// For messages: enough digits to repeat the case.
inline std::string text(const Exact3& v) {
    char line[128];
    std::snprintf(line, sizeof line, "(%a, %a, %a)", double(v.x), double(v.y), double(v.z));
    return line;
}
inline std::string text(const RayList& rays, std::size_t k) {
    return "ray " + std::to_string(k) + ": o " + text(rays.o[k]) + " d " + text(rays.d[k]);
}

}  // namespace zerkalo::test
