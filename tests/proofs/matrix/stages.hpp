// The stages on the way to a picture, for the camera rays of all its pixels: computed by the core's own functions, so
// that two builds whose pictures differ can be asked where they part.
#pragma once

#include "core/render/plan.hpp"

#include <vector>

namespace zerkalo::matrix {

/// camera_ray: origin, direction, least t. hit: t, surface, face, side. normal: towards the ray, 0 where nothing is
/// hit.
enum Stage { kCameraRay, kHit, kNormal, kStageCount };
constexpr const char* kStageNames[kStageCount] = {"camera-ray", "hit", "normal"};
constexpr int kStageValues[kStageCount] = {7, 4, 3};

/// Row-major, kStageValues floats a pixel.
struct StageImages {
    std::vector<float> values[kStageCount];
};

using StageFunction = void (*)(const Plan& plan, StageImages& out);

// One for each instruction set: those that this program was built without do not exist.
void stages_scalar(const Plan& plan, StageImages& out);
void stages_sse2(const Plan& plan, StageImages& out);
void stages_sse4_2(const Plan& plan, StageImages& out);
void stages_avx2(const Plan& plan, StageImages& out);
void stages_avx512(const Plan& plan, StageImages& out);
void stages_neon(const Plan& plan, StageImages& out);

}  // namespace zerkalo::matrix
