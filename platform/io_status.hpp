// The outcome of touching a device or a file: ok, or one line that says where and why. A value, never an exception.
#pragma once

#include <cstddef>

namespace zerkalo {

/// Ok when `text` is empty. Plain data of fixed size: no heap, so a full memory can be reported too.
struct [[nodiscard]] IoStatus {
    static constexpr std::size_t kCapacity = 512;
    char text[kCapacity] = "";

    bool ok() const { return text[0] == '\0'; }
};

/// "place: reason". A place too long for the line loses its beginning, never the reason.
IoStatus io_failure(const char* place, const char* reason);

/// "place: doing: what the system says of error_number", as in "out.png: cannot write: No space left on device".
IoStatus io_failure(const char* place, const char* doing, int error_number);

}  // namespace zerkalo
