// Scene files into one binary file of scenes. Usage: write_scenes OUT SCENE.toml...
#include "tests/proofs/matrix/scene_list.hpp"
#include "tools/scene_file/scene_file.hpp"

#include <cstdio>
#include <cstring>
#include <memory>

int main(int count, char** arguments) {
    using namespace zerkalo;
    if (count < 3) return std::fputs("usage: write_scenes OUT SCENE.toml...\n", stderr), 2;
    std::FILE* out = std::fopen(arguments[1], "wb");
    if (out == nullptr) return std::perror(arguments[1]), 1;
    const matrix::SceneListHeader header{static_cast<std::uint64_t>(count - 2), sizeof(matrix::NamedScene)};
    bool written = std::fwrite(&header, sizeof header, 1, out) == 1;
    for (int i = 2; i < count; ++i) {
        const LoadResult result = load_scene(arguments[i]);
        if (!result.ok()) return std::fputs(to_text(result).c_str(), stderr), 3;
        const auto named = std::make_unique<matrix::NamedScene>();
        std::strncpy(named->name, std::filesystem::path(arguments[i]).stem().c_str(), sizeof named->name - 1);
        named->scene = *result.scene;
        written = written && std::fwrite(named.get(), sizeof *named, 1, out) == 1;
    }
    return std::fclose(out) == 0 && written ? 0 : 1;
}
