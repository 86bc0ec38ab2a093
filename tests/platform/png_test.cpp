// PNG: what is written comes back, every kind of PNG is read, damaged files are refused.
#include "platform/png.hpp"

#include "core/image/resolve.hpp"
#include "tests/platform/random_picture.hpp"
#include "tests/platform/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <png.h>
#include <sys/resource.h>

namespace zerkalo {
namespace {

template <class... Arguments>
void write(const std::string& path, const Arguments&... arguments) {
    WholeFile file;
    ASSERT_TRUE(file.open(path.c_str()).ok());
    const IoStatus status = write_png(file, arguments...);
    ASSERT_TRUE(status.ok()) << status.text;
    ASSERT_TRUE(file.commit().ok());
}

CodePicture read(const std::string& path) {
    CodePicture picture;
    const IoStatus status = read_png(path.c_str(), picture);
    EXPECT_TRUE(status.ok()) << status.text;
    return picture;
}

constexpr Extent kExtents[] = {{1, 1}, {3, 2}, {64, 48}, {641, 7}};

TEST(Png, EightBitsRoundTrip) {
    const ScratchFolder folder;
    for (const Extent& extent : kExtents) {
        LinearPicture picture = random_linear(extent.width, extent.height, 51);
        write(folder / "a.png", picture.view(), PngDepth::eight);
        const CodePicture back = read(folder / "a.png");
        std::vector<std::uint8_t> codes(picture.rgb.size());
        resolve8(picture.rgb.data(), codes.data(), codes.size());
        EXPECT_EQ(back.depth, 8);
        EXPECT_EQ((Extent{back.width, back.height}), extent);
        EXPECT_EQ(back.rgb, std::vector<std::uint16_t>(codes.begin(), codes.end()));
    }
}

TEST(Png, SixteenBitsRoundTrip) {
    const ScratchFolder folder;
    for (const Extent& extent : kExtents) {
        LinearPicture picture = random_linear(extent.width, extent.height, 52);
        write(folder / "a.png", picture.view(), PngDepth::sixteen);
        const CodePicture back = read(folder / "a.png");
        std::vector<std::uint16_t> codes(picture.rgb.size());
        resolve16(picture.rgb.data(), codes.data(), codes.size());
        EXPECT_EQ(back.depth, 16);
        EXPECT_EQ((Extent{back.width, back.height}), extent);
        EXPECT_EQ(back.rgb, codes);
    }
}

TEST(Png, ResolvedCodesRoundTripWithoutTheirPadding) {
    const ScratchFolder folder;
    const RandomCodes codes(20, 10, 53);
    write(folder / "a.png", codes.part({5, 2, 7, 6}));
    const CodePicture back = read(folder / "a.png");
    for (std::int32_t y = 0; y < 6; ++y)
        for (std::int32_t i = 0; i < 21; ++i)
            ASSERT_EQ(back.rgb[static_cast<std::size_t>(21 * y + i)], codes.part({5, 2, 7, 6}).row(y)[i])
                << i << "," << y;
}

TEST(Png, CodesComeBackThroughLinearLight) {
    for (const int depth : {8, 16}) {
        CodePicture all{depth == 8 ? 16 : 256, depth == 8 ? 16 : 256, depth, {}};
        const int levels = depth == 8 ? 256 : 65536;
        for (int code = 0; code < levels; ++code) all.rgb.insert(all.rgb.end(), 3, static_cast<std::uint16_t>(code));
        const LinearPicture linear = linear_from_codes(all);
        std::vector<std::uint16_t> codes(linear.rgb.size());
        std::vector<std::uint8_t> narrow(linear.rgb.size());
        resolve16(linear.rgb.data(), codes.data(), codes.size());
        resolve8(linear.rgb.data(), narrow.data(), narrow.size());
        if (depth == 8) codes.assign(narrow.begin(), narrow.end());
        EXPECT_EQ(codes, all.rgb) << depth;
    }
}

TEST(Png, SaysThatItIsSrgb) {
    const ScratchFolder folder;
    LinearPicture picture = random_linear(2, 2, 54);
    write(folder / "a.png", picture.view(), PngDepth::eight);
    EXPECT_NE(content_of(folder / "a.png").find("sRGB"), std::string::npos);
}

// A PNG as another program would write it: `raw` are the file's own samples.
void write_foreign(const std::string& path, int width, int height, int depth, int color, int interlace,
                   std::vector<std::uint8_t> raw, bool transparent_palette = false) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, unsigned(width), unsigned(height), depth, color, interlace, 0, 0);
    if (color == PNG_COLOR_TYPE_PALETTE) {
        const png_color palette[4] = {{1, 2, 3}, {40, 50, 60}, {7, 8, 9}, {255, 0, 128}};
        png_set_PLTE(png, info, palette, 4);
        png_byte alpha[2] = {0, 100};
        if (transparent_palette) png_set_tRNS(png, info, alpha, 2, nullptr);
    }
    png_write_info(png, info);
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y) rows.push_back(raw.data() + raw.size() / std::size_t(height) * std::size_t(y));
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

using Codes = std::vector<std::uint16_t>;

TEST(Png, ReadsEveryColourTypeAsRgb) {
    const ScratchFolder folder;
    const std::string path = folder / "a.png";
    write_foreign(path, 2, 1, 8, PNG_COLOR_TYPE_GRAY, 0, {7, 200});
    EXPECT_EQ(read(path).rgb, (Codes{7, 7, 7, 200, 200, 200}));
    write_foreign(path, 2, 1, 16, PNG_COLOR_TYPE_GRAY, 0, {1, 2, 250, 3});
    EXPECT_EQ(read(path).rgb, (Codes{258, 258, 258, 64003, 64003, 64003}));
    write_foreign(path, 4, 1, 2, PNG_COLOR_TYPE_GRAY, 0, {0x1b});
    EXPECT_EQ(read(path).rgb, (Codes{0, 0, 0, 85, 85, 85, 170, 170, 170, 255, 255, 255}));
    write_foreign(path, 1, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, 0, {9, 50});
    EXPECT_EQ(read(path).rgb, (Codes{9, 9, 9}));
    write_foreign(path, 1, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, 0, {10, 20, 30, 0});
    EXPECT_EQ(read(path).rgb, (Codes{10, 20, 30}));
    write_foreign(path, 1, 1, 16, PNG_COLOR_TYPE_RGB_ALPHA, 0, {1, 0, 2, 0, 3, 4, 0, 0});
    EXPECT_EQ(read(path).rgb, (Codes{256, 512, 772}));
    EXPECT_EQ(read(path).depth, 16);
    for (const bool transparent : {false, true}) {
        write_foreign(path, 4, 1, 2, PNG_COLOR_TYPE_PALETTE, 0, {0x1b}, transparent);
        EXPECT_EQ(read(path).rgb, (Codes{1, 2, 3, 40, 50, 60, 7, 8, 9, 255, 0, 128})) << transparent;
        EXPECT_EQ(read(path).depth, 8);
    }
}

TEST(Png, InterlacedIsReadLikePlain) {
    const ScratchFolder folder;
    const RandomCodes codes(13, 11, 55);
    write_foreign(folder / "plain.png", 13, 11, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, codes.rgb);
    write_foreign(folder / "laced.png", 13, 11, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7, codes.rgb);
    EXPECT_EQ(read(folder / "plain.png").rgb, Codes(codes.rgb.begin(), codes.rgb.end()));
    EXPECT_EQ(read(folder / "laced.png").rgb, Codes(codes.rgb.begin(), codes.rgb.end()));
}

// Every prefix and a change of every byte: refused with the file's name, never a crash. (A byte that libpng does not
// look at, in a chunk without meaning for the picture, does not exist in these files.)
TEST(Png, DamagedFilesAreRefused) {
    const ScratchFolder folder;
    const std::string path = folder / "a.png";
    LinearPicture source = random_linear(9, 5, 56);
    write(path, source.view(), PngDepth::eight);
    const std::string good = content_of(path);
    CodePicture picture;
    for (std::size_t length = 0; length < good.size(); ++length) {
        put_content(path, good.substr(0, length));
        const std::string text = read_png(path.c_str(), picture).text;
        ASSERT_EQ(text.rfind(path + ": ", 0), 0u) << "cut after " << length << ": " << text;
    }
    const std::size_t ancillary = good.find("sRGB");
    for (std::size_t i = 0; i < good.size(); ++i) {
        if (i + 4 >= ancillary && i < ancillary + 9) continue;  // libpng goes on without a damaged sRGB chunk
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 0x10);
        put_content(path, bad);
        EXPECT_FALSE(read_png(path.c_str(), picture).ok()) << "byte " << i;
    }
}

TEST(Png, FilesThatCannotBeReadAreNamed) {
    const ScratchFolder folder;
    CodePicture picture;
    EXPECT_EQ(read_png((folder / "none").c_str(), picture).text,
              folder / "none" + ": cannot open: No such file or directory");
    EXPECT_EQ(read_png((folder / ".").c_str(), picture).text, folder / "." + ": cannot read: Is a directory");
    put_content(folder / "text", "not a picture at all");
    EXPECT_EQ(read_png((folder / "text").c_str(), picture).text, folder / "text" + ": not a PNG file");
}

// A header that promises 2^32 pixels must not be believed.
TEST(Png, HugeSizesAreRefusedBeforeMemoryIsTaken) {
    const ScratchFolder folder;
    std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\0\0\0\1\0\0\x08\2\0\0\0", 29);
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 12; i < bytes.size(); ++i) {
        crc ^= static_cast<unsigned char>(bytes[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(~crc >> shift);
    bytes += std::string("\0\0\0\0IDAT\x35\xaf\x06\x1e", 12);  // IHDR ends where the data begins
    put_content(folder / "huge.png", bytes);
    CodePicture picture;
    EXPECT_EQ(read_png((folder / "huge.png").c_str(), picture).text,
              folder / "huge.png" + ": larger than 65536 on a side or 2^28 pixels");
    EXPECT_EQ(picture.rgb.capacity(), 0u);
}

TEST(Png, FullDiskIsReportedAndLeavesNothing) {
    const ScratchFolder folder;
    LinearPicture picture = random_linear(300, 200, 57);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit tight{40000, before.rlim_max};
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "a.png").c_str()).ok());
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const IoStatus status = write_png(file, picture.view(), PngDepth::eight);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(status.text, folder / "a.png" + ": cannot write: File too large");
    EXPECT_FALSE(file.commit().ok());
    EXPECT_TRUE(folder.names().empty());
}

TEST(Png, EmptyPictureIsRefused) {
    const ScratchFolder folder;
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "a.png").c_str()).ok());
    EXPECT_FALSE(write_png(file, LinearImage{}, PngDepth::eight).ok());
}

}  // namespace
}  // namespace zerkalo
