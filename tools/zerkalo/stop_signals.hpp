// SIGINT, SIGTERM and SIGWINCH as things to ask for instead of things that strike.
#pragma once

#include <atomic>
#include <csignal>

namespace zerkalo {

/// Takes the three signals for its lifetime, and gives them back. One object at a time.
class StopSignals {
public:
    enum class Event { stop, resized };

    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Set once SIGINT or SIGTERM has come.
    const std::atomic<bool>& stopped() const;

    /// Sleeps until one of them comes, or returns at once when one came since the last call.
    Event wait();

private:
    struct sigaction before_[3];
};

}  // namespace zerkalo
