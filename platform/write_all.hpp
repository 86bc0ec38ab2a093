// A write that ends only when everything is written or something failed, and that fails by its value alone.
#pragma once

#include <cstddef>

namespace zerkalo {

/// Writes `size` bytes to `file`; returns 0 or the error number. Interrupted and partial writes go on; a non-blocking
/// file is waited for. A closed pipe gives EPIPE and a size limit EFBIG, without the signals that go with them.
int write_all(int file, const void* data, std::size_t size);

}  // namespace zerkalo
