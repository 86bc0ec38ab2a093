#include "tools/study/row_runner.hpp"

#include "tools/zerkalo/refine.hpp"

#include <limits>
#include <optional>

namespace zerkalo::study {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Row begun_row(const StudyPlan& plan, const Setting& setting) {
    const PlannedScene& planned = plan.scene_of(setting);
    Row row;
    row.scene = planned.name;
    row.lobe = planned.lobe;
    row.lobe_exponent = planned.lobe_exponent;
    row.number = name_of(setting.number);
    row.estimator = zerkalo::name_of(setting.estimator);
    row.samples = setting.samples;
    row.antialias = setting.antialias;
    row.asked_error = setting.asked_error;
    row.width = plan.wish.size.width;
    row.height = plan.wish.size.height;
    row.rotations = plan.wish.rotations;
    return row;
}

LightPicture picture_of(const StudyPlan& plan, const Setting& setting, const Renderer& renderer, std::int32_t rotation,
                        RayCounts* rays) {
    const Scene& scene = *plan.scene_of(setting).scene;
    const Settings settings = settings_of(setting, plan.wish.size, rotation);
    if (setting.asked_error > 0) return rendered_to_error(renderer, scene, settings, setting.asked_error, rays);
    return rendered(renderer, scene, settings, setting.number, rays);
}

// The picture of rotation 0, its error split by cause. Without its rays in double (`exact`) a part is not known.
void split_errors(Row& row, const SceneFacts& facts, const LightPicture& picture,
                  const std::optional<LightPicture>& exact) {
    const LightPicture& reference = facts.references.mean;
    const LightPicture light = clipped(picture);
    const LightPicture of8 = quantised(light, 8), of10 = quantised(light, 10), of16 = quantised(light, 16);
    for (std::size_t r = 0; r < facts.regions.size(); ++r) {
        const Mask& mask = facts.regions[r];
        RegionErrors& errors = row.regions[r];
        errors.pixels = pixels_of(mask);
        errors.total = error_figures(picture, reference, mask);
        errors.arithmetic = exact ? rmse_of(picture, *exact, mask) : kUnknown;
        errors.quadrature = exact ? rmse_of(*exact, reference, mask) : kUnknown;
        errors.quantised8 = rmse_of(of8, light, mask);
        errors.quantised10 = rmse_of(of10, light, mask);
        errors.quantised16 = rmse_of(of16, light, mask);
        errors.zone = facts.references.zone[r];
    }
}

// The errors of all rotations; the first is that of row.regions already.
void spread_errors(Row& row, const StudyPlan& plan, const Setting& setting, const SceneFacts& facts,
                   const Renderer& renderer) {
    std::array<std::vector<double>, kRegionCount> errors;
    for (std::size_t r = 0; r < errors.size(); ++r) errors[r].push_back(row.regions[r].total.rmse);
    for (std::int32_t rotation = 1; rotation < plan.wish.rotations; ++rotation) {
        const LightPicture picture = picture_of(plan, setting, renderer, rotation, nullptr);
        for (std::size_t r = 0; r < errors.size(); ++r) {
            errors[r].push_back(rmse_of(picture, facts.references.mean, facts.regions[r]));
        }
    }
    for (std::size_t r = 0; r < errors.size(); ++r) row.regions[r].over_rotations = mean_and_spread(errors[r]);
}

void time_row(Row& row, const StudyPlan& plan, const Setting& setting, const Renderer& renderer, const Timing& timing) {
    const Frame frame = prepare_frame(*plan.scene_of(setting).scene, settings_of(setting, plan.wish.size, 0),
                                      renderer.isa, timing.threads, setting.number);
    const std::atomic<bool> never{false};
    const auto render = [&] {
        if (setting.asked_error == 0) return render_frame(frame, 1, false).seconds.front();
        return refine_to_error(frame, setting.asked_error, never, false).cost.seconds.front();
    };
    render();  // warms caches and branch predictors up
    std::vector<double> seconds;
    double spent = 0;
    while (static_cast<int>(seconds.size()) < kMostRepetitions) {
        if (static_cast<int>(seconds.size()) >= kLeastRepetitions && spent >= timing.budget_seconds) break;
        if (renderer.stopped && renderer.stopped->load(std::memory_order_relaxed)) throw Interrupted();
        seconds.push_back(render());
        spent += seconds.back();
    }
    row.isa = zerkalo::name_of(frame.isa);
    row.lanes = frame.lanes;
    row.threads = frame.threads;
    row.repetitions = static_cast<std::int64_t>(seconds.size());
    row.seconds = median_with_interval(std::move(seconds));
}

}  // namespace

Row run_row(const StudyPlan& plan, const Setting& setting, const SceneFacts& facts, const Renderer& renderer,
            const Timing& timing) {
    Row row = begun_row(plan, setting);
    const LightPicture picture = picture_of(plan, setting, renderer, 0, &row.rays);
    std::optional<LightPicture> exact;
    if (setting.asked_error == 0) {
        exact = rendered_exactly(renderer, *plan.scene_of(setting).scene, settings_of(setting, plan.wish.size, 0));
    }
    split_errors(row, facts, picture, exact);
    spread_errors(row, plan, setting, facts, renderer);
    time_row(row, plan, setting, renderer, timing);
    return row;
}

}  // namespace zerkalo::study
