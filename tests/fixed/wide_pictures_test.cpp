// The whole fixed-point renderer over lanes: the picture of every kind of solid, mirror and light has the bytes that one
// lane gives. Compiled without optimisation: loops over arrays of lanes take minutes otherwise.
#include "core/image/hash.hpp"
#include "core/render/general.hpp"
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
void of_width(const FixedPlan& plan, const Rect& tile, const LinearImage& image, RayCounts& counts) {
    render_tile_general<FixedNumbers<W>>(plan, tile, image, counts);
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
        EXPECT_EQ(four.rays.primary + four.rays.lobe + four.rays.reflected + four.rays.refracted + four.rays.shadow,
                  one.rays.primary + one.rays.lobe + one.rays.reflected + one.rays.refracted + one.rays.shadow);
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

}  // namespace
}  // namespace zerkalo::test
