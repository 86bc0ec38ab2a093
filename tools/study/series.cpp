#include "tools/study/series.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::study {
namespace {

bool belongs(const Series& series, const Row& row) {
    return series.scene == row.scene && series.number == row.number && series.estimator == row.estimator &&
           series.antialias == row.antialias && series.asked == (row.asked_error > 0);
}

/// Over the resolved rows from so many samples on.
Estimate slope_from(const Series& series, Region region, std::int64_t first) {
    std::vector<double> samples, errors;
    for (const Row* row : series.rows) {
        const double error = error_in(*row, region);
        if (row->samples < first || error <= row->of(region).zone || error <= 0) continue;
        samples.push_back(static_cast<double>(row->samples));
        errors.push_back(error);
    }
    return log_log_slope(samples, errors);
}

Estimate slope_of(const Series& series, Region region) {
    const Estimate slope = slope_from(series, region, kFirstFittedSamples);
    return std::isnan(slope.value) ? slope_from(series, region, kFirstFittedOfFew) : slope;
}

}  // namespace

std::vector<Series> series_of(const std::vector<Row>& rows) {
    std::vector<const Row*> pointers;
    for (const Row& row : rows) pointers.push_back(&row);
    return series_of(pointers);
}

std::vector<Series> series_of(const std::vector<const Row*>& rows) {
    std::vector<Series> all;
    for (const Row* row : rows) {
        auto place = std::find_if(all.begin(), all.end(), [&](const Series& s) { return belongs(s, *row); });
        if (place == all.end()) {
            all.push_back({row->scene, row->number, row->estimator, row->antialias, row->asked_error > 0, {}, {}});
            place = all.end() - 1;
        }
        place->rows.push_back(row);
    }
    for (Series& series : all) {
        std::stable_sort(series.rows.begin(), series.rows.end(),
                         [](const Row* a, const Row* b) { return a->samples < b->samples; });
        for (int r = 0; r < kRegionCount; ++r) {
            series.slopes[static_cast<std::size_t>(r)] = slope_of(series, static_cast<Region>(r));
        }
    }
    return all;
}

std::vector<std::string> scenes_of(const std::vector<Row>& rows) {
    std::vector<std::string> scenes;
    for (const Row& row : rows) {
        if (std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
    }
    return scenes;
}

std::vector<const Row*> rows_of_scene(const std::vector<Row>& rows, const std::string& scene) {
    std::vector<const Row*> of_scene;
    for (const Row& row : rows) {
        if (row.scene == scene) of_scene.push_back(&row);
    }
    return of_scene;
}

const Series& series_with(const std::vector<Series>& all, const Row& row) {
    return *std::find_if(all.begin(), all.end(), [&](const Series& series) { return belongs(series, row); });
}

std::vector<const Row*> pareto_front(const std::vector<const Row*>& rows, Region region) {
    std::vector<const Row*> by_time;
    for (const Row* row : rows) {
        if (error_in(*row, region) > row->of(region).zone) by_time.push_back(row);
    }
    std::stable_sort(by_time.begin(), by_time.end(),
                     [](const Row* a, const Row* b) { return a->seconds.value < b->seconds.value; });
    std::vector<const Row*> front;
    for (const Row* row : by_time) {
        if (front.empty() || error_in(*row, region) < error_in(*front.back(), region)) front.push_back(row);
    }
    return front;
}

const Row* cheapest(const std::vector<const Row*>& rows, Region region, double error) {
    const Row* best = nullptr;
    for (const Row* row : rows) {
        const double reached = error_in(*row, region);
        if (reached > error || reached <= row->of(region).zone) continue;
        if (!best || row->seconds.value < best->seconds.value) best = row;
    }
    return best;
}

}  // namespace zerkalo::study
