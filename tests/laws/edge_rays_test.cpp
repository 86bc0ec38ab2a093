// Camera rays where they are needed: some pixels of a tile alone, and what they do for the picture.
#include "core/render/edges.hpp"
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 52, kHeight = 36;  // whole tiles, and a part of one at each edge

/// Some pixels of each tile: none, all, a few, most.
std::uint64_t chosen_of(int tile) {
    const std::uint64_t bits = 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(tile + 1);
    switch (tile % 5) {
        case 0: return 0;
        case 1: return kWholeTile;
        case 2: return bits & bits >> 7 & bits << 9;
        case 3: return bits;
        default: return bits | bits >> 7 | bits << 9;
    }
}

template <class AnyPlan>
void expect_chosen_pixels_alone(const Scene& scene, const std::string& name, Isa isa) {
    constexpr float kUntouched = -3;
    Settings settings = of_size(kWidth, kHeight);
    settings.samples = 3, settings.antialias = 4;
    const auto plan = std::make_unique<AnyPlan>();
    prepare_or_throw(scene, settings, *plan);
    Image whole{kWidth, kHeight, std::vector<float>(std::size_t{3} * kWidth * kHeight, kUntouched), {}}, some = whole;
    const auto kernel = kernel_for(*plan, isa);
    std::uint64_t rays = 0;
    for (int i = 0; i < tile_count(*plan); ++i) {
        const Rect rect = tile_at(*plan, i);
        kernel(*plan, rect, whole.view(), whole.rays);
        const Tile tile(rect, chosen_of(i));
        kernel(*plan, tile, some.view(), some.rays);
        for (int pixel = 0; pixel < kTilePixels; ++pixel) {
            const int x = pixel % kTileSide, y = pixel / kTileSide;
            if (x >= rect.width || y >= rect.height) continue;
            const bool chosen = (chosen_of(i) >> pixel & 1) != 0;
            rays += chosen ? 4 : 0;
            const auto first = static_cast<std::size_t>(3 * ((rect.top + y) * kWidth + rect.left + x));
            for (std::size_t c = first; c < first + 3; ++c) {
                ASSERT_EQ(some.rgb[c], chosen ? whole.rgb[c] : kUntouched)
                    << name << ", " << name_of(isa) << ", pixel " << rect.left + x << ", " << rect.top + y;
            }
        }
    }
    EXPECT_EQ(some.rays.primary, rays) << name;
    EXPECT_EQ(whole.rays.primary, std::uint64_t{4} * kWidth * kHeight) << name;
}

TEST(ChosenPixels, HaveTheBytesOfTheWholeTileAndNoOtherIsTouched) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const Isa isa : available_isas()) expect_chosen_pixels_alone<Plan>(scene, name, isa);
        for (const Isa isa : available_isas()) expect_chosen_pixels_alone<FixedPlan>(scene, name, isa);
        expect_chosen_pixels_alone<DoublePlan>(scene, name, Isa::scalar);
    }
}

/// Every pixel's centre first, then those at edges, as edges.hpp shows it.
Image with_edge_rays(const Scene& scene, std::int32_t samples) {
    Settings settings = of_size(kWidth, kHeight);
    settings.samples = samples;
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(scene, settings, *plan);
    Image image = render(*plan);
    std::vector<std::uint64_t> edges;
    for (int i = 0; i < tile_count(*plan); ++i) edges.push_back(edge_pixels(image.view(), tile_at(*plan, i)));
    EXPECT_TRUE(begin_pass(*plan, edge_pass(samples, 0, kEdgeAntialias)).ok());
    const TileFunction kernel = kernel_for(*plan, best_isa());
    for (int i = 0; i < tile_count(*plan); ++i) {
        kernel(*plan, Tile(tile_at(*plan, i), edges[static_cast<std::size_t>(i)]), image.view(), image.rays);
    }
    return image;
}

Image with_camera_rays(const Scene& scene, std::int32_t antialias, std::int32_t samples, std::int32_t rotation = 0) {
    Settings settings = of_size(kWidth, kHeight);
    settings.antialias = antialias, settings.samples = samples, settings.rotation = rotation;
    return render(scene, settings);
}

double error_of(const Image& image, const Image& truth) {
    double sum = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) sum += std::pow(double(image.rgb[i]) - double(truth.rgb[i]), 2);
    return std::sqrt(sum / double(image.rgb.size()));
}

TEST(EdgeRays, GiveHardlyLessThanAsManyRaysForAllPixels) {
    for (const auto& [name, scene] : shipped_scenes()) {
        const Image truth = with_camera_rays(scene, 1024, 1);
        const Image centres = with_camera_rays(scene, 1, 16), all = with_camera_rays(scene, kEdgeAntialias, 1);
        const Image edges = with_edge_rays(scene, 16);
        const double gained = error_of(centres, truth) - error_of(edges, truth);
        const double possible = error_of(centres, truth) - error_of(all, truth);
        RecordProperty(name, std::to_string(gained / possible));
        EXPECT_GT(gained, 0.9 * possible) << name << ": of " << error_of(centres, truth) << " " << error_of(edges, truth)
                                          << " is left, " << error_of(all, truth) << " with camera rays everywhere";
        EXPECT_LT(edges.rays.primary, all.rays.primary / 2) << name;
    }
}

/// Of the lobe rays alone: beside the same camera rays with very many of them. The mean over some placements, or the
/// default one.
double error_of_lobes(const Scene& scene, std::int32_t antialias, int placements) {
    const Image truth = with_camera_rays(scene, antialias, 16384 / antialias);
    double squares = 0;
    for (int k = 0; k < placements; ++k) {
        squares += std::pow(error_of(with_camera_rays(scene, antialias, 1, k), truth), 2);
    }
    return std::sqrt(squares / placements);
}

// 16 single lobe rays that are placed independently have a quarter of the error of one. Behind a second mirror rays go on
// at random.
TEST(EdgeRays, LobeRaysOfAPixelAreOneLatticeHoweverManyCameraRaysShareThem) {
    double product = 1;
    int scenes = 0;
    for (const auto& [name, scene] : shipped_scenes()) {
        if (scene.mirror_count > 1) continue;
        const double independent = error_of_lobes(scene, 1, 8) / 4, together = error_of_lobes(scene, 16, 1);
        RecordProperty(name, std::to_string(together / independent));
        EXPECT_LT(together, 0.97 * independent) << name;
        product *= together / independent, ++scenes;
    }
    EXPECT_LT(std::pow(product, 1.0 / scenes), 0.85);
}

}  // namespace
}  // namespace zerkalo::laws
