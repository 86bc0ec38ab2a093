// [image]: the size of the picture in pixels.
#include "core/render/settings.hpp"
#include "tools/scene_file/read_tables.hpp"
#include "tools/scene_file/table_reader.hpp"

#include <array>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 2> kImageKeys{"width", "height"};

}  // namespace

void read_image(const toml::table& table, Report& report, ImageSize& image) {
    TableReader reader(table, "the image", report);
    reader.allow(kImageKeys);
    for (const std::string_view key : kImageKeys) reader.require(key);
    const bool has_width = reader.integer("width", 1, kMaxImageSide, image.width);
    const bool has_height = reader.integer("height", 1, kMaxImageSide, image.height);
    const std::int64_t pixels = std::int64_t{image.width} * image.height;
    if (has_width && has_height && pixels > kMaxPixels) {
        reader.error(reader.place_of("width"), "\"width\" x \"height\" must be at most " + std::to_string(kMaxPixels) +
                                                   " pixels, not " + std::to_string(pixels));
    }
}

}  // namespace zerkalo::scene_file
