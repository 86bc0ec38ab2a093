// What a scene means where it says nothing.
#include "tests/scene_file/bad_scene.hpp"

namespace zerkalo {
namespace {

bool same(const Vec3<double>& a, const Vec3<double>& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool same(const Rgb<double>& a, const Rgb<double>& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

Scene scene_of(const std::string& text) {
    const LoadResult result = load_text(text);
    EXPECT_TRUE(result.ok()) << to_text(result);
    return result.ok() ? *result.scene : Scene{};
}

const std::string kPlace = "position = [0, 0, 0]\n";
const std::string kMirror =
    "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = 'disc', radius = 1 }\n";

TEST(SceneFileDefaults, EmptySceneIsLegalAndDark) {
    const LoadResult result = load_text(kHead);
    ASSERT_TRUE(result.ok()) << to_text(result);
    const Scene& scene = *result.scene;
    EXPECT_EQ(result.title, "");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(to_text(result), "");
    EXPECT_EQ(scene.light_count + scene.solid_count + scene.mirror_count + scene.triangle_count, 0);
    EXPECT_TRUE(same(scene.ambient, Rgb<double>{1, 1, 1}));
    EXPECT_TRUE(same(scene.background, Rgb<double>{0, 0, 0}));
    EXPECT_TRUE(same(scene.camera.up, Vec3<double>{0, 1, 0}));
}

TEST(SceneFileDefaults, LightIsWhiteOfIntensityOneWithoutFalloff) {
    const Scene scene = scene_of(kHead + "[[light]]\n" + kPlace);
    ASSERT_EQ(scene.light_count, 1);
    EXPECT_TRUE(same(scene.lights[0].color, Rgb<double>{1, 1, 1}));
    EXPECT_EQ(scene.lights[0].intensity, 1);
    EXPECT_EQ(scene.lights[0].falloff, Falloff::none);
}

TEST(SceneFileDefaults, SolidIsGreyMatteWithAHighlight) {
    const Scene scene = scene_of(kHead + "[[solid]]\nkind = 'sphere'\nradius = 2\n" + kPlace);
    ASSERT_EQ(scene.solid_count, 1);
    const Solid& solid = scene.solids[0];
    EXPECT_TRUE(same(solid.rotation, Vec3<double>{0, 0, 0}));
    EXPECT_TRUE(same(solid.material.color, Rgb<double>{0.8, 0.8, 0.8}));
    EXPECT_EQ(solid.material.ambient, 0.1);
    EXPECT_EQ(solid.material.diffuse, 0.7);
    EXPECT_EQ(solid.material.specular, 0.4);
    EXPECT_EQ(solid.material.shininess, 50);
    EXPECT_EQ(solid.material.reflection, 0);
    EXPECT_EQ(solid.material.transmission, 0);
    EXPECT_EQ(solid.material.refractive_index, 1.5);
    EXPECT_FALSE(solid.material.fresnel);
}

TEST(SceneFileDefaults, CylinderHasTaperOneConeZeroAndMeshScaleOne) {
    const std::string sizes = "radius = 1\nheight = 2\n" + kPlace;
    const Scene scene = scene_of(kHead + "[[solid]]\nkind = 'cone'\n" + sizes + "[[solid]]\nkind = 'cylinder'\n" +
                                 sizes + "[[solid]]\nkind = 'mesh'\nstl = 'gem.stl'\n" + kPlace);
    ASSERT_EQ(scene.solid_count, 3);
    EXPECT_EQ(scene.solids[0].taper, 0);
    EXPECT_EQ(scene.solids[1].taper, 1);
    EXPECT_EQ(scene.solids[2].scale, 1);
}

TEST(SceneFileDefaults, MirrorIsFlatWhiteAndPolished) {
    const Scene scene = scene_of(kHead + kMirror);
    ASSERT_EQ(scene.mirror_count, 1);
    const Mirror& mirror = scene.mirrors[0];
    EXPECT_TRUE(same(mirror.up, Vec3<double>{0, 1, 0}));
    EXPECT_TRUE(same(mirror.color, Rgb<double>{1, 1, 1}));
    EXPECT_EQ(mirror.curvature_radius, kInfinity);
    EXPECT_EQ(mirror.lobe, Lobe::max_phong);
    EXPECT_EQ(mirror.lobe_exponent, kInfinity);
    EXPECT_EQ(mirror.shininess, kShininessOfLobe);
    EXPECT_EQ(mirror.ambient, 0.05);
    EXPECT_EQ(mirror.diffuse, 0.1);
    EXPECT_EQ(mirror.specular, 0.3);
    EXPECT_EQ(mirror.reflection, 0.8);
}

}  // namespace
}  // namespace zerkalo
