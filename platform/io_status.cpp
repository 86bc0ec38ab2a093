// One line for what went wrong, put together in fixed memory.
#include "platform/io_status.hpp"

#include <cstdio>
#include <cstring>

namespace zerkalo {

IoStatus io_failure(const char* place, const char* reason) {
    constexpr std::size_t kReasonLimit = 200;
    constexpr std::size_t kPlaceLimit = IoStatus::kCapacity - kReasonLimit - sizeof("...: ");
    const std::size_t length = std::strlen(place);
    IoStatus status;
    if (length > kPlaceLimit)
        std::snprintf(status.text, sizeof status.text, "...%s: %.200s", place + (length - kPlaceLimit), reason);
    else
        std::snprintf(status.text, sizeof status.text, "%s: %.200s", place, reason);
    return status;
}

IoStatus io_failure(const char* place, const char* doing, int error_number) {
    char reason[200];
    std::snprintf(reason, sizeof reason, "%s: %s", doing, std::strerror(error_number));
    return io_failure(place, reason);
}

}  // namespace zerkalo
