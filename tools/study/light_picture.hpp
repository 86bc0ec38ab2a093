// Linear pictures in double and how a study gets them: from the kernels, and from the same samples in double.
#pragma once

#include "tools/zerkalo/frame.hpp"

#include <atomic>
#include <exception>
#include <vector>

namespace zerkalo::study {

/// Linear RGB, row-major, row 0 on top, without padding.
struct LightPicture {
    std::int32_t width = 0, height = 0;
    std::vector<double> rgb;
};

/// How pictures whose time does not matter are rendered, and what ends the work early.
struct Renderer {
    Isa isa = Isa::scalar;
    int threads = 1;
    const std::atomic<bool>* stopped = nullptr;
};

/// Thrown between two pictures once `stopped` is set.
struct Interrupted : std::exception {};

/// The picture and, when wanted, its rays. Throws Interrupted, and Failure when the scene or a setting is refused.
LightPicture rendered(const Renderer& renderer, const Scene& scene, const Settings& settings, Number number,
                      RayCounts* rays = nullptr);

/// The picture whose estimated error is `error`, as `render --error` makes it, in float. Throws as rendered() does.
LightPicture rendered_to_error(const Renderer& renderer, const Scene& scene, const Settings& settings, double error,
                               RayCounts* rays = nullptr);

/// The same rays in double: the picture without the errors of arithmetic, rounded to float once. Throws as rendered()
/// does.
LightPicture rendered_exactly(const Renderer& renderer, const Scene& scene, const Settings& settings);

/// The values as they are.
LightPicture light_of(const LinearImage& image);

}  // namespace zerkalo::study
