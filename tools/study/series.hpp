// Rows that differ in the number of samples alone: one line of a diagram, with its fitted slope.
#pragma once

#include "tools/study/row.hpp"

#include <array>

namespace zerkalo::study {

/// Slopes are fitted from this number of samples on: below, the lattice is no lattice yet, and its few rays pass by
/// a highlight. A series with fewer than three resolved rows from there on is fitted from the other.
constexpr std::int64_t kFirstFittedSamples = 16, kFirstFittedOfFew = 4;

struct Series {
    std::string scene, number, estimator;
    std::int64_t antialias = 1;
    bool asked = false;                           // rows of `render --error`
    std::vector<const Row*> rows;                 // by rising samples
    std::array<Estimate, kRegionCount> slopes{};  // d log(mean RMSE) / d log(samples); NaN with fewer than three rows

    const Estimate& slope(Region region) const { return slopes[static_cast<std::size_t>(region)]; }
};

/// The error of a row in diagrams, tables and slopes: the mean RMSE over the rotations.
inline double error_in(const Row& row, Region region) { return row.of(region).over_rotations.mean; }

/// In the order of their first rows. A slope uses the rows whose error in the region the references can tell.
/// `rows` must outlive the result.
std::vector<Series> series_of(const std::vector<const Row*>& rows);
std::vector<Series> series_of(const std::vector<Row>& rows);

/// The names of the scenes, in the order of their first rows, and the rows of one.
std::vector<std::string> scenes_of(const std::vector<Row>& rows);
std::vector<const Row*> rows_of_scene(const std::vector<Row>& rows, const std::string& scene);

/// The series that holds `row`.
const Series& series_with(const std::vector<Series>& all, const Row& row);

/// The rows of a scene that no other row of it beats in both time and error, by rising time.
std::vector<const Row*> pareto_front(const std::vector<const Row*>& rows, Region region);

/// The cheapest of `rows` by time whose error is at most `error` and resolved; nullptr when there is none.
const Row* cheapest(const std::vector<const Row*>& rows, Region region, double error);

}  // namespace zerkalo::study
