// The PNG reader: libpng turns every kind of PNG into rows of 16-bit RGB, which are narrowed again where the file
// has 8.
#include "platform/png.hpp"

#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <new>
#include <png.h>

namespace zerkalo {
namespace {

struct Input {
    const char* path;
    std::FILE* file;
    IoStatus failure;
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    Input* input = static_cast<Input*>(png_get_error_ptr(png));
    if (input->failure.ok()) input->failure = io_failure(input->path, message);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep data, png_size_t size) {
    Input* input = static_cast<Input*>(png_get_io_ptr(png));
    if (std::fread(data, 1, size, input->file) == size) return;
    if (std::ferror(input->file) != 0) input->failure = io_failure(input->path, "cannot read", errno);
    png_error(png, "damaged PNG: the file ends too early");
}

// Owns libpng's memory while a picture is read.
struct Reader {
    png_structp png = nullptr;
    png_infop info = nullptr;

    explicit Reader(Input& input) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, on_error, on_warning);
        if (png != nullptr) info = png_create_info_struct(png);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

// May jump out. Leaves the size, and the number of passes: 1, or 7 for an interlaced picture.
bool read_header(png_structp png, png_infop info, CodePicture& picture, int& passes) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_info(png, info);
    const std::int64_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    if (width > kMaxFileSide || height > kMaxFileSide || width * height > kMaxFilePixels)
        png_error(png, "larger than 65536 on a side or 2^28 pixels");
    picture.width = static_cast<std::int32_t>(width);
    picture.height = static_cast<std::int32_t>(height);
    picture.depth = png_get_bit_depth(png, info) == 16 ? 16 : 8;
    png_set_expand_16(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    if (std::endian::native == std::endian::little) png_set_swap(png);
    passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

// May jump out, of libpng only: the vector's own exception passes no C frame.
bool read_rows(png_structp png, png_infop info, CodePicture& picture, int passes) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    const std::size_t row = static_cast<std::size_t>(picture.width) * 3;
    const std::size_t height = static_cast<std::size_t>(picture.height);
    // A plain picture grows with the rows that really come, so that a false header cannot fill the memory.
    picture.rgb.reserve(row * height);
    if (passes > 1) picture.rgb.resize(row * height);
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t y = 0; y < height; ++y) {
            if (picture.rgb.size() < row * (y + 1)) picture.rgb.resize(row * (y + 1));
            png_read_row(png, reinterpret_cast<png_bytep>(picture.rgb.data() + row * y), nullptr);
        }
    }
    png_read_end(png, info);
    return true;
}

IoStatus read_open_png(Input& input, CodePicture& picture) {
    unsigned char signature[8];
    const std::size_t length = std::fread(signature, 1, sizeof signature, input.file);
    if (std::ferror(input.file) != 0) return io_failure(input.path, "cannot read", errno);
    if (length < sizeof signature || png_sig_cmp(signature, 0, sizeof signature) != 0)
        return io_failure(input.path, "not a PNG file");
    std::rewind(input.file);

    const Reader reader(input);
    if (reader.info == nullptr) return io_failure(input.path, "not enough memory");
    png_set_read_fn(reader.png, &input, on_read);
    int passes = 1;
    picture.rgb.clear();
    if (!read_header(reader.png, reader.info, picture, passes)) return input.failure;
    if (!read_rows(reader.png, reader.info, picture, passes)) return input.failure;
    // Widening multiplied by 257: the high byte is the file's own code.
    if (picture.depth == 8)
        for (std::uint16_t& code : picture.rgb) code = static_cast<std::uint16_t>(code >> 8);
    return {};
}

}  // namespace

IoStatus read_png(const char* path, CodePicture& picture) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path, "rbe"), std::fclose);
    if (file == nullptr) return io_failure(path, "cannot open", errno);
    Input input{path, file.get(), {}};
    try {
        return read_open_png(input, picture);
    } catch (const std::bad_alloc&) {
        return io_failure(path, "not enough memory");
    }
}

}  // namespace zerkalo
