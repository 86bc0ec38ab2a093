// Scenes in one binary file: for machines on which nothing reads scene files. Little-endian, doubles aligned to 8.
#pragma once

#include "core/scene/scene.hpp"

#include <type_traits>

namespace zerkalo::matrix {

struct NamedScene {
    char name[64];
    Scene scene;
};
static_assert(std::is_trivially_copyable_v<NamedScene>);

/// The file begins with it; a machine that lays scenes out otherwise sees another size.
struct SceneListHeader {
    std::uint64_t count, scene_size;
};

}  // namespace zerkalo::matrix
