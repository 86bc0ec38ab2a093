// Passes over a prepared frame: the plan after begin_pass() is the plan that prepare() makes, and a survey changes no byte.
#include "core/render/render.hpp"
#include "core/scene/edit.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

namespace zerkalo::test {
namespace {

Scene mirrors_and_ball() {
    Scene scene;
    scene.camera.position = {0, 1, 4}, scene.camera.view = {0, 0, -1}, scene.camera.fov = 0.8;
    scene.image = {40, 24};
    scene.lights[scene.light_count++].position = {2, 3, 3};
    Solid& ball = scene.solids[scene.solid_count++];
    ball.kind = SolidKind::sphere, ball.position = {0.2, 1, 0}, ball.radius = 0.5;
    for (const double exponent : {40.0, 3000.0}) {
        Mirror& mirror = scene.mirrors[scene.mirror_count++];
        mirror.position = {exponent > 100 ? 1.5 : -1.5, 1, -1}, mirror.normal = {0, 0, 1};
        mirror.boundary.width = mirror.boundary.height = 2;
        mirror.lobe_exponent = exponent;
    }
    return scene;
}

constexpr Pass kPasses[] = {{1, 0}, {4, 1}, {16, 0}, {3, 2, false, 5}, {100, 7}, {5000, 3, false, 1}};

// Every float of a picture, by the general and by the one-bounce kernel, and in fixed point.
template <class P>
std::vector<float> picture_of(const P& plan, RayCounts& counts) {
    std::vector<float> pixels(static_cast<std::size_t>(3 * plan.width * plan.height), -1.0f);
    const LinearImage image{pixels.data(), plan.width, plan.height, std::ptrdiff_t{12} * plan.width};
    const auto kernel = kernel_for(plan, Isa::scalar);
    for (int i = 0; i < tile_count(plan); ++i) kernel(plan, tile_at(plan, i), image, counts);
    return pixels;
}

template <class P>
void expect_as_prepared(const Scene& scene, const Pass& first, const Pass& then,
                        Estimator estimator = Estimator::fibonacci) {
    const auto prepared = std::make_unique<P>(), given = std::make_unique<P>();
    const auto camera_rays = [](const Pass& pass) { return pass.antialias > 0 ? pass.antialias : 1; };
    Settings settings{.samples = then.samples, .rotation = then.rotation, .estimator = estimator};
    // A pass without a number of its own has that of the pass before.
    settings.antialias = then.antialias > 0 ? then.antialias : camera_rays(first);
    ASSERT_TRUE(prepare(scene, settings, *prepared).ok());
    settings.samples = first.samples, settings.rotation = first.rotation, settings.antialias = camera_rays(first);
    ASSERT_TRUE(prepare(scene, settings, *given).ok());
    ASSERT_TRUE(begin_pass(*given, then).ok());
    RayCounts one, other;
    EXPECT_EQ(picture_of(*given, one), picture_of(*prepared, other))
        << name_of(estimator) << ": " << first.samples << " samples, then " << then.samples << " of rotation " << then.rotation;
    EXPECT_EQ(one.lobe, other.lobe);
    EXPECT_EQ(given->samples, then.samples);
}

TEST(Pass, TheSamePictureAsFromAPlanPreparedForIt) {
    Scene scene = mirrors_and_ball();
    for (const int mirrors : {2, 1}) {
        scene.mirror_count = mirrors;
        for (std::size_t i = 1; i < std::size(kPasses); ++i) {
            expect_as_prepared<Plan>(scene, kPasses[i - 1], kPasses[i]);
            expect_as_prepared<Plan>(scene, kPasses[i], kPasses[i - 1]);
        }
        for (int k = 0; k < kEstimatorCount; ++k) {
            expect_as_prepared<Plan>(scene, {100, 7}, {16, 3}, static_cast<Estimator>(k));
        }
    }
    expect_as_prepared<FixedPlan>(scene, {16, 0}, {4, 5});
    expect_as_prepared<DoublePlan>(scene, {16, 0}, {4, 5});
}

TEST(Pass, RefusedOnesLeaveThePlanAsItWas) {
    const auto plan = std::make_unique<Plan>(), before = std::make_unique<Plan>();
    ASSERT_TRUE(prepare(mirrors_and_ball(), {}, *plan).ok());
    std::memcpy(static_cast<void*>(before.get()), plan.get(), sizeof(Plan));
    for (const Pass& pass : {Pass{0, 0}, Pass{-1, 0}, Pass{kMaxSamples + 1, 0}}) {
        EXPECT_STREQ(begin_pass(*plan, pass).field, "samples");
    }
    EXPECT_STREQ(begin_pass(*plan, {16, -1}).field, "rotation");
    EXPECT_EQ(std::memcmp(before.get(), plan.get(), sizeof(Plan)), 0);
}

TEST(Pass, ASurveyCountsMoreRaysAndChangesNoByte) {
    Scene scene = mirrors_and_ball();
    scene.mirror_count = 1;
    const auto plan = std::make_unique<Plan>();
    for (const std::int32_t samples : {1, 4, 16, 64}) {
        ASSERT_TRUE(prepare(scene, {.samples = samples}, *plan).ok());
        RayCounts plain, survey;
        const std::vector<float> picture = picture_of(*plan, plain);
        ASSERT_TRUE(begin_pass(*plan, {samples, 0, true}).ok());
        EXPECT_EQ(picture_of(*plan, survey), picture) << samples;
        EXPECT_GT(survey.lobe, plain.lobe) << samples;
    }
}

}  // namespace
}  // namespace zerkalo::test
