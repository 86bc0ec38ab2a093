#include "tools/scene_file/file_bytes.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace zerkalo::scene_file {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace

FileBytes read_file(const std::filesystem::path& path, std::size_t limit) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (file == nullptr) return {{}, reason(errno)};
    FileBytes result;
    std::array<char, 16384> block;
    while (const std::size_t size = std::fread(block.data(), 1, block.size(), file.get())) {
        if (result.bytes.size() + size > limit) return {{}, {}, true};
        result.bytes.append(block.data(), size);
    }
    if (std::ferror(file.get()) != 0) return {{}, reason(errno)};
    return result;
}

}  // namespace zerkalo::scene_file
