// The oracle: the picture of a scene by a plain recursive ray tracer in double precision that shares no code with the
// renderer, only the structs of the scene. Pixel centres only: Settings::antialias, samples and exact_plan are ignored.
#pragma once

#include "tests/support/images.hpp"
#include "tests/support/reference_tracer.hpp"

namespace zerkalo {

/// Linear radiance of pixel (x, y), row 0 on top. Precondition: a valid scene.
/// `lobe_samples` >= 1 random directions at the first glossy mirror of a camera path, one at later ones.
/// The same arguments give the same value; another seed gives an independent estimate.
Rgb<double> reference_pixel(const Scene& scene, const Settings& settings, int x, int y, unsigned lobe_samples,
                            std::uint64_t seed);

/// The whole picture, on two threads: pixel by pixel what reference_pixel gives.
reference::Picture reference_picture(const Scene& scene, const Settings& settings, unsigned lobe_samples,
                                     std::uint64_t seed);

}  // namespace zerkalo
