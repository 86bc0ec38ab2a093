// Every key of a scene file arrives where it belongs, in the units of the scene.
#include "core/scene/edit.hpp"
#include "tests/scene_file/bad_scene.hpp"

#include <cmath>
#include <numbers>

namespace zerkalo {
namespace {

void expect_vector(const Vec3<double>& found, double x, double y, double z) {
    EXPECT_TRUE(found.x == x && found.y == y && found.z == z) << found.x << " " << found.y << " " << found.z;
}

std::unique_ptr<Scene> loaded(const std::string& text) {
    LoadResult result = load_text(text);
    EXPECT_TRUE(result.ok()) << to_text(result);
    return result.ok() ? std::move(result.scene) : std::make_unique<Scene>();
}

TEST(SceneFileValues, TopAndImageArriveAsWritten) {
    const LoadResult result = load_text(
        "version = 1\ntitle = \"зеркало\"\nambient = [0.5, 2, 0]\nbackground = [0, 0.25, 3]\n"
        "[image]\nwidth = 65536\nheight = 4096\n" +
        kCamera);
    ASSERT_FALSE(result.ok()) << "a camera key inside [image] must not be taken";
    const LoadResult right =
        load_text("version = 1\ntitle = \"зеркало\"\nambient = [0.5, 2, 0]\nbackground = [0, 0.25, 3]\n" + kCamera +
                  "[image]\nwidth = 65536\nheight = 4096\n");
    ASSERT_TRUE(right.ok()) << to_text(right);
    EXPECT_EQ(right.title, "зеркало");
    EXPECT_EQ(right.scene->image.width, 65536);
    EXPECT_EQ(right.scene->image.height, 4096);
    EXPECT_TRUE(right.scene->ambient.r == 0.5 && right.scene->ambient.g == 2 && right.scene->ambient.b == 0);
    EXPECT_TRUE(right.scene->background.g == 0.25 && right.scene->background.b == 3);
}

TEST(SceneFileValues, CameraLooksAtItsTargetFromWhereItStoodBeforeTheMove) {
    const auto scene = loaded(kTop +
                              "[camera]\nposition = [1, 2, 3]\nlook_at = [1, 2, -4]\nup = [0, 0, 2]\n"
                              "horizontal_fov_deg = 90\nmove = [10, 20, 30]\n");
    expect_vector(scene->camera.position, 11, 22, 33);
    expect_vector(scene->camera.view, 0, 0, -7);
    expect_vector(scene->camera.up, 0, 0, 2);
    EXPECT_EQ(scene->camera.fov_axis, FovAxis::horizontal);
    EXPECT_EQ(scene->camera.fov, radians(90));
    EXPECT_NEAR(scene->camera.fov, std::numbers::pi / 2, 1e-15);
}

TEST(SceneFileValues, CameraTurnsAboutXThenYThenZ) {
    const auto scene = loaded(kTop +
                              "[camera]\nposition = [0, 0, 0]\nview = [0, 0, -1]\nvertical_fov_deg = 30\n"
                              "turn_deg = [90, 90, 0]\n");
    // About x by a quarter: -z goes to +y; about y: +y stays. Up: +y goes to +z, then +z to +x.
    EXPECT_NEAR(scene->camera.view.y, 1, 1e-12);
    EXPECT_NEAR(scene->camera.up.x, 1, 1e-12);
    EXPECT_EQ(scene->camera.fov_axis, FovAxis::vertical);
    EXPECT_EQ(scene->camera.fov, radians(30));
}

TEST(SceneFileValues, LightsMoveAndKeepTheirOrder) {
    const auto scene =
        loaded(kHead +
               "[[light]]\nposition = [1, 2, 3]\nmove = [0.5, 0, -1]\ncolor = [2, 0, 0.5]\nintensity = 7\n"
               "falloff = 'inverse_square'\n[[light]]\nposition = [4, 5, 6]\n");
    ASSERT_EQ(scene->light_count, 2);
    expect_vector(scene->lights[0].position, 1.5, 2, 2);
    expect_vector(scene->lights[1].position, 4, 5, 6);
    EXPECT_EQ(scene->lights[0].color.r, 2);
    EXPECT_EQ(scene->lights[0].color.b, 0.5);
    EXPECT_EQ(scene->lights[0].intensity, 7);
    EXPECT_EQ(scene->lights[0].falloff, Falloff::inverse_square);
}

TEST(SceneFileValues, SolidsOfEveryKindArriveAsWritten) {
    const std::string tail = "position = [1, 2, 3]\n";
    const auto scene =
        loaded(kHead + "[[solid]]\nkind = 'pyramid'\nsides = 3\nradius = 2\nheight = 4\nrotate_deg = [10, -20, 720]\n" +
               tail + "[[solid]]\nkind = 'prism'\nsides = 64\nradius = 2\nheight = 4\n" + tail +
               "[[solid]]\nkind = 'sphere'\nradius = 3\n" + tail +
               "[[solid]]\nkind = 'cylinder'\nradius = 1\nheight = 5\ntaper = 0.25\n" + tail +
               "[[solid]]\nkind = 'cone'\nradius = 1\nheight = 6\ntaper = 1.5\ncolor = [0.1, 0.2, 0.3]\nambient = "
               "0.2\ndiffuse = 0.3\n"
               "specular = 0.6\nshininess = 9\nreflection = 0.3\ntransmission = 0.7\nrefractive_index = 1.33\nfresnel "
               "= true\n" +
               tail);
    ASSERT_EQ(scene->solid_count, 5);
    const Solid* s = scene->solids;
    const SolidKind kinds[] = {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                               SolidKind::cone};
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(s[i].kind, kinds[i]);
        expect_vector(s[i].position, 1, 2, 3);
    }
    expect_vector(s[0].rotation, radians(10), radians(-20), radians(720));
    EXPECT_EQ(s[0].sides, 3);
    EXPECT_EQ(s[1].sides, 64);
    EXPECT_EQ(s[2].radius, 3);
    EXPECT_EQ(s[3].taper, 0.25);
    EXPECT_EQ(s[4].taper, 1.5);
    EXPECT_EQ(s[4].height, 6);
    const Material& m = s[4].material;
    EXPECT_TRUE(m.color.r == 0.1 && m.color.g == 0.2 && m.color.b == 0.3);
    EXPECT_TRUE(m.ambient == 0.2 && m.diffuse == 0.3 && m.specular == 0.6 && m.shininess == 9);
    EXPECT_TRUE(m.reflection == 0.3 && m.transmission == 0.7 && m.refractive_index == 1.33 && m.fresnel);
}

TEST(SceneFileValues, MirrorsOfEveryOutlineArriveAsWritten) {
    const std::string place = "[[mirror]]\nposition = [1, 2, 3]\nnormal = [0, 2, 0]\nup = [0, 0, 1]\n";
    const auto scene = loaded(
        kHead + place +
        "boundary = { shape = 'rectangle', width = 4, height = 2 }\nlobe = 'phong'\nlobe_exponent = 12\n"
        "shininess = 5\ncolor = [0.1, 0.2, 0.3]\nambient = 0.4\ndiffuse = 0.5\nspecular = 0.6\nreflection = 0.7\n" +
        place + "curvature_radius = -3\npolish = 0.5\n[mirror.boundary]\nshape = 'disc'\nradius = 2.5\n" + place +
        "boundary = { shape = 'ellipse', width = 5, height = 6 }\ncurvature_radius = -inf\n" + place +
        "boundary = { shape = 'polygon', points = [[0, 0], [2, 0], [0, 3]] }\nlobe_exponent = inf\n");
    ASSERT_EQ(scene->mirror_count, 4);
    const Mirror* m = scene->mirrors;
    expect_vector(m[0].position, 1, 2, 3);
    expect_vector(m[0].normal, 0, 2, 0);
    expect_vector(m[0].up, 0, 0, 1);
    EXPECT_EQ(m[0].boundary.shape, BoundaryShape::rectangle);
    EXPECT_TRUE(m[0].boundary.width == 4 && m[0].boundary.height == 2);
    EXPECT_TRUE(m[0].lobe == Lobe::phong && m[0].lobe_exponent == 12 && m[0].shininess == 5);
    EXPECT_TRUE(m[0].color.r == 0.1 && m[0].color.b == 0.3 && m[0].ambient == 0.4 && m[0].diffuse == 0.5);
    EXPECT_TRUE(m[0].specular == 0.6 && m[0].reflection == 0.7);
    EXPECT_EQ(m[1].boundary.shape, BoundaryShape::disc);
    EXPECT_TRUE(m[1].boundary.radius == 2.5 && m[1].curvature_radius == -3);
    EXPECT_DOUBLE_EQ(m[1].lobe_exponent, 7.5);  // (0.5^-4 - 1) / 2
    EXPECT_EQ(m[2].boundary.shape, BoundaryShape::ellipse);
    EXPECT_EQ(m[2].curvature_radius, -kInfinity);
    EXPECT_EQ(m[3].boundary.shape, BoundaryShape::polygon);
    ASSERT_EQ(m[3].boundary.corner_count, 3);
    EXPECT_TRUE(m[3].boundary.corners[1].x == 2 && m[3].boundary.corners[2].y == 3);
    EXPECT_EQ(m[3].lobe_exponent, kInfinity);
}

TEST(SceneFileValues, CapacityIsReachedExactly) {
    std::string text = kHead;
    for (int i = 0; i < kMaxLights; ++i) text += "[[light]]\nposition = [0, 0, 0]\n";
    for (int i = 0; i < kMaxSolids; ++i) text += "[[solid]]\nkind = 'sphere'\nradius = 1\nposition = [0, 0, 0]\n";
    for (int i = 0; i < kMaxMirrors; ++i) {
        text += "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = 'disc', radius = 1 }\n";
    }
    const auto scene = loaded(text);
    EXPECT_EQ(scene->light_count, kMaxLights);
    EXPECT_EQ(scene->solid_count, kMaxSolids);
    EXPECT_EQ(scene->mirror_count, kMaxMirrors);
}

TEST(SceneFileValues, WindowsLineEndsAndAByteOrderMarkChangeNothing) {
    std::string text = "\xef\xbb\xbf";
    for (const char c : kHead) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const auto scene = loaded(text);
    EXPECT_EQ(scene->image.width, 8);
}

}  // namespace
}  // namespace zerkalo
