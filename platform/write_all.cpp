// Write to the end, with SIGPIPE and SIGXFSZ held back in this thread only: a library leaves the program's handlers.
#include "platform/write_all.hpp"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <poll.h>
#include <unistd.h>

namespace zerkalo {
namespace {

class HeldSignals {
public:
    HeldSignals() {
        sigemptyset(&held_);
        sigaddset(&held_, SIGPIPE);
        sigaddset(&held_, SIGXFSZ);
        sigpending(&pending_before_);
        pthread_sigmask(SIG_BLOCK, &held_, &mask_before_);
    }
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    // Swallow what the write raised, but nothing that was waiting before it.
    ~HeldSignals() {
        sigset_t swallowed = held_;
        if (sigismember(&pending_before_, SIGPIPE) == 1) sigdelset(&swallowed, SIGPIPE);
        if (sigismember(&pending_before_, SIGXFSZ) == 1) sigdelset(&swallowed, SIGXFSZ);
        const timespec at_once{};
        while (sigtimedwait(&swallowed, nullptr, &at_once) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
    }

private:
    sigset_t held_, pending_before_, mask_before_;
};

}  // namespace

int write_all(int file, const void* data, std::size_t size) {
    const HeldSignals held;
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = ::write(file, next, size);
        if (written > 0) {
            next += written;
            size -= static_cast<std::size_t>(written);
        } else if (written == 0) {
            return EIO;
        } else if (errno == EAGAIN) {
            pollfd ready{file, POLLOUT, 0};
            (void)::poll(&ready, 1, -1);
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

}  // namespace zerkalo
