// The progress line of long work: percent, seconds, rays per second, rewritten in place on a terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace zerkalo {

/// Silent for the first half second, then at most ten times a second on stderr; erased when it goes out of scope.
class Progress {
public:
    explicit Progress(std::int64_t steps) : steps_(steps) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One step done with so many rays. From any thread.
    void add_step(std::uint64_t rays);

    /// Rewrites the line when it is due. From one thread only.
    void show();

private:
    using Clock = std::chrono::steady_clock;

    std::int64_t steps_;
    std::atomic<std::int64_t> done_{0};
    std::atomic<std::uint64_t> rays_{0};
    Clock::time_point start_ = Clock::now(), next_ = start_ + std::chrono::milliseconds(500);
    int width_ = 0;  // columns that the line on the screen takes
};

/// True when stderr is a terminal that can rewrite a line.
bool progress_wanted();

}  // namespace zerkalo
