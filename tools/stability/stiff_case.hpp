// A stiff or extreme case: an input at which the textbook formula fails, the law that must hold there all the same, and
// the error against that law, of the renderer and of a naive twin.
#pragma once

#include "tools/stability/stage.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace zerkalo::stability {

/// Where fixed point differs from float.
struct InFixed {
    const char* refused = "";  // the field that prepare() names of scenes in this case that the formats cannot hold
    bool every_scene = false;  // none is left to judge
    double bound = -1;         // below 0: that of float
};

struct StiffCase {
    const char* id;       // "S01"
    const char* input;    // the scene, in a few words
    const char* failure;  // what the textbook formula does with it
    const char* law;      // what must hold; the error is the distance from it
    const char* unit;     // of the three numbers: "wrong pixels", "relative", "steps of 255", ...
    double bound;         // the largest error that keeps the law
    /// The renderer's error. Calls for the same bits at every instruction set.
    double (*ours)(const Stage& stage);
    /// The error of the naive twin: the formula that a textbook gives, in float. Beyond the bound, or not a number.
    double (*naive)();
    InFixed in_fixed = {};
};

/// What became of a case in a number system.
struct Verdict {
    std::optional<double> error;  // nothing where no scene could be judged
    std::string refused;          // the field of a scene that the formats could not hold, if there was one
    bool holds;
};

/// Plays a case by one instruction set. Throws Refused when a float stage refuses a scene: a fault of the case.
Verdict judge(const StiffCase& row, Isa isa, Number number);

/// The largest error that keeps the law in a number system.
inline double bound_of(const StiffCase& row, Number number) {
    return number == Number::fixed && row.in_fixed.bound >= 0 ? row.in_fixed.bound : row.bound;
}

/// Whether a textbook's error breaks the law; NaN does.
inline bool breaks(const StiffCase& row, double error) { return !(error <= row.bound); }

/// All cases by number.
std::vector<StiffCase> all_cases();

/// The cases of one file each, in the order of their numbers.
std::span<const StiffCase> aimed_ray_rows();
std::span<const StiffCase> bad_number_rows();
std::span<const StiffCase> bounce_rows();
std::span<const StiffCase> camera_frame_rows();
std::span<const StiffCase> camera_place_rows();
std::span<const StiffCase> contact_rows();
std::span<const StiffCase> edge_rows();
std::span<const StiffCase> far_camera_rows();
std::span<const StiffCase> format_rows();
std::span<const StiffCase> glass_rows();
std::span<const StiffCase> hemisphere_rows();
std::span<const StiffCase> lamp_rows();
std::span<const StiffCase> light_rows();
std::span<const StiffCase> lobe_rows();
std::span<const StiffCase> machine_rows();
std::span<const StiffCase> mirror_curvature_rows();
std::span<const StiffCase> parallel_ray_rows();
std::span<const StiffCase> picture_rows();
std::span<const StiffCase> polish_rows();
std::span<const StiffCase> refusal_rows();
std::span<const StiffCase> scaling_rows();
std::span<const StiffCase> solid_size_rows();
std::span<const StiffCase> sphere_rows();
std::span<const StiffCase> sun_rows();
std::span<const StiffCase> symmetry_rows();
std::span<const StiffCase> taper_rows();

}  // namespace zerkalo::stability
