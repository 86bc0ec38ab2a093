// The one piece of threading: every tile is done once, whatever the number of threads.
#include "tools/thread_tiles.hpp"

#include <gtest/gtest.h>

#include <latch>

namespace zerkalo {
namespace {

TEST(ThreadTiles, EveryTileIsDoneExactlyOnce) {
    for (const int tiles : {0, 1, 2, 63, 4800}) {
        for (const int threads : {1, 2, 3, 8}) {
            std::vector<std::atomic<int>> times(static_cast<std::size_t>(tiles));
            thread_tiles(tiles, threads, [&](int tile, int) { ++times[static_cast<std::size_t>(tile)]; });
            for (int tile = 0; tile < tiles; ++tile) {
                ASSERT_EQ(times[static_cast<std::size_t>(tile)], 1)
                    << "tile " << tile << " of " << tiles << ", " << threads << " threads";
            }
        }
    }
}

TEST(ThreadTiles, EveryThreadWorksUnderANumberOfItsOwn) {
    constexpr int kThreads = 4;
    std::atomic<int> times[kThreads]{};
    std::latch all_at_work(kThreads);
    // Each tile waits for the others, so that no thread can take two.
    thread_tiles(kThreads, kThreads, [&](int, int thread) {
        if (thread >= 0 && thread < kThreads) ++times[thread];
        all_at_work.arrive_and_wait();
    });
    for (int thread = 0; thread < kThreads; ++thread) EXPECT_EQ(times[thread], 1) << "thread " << thread;
}

TEST(ThreadTiles, OneThreadIsTheCallerAndGoesInOrder) {
    int expected = 0;
    thread_tiles(100, 1, [&](int tile, int thread) {
        EXPECT_EQ(tile, expected++);
        EXPECT_EQ(thread, 0);
    });
    EXPECT_EQ(expected, 100);
}

}  // namespace
}  // namespace zerkalo
