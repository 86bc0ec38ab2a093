// The rules that place lobe samples, and settings that ask for one.
#pragma once

#include "tests/laws/rendering.hpp"

namespace zerkalo::laws {

inline constexpr Estimator kRules[] = {Estimator::random, Estimator::jittered, Estimator::sobol, Estimator::r2,
                                       Estimator::fibonacci};
inline constexpr Estimator kKeyed[] = {Estimator::random, Estimator::jittered, Estimator::sobol, Estimator::r2};

inline Settings placed_by(Estimator rule, std::int32_t samples, std::int32_t rotation) {
    Settings settings;
    settings.estimator = rule;
    settings.samples = samples;
    settings.rotation = rotation;
    return settings;
}

}  // namespace zerkalo::laws
