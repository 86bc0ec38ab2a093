// The scenes that come with the program.
#include "tests/scene_file/bad_scene.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>
#include <vector>

namespace zerkalo {
namespace {

const std::filesystem::path kScenes = ZERKALO_SOURCE_DIR "/firmware/scenes";

std::vector<std::filesystem::path> scene_paths() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path());
    }
    return paths;
}

std::unique_ptr<Scene> shipped(const std::string& name) {
    LoadResult result = load_scene(kScenes / (name + ".toml"));
    EXPECT_TRUE(result.ok()) << to_text(result);
    return result.ok() ? std::move(result.scene) : std::make_unique<Scene>();
}

TEST(ShippedScenes, EverySceneLoadsHasATitleAndIsFourToThree) {
    EXPECT_GE(scene_paths().size(), 13u);
    std::set<std::string> titles;
    for (const auto& path : scene_paths()) {
        const LoadResult result = load_scene(path);
        ASSERT_TRUE(result.ok()) << to_text(result);
        EXPECT_TRUE(titles.insert(result.title).second && !result.title.empty()) << path;
        EXPECT_EQ(result.scene->image.width * 3, result.scene->image.height * 4) << path;
        EXPECT_GE(result.scene->light_count, 1) << path;
        EXPECT_GE(result.scene->solid_count, 1) << path;
        EXPECT_GE(result.scene->mirror_count, 1) << path;
    }
}

TEST(ShippedScenes, ReadmeHasOneLineForEveryScene) {
    std::ifstream file(kScenes / "README.md");
    std::stringstream text;
    text << file.rdbuf();
    for (const auto& path : scene_paths()) {
        EXPECT_NE(text.str().find("`" + path.filename().string() + "`"), std::string::npos) << path;
    }
}

TEST(ShippedScenes, EveryKindOfSolidAndMirrorIsShown) {
    std::set<SolidKind> kinds;
    bool concave = false, convex = false, transparent = false, fresnel = false, several_mirrors = false;
    std::set<BoundaryShape> shapes;
    for (const auto& path : scene_paths()) {
        const auto scene = shipped(path.stem().string());
        for (int i = 0; i < scene->solid_count; ++i) {
            kinds.insert(scene->solids[i].kind);
            transparent = transparent || scene->solids[i].material.transmission > 0;
            fresnel = fresnel || scene->solids[i].material.fresnel;
        }
        for (int i = 0; i < scene->mirror_count; ++i) {
            shapes.insert(scene->mirrors[i].boundary.shape);
            concave =
                concave || (scene->mirrors[i].curvature_radius > 0 && scene->mirrors[i].curvature_radius < kInfinity);
            convex = convex || scene->mirrors[i].curvature_radius < 0;
        }
        several_mirrors = several_mirrors || scene->mirror_count > 1;
    }
    EXPECT_EQ(kinds.size(), 6u);
    EXPECT_EQ(shapes.size(), 4u);
    EXPECT_TRUE(concave && convex && transparent && fresnel && several_mirrors);
}

/// Base corner k of a prism or pyramid in the world: local angle 2 pi k / n, turned about y by matrix 2.13.
Vec3<double> base_corner(const Solid& solid, int k) {
    const double a = 2 * std::numbers::pi * k / solid.sides, t = solid.rotation.y;
    const double x = solid.radius * std::cos(a), z = solid.radius * std::sin(a);
    return {solid.position.x + std::cos(t) * x + std::sin(t) * z, solid.position.y,
            solid.position.z - std::sin(t) * x + std::cos(t) * z};
}

/// Every corner of the benchmark lies at one of its angles (degrees, x = cx + r cos a, z = cz + r sin a), all
/// different.
void expect_corners_at(const Solid& solid, const std::vector<double>& degrees) {
    std::set<std::size_t> taken;
    for (int k = 0; k < solid.sides; ++k) {
        const Vec3<double> corner = base_corner(solid, k);
        for (std::size_t i = 0; i < degrees.size(); ++i) {
            const double a = degrees[i] * std::numbers::pi / 180;
            const double dx = corner.x - (solid.position.x + solid.radius * std::cos(a));
            const double dz = corner.z - (solid.position.z + solid.radius * std::sin(a));
            if (std::hypot(dx, dz) < 1e-12) taken.insert(i);
        }
    }
    EXPECT_EQ(taken.size(), degrees.size());
}

TEST(GoldMirrorFive, CornersLieAtTheBenchmarksAngles) {
    const auto scene = shipped("gold-mirror-5");
    ASSERT_EQ(scene->solid_count, 5);
    expect_corners_at(scene->solids[0], {70, 160, 250, 340});
    expect_corners_at(scene->solids[1], {10, 70, 130, 190, 250, 310});
    EXPECT_NEAR(scene->solids[0].radius * std::sqrt(2), 0.9, 1e-6) << "the side of the pyramid's base";
}

TEST(GoldMirrorFive, SolidsAreTheBenchmarks) {
    const auto scene = shipped("gold-mirror-5");
    const struct {
        SolidKind kind;
        int sides;
        double x, y, z, radius, height, r, g, b;
    } expected[] = {
        {SolidKind::pyramid, 4, -1.35, 0, -0.55, 0.636396, 1.1, 0.90, 0.10, 0.10},
        {SolidKind::prism, 6, -0.35, 0, 0.35, 0.42, 1.0, 0.10, 0.80, 0.15},
        {SolidKind::sphere, 0, 0.55, 0.5, -0.45, 0.5, 0, 0.12, 0.25, 0.95},
        {SolidKind::cylinder, 0, 1.45, 0, -0.7, 0.32, 1.2, 0.85, 0.10, 0.80},
        {SolidKind::cone, 0, 1.3, 0, 0.55, 0.45, 1.2, 0.95, 0.55, 0.05},
    };
    ASSERT_EQ(scene->solid_count, 5);
    for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE(i);
        const Solid& s = scene->solids[i];
        const auto& e = expected[i];
        EXPECT_EQ(s.kind, e.kind);
        EXPECT_TRUE(s.position.x == e.x && s.position.y == e.y && s.position.z == e.z);
        EXPECT_EQ(s.radius, e.radius);
        EXPECT_TRUE(e.sides == 0 || s.sides == e.sides);
        EXPECT_TRUE(e.height == 0 || s.height == e.height);
        const Material& m = s.material;
        EXPECT_TRUE(m.color.r == e.r && m.color.g == e.g && m.color.b == e.b);
        EXPECT_TRUE(m.ambient == 0.1 && m.diffuse == 0.7 && m.specular == 0.4 && m.shininess == 50);
        EXPECT_TRUE(m.reflection == 0 && m.transmission == 0);
    }
    EXPECT_EQ(scene->solids[3].taper, 1);
    EXPECT_EQ(scene->solids[4].taper, 0);
}

TEST(GoldMirrorFive, CameraLightAndMirrorAreTheBenchmarks) {
    const auto scene = shipped("gold-mirror-5");
    const Camera& camera = scene->camera;
    EXPECT_TRUE(scene->image.width == 640 && scene->image.height == 480);
    EXPECT_TRUE(camera.position.x == 1.2 && camera.position.y == 2.3 && camera.position.z == 5.2);
    EXPECT_NEAR(camera.view.x, -1.2, 1e-15);
    EXPECT_NEAR(camera.view.y, -1.5, 1e-15);
    EXPECT_NEAR(camera.view.z, -5.8, 1e-15);
    EXPECT_EQ(camera.fov_axis, FovAxis::horizontal);
    EXPECT_NEAR(camera.fov, 42 * std::numbers::pi / 180, 1e-15);
    EXPECT_TRUE(scene->background.r == 0.02 && scene->background.g == 0.03 && scene->background.b == 0.12);
    EXPECT_TRUE(scene->ambient.r == 1 && scene->ambient.g == 1 && scene->ambient.b == 1);
    ASSERT_EQ(scene->light_count, 1);
    const Light& light = scene->lights[0];
    EXPECT_TRUE(light.position.x == -3 && light.position.y == 4 && light.position.z == 0.8);
    EXPECT_TRUE(light.color.r == 1 && light.color.g == 1 && light.color.b == 1 && light.intensity == 1);
    EXPECT_EQ(light.falloff, Falloff::none);
    ASSERT_EQ(scene->mirror_count, 1);
    const Mirror& mirror = scene->mirrors[0];
    EXPECT_TRUE(mirror.position.x == 0 && mirror.position.y == 1.25 && mirror.position.z == -1.6);
    EXPECT_TRUE(mirror.normal.x == 0 && mirror.normal.y == 0 && mirror.normal.z == 1);
    EXPECT_TRUE(mirror.boundary.shape == BoundaryShape::rectangle && mirror.boundary.width == 4 &&
                mirror.boundary.height == 2.5);
    EXPECT_TRUE(mirror.lobe == Lobe::phong && mirror.lobe_exponent == 200 && mirror.shininess == 200);
    EXPECT_TRUE(mirror.color.r == 0.95 && mirror.color.g == 0.80 && mirror.color.b == 0.45);
    EXPECT_TRUE(mirror.ambient == 0.05 && mirror.diffuse == 0.1 && mirror.specular == 0.3 && mirror.reflection == 0.8);
    EXPECT_EQ(mirror.curvature_radius, kInfinity);
}

}  // namespace
}  // namespace zerkalo
