// PFM: round trip, the bytes as the format prescribes them, both byte orders, damaged files.
#include "platform/pfm.hpp"

#include "tests/platform/random_picture.hpp"
#include "tests/platform/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace zerkalo {
namespace {

void write(const std::string& path, const LinearImage& picture) {
    WholeFile file;
    ASSERT_TRUE(file.open(path.c_str()).ok());
    ASSERT_TRUE(write_pfm(file, picture).ok());
    ASSERT_TRUE(file.commit().ok());
}

std::string bytes_of(std::initializer_list<float> values, bool big_endian) {
    std::string bytes;
    for (const float value : values) {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> 8 * (big_endian ? 3 - i : i));
    }
    return bytes;
}

TEST(Pfm, RoundTripsEveryFloat) {
    const ScratchFolder folder;
    LinearPicture picture = random_linear(31, 17, 41);
    const float special[] = {
        0.0f, -0.0f, 1e-45f, -1e30f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()};
    std::copy(std::begin(special), std::end(special), picture.rgb.begin());
    write(folder / "a.pfm", picture.view());
    LinearPicture back;
    const IoStatus status = read_pfm((folder / "a.pfm").c_str(), back);
    ASSERT_TRUE(status.ok()) << status.text;
    EXPECT_EQ(back.width, 31);
    EXPECT_EQ(back.height, 17);
    ASSERT_EQ(back.rgb.size(), picture.rgb.size());
    for (std::size_t i = 0; i < back.rgb.size(); ++i)
        ASSERT_EQ(std::bit_cast<std::uint32_t>(back.rgb[i]), std::bit_cast<std::uint32_t>(picture.rgb[i])) << i;
}

TEST(Pfm, BottomRowComesFirst) {
    const ScratchFolder folder;
    LinearPicture picture{1, 2, {1, 2, 3, 4, 5, 6}};
    write(folder / "a.pfm", picture.view());
    EXPECT_EQ(content_of(folder / "a.pfm"), "PF\n1 2\n-1.0\n" + bytes_of({4, 5, 6, 1, 2, 3}, false));
}

TEST(Pfm, RowPaddingIsNotWritten) {
    const ScratchFolder folder;
    float pixels[] = {1, 2, 3, 99, 4, 5, 6, 99};
    write(folder / "a.pfm", {pixels, 1, 2, 4 * sizeof(float)});
    EXPECT_EQ(content_of(folder / "a.pfm"), "PF\n1 2\n-1.0\n" + bytes_of({4, 5, 6, 1, 2, 3}, false));
}

TEST(Pfm, ReadsBigEndianAndGrey) {
    const ScratchFolder folder;
    LinearPicture picture;
    put_content(folder / "big", "PF 1 2\n2.5\n" + bytes_of({4, 5, 6, 1, 2, 3}, true));
    ASSERT_TRUE(read_pfm((folder / "big").c_str(), picture).ok());
    EXPECT_EQ(picture.rgb, (std::vector<float>{1, 2, 3, 4, 5, 6}));
    put_content(folder / "grey", "Pf\n2 2\n-1\n" + bytes_of({3, 4, 1, 2}, false));
    ASSERT_TRUE(read_pfm((folder / "grey").c_str(), picture).ok());
    EXPECT_EQ(picture.rgb, (std::vector<float>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}));
}

TEST(Pfm, DamagedFilesAreRefusedWithTheReason) {
    const ScratchFolder folder;
    const std::string pixel = bytes_of({1, 2, 3}, false);
    const struct {
        std::string content, reason;
    } cases[] = {
        {"", "not a PFM file"},
        {"P6\n1 1\n255\n" + pixel, "not a PFM file"},
        {"PF", "not a PFM file"},
        {"PF\n0 1\n-1\n", "width"},
        {"PF\n1x 1\n-1\n" + pixel, "width"},
        {"PF\n99999999999999999999 1\n-1\n", "width"},
        {"PF\n1 -1\n-1\n" + pixel, "height"},
        {"PF\n65536 65536\n-1\n", "2^28"},
        {"PF\n1 1\n0\n" + pixel, "scale"},
        {"PF\n1 1\nnan\n" + pixel, "scale"},
        {"PF\n1 1\n-1.0.0\n" + pixel, "scale"},
        {"PF\n1 1\n-1", "scale"},
        {"PF\n1 1\n-1\n" + pixel.substr(1), "ends too early"},
        {"PF\n1 1\n-1\n" + pixel + "x", "goes on"},
    };
    for (const auto& damaged : cases) {
        put_content(folder / "x.pfm", damaged.content);
        LinearPicture picture;
        const std::string text = read_pfm((folder / "x.pfm").c_str(), picture).text;
        EXPECT_EQ(text.rfind(folder / "x.pfm" + ": ", 0), 0u) << text;
        EXPECT_NE(text.find(damaged.reason), std::string::npos) << text << " for " << damaged.content;
    }
}

TEST(Pfm, UnreadableFilesAreNamed) {
    const ScratchFolder folder;
    LinearPicture picture;
    EXPECT_EQ(read_pfm((folder / "none").c_str(), picture).text,
              folder / "none" + ": cannot open: No such file or directory");
    EXPECT_EQ(read_pfm((folder / ".").c_str(), picture).text, folder / "." + ": cannot read: Is a directory");
}

TEST(Pfm, EmptyPictureIsRefused) {
    const ScratchFolder folder;
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "a.pfm").c_str()).ok());
    EXPECT_FALSE(write_pfm(file, {nullptr, 0, 0, 0}).ok());
}

}  // namespace
}  // namespace zerkalo
