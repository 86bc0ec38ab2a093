// PFM files: the linear picture as it is, three 32-bit floats a pixel, bottom row first.
// Source: Debevec, "Portable FloatMap Image Format": "PF", width height, scale (its sign is the byte order), rows.
#pragma once

#include "platform/picture.hpp"
#include "platform/whole_file.hpp"

namespace zerkalo {

/// Writes `picture`, little-endian (scale -1), to an open `file`; commit() is the caller's. Heap: none.
/// Errors: those of WholeFile::write, an empty picture.
IoStatus write_pfm(WholeFile& file, const LinearImage& picture);

/// Reads colour (PF) and grey (Pf, becomes RGB) in both byte orders; the scale's size is ignored. Errors name the file:
/// unreadable, not a PFM, damaged, too short or too long, too large, no memory; then `picture` is unspecified.
IoStatus read_pfm(const char* path, LinearPicture& picture);

}  // namespace zerkalo
