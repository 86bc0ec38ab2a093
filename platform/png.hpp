// PNG files: 8 and 16 bit RGB written row by row as the linear picture is resolved; any PNG read.
// Source: ISO/IEC 15948, libpng.
#pragma once

#include "platform/picture.hpp"
#include "platform/pixel.hpp"
#include "platform/whole_file.hpp"

namespace zerkalo {

enum class PngDepth : std::uint8_t { eight = 8, sixteen = 16 };

/// Resolves `picture` and writes it to an open `file`; commit() is the caller's. Heap: one row and libpng's 0.4 MB.
/// Errors: those of WholeFile::write, no memory, an empty picture.
IoStatus write_png(WholeFile& file, const LinearImage& picture, PngDepth depth);

/// The same for codes that are resolved already (a display's frame): 8 bit.
IoStatus write_png(WholeFile& file, const SrgbPart& picture);

/// Reads any PNG: grey and palettes become RGB, alpha is dropped, less than 8 bits become 8, interlaced or not; colour
/// profiles and gamma are ignored. Errors name the file: unreadable, not a PNG, damaged, too large, no memory; then
/// `picture` is unspecified.
IoStatus read_png(const char* path, CodePicture& picture);

}  // namespace zerkalo
