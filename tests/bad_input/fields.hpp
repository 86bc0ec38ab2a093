// The table of all numbers in a scene: how a Status names each, and where it lies.
#pragma once

#include "core/scene/scene.hpp"
#include "core/status.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace zerkalo::bad_input {

/// real: a double; whole: an int32; choice: an enumeration in one byte; truth: a bool.
enum class FieldType { real, whole, choice, truth };

struct Field {
    Part part;
    std::int32_t index;
    std::string name;  // the key, as a Status has it
    std::string also;  // the other field of a rule that binds two: a Status may name that one; or ""
    FieldType type;
    std::size_t offset;    // bytes from the beginning of the Scene
    std::size_t size;      // bytes
    std::uint8_t choices;  // of a choice: how many there are
};

/// Every number and choice of the scene's capacity, used or not, in the order of memory. Compiling fails when a part of
/// the scene gets a member that is not here.
std::vector<Field> all_fields(const Scene& scene);

/// Those that the scene's counts reach: of its lights, solids, mirrors, corners and triangles.
std::vector<Field> fields_in_use(const Scene& scene);

/// Overwrites the field in `scene` with the value of its own type.
void set(Scene& scene, const Field& field, double value);
void set(Scene& scene, const Field& field, std::int32_t value);
void set(Scene& scene, const Field& field, std::uint8_t value);

/// True when a refusal names this field, or the other one of a rule that binds both.
bool names(const Status& status, const Field& field);

/// "mirror 0 curvature_radius (byte 17448)"
std::string text_of(const Field& field);

}  // namespace zerkalo::bad_input
