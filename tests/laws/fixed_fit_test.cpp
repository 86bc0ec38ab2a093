// What the fixed-point formats hold and what prepare() refuses: with the part, the field and nothing wrapped.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

namespace zerkalo::laws {
namespace {

Vec3<double> times(double s, const Vec3<double>& v) { return {s * v.x, s * v.y, s * v.z}; }

/// Every length of a simple scene times s.
Scene larger(double s) {
    Scene scene = simple_scene();
    scene.camera.position = times(s, scene.camera.position);
    scene.lights[0].position = times(s, scene.lights[0].position);
    for (int k = 0; k < scene.solid_count; ++k) {
        scene.solids[k].position = times(s, scene.solids[k].position);
        scene.solids[k].radius *= s, scene.solids[k].height *= s;
    }
    scene.mirrors[0].position = times(s, scene.mirrors[0].position);
    scene.mirrors[0].boundary.width *= s, scene.mirrors[0].boundary.height *= s;
    return scene;
}

TEST(FixedFit, ScenesOfAnySizeGiveTheSameBytes) {
    const Image image = render_fixed(simple_scene(), of_size(48, 36));
    for (const double s : {0x1p-30, 0.25, 2.0, 64.0, 0x1p40}) {
        EXPECT_EQ(render_fixed(larger(s), of_size(48, 36)).hash(), image.hash()) << s;
    }
}

TEST(FixedFit, SizesBetweenPowersOfTwoGiveThePictureOfFloat) {
    for (const double s : {0.7, 1.3, 3.1, 1e6}) {
        const Image fixed = render_fixed(larger(s), of_size(48, 36)), floats = render(larger(s), of_size(48, 36));
        const auto difference = reference::compare(picture_of(fixed), picture_of(floats), 1);
        EXPECT_LE(difference.pixels_off_by_more, 2) << s;
    }
}

struct Refusal {
    const char* what;
    Part part;
    std::int32_t index;
    const char* field;
    std::function<void(Scene&)> change;
};

TEST(FixedFit, WhatTheFormatsCannotHoldIsRefusedByItsField) {
    const Refusal refusals[] = {
        {"a lamp far away", Part::light, 1, "position", [](Scene& s) { add(s, lamp({0, 5000, 0})); }},
        {"a mirror's neighbour far smaller", Part::solid, 0, "radius", [](Scene& s) { s.solids[0].radius = 1e-4; }},
        {"a flat cone", Part::solid, 1, "height", [](Scene& s) { s.solids[1].height = 0.02; }},
        {"a dense glass", Part::solid, 2, "refractive_index",
         [](Scene& s) { s.solids[2].material.transmission = 0.5, s.solids[2].material.refractive_index = 9; }},
        {"a highlight of no width", Part::solid, 3, "shininess", [](Scene& s) { s.solids[3].material.shininess = 1e12; }},
        {"a strong curve", Part::mirror, 0, "curvature_radius",
         [](Scene& s) {
             s.mirrors[0].boundary = {BoundaryShape::disc, 1, 1, 0.03, 0, {}};
             s.mirrors[0].curvature_radius = 0.04;
         }},
        {"a tiny mirror", Part::mirror, 0, "boundary",
         [](Scene& s) { s.mirrors[0].boundary.width = s.mirrors[0].boundary.height = 1e-5; }},
        {"a lamp too bright", Part::light, 0, "intensity", [](Scene& s) { s.lights[0].intensity = 1e6; }},
        {"too much light from everywhere", Part::scene, 0, "ambient", [](Scene& s) { s.ambient = {1e6, 0, 0}; }},
        {"too bright a background", Part::scene, 0, "background", [](Scene& s) { s.background = {0, 1e6, 0}; }},
    };
    const auto plan = std::make_unique<FixedPlan>();
    for (const Refusal& refusal : refusals) {
        Scene scene = simple_scene();
        refusal.change(scene);
        const Status status = prepare(scene, of_size(8, 8), *plan);
        if (status.ok()) {
            ADD_FAILURE() << refusal.what << ": accepted";
            continue;
        }
        EXPECT_STREQ(status.field, refusal.field) << refusal.what;
        EXPECT_EQ(status.part, refusal.part) << refusal.what;
        EXPECT_EQ(status.index, refusal.index) << refusal.what;
    }
}

TEST(FixedFit, ASceneThatFloatRefusesIsRefusedAlike) {
    Scene scene = simple_scene();
    scene.solids[0].radius = -1;
    const auto plan = std::make_unique<FixedPlan>();
    EXPECT_STREQ(prepare(scene, of_size(8, 8), *plan).field, "radius");
}

/// A lamp a hundred times as bright before a surface a hundredth as bright: the exposure is undone exactly.
TEST(FixedFit, BrightLightIsExposedAndTheExposureUndone) {
    Scene scene = simple_scene();
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].material.specular = 0;
    const Image ordinary = render(scene, of_size(48, 36));
    scene.lights[0].intensity = 1000;
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].material.diffuse /= 1000;
    scene.mirrors[0].diffuse /= 1000;
    const Image exposed = render_fixed(scene, of_size(48, 36));
    EXPECT_LE(reference::compare(picture_of(exposed), picture_of(ordinary), 1).pixels_off_by_more, 2);
}

TEST(FixedFit, ACameraFarAwaySeesWhatFloatSees) {
    Scene scene = simple_scene();
    scene.camera = camera_at({100, 800, 2000}, {-100, -799, -1999}, 0.004);
    const Image fixed = render_fixed(scene, of_size(48, 36)), floats = render(scene, of_size(48, 36));
    EXPECT_GT(largest_difference(render(simple_scene(), of_size(48, 36)), floats), 0.1);
    EXPECT_LE(reference::compare(picture_of(fixed), picture_of(floats), 1).pixels_off_by_more, 3);
}

TEST(FixedFit, FadingLightIsThatOfFloatInAnyBox) {
    for (const double s : {0.125, 1.0, 16.0}) {
        Scene scene = larger(s);
        scene.lights[0].falloff = Falloff::inverse_square;
        scene.lights[0].intensity = 30 * s * s;
        const Image fixed = render_fixed(scene, of_size(48, 36)), floats = render(scene, of_size(48, 36));
        EXPECT_LE(reference::compare(picture_of(fixed), picture_of(floats), 1).pixels_off_by_more, 2) << s;
    }
}

}  // namespace
}  // namespace zerkalo::laws
