#include "tools/study/results.hpp"

#include "tools/study/journal.hpp"
#include "tools/study/row_text.hpp"
#include "tools/zerkalo/json.hpp"

#include <sstream>

namespace zerkalo::study {
namespace {

constexpr Region kSlopeRegions[] = {Region::mirror, Region::edges, Region::smooth};

// visit(name, value) for the slopes of a series.
template <class Visit>
void visit_slopes(const Series& series, const Visit& visit) {
    for (const Region region : kSlopeRegions) {
        const Estimate& slope = series.slope(region);
        const std::string of = kRegionNames[static_cast<int>(region)];
        visit("slope_" + of, slope.value);
        visit("slope_low_" + of, slope.low);
        visit("slope_high_" + of, slope.high);
    }
}

struct JsonFiller {
    JsonObject& json;

    void operator()(const std::string& name, const std::string& value) const { json.text(name, value); }
    void operator()(const std::string& name, double value) const { json.number(name, value); }
    void operator()(const std::string& name, std::int64_t value) const { json.integer(name, value); }
    void operator()(const std::string& name, std::uint64_t value) const {
        json.integer(name, static_cast<std::int64_t>(value));
    }
};

JsonObject json_of(const Row& row, const Series& series) {
    JsonObject exact, measured, slope, whole;
    visit_exact(row, JsonFiller{exact});
    visit_measured(row, JsonFiller{measured});
    visit_slopes(series, JsonFiller{slope});
    return whole.object("exact", exact).object("measured", measured).object("slope", slope);
}

}  // namespace

std::string results_csv(const std::vector<Row>& rows) {
    const std::vector<Series> all = series_of(rows);
    std::string text = csv_header();
    visit_slopes(Series{}, [&](const std::string& name, double) { text += "," + name; });
    text += "\n";
    for (const Row& row : rows) {
        text += csv_line(row);
        visit_slopes(series_with(all, row), [&](const std::string&, double value) { text += "," + csv_number(value); });
        text += "\n";
    }
    return text;
}

std::string results_json(const std::string& plan_text, const std::vector<Row>& rows) {
    const std::vector<Series> all = series_of(rows);
    std::vector<std::string> plan;
    std::istringstream lines(plan_text);
    for (std::string line; std::getline(lines, line);) plan.push_back(line);
    std::vector<JsonObject> objects;
    for (const Row& row : rows) objects.push_back(json_of(row, series_with(all, row)));
    JsonObject json;
    return json.list("plan", plan).list("rows", objects).str() + "\n";
}

void write_results(const std::string& folder, const std::string& plan_text, const std::vector<Row>& rows) {
    write_text(folder + "/study.csv", results_csv(rows));
    write_text(folder + "/study.json", results_json(plan_text, rows));
}

}  // namespace zerkalo::study
