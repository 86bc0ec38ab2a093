// Lines of a diagram, the Pareto front and the cheapest setting, from rows that are made up.
#include "tools/study/series.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace zerkalo::study {
namespace {

Row row_with(const char* estimator, std::int64_t samples, double seconds, double error, double zone = 0) {
    Row row;
    row.scene = "s";
    row.number = "float";
    row.estimator = estimator;
    row.samples = samples;
    row.antialias = 1;
    row.seconds = {seconds, seconds, seconds};
    for (RegionErrors& region : row.regions) {
        region.over_rotations.mean = error;
        region.zone = zone;
    }
    return row;
}

std::vector<const Row*> pointers(const std::vector<Row>& rows) {
    std::vector<const Row*> all;
    for (const Row& row : rows) all.push_back(&row);
    return all;
}

TEST(StudySeries, ASlopeIsThatOfItsRowsAlone) {
    std::vector<Row> rows;
    for (std::int64_t n = 256; n >= 4; n /= 2) {
        const double samples = static_cast<double>(n);
        rows.push_back(row_with("a", n, samples, std::pow(samples, -0.5)));
        rows.push_back(row_with("b", n, samples, std::pow(samples, -1.5)));
    }
    rows.push_back(row_with("a", 1, 1, 7));  // below the first that is fitted
    const std::vector<Series> all = series_of(rows);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(all[0].slope(Region::mirror).value, -0.5, 1e-9);
    EXPECT_NEAR(all[1].slope(Region::edges).value, -1.5, 1e-9);
    EXPECT_EQ(all[0].rows.front()->samples, 1);
    EXPECT_EQ(all[0].rows.back()->samples, 256);
    EXPECT_EQ(&series_with(all, rows[1]), &all[1]);
}

TEST(StudySeries, FewSamplesAreFittedOnlyWhereThereAreNoOthers) {
    std::vector<Row> rows;
    for (std::int64_t n = 4; n <= 64; n *= 2) {
        rows.push_back(row_with("a", n, 1, n < 16 ? 1 : 1 / static_cast<double>(n)));
    }
    EXPECT_NEAR(series_of(rows)[0].slope(Region::smooth).value, -1, 1e-9);
    rows.pop_back();
    EXPECT_LT(series_of(rows)[0].slope(Region::smooth).value, -1.5);
}

TEST(StudySeries, WhatTheReferencesCannotTellIsNotFitted) {
    std::vector<Row> rows;
    for (std::int64_t n = 4; n <= 64; n *= 2) {
        const double error = 1.0 / static_cast<double>(n);
        rows.push_back(row_with("a", n, 1, n <= 16 ? error : 0.06, 0.0611));
    }
    EXPECT_NEAR(series_of(rows)[0].slope(Region::mirror).value, -1, 1e-9);
    rows.resize(2);
    EXPECT_TRUE(std::isnan(series_of(rows)[0].slope(Region::mirror).value));
}

TEST(StudySeries, TheParetoFrontHasWhatNothingBeats) {
    const std::vector<Row> rows{row_with("a", 1, 3, 0.1), row_with("a", 2, 1, 0.5),  row_with("b", 1, 2, 0.6),
                                row_with("b", 2, 4, 0.1), row_with("b", 4, 5, 0.01), row_with("b", 8, 0.1, 0.001, 1)};
    const auto front = pareto_front(pointers(rows), Region::mirror);
    ASSERT_EQ(front.size(), 3u);
    EXPECT_EQ(front[0], &rows[1]);
    EXPECT_EQ(front[1], &rows[0]);
    EXPECT_EQ(front[2], &rows[4]);
}

TEST(StudySeries, TheCheapestReachesTheErrorInTheLeastTime) {
    const std::vector<Row> rows{row_with("a", 1, 3, 0.1), row_with("a", 2, 4, 0.01), row_with("b", 1, 9, 0.001),
                                row_with("b", 2, 1, 0.001, 0.01)};
    EXPECT_EQ(cheapest(pointers(rows), Region::mirror, 0.2), &rows[0]);
    EXPECT_EQ(cheapest(pointers(rows), Region::mirror, 0.05), &rows[1]);
    EXPECT_EQ(cheapest(pointers(rows), Region::mirror, 0.002), &rows[2]);
    EXPECT_EQ(cheapest(pointers(rows), Region::mirror, 0.0001), nullptr);
}

}  // namespace
}  // namespace zerkalo::study
