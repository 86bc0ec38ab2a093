// Rows through their text and back.
#include "tools/study/row_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace zerkalo::study {
namespace {

// Fills every field with something of its own.
Row random_row(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto fill = [&](const std::string& name, auto& field) {
        using Field = std::decay_t<decltype(field)>;
        if constexpr (std::is_same_v<Field, std::string>) {
            field = name + ", \"quoted\"";
        } else if constexpr (std::is_same_v<Field, double>) {
            field = std::ldexp(static_cast<double>(random()), -static_cast<int>(random() % 200));
        } else {
            field = static_cast<Field>(random() >> 1);
        }
    };
    Row row;
    visit_exact(row, fill);
    visit_measured(row, fill);
    return row;
}

TEST(StudyRows, EveryColumnComesBackBitForBit) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const Row row = random_row(seed);
        const std::string line = csv_line(row);
        const auto back = row_of(line);
        ASSERT_TRUE(back) << line;
        EXPECT_EQ(csv_line(*back), line);
        EXPECT_EQ(back->seconds.high, row.seconds.high) << seed;
        EXPECT_EQ(back->of(Region::smooth).zone, row.of(Region::smooth).zone) << seed;
        EXPECT_EQ(back->scene, row.scene);
        EXPECT_EQ(back->rays.shadow, row.rays.shadow) << seed;
    }
}

TEST(StudyRows, WhatIsNoNumberComesBackToo) {
    Row row = random_row(7);
    row.regions[0].total.psnr = std::numeric_limits<double>::infinity();
    row.regions[1].total.rmse = std::numeric_limits<double>::quiet_NaN();
    const auto back = row_of(csv_line(row));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->regions[0].total.psnr, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(back->regions[1].total.rmse));
}

TEST(StudyRows, ADamagedLineIsNoRow) {
    const std::string line = csv_line(random_row(3));
    for (std::size_t length = 0; length < line.size(); ++length) {
        const auto row = row_of(line.substr(0, length));
        // Cut within the last number it may still be one: the line's end tells, and the journal asks for that.
        EXPECT_TRUE(!row || length > line.rfind(',') + 1) << line.substr(0, length);
    }
    EXPECT_FALSE(row_of(line + ",1"));
    EXPECT_FALSE(row_of(""));
}

TEST(StudyRows, TheHeaderNamesEveryCellOnce) {
    const auto names = cells_of(csv_header());
    const auto cells = cells_of(csv_line(random_row(5)));
    ASSERT_TRUE(names && cells);
    EXPECT_EQ(names->size(), cells->size());
    EXPECT_EQ(std::set<std::string>(names->begin(), names->end()).size(), names->size());
}

TEST(StudyRows, TheExactCellsComeFirst) {
    Row row = random_row(9);
    const std::string exact = exact_csv_line(row);
    row.isa = "other";
    row.seconds.value *= 2;
    EXPECT_EQ(exact_csv_line(row), exact);
    EXPECT_EQ(csv_line(row).substr(0, exact.size() + 1), exact + ",");
}

}  // namespace
}  // namespace zerkalo::study
