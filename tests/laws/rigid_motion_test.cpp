// P20: a scene that is turned and shifted together with its camera is the same scene.
#include "core/geometry/frame.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::laws {
namespace {

/// A turn by `angles` about x, then y, then z, and a shift.
struct Motion {
    Vec3<double> angles, shift;

    Vec3<double> direction(const Vec3<double>& v) const { return rotated(v, angles); }
    Vec3<double> point(const Vec3<double>& p) const { return rotated(p, angles) + shift; }
    /// The angles of this turn after that of `inner`, out of the columns of the matrix of both.
    Vec3<double> after(const Vec3<double>& inner) const {
        const Vec3<double> x = direction(rotated({1, 0, 0}, inner)), y = direction(rotated({0, 1, 0}, inner)),
                           z = direction(rotated({0, 0, 1}, inner));
        return {std::atan2(y.z, z.z), std::asin(-x.z), std::atan2(x.y, x.x)};
    }
};

Scene moved(Scene scene, const Motion& motion) {
    scene.camera.position = motion.point(scene.camera.position);
    scene.camera.view = motion.direction(scene.camera.view);
    scene.camera.up = motion.direction(scene.camera.up);
    for (int j = 0; j < scene.light_count; ++j) scene.lights[j].position = motion.point(scene.lights[j].position);
    for (int k = 0; k < scene.solid_count; ++k) {
        scene.solids[k].position = motion.point(scene.solids[k].position);
        scene.solids[k].rotation = motion.after(scene.solids[k].rotation);
    }
    for (int m = 0; m < scene.mirror_count; ++m) {
        Mirror& mirror = scene.mirrors[m];
        mirror.position = motion.point(mirror.position);
        mirror.normal = motion.direction(mirror.normal);
        mirror.up = motion.direction(mirror.up);
    }
    return scene;
}

Scene five_solids_before(double curvature_radius) {
    Scene scene = five_solids_before_mirror_aslant(curvature_radius);
    scene.solids[0].material = clear_glass(1.5);
    scene.solids[0].material.fresnel = true;
    return scene;
}

TEST(P20, TurnedAndShiftedSceneGivesTheSamePicture) {
    constexpr double kSilhouetteShare = 1e-3;
    const Motion motions[] = {{{0, 0, 0}, {8, -4, 2}}, {{0.5, 0, 0}, {0, 0, 0}}, {{-1, 0.75, 2.5}, {-3, 1, 7}}};
    for (const double curvature_radius : {kInfinity, 9.0}) {
        const Scene scene = five_solids_before(curvature_radius);
        const reference::Picture still = picture_of(render(scene, of_size(160, 120)));
        for (const Motion& motion : motions) {
            const reference::Picture after = picture_of(render(moved(scene, motion), of_size(160, 120)));
            const auto difference = reference::compare(after, still, 1);
            EXPECT_LE(static_cast<double>(difference.pixels_off_by_more), kSilhouetteShare * difference.pixels)
                << "shift " << motion.shift.x << ", turn " << motion.angles.x << ", R " << curvature_radius;
        }
    }
}

Vec3<double> half_turn(const Vec3<double>& v) { return {-v.x, v.y, -v.z}; }

/// Half a turn about the y axis: two signs change, in round solids and mirrors without a rounding.
Scene turned_round(Scene scene) {
    scene.camera.position = half_turn(scene.camera.position);
    scene.camera.view = half_turn(scene.camera.view);
    for (int j = 0; j < scene.light_count; ++j) scene.lights[j].position = half_turn(scene.lights[j].position);
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].position = half_turn(scene.solids[k].position);
    for (int m = 0; m < scene.mirror_count; ++m) {
        scene.mirrors[m].position = half_turn(scene.mirrors[m].position);
        scene.mirrors[m].normal = half_turn(scene.mirrors[m].normal);
    }
    return scene;
}

TEST(P20, HalfATurnOfRoundSolidsLeavesEveryByte) {
    for (const double curvature_radius : {kInfinity, 9.0, -9.0}) {
        Scene scene = five_solids_before(curvature_radius);
        for (int k = 0; k < scene.solid_count; ++k) {
            const SolidKind kinds[] = {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone};
            scene.solids[k].kind = kinds[k % 3];
            scene.solids[k].rotation = {0, 0, 0};
        }
        const Image still = render(scene, of_size(96, 72));
        EXPECT_EQ(pixels_apart(render(turned_round(scene), of_size(96, 72)), still), 0) << "R " << curvature_radius;
        EXPECT_GT(pixels_apart(flipped(still), still), 1000);
    }
}

}  // namespace
}  // namespace zerkalo::laws
