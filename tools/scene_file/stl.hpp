// Triangle meshes in STL, binary and ASCII. Source: M. Burns, Automated Fabrication, 1993, section 6.5.
// Facet normals and attribute bytes are not used: the corners' order says which side is outside.
#pragma once

#include "core/scene/scene.hpp"
#include "tools/scene_file/source_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace zerkalo::scene_file {

/// What is wrong with an STL file; line 0 in a binary one.
struct StlFault {
    Position at;
    std::string message;
};

/// Appends the triangles, at most `room`. The first word alone does not make a file ASCII: many binary ones begin with
/// "solid" too.
std::optional<StlFault> read_stl(const SourceText& file, int room, std::vector<Triangle>& triangles);

/// The two formats. Preconditions: as detected by read_stl.
std::optional<StlFault> read_binary_stl(std::string_view bytes, int room, std::vector<Triangle>& triangles);
std::optional<StlFault> read_ascii_stl(const SourceText& file, int room, std::vector<Triangle>& triangles);

/// "more than ... triangles" with the limit of a scene.
std::string too_many_triangles(int room);

}  // namespace zerkalo::scene_file
