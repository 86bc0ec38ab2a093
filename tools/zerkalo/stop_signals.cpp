#include "tools/zerkalo/stop_signals.hpp"

namespace zerkalo {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGWINCH};

// What a handler may touch: lock-free atomics and nothing else.
std::atomic<bool> stop_came{false};
std::atomic<bool> resize_came{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int signal) { (signal == SIGWINCH ? resize_came : stop_came).store(true, std::memory_order_relaxed); }

}  // namespace

StopSignals::StopSignals() {
    struct sigaction action {};
    action.sa_handler = note;
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < 3; ++i) sigaction(kSignals[i], &action, &before_[i]);
}

StopSignals::~StopSignals() {
    for (int i = 0; i < 3; ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

const std::atomic<bool>& StopSignals::stopped() const { return stop_came; }

StopSignals::Event StopSignals::wait() {
    sigset_t ours, before;
    sigemptyset(&ours);
    for (const int signal : kSignals) sigaddset(&ours, signal);
    // Blocked while asked, let in only while asleep: none can slip in between the question and the sleep.
    sigprocmask(SIG_BLOCK, &ours, &before);
    while (!stop_came.load(std::memory_order_relaxed) && !resize_came.load(std::memory_order_relaxed)) {
        sigsuspend(&before);
    }
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (stop_came.load(std::memory_order_relaxed)) return Event::stop;
    resize_came.store(false, std::memory_order_relaxed);
    return Event::resized;
}

}  // namespace zerkalo
