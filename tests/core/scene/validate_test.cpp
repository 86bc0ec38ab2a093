// The gate names the field that is wrong: one bad value at a time, in every field of every part of a scene.
#include "core/scene/validate.hpp"

#include "core/geometry/frame.hpp"
#include "tests/core/support/meshes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace zerkalo::test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A valid scene with two of everything, so that an index can be wrong too.
std::unique_ptr<Scene> good_scene() {
    auto scene = std::make_unique<Scene>();
    scene->light_count = 2, scene->solid_count = 2, scene->mirror_count = 2;
    scene->solids[1].kind = SolidKind::prism;
    scene->mirrors[1].boundary = {.shape = BoundaryShape::disc, .radius = 1};
    scene->mirrors[1].curvature_radius = 3;
    return scene;
}

using Spoil = void (*)(Scene& scene, double value);

/// Expects every one of `values`, put in by `spoil`, to be refused with this part, index and field.
void expect_refused(Part part, std::int32_t index, const char* field, std::initializer_list<double> values,
                    Spoil spoil) {
    for (const double value : values) {
        const auto scene = good_scene();
        spoil(*scene, value);
        const Status status = validate(*scene);
        ASSERT_FALSE(status.ok()) << name_of(part) << "." << field << " = " << value << " is let through";
        EXPECT_STREQ(status.field, field) << name_of(part) << " = " << value;
        EXPECT_EQ(name_of(status.part), std::string(name_of(part))) << field << " = " << value;
        EXPECT_EQ(status.index, index) << field << " = " << value;
        EXPECT_GT(std::string(status.reason).size(), 5u) << field;
    }
}

/// Expects every one of `values` to be let through.
void expect_legal(std::initializer_list<double> values, Spoil change) {
    for (const double value : values) {
        const auto scene = good_scene();
        change(*scene, value);
        const Status status = validate(*scene);
        EXPECT_TRUE(status.ok()) << status.field << " " << status.reason << ": " << value;
    }
}

constexpr double kTooFar = 1.0000001e15;

TEST(Validate, AGoodSceneAndAnEmptyOnePass) {
    EXPECT_TRUE(validate(*good_scene()).ok());
    EXPECT_TRUE(validate(*std::make_unique<Scene>()).ok());
}

TEST(Validate, CountsAreNamed) {
    expect_refused(Part::scene, 0, "light", {-1, 9}, [](Scene& s, double v) { s.light_count = int(v); });
    expect_refused(Part::scene, 0, "solid", {-1, 33}, [](Scene& s, double v) { s.solid_count = int(v); });
    expect_refused(Part::scene, 0, "mirror", {-1, 9}, [](Scene& s, double v) { s.mirror_count = int(v); });
    expect_refused(Part::scene, 0, "triangles", {-1, 513}, [](Scene& s, double v) { s.triangle_count = int(v); });
    expect_legal({0, 8}, [](Scene& s, double v) { s.light_count = s.mirror_count = int(v); });
    expect_legal({0, 32}, [](Scene& s, double v) { s.solid_count = int(v); });
}

TEST(Validate, FieldsOfTheWholeSceneAreNamed) {
    const auto bad = {kNan, kInfinity, -1e-9};
    expect_refused(Part::scene, 0, "ambient", bad, [](Scene& s, double v) { s.ambient.g = v; });
    expect_refused(Part::scene, 0, "background", bad, [](Scene& s, double v) { s.background.b = v; });
    expect_refused(Part::image, 0, "width", {0, -1, 65537}, [](Scene& s, double v) { s.image.width = int(v); });
    expect_refused(Part::image, 0, "height", {0, -1, 65537}, [](Scene& s, double v) { s.image.height = int(v); });
    expect_refused(Part::image, 0, "height", {4097}, [](Scene& s, double v) { s.image = {65536, int(v)}; });
    expect_legal({1, 4096}, [](Scene& s, double v) { s.image = {65536, int(v)}; });
    expect_legal({0, 100}, [](Scene& s, double v) { s.background = {v, v, v}; });
}

TEST(Validate, FieldsOfTheCameraAreNamed) {
    const auto bad = {kNan, kInfinity, -kInfinity, kTooFar, -kTooFar};
    expect_refused(Part::camera, 0, "position", bad, [](Scene& s, double v) { s.camera.position.y = v; });
    expect_refused(Part::camera, 0, "view", {kNan, kInfinity}, [](Scene& s, double v) { s.camera.view.z = v; });
    expect_refused(Part::camera, 0, "view", {0, -0.0}, [](Scene& s, double v) { s.camera.view = {v, v, v}; });
    expect_refused(Part::camera, 0, "up", {kNan, -kInfinity}, [](Scene& s, double v) { s.camera.up.x = v; });
    expect_refused(Part::camera, 0, "up", {0}, [](Scene& s, double v) { s.camera.up = {v, v, v}; });
    const auto bad_angles = {kNan, kInfinity, 0.0, -1.0, kPi, 4.0};
    expect_refused(Part::camera, 0, "horizontal_fov_deg", bad_angles, [](Scene& s, double v) { s.camera.fov = v; });
    expect_refused(Part::camera, 0, "vertical_fov_deg", bad_angles, [](Scene& s, double v) {
        s.camera.fov = v;
        s.camera.fov_axis = FovAxis::vertical;
    });
    expect_legal({1e15, -1e15}, [](Scene& s, double v) { s.camera.position = {v, v, v}; });
    expect_legal({1e-300, 1e300, -1}, [](Scene& s, double v) { s.camera.view = s.camera.up = {0, v, 0}; });
    expect_legal({1e-9, 3.14159}, [](Scene& s, double v) { s.camera.fov = v; });
}

TEST(Validate, FieldsOfALightAreNamed) {
    const auto far = {kNan, kInfinity, kTooFar};
    const auto dark = {kNan, kInfinity, -1e-300};
    expect_refused(Part::light, 1, "position", far, [](Scene& s, double v) { s.lights[1].position.z = v; });
    expect_refused(Part::light, 1, "color", dark, [](Scene& s, double v) { s.lights[1].color.r = v; });
    expect_refused(Part::light, 0, "intensity", dark, [](Scene& s, double v) { s.lights[0].intensity = v; });
    expect_legal({0, 1e300}, [](Scene& s, double v) { s.lights[1].intensity = v; });
}

TEST(Validate, SizesOfASolidAreNamed) {
    const auto no_size = {kNan, kInfinity, 0.0, -1.0, kTooFar};
    const auto far = {kNan, -kInfinity, -kTooFar};
    expect_refused(Part::solid, 1, "position", far, [](Scene& s, double v) { s.solids[1].position.x = v; });
    expect_refused(Part::solid, 1, "rotate_deg", {kNan, kInfinity, -1.8e5},
                   [](Scene& s, double v) { s.solids[1].rotation.y = v; });
    expect_refused(Part::solid, 1, "sides", {2, 65, 0, -3}, [](Scene& s, double v) { s.solids[1].sides = int(v); });
    expect_refused(Part::solid, 0, "radius", no_size, [](Scene& s, double v) { s.solids[0].radius = v; });
    expect_refused(Part::solid, 1, "height", no_size, [](Scene& s, double v) { s.solids[1].height = v; });
    expect_refused(Part::solid, 0, "taper", {kNan, kInfinity, -1e-9, kTooFar}, [](Scene& s, double v) {
        s.solids[0].kind = SolidKind::cone;
        s.solids[0].taper = v;
    });
    // What does not belong to the kind does not count.
    expect_legal({kNan, -1}, [](Scene& s, double v) { s.solids[0].height = s.solids[0].taper = v; });
    expect_legal({3, 64}, [](Scene& s, double v) { s.solids[1].sides = int(v); });
}

TEST(Validate, MaterialOfASolidIsNamed) {
    const auto no_share = {kNan, kInfinity, -1e-9, 1.0000001};
    expect_refused(Part::solid, 1, "color", no_share, [](Scene& s, double v) { s.solids[1].material.color.g = v; });
    expect_refused(Part::solid, 1, "ambient", no_share, [](Scene& s, double v) { s.solids[1].material.ambient = v; });
    expect_refused(Part::solid, 1, "diffuse", no_share, [](Scene& s, double v) { s.solids[1].material.diffuse = v; });
    expect_refused(Part::solid, 1, "specular", no_share, [](Scene& s, double v) { s.solids[1].material.specular = v; });
    expect_refused(Part::solid, 1, "shininess", {kNan, kInfinity, -1e-9},
                   [](Scene& s, double v) { s.solids[1].material.shininess = v; });
    expect_refused(Part::solid, 1, "reflection", no_share,
                   [](Scene& s, double v) { s.solids[1].material.reflection = v; });
    expect_refused(Part::solid, 1, "transmission", no_share,
                   [](Scene& s, double v) { s.solids[1].material.transmission = v; });
    expect_refused(Part::solid, 1, "transmission", {0.5000001}, [](Scene& s, double v) {
        s.solids[1].material.reflection = 0.5;
        s.solids[1].material.transmission = v;
    });
    expect_refused(Part::solid, 1, "refractive_index", {kNan, kInfinity, 0, -1.5},
                   [](Scene& s, double v) { s.solids[1].material.refractive_index = v; });
    expect_refused(Part::solid, 1, "fresnel", {0.0}, [](Scene& s, double v) {
        s.solids[1].material.transmission = v;
        s.solids[1].material.fresnel = true;
    });
    expect_legal({1e-9, 1.0}, [](Scene& s, double v) {
        s.solids[1].material.transmission = v;
        s.solids[1].material.fresnel = true;
    });
    expect_legal({0, 0.5}, [](Scene& s, double v) {
        s.solids[1].material.reflection = s.solids[1].material.transmission = v;
        s.solids[1].material.shininess = v * 1e300;
    });
}

TEST(Validate, FieldsOfAMirrorAreNamed) {
    const auto far = {kNan, kInfinity, kTooFar};
    const auto no_share = {kNan, kInfinity, -1e-9, 1.0000001};
    expect_refused(Part::mirror, 1, "position", far, [](Scene& s, double v) { s.mirrors[1].position.x = v; });
    expect_refused(Part::mirror, 1, "normal", {kNan, kInfinity}, [](Scene& s, double v) { s.mirrors[1].normal.x = v; });
    expect_refused(Part::mirror, 1, "normal", {0}, [](Scene& s, double v) { s.mirrors[1].normal = {v, v, v}; });
    expect_refused(Part::mirror, 1, "up", {0}, [](Scene& s, double v) { s.mirrors[1].up = {v, v, v}; });
    expect_refused(Part::mirror, 1, "up", {kNan}, [](Scene& s, double v) { s.mirrors[1].up.z = v; });
    expect_refused(Part::mirror, 1, "curvature_radius", {kNan, 0, -0.0, 1, -1, 0.5},
                   [](Scene& s, double v) { s.mirrors[1].curvature_radius = v; });
    expect_refused(Part::mirror, 0, "lobe_exponent", {kNan, -1e-9, -kInfinity},
                   [](Scene& s, double v) { s.mirrors[0].lobe_exponent = v; });
    expect_refused(Part::mirror, 0, "color", no_share, [](Scene& s, double v) { s.mirrors[0].color.b = v; });
    expect_refused(Part::mirror, 0, "ambient", no_share, [](Scene& s, double v) { s.mirrors[0].ambient = v; });
    expect_refused(Part::mirror, 0, "diffuse", no_share, [](Scene& s, double v) { s.mirrors[0].diffuse = v; });
    expect_refused(Part::mirror, 0, "specular", no_share, [](Scene& s, double v) { s.mirrors[0].specular = v; });
    expect_refused(Part::mirror, 0, "reflection", no_share, [](Scene& s, double v) { s.mirrors[0].reflection = v; });
    expect_refused(Part::mirror, 0, "shininess", {kNan, kInfinity, -2, -0.5},
                   [](Scene& s, double v) { s.mirrors[0].shininess = v; });
    expect_legal({1.0000001, -1.0000001, 1e300, kInfinity, -kInfinity},
                 [](Scene& s, double v) { s.mirrors[1].curvature_radius = v; });
    expect_legal({0, 1e300, kInfinity}, [](Scene& s, double v) { s.mirrors[0].lobe_exponent = v; });
    expect_legal({kShininessOfLobe, 0, 1e300}, [](Scene& s, double v) { s.mirrors[0].shininess = v; });
}

TEST(Validate, OutlineOfAMirrorIsNamed) {
    const auto no_size = {kNan, kInfinity, 0.0, -1.0, kTooFar};
    expect_refused(Part::mirror, 0, "boundary.width", no_size,
                   [](Scene& s, double v) { s.mirrors[0].boundary.width = v; });
    expect_refused(Part::mirror, 0, "boundary.height", no_size, [](Scene& s, double v) {
        s.mirrors[0].boundary.shape = BoundaryShape::ellipse;
        s.mirrors[0].boundary.height = v;
    });
    expect_refused(Part::mirror, 1, "boundary.radius", no_size,
                   [](Scene& s, double v) { s.mirrors[1].boundary.radius = v; });
    // The farthest point of each outline against |R|, from just inside to just outside.
    expect_refused(Part::mirror, 0, "curvature_radius", {2.5, -2.5, 2.4}, [](Scene& s, double v) {
        s.mirrors[0].boundary = {.shape = BoundaryShape::rectangle, .width = 3, .height = 4};
        s.mirrors[0].curvature_radius = v;
    });
    expect_legal({2.5000001, -2.5000001}, [](Scene& s, double v) {
        s.mirrors[0].boundary = {.shape = BoundaryShape::rectangle, .width = 3, .height = 4};
        s.mirrors[0].curvature_radius = v;
    });
    expect_refused(Part::mirror, 0, "curvature_radius", {2, -2}, [](Scene& s, double v) {
        s.mirrors[0].boundary = {.shape = BoundaryShape::ellipse, .width = 3, .height = 4};
        s.mirrors[0].curvature_radius = v;
    });
}

Boundary polygon(std::initializer_list<Vec2<double>> corners) {
    Boundary boundary{.shape = BoundaryShape::polygon};
    for (const Vec2<double>& corner : corners) boundary.corners[boundary.corner_count++] = corner;
    return boundary;
}

Status validated(const Boundary& boundary) {
    const auto scene = good_scene();
    scene->mirrors[0].boundary = boundary;
    return validate(*scene);
}

TEST(Validate, PolygonsMustBeConvexInEitherSense) {
    EXPECT_TRUE(validated(polygon({{0, 0}, {1, 0}, {0, 1}})).ok());
    EXPECT_TRUE(validated(polygon({{0, 1}, {1, 0}, {0, 0}})).ok());
    EXPECT_TRUE(validated(polygon({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {-1, 1}})).ok());
    const Boundary bad[] = {
        polygon({{0, 0}, {1, 0}}),                                                // too few
        polygon({{0, 0}, {1, 0}, {2, 0}}),                                        // in a line
        polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}),                                // a corner twice
        polygon({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}}),                              // a dent
        polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}),                                // crosses itself
        polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}}),                      // a corner on an edge
        polygon({{1, 0}, {-0.8, 0.6}, {0.3, -0.95}, {0.3, 0.95}, {-0.8, -0.6}}),  // a star: turns one way, twice round
        polygon({{0, 0}, {1, 0}, {0, kNan}}),
        polygon({{0, 0}, {1, 0}, {0, kTooFar}}),
    };
    for (const Boundary& boundary : bad) {
        const Status status = validated(boundary);
        ASSERT_FALSE(status.ok()) << "polygon " << &boundary - bad;
        EXPECT_STREQ(status.field, "boundary.points") << "polygon " << &boundary - bad;
    }
    Boundary many = polygon({{0, 0}, {1, 0}, {0, 1}});
    many.corner_count = kMaxCorners + 1;
    EXPECT_STREQ(validated(many).field, "boundary.points");
}

/// The complaint about a mesh that is a cube, changed by `change`.
template <class F>
Status validated_mesh(F change) {
    const auto scene = std::make_unique<Scene>();
    Solid cube;
    cube.kind = SolidKind::prism;
    const auto triangles = triangles_of(cube);
    std::copy(triangles.begin(), triangles.end(), scene->triangles);
    scene->triangle_count = static_cast<std::int32_t>(triangles.size());
    scene->solid_count = 1;
    scene->solids[0] = meshed(cube, triangles);
    change(*scene);
    return validate(*scene);
}

TEST(Validate, MeshesMustBeClosedAndTurnedOutwards) {
    EXPECT_TRUE(validated_mesh([](Scene&) {}).ok());
    const auto expect_field = [](const Status& status, const char* field, const char* what) {
        ASSERT_FALSE(status.ok()) << what;
        EXPECT_STREQ(status.field, field) << what;
        EXPECT_EQ(status.part, Part::solid) << what;
    };
    expect_field(validated_mesh([](Scene& s) { s.solids[0].triangle_count -= 1; }), "triangles", "a hole");
    expect_field(validated_mesh([](Scene& s) { s.solids[0].triangle_count = 3; }), "triangles", "too few");
    expect_field(validated_mesh([](Scene& s) { s.solids[0].triangle_count += 1; }), "triangles", "beyond the pool");
    expect_field(validated_mesh([](Scene& s) { s.solids[0].first_triangle = -1; }), "triangles", "before the pool");
    expect_field(validated_mesh([](Scene& s) { std::swap(s.triangles[0].a, s.triangles[0].b); }), "triangles",
                 "one triangle inside out");
    expect_field(validated_mesh([](Scene& s) {
                     for (std::int32_t k = 0; k < s.triangle_count; ++k) std::swap(s.triangles[k].a, s.triangles[k].b);
                 }),
                 "triangles", "all inside out");
    expect_field(validated_mesh([](Scene& s) { s.triangles[0].b = s.triangles[0].a; }), "triangles", "no area");
    expect_field(validated_mesh([](Scene& s) { s.triangles[1] = s.triangles[0]; }), "triangles", "a triangle twice");
    for (const double bad : {kNan, kInfinity, kTooFar}) {
        expect_field(validated_mesh([bad](Scene& s) { s.triangles[2].c.y = bad; }), "vertices",
                     "a corner out of range");
    }
    for (const double bad : {kNan, kInfinity, 0.0, -1.0}) {
        expect_field(validated_mesh([bad](Scene& s) { s.solids[0].scale = bad; }), "scale", "scale");
    }
}

TEST(Validate, TheFirstOfTwoFaultsIsTheOneInTheOrderOfTheFile) {
    const auto scene = good_scene();
    scene->mirrors[0].reflection = 2;
    scene->camera.fov = 0;
    EXPECT_EQ(validate(*scene).part, Part::camera);
}

}  // namespace
}  // namespace zerkalo::test
