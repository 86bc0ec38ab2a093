#include "tools/zerkalo/scene_input.hpp"

#include "tools/scene_file/scene_file.hpp"
#include "tools/zerkalo/failure.hpp"

#include <cstdio>
#include <utility>

namespace zerkalo {

SceneInput read_scene(const std::string& path) {
    LoadResult result = load_scene(path);
    if (!result.ok()) {
        std::fputs(to_text(result).c_str(), stderr);
        throw Failure(static_cast<ExitCode>(result.exit_code), "");
    }
    return {std::move(result.scene), std::move(result.title)};
}

}  // namespace zerkalo
