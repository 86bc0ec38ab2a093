// Which pixels need more camera rays: against the definition, pixel by pixel with square roots.
#include "core/render/edges.hpp"
#include "core/render/render.hpp"
#include "tests/core/support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace zerkalo::test {
namespace {

struct Picture {
    int width, height;
    std::vector<float> pixels;

    Picture(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(3 * w * h)) {}
    float& at(int x, int y, int channel) { return pixels[static_cast<std::size_t>(3 * (y * width + x) + channel)]; }
    LinearImage view() { return {pixels.data(), width, height, std::ptrdiff_t{12} * width}; }
};

double shown(float value) { return std::sqrt(std::clamp(double(value), 0.0, 1.0)); }

bool apart(Picture& picture, int x, int y, int other_x, int other_y) {
    if (other_x < 0 || other_y < 0 || other_x >= picture.width || other_y >= picture.height) return false;
    for (int channel = 0; channel < 3; ++channel) {
        const double difference =
            shown(picture.at(x, y, channel)) - shown(picture.at(other_x, other_y, channel));
        if (std::abs(difference) > 1.0 / 16) return true;
    }
    return false;
}

bool is_edge(Picture& picture, int x, int y) {
    return apart(picture, x, y, x - 1, y) || apart(picture, x, y, x + 1, y) || apart(picture, x, y, x, y - 1) ||
           apart(picture, x, y, x, y + 1);
}

/// Tile by tile.
void expect_as_defined(Picture& picture, const char* what) {
    PlanHead head{};
    head.width = picture.width, head.height = picture.height;
    for (int i = 0; i < tile_count(head); ++i) {
        const Rect tile = tile_at(head, i);
        const std::uint64_t edges = edge_pixels(picture.view(), tile);
        for (int pixel = 0; pixel < kTilePixels; ++pixel) {
            const int x = pixel % kTileSide, y = pixel / kTileSide;
            const bool inside = x < tile.width && y < tile.height;
            ASSERT_EQ(edges >> pixel & 1, inside && is_edge(picture, tile.left + x, tile.top + y))
                << what << ": " << picture.width << "x" << picture.height << ", pixel " << tile.left + x << ", "
                << tile.top + y;
        }
    }
}

constexpr struct { int width, height; } kSizes[] = {{1, 1}, {1, 9}, {8, 8}, {9, 17}, {16, 8}, {33, 21}};

TEST(Edges, AreThePixelsThatDifferInTheRootOfTheirLight) {
    Random random(411);
    for (const auto& [width, height] : kSizes) {
        for (const double spread : {0.02, 0.2, 3.0}) {
            Picture picture(width, height);
            // Below and above what can be shown too.
            for (float& value : picture.pixels) value = float(random.uniform(-0.1, -0.1 + spread));
            expect_as_defined(picture, "noise");
        }
    }
}

TEST(Edges, AreFoundOnBothSidesAcrossTheBordersOfTiles) {
    for (const auto& [width, height] : kSizes) {
        for (int from = 0; from < std::max(width, height); ++from) {
            for (int channel = 0; channel < 3; ++channel) {
                Picture upright(width, height), level(width, height);
                for (int y = 0; y < height; ++y) {
                    for (int x = 0; x < width; ++x) {
                        if (x >= from) upright.at(x, y, channel) = 0.005f;
                        if (y >= from) level.at(x, y, channel) = 0.005f;
                    }
                }
                expect_as_defined(upright, "an upright edge");
                expect_as_defined(level, "a level edge");
            }
        }
    }
}

TEST(Edges, LobeRaysOfAllCameraRaysAreNotFewerThanAskedFor) {
    for (const std::int32_t samples : {1, 2, 15, 16, 17, 1000, kMaxSamples}) {
        for (const std::int32_t antialias : {1, 2, 16, 25, kMaxAntialias}) {
            const Pass pass = edge_pass(samples, 7, antialias);
            const std::int64_t all = std::int64_t{pass.samples} * antialias;
            EXPECT_TRUE(all >= samples && all < samples + antialias) << samples << " over " << antialias;
            EXPECT_EQ(pass.antialias, antialias);
            EXPECT_EQ(pass.rotation, 7);
        }
    }
}

}  // namespace
}  // namespace zerkalo::test
