// Preparing a frame: bad settings are named, tiles cover the picture once, features are those that the scene uses.
#include "core/render/render.hpp"

#include "core/scene/edit.hpp"
#include "tests/core/support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace zerkalo::test {
namespace {

TEST(Prepare, BadSettingsAreNamed) {
    struct Row {
        const char* field;
        Settings settings;
    };
    const Row rows[] = {
        {"width", {.width = kMaxImageSide + 1}},
        {"height", {.height = kMaxImageSide + 1}},
        {"height", {.width = kMaxImageSide, .height = 4097}},
        {"samples", {.samples = 0}},
        {"samples", {.samples = -1}},
        {"samples", {.samples = kMaxSamples + 1}},
        {"antialias", {.antialias = 0}},
        {"antialias", {.antialias = kMaxAntialias + 1}},
        {"depth_limit", {.depth_limit = -1}},
        {"depth_limit", {.depth_limit = kMaxDepth + 1}},
    };
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    for (const Row& row : rows) {
        const Status status = prepare(*scene, row.settings, *plan);
        ASSERT_FALSE(status.ok()) << row.field;
        EXPECT_STREQ(status.field, row.field);
        EXPECT_EQ(status.part, Part::settings) << row.field;
    }
}

TEST(Prepare, ExtremeSettingsAreLegal) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    for (const Settings& settings :
         {Settings{.width = 1, .height = 1}, Settings{.width = kMaxImageSide, .height = 4096},
          Settings{.samples = 1, .antialias = 1, .depth_limit = 0},
          Settings{.samples = kMaxSamples, .antialias = kMaxAntialias, .depth_limit = kMaxDepth}}) {
        const Status status = prepare(*scene, settings, *plan);
        EXPECT_TRUE(status.ok()) << status.field;
        EXPECT_EQ(plan->samples, settings.samples);
        EXPECT_EQ(plan->antialias, settings.antialias);
        EXPECT_EQ(plan->depth_limit, settings.depth_limit);
    }
}

TEST(Prepare, SizeOfTheSettingsComesBeforeThatOfTheScene) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    scene->image = {31, 17};
    ASSERT_TRUE(prepare(*scene, {}, *plan).ok());
    EXPECT_EQ(plan->width, 31);
    EXPECT_EQ(plan->height, 17);
    ASSERT_TRUE(prepare(*scene, {.width = 8}, *plan).ok());
    EXPECT_EQ(plan->width, 8);
    EXPECT_EQ(plan->height, 17);
}

TEST(Prepare, BadSceneIsRefusedBeforeBadSettings) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    scene->camera.fov = 0;
    const Status status = prepare(*scene, {.samples = 0}, *plan);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.part, Part::camera);
}

TEST(Prepare, SurfacesThatBranchLimitTheDepth) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    scene->solid_count = 1;
    scene->solids[0].position = {0, 0, -5};
    scene->solids[0].material.reflection = 0.3, scene->solids[0].material.transmission = 0.6;
    EXPECT_TRUE(prepare(*scene, {.depth_limit = kMaxBranchDepth}, *plan).ok());
    EXPECT_STREQ(prepare(*scene, {.depth_limit = kMaxBranchDepth + 1}, *plan).field, "depth_limit");
    scene->solids[0].material.reflection = 0, scene->solids[0].material.fresnel = true;
    EXPECT_STREQ(prepare(*scene, {.depth_limit = kMaxBranchDepth + 1}, *plan).field, "depth_limit");
    scene->solids[0].material.reflection = 0.3, scene->solids[0].material.fresnel = false;
    scene->solids[0].material.transmission = 0;
    EXPECT_TRUE(prepare(*scene, {.depth_limit = kMaxDepth}, *plan).ok());
}

TEST(Tiles, CoverThePictureExactlyOnce) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    const Vec2<std::int32_t> sizes[] = {{1, 1},  {1, 65},  {65, 1},  {7, 5},   {8, 8},
                                        {9, 17}, {33, 16}, {64, 48}, {101, 99}};
    for (const auto& size : sizes) {
        ASSERT_TRUE(prepare(*scene, {.width = size.x, .height = size.y}, *plan).ok());
        std::vector<int> covered(static_cast<std::size_t>(size.x * size.y), 0);
        for (int k = 0; k < tile_count(*plan); ++k) {
            const Rect tile = tile_at(*plan, k);
            ASSERT_TRUE(tile.left >= 0 && tile.top >= 0 && tile.width > 0 && tile.height > 0) << k;
            ASSERT_TRUE(tile.left + tile.width <= size.x && tile.top + tile.height <= size.y) << k;
            ASSERT_TRUE(tile.width <= kTileSide && tile.height <= kTileSide) << k;
            for (int y = tile.top; y < tile.top + tile.height; ++y) {
                for (int x = tile.left; x < tile.left + tile.width; ++x)
                    covered[static_cast<std::size_t>(y * size.x + x)]++;
            }
        }
        EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), size.x * size.y) << size.x << " x " << size.y;
    }
}

TEST(Tiles, OfTheLargestPictureAreCountedRight) {
    const auto scene = std::make_unique<Scene>();
    const auto plan = std::make_unique<Plan>();
    ASSERT_TRUE(prepare(*scene, {.width = kMaxImageSide, .height = 4096}, *plan).ok());
    EXPECT_EQ(tile_count(*plan), 8192 * 512);
    const Rect last = tile_at(*plan, tile_count(*plan) - 1);
    EXPECT_EQ(last.left + last.width, kMaxImageSide);
    EXPECT_EQ(last.top + last.height, 4096);
}

std::set<std::string> features_of(const Scene& scene, const Settings& settings = {}) {
    const auto plan = std::make_unique<Plan>();
    const Status status = prepare(scene, settings, *plan);
    EXPECT_TRUE(status.ok()) << status.field << " " << status.reason;
    const char* names[32];
    const int count = feature_names(*plan, names, 32);
    std::set<std::string> features(names, names + count);
    EXPECT_EQ(static_cast<int>(features.size()), count) << "a name occurs twice";
    return features;
}

using Names = std::set<std::string>;

/// A ball of radius 1 before the camera, nothing else.
std::unique_ptr<Scene> one_ball() {
    auto scene = std::make_unique<Scene>();
    scene->solid_count = 1;
    scene->solids[0].position = {0, 0, -5};
    return scene;
}

TEST(Features, NameWhatEachSolidNeeds) {
    const auto nothing = std::make_unique<Scene>();
    EXPECT_EQ(features_of(*nothing), Names{});
    const auto scene = one_ball();
    EXPECT_EQ(features_of(*scene), Names{"sphere"});
    for (const SolidKind kind : {SolidKind::pyramid, SolidKind::prism}) {
        scene->solids[0].kind = kind;
        EXPECT_EQ(features_of(*scene), Names{"half_spaces"});
    }
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::cone}) {
        scene->solids[0].kind = kind;
        EXPECT_EQ(features_of(*scene), Names{"tube"});
    }
    Solid cube = scene->solids[0];
    cube.kind = SolidKind::prism;
    const auto triangles = triangles_of(cube);
    std::copy(triangles.begin(), triangles.end(), scene->triangles);
    scene->triangle_count = static_cast<std::int32_t>(triangles.size());
    scene->solids[0] = meshed(cube, triangles);
    EXPECT_EQ(features_of(*scene), Names{"mesh"});
}

TEST(Features, NameWhatEachMirrorNeeds) {
    const auto scene = std::make_unique<Scene>();
    Mirror& mirror = scene->mirrors[0];
    scene->mirror_count = 1;
    mirror.position = {0, 0, -5};
    EXPECT_EQ(features_of(*scene), Names{"mirror"});
    EXPECT_EQ(features_of(*scene, {.depth_limit = 0}), Names{}) << "no ray may leave it";
    mirror.lobe_exponent = 100;
    EXPECT_EQ(features_of(*scene), (Names{"mirror", "glossy", "max_phong"}));
    mirror.lobe = Lobe::phong;
    EXPECT_EQ(features_of(*scene), (Names{"mirror", "glossy"}));
    mirror.lobe = Lobe::ggx;
    EXPECT_EQ(features_of(*scene), (Names{"mirror", "glossy", "ggx"}));
    mirror.reflection = 0;
    EXPECT_EQ(features_of(*scene), Names{});
    mirror = Mirror{};
    mirror.position = {0, 0, -5}, mirror.curvature_radius = 10;
    EXPECT_EQ(features_of(*scene), (Names{"mirror", "curved_mirror", "chain"}));
}

TEST(Features, NameAFaceInAMirrorsPlaneThatTheCameraCanSee) {
    const auto scene = std::make_unique<Scene>();
    scene->mirror_count = scene->solid_count = 1;
    scene->mirrors[0].position = {0, -1, -5};
    scene->mirrors[0].normal = {0, 1, 0};
    Solid& solid = scene->solids[0];
    for (const SolidKind kind : {SolidKind::prism, SolidKind::cylinder}) {
        const char* const shape = kind == SolidKind::prism ? "half_spaces" : "tube";
        solid.kind = kind;
        solid.position = {0, -2, -5};
        EXPECT_EQ(features_of(*scene), (Names{shape, "mirror", "flush"})) << "its lid is seen";
        solid.position.y = -2.001;
        EXPECT_EQ(features_of(*scene), (Names{shape, "mirror"})) << "its lid is below the mirror";
        solid.position.y = -1;
        EXPECT_EQ(features_of(*scene), (Names{shape, "mirror"})) << "it stands on the mirror";
        scene->camera.position = {0, -4, 0};
        EXPECT_EQ(features_of(*scene), (Names{shape, "mirror", "flush"})) << "its base is seen from behind";
        scene->camera.position = {0, 0, 0};
    }
}

TEST(Features, NameWhatLightAndRaysNeed) {
    const auto scene = one_ball();
    scene->light_count = 1;
    scene->lights[0].position = {0, 4, 0};
    EXPECT_EQ(features_of(*scene), Names{"sphere"}) << "a convex solid casts no shadow on itself";
    scene->solid_count = 2;
    scene->solids[1].position = {3, 0, -5};
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "shadow"}));
    scene->lights[0].falloff = Falloff::inverse_square;
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "shadow", "inverse_square"}));
    scene->light_count = 0;
    scene->solids[1].material.transmission = 0.5;
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "chain"}));
    scene->solids[1].material.fresnel = true;
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "chain", "branch", "fresnel"}));
    scene->solids[1].material.fresnel = false;
    scene->solids[1].material.reflection = 0.5;
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "chain", "branch"}));
    EXPECT_EQ(features_of(*one_ball(), {.antialias = 4}), (Names{"sphere", "antialias"}));
}

TEST(Features, NameWhereTheCameraStands) {
    const auto scene = one_ball();
    scene->camera.position = {0, 0, -5};
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "inside"}));
    scene->camera.position = {0, 0, 1e6};
    EXPECT_EQ(features_of(*scene), (Names{"sphere", "far"}));
}

TEST(Prepare, RefusesCoverageOfALobeThatHasNone) {
    const auto scene = one_ball();
    const auto plan = std::make_unique<Plan>();
    const auto fixed_plan = std::make_unique<FixedPlan>();
    const Settings covered{.estimator = Estimator::fibonacci_coverage};
    scene->mirror_count = 1;
    scene->mirrors[0].position = {0, 0, -5};
    scene->mirrors[0].lobe = Lobe::ggx;
    EXPECT_TRUE(prepare(*scene, covered, *plan).ok()) << "a sharp mirror has no lobe";
    scene->mirrors[0].lobe_exponent = 100;
    EXPECT_STREQ(prepare(*scene, covered, *plan).field, "estimator");
    EXPECT_STREQ(prepare(*scene, covered, *fixed_plan).field, "estimator");
    EXPECT_TRUE(prepare(*scene, Settings{}, *plan).ok());
    scene->mirrors[0].lobe = Lobe::phong;
    EXPECT_TRUE(prepare(*scene, covered, *plan).ok());
}

TEST(Features, NoMoreNamesThanThereIsRoomFor) {
    const auto scene = one_ball();
    const auto plan = std::make_unique<Plan>();
    ASSERT_TRUE(prepare(*scene, {.antialias = 2}, *plan).ok());
    const char* names[2] = {nullptr, nullptr};
    EXPECT_EQ(feature_names(*plan, names, 1), 1);
    EXPECT_STREQ(names[0], "sphere");
    EXPECT_EQ(names[1], nullptr);
    EXPECT_EQ(feature_names(*plan, names, 2), 2);
}

}  // namespace
}  // namespace zerkalo::test
