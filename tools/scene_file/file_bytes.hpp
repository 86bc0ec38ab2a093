// A whole file into memory, refusing those that are larger than they may be.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace zerkalo::scene_file {

struct FileBytes {
    std::string bytes;
    std::string fault;       // why it could not be read, or empty
    bool too_large = false;  // then `bytes` is empty
};

/// Reads at most `limit` bytes. Never throws; memory stays below twice the limit whatever the file is.
FileBytes read_file(const std::filesystem::path& path, std::size_t limit);

}  // namespace zerkalo::scene_file
