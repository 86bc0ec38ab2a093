// The whole fixed-point renderer over lanes: the picture of every kind of solid, mirror and light has the bytes that one
// lane gives. Compiled without optimisation and without forced inlining: loops over arrays of lanes take minutes
// otherwise.
#include "core/image/hash.hpp"
#include "core/render/fixed_bounce.hpp"
#include "tests/proofs/pictures/scenes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace zerkalo::test {
namespace {

struct Hashed {
    std::uint64_t hash = 0;
    RayCounts rays;
};

Hashed rendered(const FixedPlan& plan, FixedTileFunction render_tile) {
    std::vector<float> pixels(std::size_t{3} * plan.width * plan.height);
    const LinearImage image{pixels.data(), plan.width, plan.height, std::ptrdiff_t{12} * plan.width};
    Hashed result;
    for (int i = 0; i < tile_count(plan); ++i) render_tile(plan, tile_at(plan, i), image, result.rays);
    result.hash = hash_of(image);
    return result;
}

/// A kernel of W lanes in arrays.
template <int W>
void of_width(const FixedPlan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    render_tile_fixed<FixedNumbers<W>>(plan, tile, image, counts);
}

void by_general_kernel(const FixedPlan& plan, const Tile& tile, const LinearImage& image, RayCounts& counts) {
    render_tile_general<FixedNumbers<1>>(plan, tile, image, counts);
}

std::uint64_t all_rays(const RayCounts& rays) {
    return rays.primary + rays.lobe + rays.reflected + rays.refracted + rays.shadow;
}

TEST(FixedWidths, GiveTheSameBytesForEveryKindOfSurface) {
    const auto plan = std::make_unique<FixedPlan>();
    Settings settings;
    settings.width = 29, settings.height = 21;  // no width divides them
    settings.samples = 3;
    settings.antialias = 2;
    for (const Scene& scene : pictures::kScenes) {
        ASSERT_TRUE(prepare(scene, settings, *plan).ok());
        const Hashed one = rendered(*plan, kernel_for(*plan, Isa::scalar));
        const Hashed four = rendered(*plan, &of_width<4>);
        EXPECT_EQ(four.hash, one.hash);
        EXPECT_EQ(all_rays(four.rays), all_rays(one.rays));
        EXPECT_EQ(rendered(*plan, &of_width<8>).hash, one.hash);
        for (int i = 0; i < kIsaCount; ++i) {
            const Isa isa = static_cast<Isa>(i);
            if (!available(isa)) continue;
            const Hashed vectors = rendered(*plan, kernel_for(*plan, isa));
            EXPECT_EQ(vectors.hash, one.hash) << name_of(isa);
            EXPECT_EQ(vectors.rays.lobe, one.rays.lobe) << name_of(isa);
            EXPECT_EQ(vectors.rays.shadow, one.rays.shadow) << name_of(isa);
        }
    }
}

/// All opaque solids, one of them through the mirror; two lights.
Scene five_solids(Lobe lobe, double exponent) {
    using pictures::solid_of;
    Scene scene = pictures::kScenes[0];
    scene.mirrors[0].lobe = lobe;
    scene.mirrors[0].lobe_exponent = exponent;
    scene.light_count = 2;
    scene.lights[1] = {{3, 5, 3}, {1, 0.6, 0.3}, 20, Falloff::inverse_square};
    scene.solid_count = 5;
    scene.solids[1] = solid_of(SolidKind::pyramid, {-1.3, 0, -0.5}, 1);
    scene.solids[2] = solid_of(SolidKind::prism, {1.2, 0.3, -1.5}, 1);
    scene.solids[3] = solid_of(SolidKind::cylinder, {-0.6, 0, 0.5}, 1);
    scene.solids[4] = solid_of(SolidKind::cone, {0.8, 0.2, 0.4}, 0);
    scene.solids[4].rotation = {0.7, 0.35, -0.4};
    return scene;
}

/// Sums are exact in fixed point, so the kernel for one bounce may trace the rays of a tile class by class, leave out
/// those that meet nothing, and still gives every byte.
TEST(FixedBounce, GivesTheBytesOfTheGeneralKernel) {
    const auto plan = std::make_unique<FixedPlan>();
    Settings plain;
    plain.width = 29, plain.height = 21, plain.samples = 5;
    Settings many = plain, smooth = plain, exact = plain, keyed = plain;
    many.samples = 40;  // more than a chunk
    smooth.antialias = 3;
    exact.exact_plan = true;
    keyed.estimator = Estimator::sobol, keyed.samples = 8;
    const Scene scenes[] = {five_solids(Lobe::phong, 200), five_solids(Lobe::phong, 3), five_solids(Lobe::phong, 1e5),
                            five_solids(Lobe::max_phong, 50), five_solids(Lobe::phong, kInfinity)};
    int number = 0;
    for (const Scene& scene : scenes) {
        for (const Settings& settings : {plain, many, smooth, exact, keyed}) {
            ++number;
            ASSERT_TRUE(prepare(scene, settings, *plan).ok());
            ASSERT_EQ(plan->features & kNeedsGeneral, 0u);
            const Hashed general = rendered(*plan, &by_general_kernel);
            EXPECT_EQ(rendered(*plan, &of_width<4>).hash, general.hash) << "case " << number;
            for (int i = 0; i < kIsaCount; ++i) {
                const Isa isa = static_cast<Isa>(i);
                if (!available(isa)) continue;
                const Hashed one_bounce = rendered(*plan, kernel_for(*plan, isa));
                EXPECT_EQ(one_bounce.hash, general.hash) << name_of(isa) << ", case " << number;
                EXPECT_EQ(all_rays(one_bounce.rays), all_rays(general.rays)) << name_of(isa) << ", case " << number;
            }
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
