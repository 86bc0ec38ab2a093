#include "tools/zerkalo/progress.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace zerkalo {

Progress::~Progress() {
    // Blanks instead of an erase sequence: no escape codes at all, so NO_COLOR needs no second form.
    if (width_ > 0) std::fprintf(stderr, "\r%*s\r", width_, "");
}

void Progress::add_step(std::uint64_t rays) {
    done_.fetch_add(1, std::memory_order_relaxed);
    rays_.fetch_add(rays, std::memory_order_relaxed);
}

void Progress::show() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double done = static_cast<double>(done_.load(std::memory_order_relaxed));
    const double rays = static_cast<double>(rays_.load(std::memory_order_relaxed));
    char line[96];
    const int width = std::snprintf(line, sizeof line, "%3.0f %%  %.1f s  %.1f Mray/s",
                                    100 * done / static_cast<double>(steps_), seconds, rays / seconds * 1e-6);
    std::fprintf(stderr, "\r%-*s", width_, line);
    if (width > width_) width_ = width;
}

bool progress_wanted() {
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && !(terminal && std::string_view(terminal) == "dumb");
}

}  // namespace zerkalo
