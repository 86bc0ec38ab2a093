// One setting of a study: a way to render one of its scenes. Every row of the results belongs to one.
#pragma once

#include "core/render/settings.hpp"
#include "tools/zerkalo/frame.hpp"

namespace zerkalo::study {

struct Setting {
    int scene = 0;  // of the plan
    Number number = Number::floating;
    Estimator estimator = Estimator::fibonacci;
    std::int32_t samples = 1;
    std::int32_t antialias = 1;
    double asked_error =
        0;  // above 0: as many samples as reach it, tile by tile (`render --error`), and `samples` is 0
};

/// For the renderer. `rotation` is one of the equally good placements of the lobe rays.
inline Settings settings_of(const Setting& setting, const ImageSize& size, std::int32_t rotation) {
    Settings settings;
    settings.width = size.width;
    settings.height = size.height;
    if (setting.samples > 0) settings.samples = setting.samples;
    settings.antialias = setting.antialias;
    settings.estimator = setting.estimator;
    settings.rotation = rotation;
    return settings;
}

}  // namespace zerkalo::study
