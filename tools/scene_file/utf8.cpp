#include "tools/scene_file/utf8.hpp"

#include <algorithm>
#include <cstdint>

namespace zerkalo::scene_file {
namespace {

/// How many bytes a first byte announces, and the smallest code point that needs them.
struct Lead {
    std::size_t size;
    std::uint32_t bits, smallest;
};

Lead lead_of(unsigned char byte) {
    if (byte < 0x80) return {1, byte, 0};
    if ((byte & 0xe0) == 0xc0) return {2, byte & 0x1fu, 0x80};
    if ((byte & 0xf0) == 0xe0) return {3, byte & 0x0fu, 0x800};
    if ((byte & 0xf8) == 0xf0) return {4, byte & 0x07u, 0x10000};
    return {0, 0, 0};
}

}  // namespace

std::size_t character_size(std::string_view text) {
    if (text.empty()) return 0;
    const Lead lead = lead_of(static_cast<unsigned char>(text[0]));
    if (lead.size > text.size()) return 0;
    std::uint32_t code = lead.bits;
    for (std::size_t i = 1; i < lead.size; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xc0) != 0x80) return 0;
        code = code << 6 | (byte & 0x3fu);
    }
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    return code < lead.smallest || code > 0x10ffff || surrogate ? 0 : lead.size;
}

std::vector<std::string_view> characters_of(std::string_view text) {
    std::vector<std::string_view> characters;
    while (!text.empty()) {
        const std::size_t size = std::max<std::size_t>(1, character_size(text));
        characters.push_back(text.substr(0, size));
        text.remove_prefix(size);
    }
    return characters;
}

std::size_t first_malformed(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = character_size(text.substr(i));
        if (size == 0) return i;
        i += size;
    }
    return std::string_view::npos;
}

}  // namespace zerkalo::scene_file
