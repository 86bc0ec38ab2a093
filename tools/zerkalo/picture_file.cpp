#include "tools/zerkalo/picture_file.hpp"

#include "core/image/resolve.hpp"
#include "platform/pfm.hpp"
#include "platform/png.hpp"
#include "tools/zerkalo/failure.hpp"

#include <cstdio>
#include <utility>

namespace zerkalo {
namespace {

void require(const IoStatus& status) {
    if (!status.ok()) throw Failure(ExitCode::io_failed, status.text);
}

bool ends_with(const std::string& path, const std::string& ending) {
    return path.size() > ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

// "PF" and "Pf" begin a PFM; everything else is left to the PNG reader, which says what it is not.
bool begins_like_pfm(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) return false;
    const int first = std::fgetc(file), second = std::fgetc(file);
    std::fclose(file);
    return first == 'P' && (second == 'F' || second == 'f');
}

// 8-bit codes as they are, 16-bit ones rounded to the nearest of 256.
std::vector<std::uint8_t> codes8_of(const CodePicture& picture) {
    std::vector<std::uint8_t> codes(picture.rgb.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const unsigned code = picture.rgb[i];
        codes[i] = static_cast<std::uint8_t>(picture.depth == 8 ? code : (code * 255 + 32767) / 65535);
    }
    return codes;
}

}  // namespace

PictureKind picture_kind(const std::string& path, int depth) {
    if (path == "-" || ends_with(path, ".png")) return depth == 16 ? PictureKind::png16 : PictureKind::png8;
    if (!ends_with(path, ".pfm")) {
        throw Failure(ExitCode::usage,
                      "-o " + path + ": the name must end in .png or .pfm, or be - for standard output");
    }
    if (depth == 16) throw Failure(ExitCode::usage, "--depth 16: a PFM has no depth, it holds 32-bit floats");
    return PictureKind::pfm;
}

void open_picture(WholeFile& file, const std::string& path) { require(file.open(path.c_str())); }

void write_picture(WholeFile& file, const LinearImage& image, PictureKind kind) {
    switch (kind) {
        case PictureKind::png8: require(write_png(file, image, PngDepth::eight)); break;
        case PictureKind::png16: require(write_png(file, image, PngDepth::sixteen)); break;
        case PictureKind::pfm: require(write_pfm(file, image)); break;
    }
    require(file.commit());
}

void write_codes(WholeFile& file, const SrgbPart& codes) {
    require(write_png(file, codes));
    require(file.commit());
}

Picture read_picture(const std::string& path) {
    Picture picture;
    if (begins_like_pfm(path)) {
        LinearPicture linear;
        require(read_pfm(path.c_str(), linear));
        picture.codes.resize(linear.rgb.size());
        resolve8(linear.rgb.data(), picture.codes.data(), picture.codes.size());
        picture.width = linear.width;
        picture.height = linear.height;
        picture.linear = std::move(linear.rgb);
        return picture;
    }
    CodePicture codes;
    require(read_png(path.c_str(), codes));
    picture.clipped = true;
    picture.width = codes.width;
    picture.height = codes.height;
    picture.codes = codes8_of(codes);
    picture.linear = std::move(linear_from_codes(codes).rgb);
    return picture;
}

}  // namespace zerkalo
