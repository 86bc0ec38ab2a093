#include "tools/study/goals.hpp"

#include "tools/zerkalo/messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace zerkalo::study {
namespace {

constexpr double kHalfStep = 1.0 / 510;
constexpr const char* kBenchmark = "gold-mirror-5";
constexpr const char* kLattice = "fibonacci";
constexpr const char* kCoverage = "fibonacci+coverage";

std::string told(const Row& row) {
    return format("%s N = %lld, %.3g ms", row.estimator.c_str(), static_cast<long long>(row.samples),
                  1e3 * row.seconds.value);
}

std::vector<const Row*> float_rows(const std::vector<Row>& rows, const std::string& scene) {
    std::vector<const Row*> of_scene = rows_of_scene(rows, scene);
    std::erase_if(of_scene, [&](const Row* row) { return row->number != "float" || row->antialias != 1; });
    return of_scene;
}

std::vector<const Row*> without_asked(std::vector<const Row*> rows) {
    std::erase_if(rows, [](const Row* row) { return row->asked_error > 0; });
    return rows;
}

const Row* row_with(const std::vector<const Row*>& rows, const std::string& estimator, std::int64_t samples) {
    for (const Row* row : rows) {
        if (row->estimator == estimator && row->samples == samples) return row;
    }
    return nullptr;
}

// The row with the fewest lobe rays whose error is half an 8-bit step.
Goal rays_goal(const std::vector<const Row*>& rows, const std::string& scene, double most) {
    Goal goal{format("%s: RMSE 1/510 with at most %g lobe rays a mirror pixel", scene.c_str(), most),
              "no setting reaches 1/510", false};
    const Row* best = nullptr;
    for (const Row* row : rows) {
        if (error_in(*row, Region::mirror) > kHalfStep) continue;
        if (!best || lobe_rays_a_pixel(*row) < lobe_rays_a_pixel(*best)) best = row;
    }
    if (!best) return goal;
    goal.reached = format("%.2f rays (%s, RMSE %.2e)", lobe_rays_a_pixel(*best), told(*best).c_str(),
                          error_in(*best, Region::mirror));
    goal.met = lobe_rays_a_pixel(*best) <= most;
    return goal;
}

// One step of 8-bit sRGB in the time of eight samples of the plain lattice.
Goal step_goal(const std::vector<const Row*>& rows) {
    Goal goal{std::string(kBenchmark) + ": one 8-bit sRGB step in the time of fibonacci N = 8", "", false};
    const Row *plain = row_with(rows, kLattice, 8), *best = nullptr;
    for (const Row* row : rows) {
        if (srgb_steps(*row) <= 1 && (!best || row->seconds.value < best->seconds.value)) best = row;
    }
    if (!plain || !best) {
        goal.reached = !plain ? "fibonacci N = 8 is not in this study" : "no setting reaches it";
        return goal;
    }
    goal.reached = format("%.2f times that time (%s; fibonacci N = 8 takes %.3g ms)",
                          best->seconds.value / plain->seconds.value, told(*best).c_str(), 1e3 * plain->seconds.value);
    goal.met = best->seconds.value <= plain->seconds.value;
    return goal;
}

// How many times less error the control variate has at equal samples: the least of all numbers of samples counts.
Goal variate_goal(const std::vector<const Row*>& rows, const std::string& scene, double least) {
    Goal goal{format("%s: control variate, at least %g times less RMSE at equal N", scene.c_str(), least),
              "fibonacci+coverage is not in this study, or not resolved", false};
    const Row *worst = nullptr, *best = nullptr;
    const auto ratio = [&](const Row& covered) {
        return error_in(*row_with(rows, kLattice, covered.samples), Region::mirror) / error_in(covered, Region::mirror);
    };
    for (const Row* row : rows) {
        if (row->estimator != kCoverage || !row->resolved() || !row_with(rows, kLattice, row->samples)) continue;
        if (!worst || ratio(*row) < ratio(*worst)) worst = row;
        if (!best || ratio(*row) > ratio(*best)) best = row;
    }
    if (!worst) return goal;
    goal.reached = format("%.1f times at N = %lld to %.1f times at N = %lld", ratio(*worst),
                          static_cast<long long>(worst->samples), ratio(*best), static_cast<long long>(best->samples));
    goal.met = ratio(*worst) >= least;
    return goal;
}

Goal slope_goal(const std::vector<const Row*>& rows, const std::string& scene, Region region, double most) {
    const char* name = kRegionNames[static_cast<int>(region)];
    Goal goal{format("%s: slope of fibonacci at most %g on %s", scene.c_str(), most, name),
              "fewer than three resolved rows", false};
    for (const Series& series : series_of(rows)) {
        const Estimate& slope = series.slope(region);
        if (series.estimator != kLattice || std::isnan(slope.value)) continue;
        goal.reached = format("%.2f (%.2f to %.2f)", slope.value, slope.low, slope.high);
        goal.met = slope.value <= most;
    }
    return goal;
}

// Of one scene: time to the error that was asked for, in times of the best setting of equal samples that reaches it.
// Infinite where the error was not reached; nothing without such rows.
std::optional<double> asked_ratio(const std::vector<const Row*>& rows, double error) {
    const std::vector<const Row*> fixed = without_asked(rows);
    const Row *best = cheapest(fixed, Region::picture, error), *asked = nullptr;
    bool there = false;
    for (const Row* row : rows) {
        if (row->asked_error != error) continue;
        there = true;
        if (error_in(*row, Region::picture) > error) continue;
        if (!asked || row->seconds.value < asked->seconds.value) asked = row;
    }
    if (!there || !best) return std::nullopt;
    return asked ? asked->seconds.value / best->seconds.value : std::numeric_limits<double>::infinity();
}

std::optional<Goal> asked_goal(const std::vector<Row>& rows) {
    constexpr double kError = 0.002, kMost = 1.3;
    std::string dearer, larger;
    std::vector<double> ratios;
    const auto list = [](std::string& names, const std::string& scene) {
        names += (names.empty() ? "" : ", ") + scene;
    };
    for (const std::string& scene : scenes_of(rows)) {
        const auto ratio = asked_ratio(float_rows(rows, scene), kError);
        if (!ratio) continue;
        if (std::isinf(*ratio)) {
            list(larger, scene);
            continue;
        }
        ratios.push_back(*ratio);
        if (*ratio > kMost) list(dearer, scene);
    }
    if (ratios.empty() && larger.empty()) return std::nullopt;
    std::string reached = "on no scene";
    if (!ratios.empty()) {
        const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
        reached = format("%.2f to %.2f times on %zu scenes", *least, *most, ratios.size());
    }
    if (!dearer.empty()) reached += format("; more than %g on ", kMost) + dearer;
    if (!larger.empty()) reached += "; a larger error on " + larger;
    return Goal{
        format("--error %g in at most %g times the time of the best equal samples, whole picture", kError, kMost),
        reached, dearer.empty() && larger.empty()};
}

}  // namespace

double srgb_steps(const Row& row) { return 255 * std::pow(10, -row.of(Region::mirror).total.psnr / 20); }

double lobe_rays_a_pixel(const Row& row) {
    const auto pixels = std::max<std::int64_t>(row.of(Region::mirror).pixels, 1);
    return static_cast<double>(row.rays.lobe) / static_cast<double>(pixels);
}

std::vector<Goal> goals_of(const std::vector<Row>& rows) {
    std::vector<Goal> goals;
    for (const std::string& scene : scenes_of(rows)) {
        const std::vector<const Row*> of_scene = without_asked(float_rows(rows, scene));
        const bool polyhedron = scene == "prism@1000" || scene == "pyramid@1000";
        if (scene == "sphere@1000") goals.push_back(rays_goal(of_scene, scene, 4));
        if (polyhedron) goals.push_back(rays_goal(of_scene, scene, 2));
        if (scene == kBenchmark) goals.push_back(step_goal(of_scene));
        if (polyhedron) goals.push_back(variate_goal(of_scene, scene, 10));
        if (scene == kBenchmark) goals.push_back(variate_goal(of_scene, scene, 4));
        if (scene == kBenchmark || polyhedron) goals.push_back(slope_goal(of_scene, scene, Region::edges, -0.72));
        if (scene == "sphere" || scene == "sphere@1000") {
            goals.push_back(slope_goal(of_scene, scene, Region::smooth, -1.5));
        }
    }
    if (const auto goal = asked_goal(rows)) goals.push_back(*goal);
    return goals;
}

}  // namespace zerkalo::study
