// What a person writes: a static scene as plain data, in doubles, lengths in scene units, angles in radians.
// Trivially copyable and of fixed capacity; a Scene can be a constexpr object.
#pragma once

#include "core/geometry/vec.hpp"
#include "core/shapes/boundary_shape.hpp"

#include <cstdint>
#include <limits>

namespace zerkalo {

constexpr int kMaxSolids = 32;
constexpr int kMaxMirrors = 8;
constexpr int kMaxLights = 8;
constexpr int kMaxTriangles = 512;  // of all meshes together
constexpr int kMinSides = 3;
constexpr int kMaxSides = 64;
constexpr double kMaxCoordinate = 1e15;
constexpr double kMaxAngleDegrees = 1e7;  // of a rotation; sine and cosine of more would be noise
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The angle that was given stays; the other follows from the size that is rendered.
enum class FovAxis : std::uint8_t { horizontal, vertical };

struct Camera {
    Vec3<double> position{0, 0, 0};
    Vec3<double> view{0, 0, -1};  // any length > 0
    Vec3<double> up{0, 1, 0};     // any length > 0; parallel to view is legal
    double fov = 0.7;             // full angle, radians, 0 < fov < pi
    FovAxis fov_axis = FovAxis::horizontal;
};

enum class Falloff : std::uint8_t { none, inverse_square };

/// A point light. Its irradiance at distance d is color * intensity * (1 or 1/d^2).
struct Light {
    Vec3<double> position{0, 0, 0};
    Rgb<double> color{1, 1, 1};
    double intensity = 1;
    Falloff falloff = Falloff::none;
};

/// The coefficients of Whitted's sum (seed formula 1.5), used as given.
struct Material {
    Rgb<double> color{0.8, 0.8, 0.8};  // C
    double ambient = 0.1;              // K_a
    double diffuse = 0.7;              // K_d
    double specular = 0.4;             // K_s
    double shininess = 50;             // n
    double reflection = 0;             // K_r
    double transmission = 0;           // K_t
    double refractive_index = 1.5;     // of the solid, against 1 outside
    bool fresnel = false;              // Fresnel's equations divide K_t by the angle; needs K_t > 0
};

enum class SolidKind : std::uint8_t { pyramid, prism, sphere, cylinder, cone, mesh };

/// A closed solid. Its own axis is local +y, its base lies in y = 0 at `position`; a sphere's centre is `position`.
/// Which sizes count depends on the kind: sides (pyramid, prism), radius (all but mesh), height (all but sphere and
/// mesh), taper (cylinder, cone: top radius / base radius), triangles and scale (mesh).
struct Solid {
    SolidKind kind = SolidKind::sphere;
    Vec3<double> position{0, 0, 0};
    Vec3<double> rotation{0, 0, 0};  // radians about x, then y, then z, at `position`; up to 1e7 degrees either way
    double radius = 1;               // circumradius of the base for pyramid and prism
    double height = 1;
    double taper = 1;
    double scale = 1;
    std::int32_t sides = 4;
    std::int32_t first_triangle = 0;  // into Scene::triangles
    std::int32_t triangle_count = 0;
    Material material;
};

/// Corners counter-clockwise seen from outside, in the mesh's own coordinates.
struct Triangle {
    Vec3<double> a, b, c;
};

/// The outline of a mirror in the tangent plane at its vertex: x along `right`, y along `v` (see Mirror).
struct Boundary {
    BoundaryShape shape = BoundaryShape::rectangle;
    double width = 1, height = 1;  // full sizes: rectangle, ellipse
    double radius = 1;             // disc
    std::int32_t corner_count = 0;
    Vec2<double> corners[kMaxCorners]{};  // polygon: convex, in either sense
};

/// phong: the seed's lobe, directions below the horizon see the background.
/// max_phong: the same density with weight min(1, cos_i / cos_o), nothing from below: reciprocal, albedo <= 1.
/// ggx: microfacets of width alpha = (2 n + 1)^-1/2 (optics/ggx.hpp), nothing from below: reciprocal, albedo <= 1.
enum class Lobe : std::uint8_t { phong, max_phong, ggx };

/// A mirror's shininess when nothing else is said: that of its lobe; a sharp mirror then has no highlight.
constexpr double kShininessOfLobe = -1;

/// A bounded plane or spherical mirror. Frame: n = normal, right = up x n, v = n x right.
struct Mirror {
    Vec3<double> position{0, 0, 0};  // its vertex
    Vec3<double> normal{0, 0, 1};    // any length > 0; rays meet the front where D.N < 0
    Vec3<double> up{0, 1, 0};
    Boundary boundary;
    double curvature_radius = kInfinity;  // centre of the sphere = position + R n; > 0 is hollow from the front
    Lobe lobe = Lobe::max_phong;
    double lobe_exponent = kInfinity;  // infinity is the sharp mirror
    Rgb<double> color{1, 1, 1};        // F: tints the reflected and the specular share, and C of the matte share
    double ambient = 0.05;
    double diffuse = 0.1;
    double specular = 0.3;
    double shininess = kShininessOfLobe;
    double reflection = 0.8;
};

struct ImageSize {
    std::int32_t width = 640, height = 480;
};

struct Scene {
    ImageSize image;
    Camera camera;
    Rgb<double> ambient{1, 1, 1};
    Rgb<double> background{0, 0, 0};
    std::int32_t light_count = 0, solid_count = 0, mirror_count = 0, triangle_count = 0;
    Light lights[kMaxLights]{};
    Solid solids[kMaxSolids]{};
    Mirror mirrors[kMaxMirrors]{};
    Triangle triangles[kMaxTriangles]{};
};

}  // namespace zerkalo
