// PFM: a text header of three lines, then rows of floats.
#include "platform/pfm.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace zerkalo {
namespace {

static_assert(std::endian::native == std::endian::little, "rows are written as they lie in memory");

constexpr std::size_t kTokenCapacity = 32;

// The next word of the header and the one white character that ends it; false at the file's end or a long word.
bool read_token(std::FILE* file, char (&token)[kTokenCapacity]) {
    int character = std::fgetc(file);
    while (character != EOF && std::isspace(character) != 0) character = std::fgetc(file);
    std::size_t length = 0;
    for (; character != EOF && std::isspace(character) == 0; character = std::fgetc(file)) {
        if (length + 1 == kTokenCapacity) return false;
        token[length++] = static_cast<char>(character);
    }
    token[length] = '\0';
    return length > 0 && character != EOF;
}

// A side in decimal digits, 1..kMaxFileSide; 0 when it is anything else.
std::int32_t side_of(const char* token) {
    std::int64_t side = 0;
    for (; *token != '\0'; ++token) {
        if (*token < '0' || *token > '9') return 0;
        side = side * 10 + (*token - '0');
        if (side > kMaxFileSide) return 0;
    }
    return static_cast<std::int32_t>(side);
}

struct Header {
    std::int32_t width = 0, height = 0;
    std::size_t channels = 3;
    bool big_endian = false;
};

// nullptr, or what is wrong with the header.
const char* read_header(std::FILE* file, Header& header) {
    char token[kTokenCapacity];
    if (!read_token(file, token) || (std::strcmp(token, "PF") != 0 && std::strcmp(token, "Pf") != 0))
        return "not a PFM file (it must begin with PF or Pf)";
    header.channels = token[1] == 'F' ? 3 : 1;
    if (!read_token(file, token) || (header.width = side_of(token)) == 0)
        return "damaged PFM: width must be 1 to 65536";
    if (!read_token(file, token) || (header.height = side_of(token)) == 0)
        return "damaged PFM: height must be 1 to 65536";
    if (std::int64_t{header.width} * header.height > kMaxFilePixels) return "larger than 2^28 pixels";
    char* end = nullptr;
    const bool complete = read_token(file, token);
    const double scale = std::strtod(token, &end);
    if (!complete || *end != '\0' || !std::isfinite(scale) || scale == 0)
        return "damaged PFM: the scale must be a number other than 0";
    header.big_endian = scale > 0;
    return nullptr;
}

float byte_swapped(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    return std::bit_cast<float>(bits >> 24 | (bits >> 8 & 0xff00u) | (bits & 0xff00u) << 8 | bits << 24);
}

// A row as it came -> RGB in this machine's byte order, in place; grey is spread from the end.
void finish_row(const Header& header, float* row) {
    const std::size_t width = static_cast<std::size_t>(header.width);
    if (header.big_endian)
        for (std::size_t i = 0; i < width * header.channels; ++i) row[i] = byte_swapped(row[i]);
    if (header.channels == 1)
        for (std::size_t i = width; i-- > 0;) row[3 * i] = row[3 * i + 1] = row[3 * i + 2] = row[i];
}

IoStatus read_open_pfm(const char* path, std::FILE* file, LinearPicture& picture) {
    Header header;
    const char* wrong = read_header(file, header);
    if (std::ferror(file) != 0) return io_failure(path, "cannot read", errno);
    if (wrong != nullptr) return io_failure(path, wrong);

    const std::size_t width = static_cast<std::size_t>(header.width), height = static_cast<std::size_t>(header.height);
    picture.width = header.width;
    picture.height = header.height;
    picture.rgb.clear();
    picture.rgb.reserve(3 * width * height);
    // Rows come bottom up: append what really comes, then turn the picture over.
    for (std::size_t y = 0; y < height; ++y) {
        picture.rgb.resize(3 * width * (y + 1));
        float* row = picture.rgb.data() + 3 * width * y;
        if (std::fread(row, sizeof(float), width * header.channels, file) != width * header.channels)
            return std::ferror(file) != 0 ? io_failure(path, "cannot read", errno)
                                          : io_failure(path, "damaged PFM: the file ends too early");
        finish_row(header, row);
    }
    if (std::fgetc(file) != EOF) return io_failure(path, "damaged PFM: the file goes on after the last row");
    for (std::size_t y = 0; y < height / 2; ++y)
        std::swap_ranges(picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * width * y),
                         picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * width * (y + 1)),
                         picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * width * (height - 1 - y)));
    return {};
}

}  // namespace

IoStatus write_pfm(WholeFile& file, const LinearImage& picture) {
    if (picture.width < 1 || picture.height < 1) return io_failure(file.name(), "a picture without pixels");
    char header[64];
    const int length = std::snprintf(header, sizeof header, "PF\n%d %d\n-1.0\n", picture.width, picture.height);
    if (const IoStatus status = file.write(header, static_cast<std::size_t>(length)); !status.ok()) return status;
    for (std::int32_t y = picture.height; y-- > 0;) {
        const std::size_t bytes = static_cast<std::size_t>(picture.width) * 3 * sizeof(float);
        if (const IoStatus status = file.write(picture.row(y), bytes); !status.ok()) return status;
    }
    return {};
}

IoStatus read_pfm(const char* path, LinearPicture& picture) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path, "rbe"), std::fclose);
    if (file == nullptr) return io_failure(path, "cannot open", errno);
    try {
        return read_open_pfm(path, file.get(), picture);
    } catch (const std::bad_alloc&) {
        return io_failure(path, "not enough memory");
    }
}

}  // namespace zerkalo
