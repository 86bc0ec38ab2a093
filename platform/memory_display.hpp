// A display in memory: keeps the last frame, packed as a device of the given format would hold it.
#pragma once

#include "platform/display.hpp"

#include <vector>

namespace zerkalo {

class MemoryDisplay {
public:
    /// Black at first. The default format keeps the bytes R, G, B, so that codes() can read them back.
    explicit MemoryDisplay(Extent extent, PixelFormat format = kBgr888)
        : extent_(extent), format_(format), bytes_(stride() * static_cast<std::size_t>(extent.height)) {}

    Extent extent() const { return extent_; }
    PixelFormat format() const { return format_; }

    /// Cannot fail.
    IoStatus present(const SrgbPart& part, const Point& at) {
        pack_part(format_, bytes_.data(), stride(), extent_, part, at);
        return {};
    }

    const std::vector<unsigned char>& bytes() const { return bytes_; }
    std::size_t stride() const { return static_cast<std::size_t>(extent_.width) * format_.bytes; }

    /// The frame as sRGB codes. Precondition: format() == kBgr888.
    SrgbPart codes() const {
        return {bytes_.data(), extent_.width, extent_.height, static_cast<std::ptrdiff_t>(stride())};
    }

private:
    Extent extent_;
    PixelFormat format_;
    std::vector<unsigned char> bytes_;
};

static_assert(Display<MemoryDisplay>);

}  // namespace zerkalo
