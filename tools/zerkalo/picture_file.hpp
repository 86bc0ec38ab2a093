// Picture files by name: which format a path means, writing a rendered picture, reading one to compare.
#pragma once

#include "core/image/image_view.hpp"
#include "platform/pixel.hpp"
#include "platform/whole_file.hpp"
#include "tools/zerkalo/picture_difference.hpp"

#include <string>

namespace zerkalo {

enum class PictureKind { png8, png16, pfm };

/// The format of an output path: .png (8 or 16 bits a channel by `depth`), .pfm (linear floats), "-" is PNG.
/// Throws Failure(usage) for any other name, and for a 16-bit depth where there is none.
PictureKind picture_kind(const std::string& path, int depth);

/// Starts an output file before the work, so that a wrong path fails early. Throws Failure(io_failed).
void open_picture(WholeFile& file, const std::string& path);

/// Writes and finishes the file. Throws Failure(io_failed); then no file is left.
void write_picture(WholeFile& file, const LinearImage& image, PictureKind kind);

/// Writes and finishes a PNG of 8-bit codes. Throws Failure(io_failed); then no file is left.
void write_codes(WholeFile& file, const SrgbPart& codes);

/// Reads a PNG (8 or 16 bits) or a PFM, told apart by their first bytes. Throws Failure(io_failed).
Picture read_picture(const std::string& path);

}  // namespace zerkalo
