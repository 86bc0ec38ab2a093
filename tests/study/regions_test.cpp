// The regions of a scene whose outlines are known.
#include "tools/study/regions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::study {
namespace {

// The camera looks along -z at a mirror at z = -2 that covers the whole view but a margin; a ball stands aside.
Scene staged() {
    Scene scene;
    scene.camera.position = {0, 0, 2};
    scene.camera.fov = 1;
    scene.mirror_count = 1;
    scene.mirrors[0].position = {0, 0, -2};
    scene.mirrors[0].boundary.width = scene.mirrors[0].boundary.height = 2.5;
    scene.mirrors[0].lobe_exponent = 1000;
    scene.solid_count = 1;
    scene.solids[0].position = {0, 0, 0};
    scene.solids[0].radius = 0.2;
    return scene;
}

constexpr ImageSize kSize{120, 120};

Regions regions_of_scene(const Scene& scene) { return regions_of({best_isa(), 1, nullptr}, scene, kSize); }

bool at(const Regions& regions, Region region, int x, int y) {
    return mask_of(regions, region)[static_cast<std::size_t>(y * kSize.width + x)];
}

// Tangent of the view angle at a pixel's centre, as a share of the half picture.
double tangent(int pixel) { return ((2 * pixel + 1) / 120.0 - 1) * std::tan(0.5); }

TEST(StudyRegions, TheMirrorIsWhereTheCameraSeesItsFront) {
    const Regions regions = regions_of_scene(staged());
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const double tx = tangent(x), ty = tangent(y);
            // The ball has the angle asin(0.2 / 2) about the axis.
            const bool ball = std::hypot(tx, ty) < std::tan(std::asin(0.1));
            const bool mirror = std::abs(tx) < 1.25 / 4 && std::abs(ty) < 1.25 / 4 && !ball;
            EXPECT_EQ(at(regions, Region::mirror, x, y), mirror) << x << " " << y;
        }
    }
}

TEST(StudyRegions, ABackReflectsNothing) {
    Scene scene = staged();
    scene.mirrors[0].normal = {0, 0, -1};
    EXPECT_EQ(pixels_of(mask_of(regions_of_scene(scene), Region::mirror)), 0);
}

TEST(StudyRegions, SilhouettesAreTheOutlines) {
    const Regions regions = regions_of_scene(staged());
    EXPECT_EQ(pixels_of(mask_of(regions, Region::picture)), kSize.width * kSize.height);
    const int middle = kSize.height / 2;
    int outlines = 0;
    for (int x = 0; x < kSize.width; ++x) outlines += at(regions, Region::silhouettes, x, middle);
    // Two pixels at each of: both edges of the mirror, both of the ball, both of its image (hidden by the ball).
    EXPECT_EQ(outlines, 8);
    EXPECT_FALSE(at(regions, Region::silhouettes, 2, 2));
    EXPECT_FALSE(at(regions, Region::silhouettes, middle, middle));
}

TEST(StudyRegions, AnImageInTheMirrorHasAnOutlineToo) {
    Scene scene = staged();
    scene.camera.position = {1.5, 0, 1};
    scene.camera.view = {-1.5, 0, -3};
    scene.mirrors[0].lobe_exponent = 20000;
    const Regions regions = regions_of_scene(scene);
    const Mask &silhouettes = mask_of(regions, Region::silhouettes), &mirror = mask_of(regions, Region::mirror);
    const Mask &edges = mask_of(regions, Region::edges), &smooth = mask_of(regions, Region::smooth);
    std::int64_t inside = 0, sharp_but_smooth = 0;
    for (std::size_t i = 0; i < mirror.size(); ++i) {
        EXPECT_FALSE(edges[i] && !mirror[i]) << i;
        EXPECT_FALSE(smooth[i] && !mirror[i]) << i;
        EXPECT_FALSE(edges[i] && smooth[i]) << i;
        inside += silhouettes[i] && edges[i];
        sharp_but_smooth += silhouettes[i] && smooth[i];
    }
    EXPECT_GT(inside, 10);
    EXPECT_EQ(sharp_but_smooth, 0);  // on the outline of the image the lobe meets the ball and the background
    EXPECT_GT(pixels_of(edges), inside);
    EXPECT_GT(pixels_of(smooth), 0);
}

// A lamp aside lights half of the ball: no lobe that meets the other half's border is smooth.
TEST(StudyRegions, NoRimOfAShadowIsSmooth) {
    Scene scene = staged();
    scene.camera.position = {1.5, 0, 1};
    scene.camera.view = {-1.5, 0, -3};
    scene.mirrors[0].lobe_exponent = 20000;
    scene.mirrors[0].specular = 0;
    const std::int64_t dark = pixels_of(mask_of(regions_of_scene(scene), Region::smooth));
    scene.light_count = 1;
    scene.lights[0].position = {0, 50, -0.2};
    const Regions half = regions_of_scene(scene);
    EXPECT_LT(pixels_of(mask_of(half, Region::smooth)), dark);
    EXPECT_GT(pixels_of(mask_of(half, Region::smooth)), dark / 2);
    // From all around the mirror everything that it shows is lit.
    scene.lights[0].position = {0.3, 0.1, -1.9};
    EXPECT_GT(pixels_of(mask_of(regions_of_scene(scene), Region::smooth)), pixels_of(mask_of(half, Region::smooth)));
}

TEST(StudyRegions, ADullerMirrorHasWiderEdges) {
    Scene scene = staged();
    const auto edges = [&](double exponent) {
        scene.mirrors[0].lobe_exponent = exponent;
        return pixels_of(mask_of(regions_of_scene(scene), Region::edges));
    };
    const std::int64_t sharp = edges(1e5), dull = edges(200);
    EXPECT_GT(dull, 2 * sharp);
}

}  // namespace
}  // namespace zerkalo::study
