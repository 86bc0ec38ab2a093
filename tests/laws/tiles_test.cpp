// Tiles: any order and any thread give the same bytes, and none writes outside itself.
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include "core/image/hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <memory>
#include <numeric>
#include <random>
#include <thread>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 33, kHeight = 17;  // whole tiles, and a part of one at each edge

std::vector<int> row_major(const Plan& plan) {
    std::vector<int> order(static_cast<std::size_t>(tile_count(plan)));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

std::uint64_t hash_in_order(const Plan& plan, const std::vector<int>& order, Isa isa) {
    Image image{plan.width, plan.height, std::vector<float>(std::size_t{3} * plan.width * plan.height), {}};
    const TileFunction render_tile = kernel_for(plan, isa);
    for (const int tile : order) render_tile(plan, tile_at(plan, tile), image.view(), image.rays);
    return image.hash();
}

/// Two threads take tiles from one counter.
Image by_two_threads(const Plan& plan, Isa isa) {
    Image image{plan.width, plan.height, std::vector<float>(std::size_t{3} * plan.width * plan.height), {}};
    const TileFunction render_tile = kernel_for(plan, isa);
    std::atomic<int> next{0};
    const auto work = [&](RayCounts& rays) {
        for (int tile = next++; tile < tile_count(plan); tile = next++) {
            render_tile(plan, tile_at(plan, tile), image.view(), rays);
        }
    };
    RayCounts of_second;
    std::thread second(work, std::ref(of_second));
    work(image.rays);
    second.join();
    image.rays.primary += of_second.primary;
    image.rays.shadow += of_second.shadow;
    return image;
}

/// Calls law(name, plan) for every shipped scene as it is and with polished mirrors.
template <class Law>
void for_every_plan(const Law& law) {
    const auto plan = std::make_unique<Plan>();
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(kWidth, kHeight);
        settings.samples = 5;
        prepare_or_throw(scene, settings, *plan);
        law(name, *plan);
        prepare_or_throw(sharpened(scene), settings, *plan);
        law(name + " (polished)", *plan);
    }
}

TEST(Tile, EveryOrderGivesTheSameBytes) {
    std::mt19937 random(7);
    for_every_plan([&](const std::string& name, const Plan& plan) {
        std::vector<int> backwards = row_major(plan), shuffled = backwards;
        std::reverse(backwards.begin(), backwards.end());
        std::shuffle(shuffled.begin(), shuffled.end(), random);
        for (const Isa isa : available_isas()) {
            const std::uint64_t forwards = hash_in_order(plan, row_major(plan), isa);
            EXPECT_EQ(hash_in_order(plan, backwards, isa), forwards) << name << ", " << name_of(isa);
            EXPECT_EQ(hash_in_order(plan, shuffled, isa), forwards) << name << ", " << name_of(isa);
        }
    });
}

TEST(Tile, TwoThreadsGiveTheBytesAndTheCountsOfOne) {
    for_every_plan([](const std::string& name, const Plan& plan) {
        const Image one = render(plan), two = by_two_threads(plan, best_isa());
        EXPECT_EQ(two.hash(), one.hash()) << name;
        EXPECT_EQ(two.rays.primary, one.rays.primary) << name;
        EXPECT_EQ(two.rays.shadow, one.rays.shadow) << name;
    });
}

TEST(Tile, WritesEveryPixelOfItsOwnAndNoOther) {
    // A signalling pattern that no renderer computes: a NaN with a payload.
    constexpr std::uint32_t kGuard = 0x7fbadbad;
    constexpr std::ptrdiff_t kPadding = 5;  // floats after each row
    constexpr std::ptrdiff_t kRow = 3 * kWidth + kPadding;
    for_every_plan([&](const std::string& name, const Plan& plan) {
        for (const Isa isa : available_isas()) {
            const TileFunction render_tile = kernel_for(plan, isa);
            for (const int tile : {0, 4, 12, tile_count(plan) - 1}) {
                std::vector<std::uint32_t> memory(static_cast<std::size_t>(kRow * (kHeight + 2)), kGuard);
                float* first = reinterpret_cast<float*>(memory.data() + kRow);
                RayCounts rays;
                const Rect rect = tile_at(plan, tile);
                render_tile(plan, rect, {first, kWidth, kHeight, kRow * 4}, rays);
                for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(memory.size()); ++i) {
                    const std::ptrdiff_t y = i / kRow - 1 - rect.top, x = i % kRow / 3 - rect.left;
                    const bool own = y >= 0 && y < rect.height && x >= 0 && x < rect.width && i % kRow < 3 * kWidth;
                    ASSERT_EQ(memory[static_cast<std::size_t>(i)] != kGuard, own)
                        << name << ", " << name_of(isa) << ", tile " << tile << ", float " << i;
                }
            }
        }
    });
}

}  // namespace
}  // namespace zerkalo::laws
