// The outcome of everything in the library that can fail: a value, never an exception.
#pragma once

#include <cstdint>

namespace zerkalo {

/// The part of a scene (or of the settings) that a Status speaks of.
enum class Part : std::uint8_t { none, scene, image, camera, light, solid, mirror, settings };

/// Ok, or the one field that is wrong. `field` and `reason` point to string literals.
/// `field` is the key of the scene file (docs: README, "The scene file"); `index` counts from 0 within the part.
struct [[nodiscard]] Status {
    const char* field = nullptr;
    const char* reason = nullptr;
    Part part = Part::none;
    std::int32_t index = 0;

    constexpr bool ok() const { return reason == nullptr; }
};

constexpr Status kOk{};

/// "camera", "light", ...: the table's name in a scene file.
constexpr const char* name_of(Part part) {
    switch (part) {
        case Part::scene: return "scene";
        case Part::image: return "image";
        case Part::camera: return "camera";
        case Part::light: return "light";
        case Part::solid: return "solid";
        case Part::mirror: return "mirror";
        case Part::settings: return "settings";
        case Part::none: break;
    }
    return "";
}

}  // namespace zerkalo
