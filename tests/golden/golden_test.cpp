// Every shipped scene still gives the picture that was stored: not one 8-bit code may differ.
#include "core/image/resolve.hpp"
#include "platform/png.hpp"
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace zerkalo::laws {
namespace {

const std::filesystem::path kGoldens = ZERKALO_SOURCE_DIR "/tests/golden";

std::vector<std::uint16_t> codes_of(const Image& image) {
    std::vector<std::uint8_t> codes(image.rgb.size());
    resolve8(image.rgb.data(), codes.data(), codes.size());
    return {codes.begin(), codes.end()};
}

/// What a person looks at when the codes differ.
std::string save_pictures(const std::string& name, const Image& image, const CodePicture& golden) {
    LinearPicture linear = linear_from_codes(golden);
    return reference::save_failure(ZERKALO_FAILURE_DIR "/" + name, picture_of(image),
                                   reference::picture_of(linear.view()));
}

TEST(Golden, EveryShippedSceneGivesItsStoredPicture) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(64, 48);
        settings.samples = 16;
        const Image image = render(scene, settings);
        CodePicture golden;
        const IoStatus status = read_png((kGoldens / (name + ".png")).c_str(), golden);
        ASSERT_TRUE(status.ok()) << status.text;
        ASSERT_EQ(golden.depth, 8) << name;
        ASSERT_EQ(golden.width, image.width) << name;
        ASSERT_EQ(golden.height, image.height) << name;
        EXPECT_TRUE(codes_of(image) == golden.rgb) << name << ": " << save_pictures(name, image, golden);
    }
}

TEST(Golden, EveryStoredPictureBelongsToAShippedScene) {
    std::set<std::string> names;
    for (const ShippedScene& shipped : shipped_scenes()) names.insert(shipped.name);
    for (const auto& entry : std::filesystem::directory_iterator(kGoldens)) {
        if (entry.path().extension() != ".png") continue;
        EXPECT_EQ(names.count(entry.path().stem().string()), 1u) << entry.path();
    }
}

}  // namespace
}  // namespace zerkalo::laws
