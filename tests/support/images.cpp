// Comparison of pictures, and PNG by its own specification (ISO/IEC 15948) with stored deflate blocks (RFC 1950, 1951).
#include "tests/support/images.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

namespace zerkalo::reference {
namespace {

using Bytes = std::string;

void append_big_endian(Bytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

std::uint32_t crc32(const Bytes& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes) {
    std::uint32_t a = 1, b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<unsigned char>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

void append_chunk(Bytes& file, const Bytes& type, const Bytes& data) {
    append_big_endian(file, static_cast<std::uint32_t>(data.size()));
    file += type + data;
    append_big_endian(file, crc32(type + data));
}

Bytes stored_zlib(const Bytes& raw) {
    constexpr std::size_t kLargestBlock = 65535;
    Bytes out("\x78\x01", 2);
    for (std::size_t start = 0; start < raw.size(); start += kLargestBlock) {
        const std::size_t size = std::min(kLargestBlock, raw.size() - start);
        out.push_back(start + size == raw.size() ? 1 : 0);
        for (const std::size_t word : {size, ~size})
            for (int shift : {0, 8}) out.push_back(static_cast<char>(word >> shift & 0xff));
        out.append(raw, start, size);
    }
    append_big_endian(out, adler32(raw));
    return out;
}

/// `codes`: width * height * 3 bytes.
void write_png_codes(const std::string& path, int width, int height, const Bytes& codes) {
    Bytes header;
    append_big_endian(header, static_cast<std::uint32_t>(width));
    append_big_endian(header, static_cast<std::uint32_t>(height));
    header += Bytes("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB, no interlace
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    Bytes raw;
    for (std::size_t start = 0; start < codes.size(); start += row) {
        raw.push_back(0);  // no filter
        raw.append(codes, start, row);
    }
    Bytes file("\x89PNG\r\n\x1a\n");
    append_chunk(file, "IHDR", header);
    append_chunk(file, "IDAT", stored_zlib(raw));
    append_chunk(file, "IEND", "");
    std::ofstream stream(path, std::ios::binary);
    stream.write(file.data(), static_cast<std::streamsize>(file.size()));
    if (!stream.flush()) throw std::runtime_error("cannot write " + path);
}

Bytes codes_of(const Picture& picture) {
    Bytes codes;
    for (const Rgb<double>& p : picture.pixels)
        for (const double channel : {p.r, p.g, p.b}) codes.push_back(static_cast<char>(srgb_code(channel)));
    return codes;
}

void require_same_size(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size())
        throw std::invalid_argument("pictures of different sizes cannot be compared");
}

int codes_apart(double a, double b) {
    if (std::isnan(a) != std::isnan(b)) return 256;
    return std::abs(srgb_code(a) - srgb_code(b));
}

}  // namespace

Picture picture_of(const LinearImage& image) {
    Picture picture{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y) {
        const float* row = image.row(y);
        for (int x = 0; x < image.width; ++x) picture.pixels.push_back({row[3 * x], row[3 * x + 1], row[3 * x + 2]});
    }
    return picture;
}

std::uint8_t srgb_code(double linear) {
    if (!(linear > 0)) return 0;
    const double c = std::min(linear, 1.0);
    const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::floor(255 * encoded + 0.5));
}

PictureDifference compare(const Picture& actual, const Picture& expected, int steps) {
    require_same_size(actual, expected);
    PictureDifference difference;
    difference.pixels = static_cast<std::int64_t>(actual.pixels.size());
    double squares = 0;
    for (std::size_t i = 0; i < actual.pixels.size(); ++i) {
        const Rgb<double>&a = actual.pixels[i], &e = expected.pixels[i];
        int worst = 0;
        for (const auto& [x, y] : {std::pair{a.r, e.r}, std::pair{a.g, e.g}, std::pair{a.b, e.b}}) {
            const double apart = std::abs(x - y);
            squares += apart * apart;
            difference.max =
                std::isnan(apart) ? std::numeric_limits<double>::infinity() : std::max(difference.max, apart);
            worst = std::max(worst, codes_apart(x, y));
        }
        if (worst > steps) ++difference.pixels_off_by_more;
    }
    if (difference.pixels > 0) difference.rmse = std::sqrt(squares / (3.0 * static_cast<double>(difference.pixels)));
    return difference;
}

void write_png(const std::string& path, const Picture& picture) {
    write_png_codes(path, picture.width, picture.height, codes_of(picture));
}

std::string save_failure(const std::string& stem, const Picture& actual, const Picture& expected) {
    require_same_size(actual, expected);
    constexpr int kGain = 8;
    const Bytes a = codes_of(actual), e = codes_of(expected);
    Bytes apart;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const int step = std::abs(static_cast<unsigned char>(a[i]) - static_cast<unsigned char>(e[i]));
        apart.push_back(static_cast<char>(std::min(255, kGain * step)));
    }
    write_png(stem + "-actual.png", actual);
    write_png(stem + "-expected.png", expected);
    write_png_codes(stem + "-difference.png", actual.width, actual.height, apart);
    return "see " + stem + "-actual.png, -expected.png and -difference.png";
}

}  // namespace zerkalo::reference
