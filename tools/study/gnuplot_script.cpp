#include "tools/study/gnuplot_script.hpp"

#include "core/optics/estimator.hpp"
#include "tools/study/row_text.hpp"
#include "tools/zerkalo/messages.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace zerkalo::study {
namespace {

using Figure = std::function<double(const Row&)>;

// One curve: its points and how they are drawn.
struct Curve {
    std::string title, style;
    std::vector<std::pair<double, double>> points;
};

struct Chart {
    std::string file, title, x_label, y_label;
    std::vector<Curve> curves;
    double zone = 0;         // errors across below it cannot be told
    bool error_is_x = true;  // else it is y, and x the number of samples
};

constexpr const char* kColours[] = {"#e41a1c", "#ff7f00", "#984ea3", "#4daf4a", "#377eb8", "#000000"};
static_assert(std::size(kColours) == kEstimatorCount);
constexpr const char* kSlopeNames[] = {"-1/2", "-3/4", "-1", "-3/2"};
constexpr double kSlopes[] = {0.5, 0.75, 1.0, 1.5};

const char* colour_of(const std::string& estimator) {
    const auto place = std::find(std::begin(kEstimatorNames), std::end(kEstimatorNames), estimator);
    return place == std::end(kEstimatorNames) ? "#666666" : kColours[place - std::begin(kEstimatorNames)];
}

std::string title_of(const Series& series) {
    const std::string title = series.estimator + (series.asked ? " --error, " : ", ") + series.number;
    return series.antialias == 1 ? title : title + ", antialias " + std::to_string(series.antialias);
}

std::string style_of(const std::string& number, const char* colour) {
    const bool fixed = number == "fixed";
    return format("with linespoints lc rgb '%s' dt %d pt %d ps 0.7 lw 1.5", colour, fixed ? 2 : 1, fixed ? 6 : 7);
}

double mirror_error(const Row& row) { return error_in(row, Region::mirror); }

void add_point(Curve& curve, double x, double y) {
    if (x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y)) curve.points.emplace_back(x, y);
}

// One curve a series, error across and `cost` upwards, and rings around what no other dot beats.
Chart cost_chart(const std::vector<Series>& all, const std::vector<const Row*>& rows, const Figure& cost) {
    Chart chart;
    for (const Row* row : rows) chart.zone = std::max(chart.zone, row->of(Region::mirror).zone);
    for (const Series& series : all) {
        Curve curve{title_of(series), style_of(series.number, colour_of(series.estimator)), {}};
        if (series.asked) curve.style = format("with points lc rgb '%s' pt 3 ps 1.5", colour_of(series.estimator));
        for (const Row* row : series.rows) {
            if (row->resolved()) add_point(curve, mirror_error(*row), cost(*row));
        }
        chart.curves.push_back(std::move(curve));
    }
    chart.x_label = "error: RMSE of the mirror region, linear light";
    return chart;
}

Curve pareto_curve(const std::vector<const Row*>& rows) {
    Curve curve{"Pareto front", "with points lc rgb 'black' pt 6 ps 1.8 lw 1.5", {}};
    for (const Row* row : pareto_front(rows, Region::mirror)) {
        add_point(curve, mirror_error(*row), 1e3 * row->seconds.value);
    }
    return curve;
}

// Where the error of one estimator comes from, against the number of samples.
Chart split_chart(const std::vector<Series>& all, const std::string& estimator) {
    Chart chart;
    chart.error_is_x = false;
    const auto add = [&](const Series& series, const std::string& title, const char* colour, const auto& figure) {
        Curve curve{title, style_of(series.number, colour), {}};
        for (const Row* row : series.rows) {
            add_point(curve, static_cast<double>(row->samples), figure(row->of(Region::mirror)));
        }
        chart.curves.push_back(std::move(curve));
    };
    for (const Series& series : all) {
        if (series.estimator != estimator || series.antialias != all.front().antialias || series.asked) continue;
        const std::string of = ", " + series.number;
        add(series, "total" + of, "#000000", [](const RegionErrors& e) { return e.total.rmse; });
        add(series, "quadrature" + of, "#377eb8", [](const RegionErrors& e) { return e.quadrature; });
        add(series, "arithmetic" + of, "#e41a1c", [](const RegionErrors& e) { return e.arithmetic; });
        add(series, "8 bits" + of, "#4daf4a", [](const RegionErrors& e) { return e.quantised8; });
        add(series, "10 bits" + of, "#984ea3", [](const RegionErrors& e) { return e.quantised10; });
        add(series, "16 bits" + of, "#ff7f00", [](const RegionErrors& e) { return e.quantised16; });
        // Only total and quadrature are measured against the references: a line, not an area that hides the others.
        Curve apart{"references apart" + of, "with lines lc rgb '#888888' dt 3 lw 2", {}};
        for (const Row* row : series.rows) {
            add_point(apart, static_cast<double>(row->samples), row->of(Region::mirror).zone);
        }
        if (series.number == "float") chart.curves.push_back(std::move(apart));
    }
    chart.x_label = "lobe samples";
    chart.y_label = "error: RMSE of the mirror region, linear light";
    return chart;
}

struct Range {
    double low = 0, high = 0;

    void take(double value) {
        low = low == 0 ? value : std::min(low, value);
        high = std::max(high, value);
    }
};

// Four triangles on one base at the top right: what an error that falls with the work to that power would draw.
std::string triangles(const Range& x, const Range& y) {
    constexpr double kWidth = 2;
    const double right = x.high, left = right / kWidth, base = y.high / 6;
    std::string text;
    for (std::size_t i = 0; i < std::size(kSlopes); ++i) {
        const double top = base * std::pow(kWidth, 1 / kSlopes[i]);
        text += format("set object %zu polygon from %g,%g to %g,%g to %g,%g to %g,%g fs empty border rgb '#888888'\n",
                       i + 10, right, base, left, base, left, top, right, base);
        text += format("set label %zu '%s' at %g,%g right offset -0.5,0 textcolor rgb '#666666'\n", i + 10,
                       kSlopeNames[i], left, top);
    }
    return text;
}

std::string commands_of(const Chart& chart, int first_block) {
    Range x, y;
    for (const Curve& curve : chart.curves) {
        for (const auto& [px, py] : curve.points) x.take(px), y.take(py);
    }
    std::string text = "reset\nset logscale xy\nset grid\nset key outside right noenhanced\nset format '%.0e'\n";
    text += "set title " + gnuplot_quoted(chart.title) + " noenhanced\n";
    text += "set xlabel " + gnuplot_quoted(chart.x_label) + "\nset ylabel " + gnuplot_quoted(chart.y_label) + "\n";
    if (!chart.error_is_x) text += "set format x '%g'\n";
    if (chart.zone > 0) {
        x.take(chart.zone);
        text += format(
            "set object 1 rectangle from graph 0, graph 0 to first %g, graph 1 fc rgb '#dddddd' fs solid "
            "noborder behind\n",
            chart.zone);
    }
    if (chart.error_is_x) text += triangles(x, y);
    text += format("set xrange [%g:%g]\nset yrange [%g:%g]\n", x.low / 2, x.high * 2, y.low / 2, y.high * 2);
    text += "set output " + gnuplot_quoted(chart.file) + ".ending\nplot ";
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
        const Curve& curve = chart.curves[i];
        text += format("%s$data%zu using 1:2 %s title ", i == 0 ? "" : ", \\\n    ",
                       static_cast<std::size_t>(first_block) + i, curve.style.c_str()) +
                gnuplot_quoted(curve.title);
    }
    return text + "\nset output\n";
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
}

std::string split_estimator(const std::vector<const Row*>& rows) {
    const std::string lattice = zerkalo::name_of(Estimator::fibonacci);
    const bool there = std::any_of(rows.begin(), rows.end(), [&](const Row* row) { return row->estimator == lattice; });
    return there ? lattice : rows.front()->estimator;
}

std::string gnuplot_script(const std::string& name, const std::vector<const Row*>& rows) {
    if (rows.empty()) return "";
    const std::vector<Series> all = series_of(rows);
    Chart time = cost_chart(all, rows, [](const Row& row) { return 1e3 * row.seconds.value; });
    time.curves.push_back(pareto_curve(rows));
    time.title = name + ": time against error", time.y_label = "time of a frame, ms";
    Chart rays = cost_chart(all, rows, [](const Row& row) {
        return static_cast<double>(row.rays.lobe) / static_cast<double>(row.of(Region::mirror).pixels);
    });
    rays.title = name + ": rays against error", rays.y_label = "lobe rays a pixel of the mirror";
    Chart split = split_chart(all, split_estimator(rows));
    split.title = name + ": where the error of " + split_estimator(rows) + " comes from";
    time.file = name + "-time", rays.file = name + "-rays", split.file = name + "-split";

    std::string data, commands;
    int blocks = 0;
    for (Chart* chart : {&time, &rays, &split}) {
        // gnuplot warns of curves without a point.
        std::erase_if(chart->curves, [](const Curve& curve) { return curve.points.empty(); });
        if (chart->curves.empty()) continue;
        commands += commands_of(*chart, blocks);
        for (const Curve& curve : chart->curves) {
            data += format("$data%d << EOD\n", blocks++);
            for (const auto& [x, y] : curve.points) data += csv_number(x) + " " + csv_number(y) + "\n";
            data += "EOD\n";
        }
    }
    if (commands.empty()) return "";
    return data + "set terminal svg size 900,560 font 'sans,13' background 'white'\nending = '.svg'\n" + commands +
           "set terminal pngcairo size 720,450 font 'sans,9'\nending = '.png'\n" + commands;
}

}  // namespace zerkalo::study
