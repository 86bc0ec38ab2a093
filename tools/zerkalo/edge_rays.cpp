#include "tools/zerkalo/edge_rays.hpp"

#include "core/render/edges.hpp"
#include "tools/thread_tiles.hpp"

#include <bit>
#include <map>

namespace zerkalo {

EdgePixels find_edges(const Frame& frame) {
    EdgePixels edges;
    edges.of_tile.resize(static_cast<std::size_t>(tile_count(frame.head())));
    thread_tiles(tile_count(frame.head()), frame.threads, [&](int i, int) {
        edges.of_tile[static_cast<std::size_t>(i)] = edge_pixels(frame.image, tile_at(frame.head(), i));
    });
    for (const std::uint64_t pixels : edges.of_tile) edges.count += std::popcount(pixels);
    return edges;
}

void paint_edges(const Frame& frame, const EdgePixels& edges, const std::vector<std::int32_t>& samples,
                 const std::function<bool()>& stopped, RayCounts& rays) {
    // A pass has one number of lobe rays: tiles that share it are painted together.
    std::map<std::int32_t, std::vector<int>> tiles_of;
    for (std::size_t i = 0; i < edges.of_tile.size(); ++i) {
        if (edges.of_tile[i] != 0) tiles_of[samples[i]].push_back(static_cast<int>(i));
    }
    std::vector<ThreadCounts> counts(static_cast<std::size_t>(frame.threads));
    for (const auto& [of_pixel, tiles] : tiles_of) {
        frame.begin(edge_pass(of_pixel, frame.rotation, frame.head().edge_antialias));
        thread_tiles(static_cast<int>(tiles.size()), frame.threads, [&, &tiles = tiles](int i, int thread) {
            if (stopped()) return;
            const int tile = tiles[static_cast<std::size_t>(i)];
            const std::uint64_t pixels = edges.of_tile[static_cast<std::size_t>(tile)];
            frame.render_tile(Tile(tile_at(frame.head(), tile), pixels), counts[static_cast<std::size_t>(thread)].rays);
        });
    }
    for (const ThreadCounts& of_thread : counts) rays += of_thread.rays;
    frame.begin(centre_pass(frame.samples, frame.rotation));
}

}  // namespace zerkalo
