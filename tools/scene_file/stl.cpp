#include "tools/scene_file/stl.hpp"

#include <cstring>

namespace zerkalo::scene_file {
namespace {

constexpr std::size_t kHeaderSize = 84;    // 80 bytes of comment and the number of triangles
constexpr std::size_t kTriangleSize = 50;  // normal and three corners in float, two bytes of attributes

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

float float_at(std::string_view bytes, std::size_t at) {
    const std::uint32_t bits = little_endian(bytes, at);
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// Bytes that the file should have for the number of triangles that it states.
std::uint64_t stated_size(std::string_view bytes) {
    return kHeaderSize + std::uint64_t{kTriangleSize} * little_endian(bytes, kHeaderSize - 4);
}

/// The last byte of a binary file's count is zero below 2^24 triangles, and a text has no zero byte.
bool is_binary(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    const std::string_view word = first == std::string_view::npos ? std::string_view{} : bytes.substr(first, 5);
    const bool begins_with_solid = word == "solid" || word == "SOLID" || word == "Solid";
    return !begins_with_solid || bytes.find('\0') != std::string_view::npos;
}

}  // namespace

std::string too_many_triangles(int room) {
    const std::string limit = "a scene holds at most " + std::to_string(kMaxTriangles) + " triangles";
    return room == kMaxTriangles ? limit : limit + ", and the meshes before leave room for " + std::to_string(room);
}

std::optional<StlFault> read_binary_stl(std::string_view bytes, int room, std::vector<Triangle>& triangles) {
    if (bytes.size() < kHeaderSize) {
        return StlFault{{}, "neither a binary STL file (84 bytes or more) nor an ASCII one (begins with \"solid\")"};
    }
    const std::uint32_t count = little_endian(bytes, kHeaderSize - 4);
    if (stated_size(bytes) != bytes.size()) {
        return StlFault{{},
                        "states " + std::to_string(count) + " triangles, which take " +
                            std::to_string(stated_size(bytes)) + " bytes, but has " + std::to_string(bytes.size())};
    }
    if (count > static_cast<std::uint32_t>(room)) {
        return StlFault{{}, std::to_string(count) + " triangles: " + too_many_triangles(room)};
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        double corner[9];
        for (std::size_t k = 0; k < 9; ++k) {
            corner[k] = float_at(bytes, kHeaderSize + kTriangleSize * i + 12 + 4 * k);
            if (!(corner[k] >= -kMaxCoordinate && corner[k] <= kMaxCoordinate)) {
                return StlFault{{},
                                "triangle " + std::to_string(i + 1) + ", corner " + std::to_string(k / 3 + 1) +
                                    ": a coordinate must be a number from -1e15 to 1e15"};
            }
        }
        triangles.push_back(
            {{corner[0], corner[1], corner[2]}, {corner[3], corner[4], corner[5]}, {corner[6], corner[7], corner[8]}});
    }
    return std::nullopt;
}

std::optional<StlFault> read_stl(const SourceText& file, int room, std::vector<Triangle>& triangles) {
    if (is_binary(file.text())) return read_binary_stl(file.text(), room, triangles);
    return read_ascii_stl(file, room, triangles);
}

}  // namespace zerkalo::scene_file
