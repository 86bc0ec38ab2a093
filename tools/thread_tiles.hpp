// Hands tiles to threads by one atomic counter: whoever is free takes the next one.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace zerkalo {

/// Calls work(tile, thread) once for every tile 0..tiles-1, with thread in 0..threads-1; thread 0 is the caller, so one
/// thread starts none. Returns when all are done. `work` is called from several threads at once and must not throw.
/// Throws std::system_error when the system refuses a thread, after the tiles are done by those that it gave.
template <class Work>
void thread_tiles(int tiles, int threads, const Work& work) {
    std::atomic<int> next{0};
    const auto take_tiles = [&](int thread) {
        for (int tile = next.fetch_add(1, std::memory_order_relaxed); tile < tiles;
             tile = next.fetch_add(1, std::memory_order_relaxed)) {
            work(tile, thread);
        }
    };
    // jthread joins in its destructor, also when starting a later one fails.
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < threads; ++thread) helpers.emplace_back(take_tiles, thread);
    take_tiles(0);
}

}  // namespace zerkalo
