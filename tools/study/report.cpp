#include "tools/study/report.hpp"

#include "tools/study/crops.hpp"
#include "tools/study/gnuplot_script.hpp"
#include "tools/study/goals.hpp"
#include "tools/zerkalo/messages.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::study {
namespace {

struct Target {
    const char* name;
    double error;
};
constexpr Target kTargets[] = {{"1e-2", 1e-2}, {"1e-3", 1e-3}, {"1/510", 1.0 / 510}, {"1e-4", 1e-4}};
constexpr const char* kNumbers[] = {"float", "fixed"};

std::vector<const Row*> of_number(std::vector<const Row*> rows, const std::string& number) {
    std::erase_if(rows, [&](const Row* row) { return row->number != number; });
    return rows;
}

std::string setting_text(const Row& row) {
    const std::string antialias = row.antialias == 1 ? "" : format(", antialias %d", static_cast<int>(row.antialias));
    if (row.asked_error > 0) return format("%s --error %g", row.estimator.c_str(), row.asked_error) + antialias;
    return format("%s %lld%s", row.estimator.c_str(), static_cast<long long>(row.samples), antialias.c_str());
}

std::string heading_text(const std::vector<Row>& rows) {
    std::string machines;
    for (const Row& row : rows) {
        const std::string machine = format("%s, %lld lanes in float, %lld thread%s", row.isa.c_str(),
                                           static_cast<long long>(row.number == "float" ? row.lanes : 1),
                                           static_cast<long long>(row.threads), row.threads == 1 ? "" : "s");
        if (row.number == "float" && machines.find(machine) == std::string::npos) {
            machines += (machines.empty() ? "" : "; ") + machine;
        }
    }
    const Row& first = rows.front();
    const auto unresolved = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.resolved(); });
    return format(
        "# Error against run time\n\n%zu settings, %lldx%lld pixels, %lld rotations of the lobe's rays. "
        "Timed with: %s.\nErrors are RMSE in linear light over the mirror region, the mean over the "
        "rotations.\nNot resolved, for the two references are no nearer: %lld settings; no diagram or table "
        "shows them.\n\n",
        rows.size(), static_cast<long long>(first.width), static_cast<long long>(first.height),
        static_cast<long long>(first.rotations), machines.c_str(), static_cast<long long>(unresolved));
}

std::string goals_text(const std::vector<Row>& rows) {
    const std::vector<Goal> goals = goals_of(rows);
    if (goals.empty()) return "";
    std::string text = "## Goals\n\n| to reach | reached | |\n|---|---|---|\n";
    for (const Goal& goal : goals) {
        text += "| " + goal.wanted + " | " + goal.reached + " | " + (goal.met ? "met" : "missed") + " |\n";
    }
    return text + "\n";
}

std::string cheapest_text(const std::vector<Row>& rows) {
    std::string text = "## Cheapest setting that reaches an error\n\n| scene | numbers |", line = "|---|---|";
    for (const Target& target : kTargets) text += format(" %s |", target.name), line += "---|";
    text += "\n" + line + "\n";
    for (const std::string& scene : scenes_of(rows)) {
        for (const char* number : kNumbers) {
            const std::vector<const Row*> of_scene = of_number(rows_of_scene(rows, scene), number);
            if (of_scene.empty()) continue;
            text += "| " + scene + " | " + number + " |";
            for (const Target& target : kTargets) {
                const Row* row = cheapest(of_scene, Region::mirror, target.error);
                text += row ? format(" %s: %.3g ms |", setting_text(*row).c_str(), 1e3 * row->seconds.value) : " - |";
            }
            text += "\n";
        }
    }
    return text + "\n";
}

std::string slope_cell(const Estimate& slope) {
    if (std::isnan(slope.value)) return " - |";
    return format(" %.2f (%.2f to %.2f) |", slope.value, slope.low, slope.high);
}

std::string slopes_text(const std::vector<Row>& rows) {
    std::string text = "## Slopes\n\nError ~ N^slope, fitted from N = " + std::to_string(kFirstFittedSamples) +
                       " on (short series from " + std::to_string(kFirstFittedOfFew) +
                       " on), with 95 % intervals; `-` where fewer than three settings are resolved.\n\n"
                       "| scene | estimator | numbers | mirror | edges | smooth |\n|---|---|---|---|---|---|\n";
    for (const Series& series : series_of(rows)) {
        if (series.asked) continue;
        text += "| " + series.scene + " | " + series.estimator + " | " + series.number + " |";
        for (const Region region : {Region::mirror, Region::edges, Region::smooth}) {
            text += slope_cell(series.slope(region));
        }
        text += "\n";
    }
    return text + "\n";
}

// Where the error comes from, at the samples that crops compare with.
std::string split_text(const std::vector<Row>& rows) {
    std::string text =
        "## Where the error comes from\n\nRMSE of the mirror region, rotation 0. Zone: how far the "
        "references are apart.\n\n| scene | setting | numbers | total | quadrature | arithmetic | "
        "8 bits | 10 bits | 16 bits | zone |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const std::string& scene : scenes_of(rows)) {
        const std::vector<const Row*> of_scene = rows_of_scene(rows, scene);
        const Row* benchmark = benchmark_row(of_scene);
        if (!benchmark) continue;
        for (const Row* row : of_scene) {
            if (setting_text(*row) != setting_text(*benchmark)) continue;
            const RegionErrors& e = row->of(Region::mirror);
            text += format("| %s | %s | %s | %.2e | %.2e | %.2e | %.2e | %.2e | %.2e | %.2e |\n", scene.c_str(),
                           setting_text(*row).c_str(), row->number.c_str(), e.total.rmse, e.quadrature, e.arithmetic,
                           e.quantised8, e.quantised10, e.quantised16, e.zone);
        }
    }
    return text + "\n";
}

std::string legend_of(const std::vector<const Row*>& chosen) {
    std::string text = "the reference";
    for (const Row* row : chosen) {
        text += format("; %s (%.3g ms, %.2e)", setting_text(*row).c_str(), 1e3 * row->seconds.value,
                       error_in(*row, Region::mirror));
    }
    return text + "\n\n";
}

std::string pictures_text(const std::vector<Row>& rows, bool pictures, bool crops) {
    std::string text;
    for (const std::string& scene : scenes_of(rows)) {
        const std::vector<const Row*> of_scene = rows_of_scene(rows, scene);
        text += "## " + scene + "\n\n";
        for (const char* kind : {"time", "rays", "split"}) {
            if (pictures) text += "![](diagrams/" + scene + "-" + kind + ".svg)\n";
        }
        const Row* benchmark = benchmark_row(of_scene);
        if (!crops || !benchmark) continue;
        text += "\nEqual time, from left to right: " + legend_of(equal_time_rows(of_scene, *benchmark)) + "![](crops/" +
                scene + "-equal-time.png)\n\nEqual error: " + legend_of(equal_error_rows(of_scene, *benchmark)) +
                "![](crops/" + scene + "-equal-error.png)\n\n";
    }
    return text;
}

}  // namespace

std::string report_text(const std::vector<Row>& rows, const std::string& plan_text, bool pictures, bool crops) {
    if (rows.empty()) return "# Error against run time\n\nNo rows.\n";
    std::string text = heading_text(rows) + goals_text(rows) + cheapest_text(rows) + slopes_text(rows) +
                       split_text(rows) + pictures_text(rows, pictures, crops);
    return text + "## The plan\n\n```\n" + plan_text.substr(0, plan_text.find("\nrow ") + 1) + "```\n";
}

}  // namespace zerkalo::study
