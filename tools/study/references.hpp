// What the errors of a study are measured against: two pictures of a scene that share no ray, by two quadratures.
#pragma once

#include "tools/study/regions.hpp"

#include <string>

namespace zerkalo::study {

/// The mean of both, and their RMSE from one another by region: what is less than this cannot be told.
struct References {
    LightPicture mean;
    std::array<double, kRegionCount> zone{};
};

/// How much a reference takes: so many lobe rays a camera ray, in frames of at most kFrameSamples.
struct ReferenceEffort {
    std::int32_t samples = 0;
    std::int32_t antialias = 1;
};

/// Up to here the culling of the lobe's far rays changes no byte (core/README.md).
constexpr std::int32_t kFrameSamples = 1024;

/// Renders both in double, A by the lattice (fibonacci), B by scrambled Sobol points (sobol), each the mean over
/// rotations of its own that no row uses; or reads them from `folder`, where they are kept as NAME-a.pfm and
/// NAME-b.pfm. What is measured against is what the files hold. Throws Failure(io_failed), and as rendered() does.
References references_of(const Renderer& renderer, const Scene& scene, const ImageSize& size,
                         const ReferenceEffort& effort, const Regions& regions, const std::string& folder,
                         const std::string& name);

/// Of two pictures that are there already.
References references_of(const LightPicture& a, const LightPicture& b, const Regions& regions);

}  // namespace zerkalo::study
