// Rendering in passes on the host: until an error is reached, or for a time; threads, clock and signals around the core.
#pragma once

#include "core/render/progressive.hpp"
#include "tools/zerkalo/frame.hpp"

#include <atomic>
#include <chrono>

namespace zerkalo {

/// What became of a picture in passes.
struct Refined {
    double estimated = 0;           // root of the mean square over pixels and channels, linear light
    bool reached = true;            // the error asked for, or every tile had all the samples that it may have
    std::int32_t passes = 0;        // over the picture or a part of it
    std::int64_t most_samples = 0;  // lobe rays of a hit where there were most
    FrameCost cost;
};

/// Renders until the estimated error is at most `error`, until no tile may have more samples, or until `stopped`. The
/// survey is always finished, so the picture is whole. Deterministic unless stopped.
Refined refine_to_error(const Frame& frame, double error, const std::atomic<bool>& stopped, bool progress);

/// The best picture in the time: the same passes, chosen by how fast they are, so not deterministic.
Refined refine_for(const Frame& frame, std::chrono::duration<double> time, const std::atomic<bool>& stopped,
                   bool progress);

}  // namespace zerkalo
