// zerkalo stability: the stiff and extreme cases, the renderer's error in both number systems beside that of the
// textbook's formula.
#include "tools/stability/stiff_case.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace zerkalo {
namespace {

using stability::StiffCase;

struct StabilityOptions {
    std::optional<Isa> isa;
    bool json = false, markdown = false;
    std::vector<std::string> rows;
};

struct Outcome {
    const StiffCase* row;
    double naive;
    stability::Verdict in_float, in_fixed;

    bool kept() const { return in_float.holds && in_fixed.holds; }
    double ours() const { return in_float.error.value_or(0); }
};

std::vector<Outcome> play(const std::vector<StiffCase>& cases, const std::vector<std::string>& wanted, Isa isa) {
    std::vector<Outcome> outcomes;
    for (const StiffCase& row : cases) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.id) == wanted.end()) continue;
        outcomes.push_back({&row, row.naive(), stability::judge(row, isa, Number::floating),
                            stability::judge(row, isa, Number::fixed)});
    }
    return outcomes;
}

/// The error in fixed point, the field that was refused, or both.
std::string fixed_figure(const Outcome& outcome) {
    const stability::Verdict& verdict = outcome.in_fixed;
    const std::string error = verdict.error ? format("%.2g", *verdict.error) : "";
    if (verdict.refused.empty()) return error;
    return error + (error.empty() ? "" : "; ") + "refused: " + verdict.refused;
}

/// Of float; and of fixed point where that is another one.
std::string bound_figure(const StiffCase& row) {
    const double in_fixed = bound_of(row, Number::fixed);
    return format("%.2g", row.bound) + (in_fixed != row.bound ? format(" (fixed %.2g)", in_fixed) : "");
}

std::string as_text(const std::vector<Outcome>& outcomes, Isa isa) {
    std::string text = format("instruction set %s\n%-4s  %-70s %9s %9s  %-34s %s\n", name_of(isa), "case", "input", "naive",
                              "float", "fixed", "bound");
    int kept = 0;
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        text += format("%-4s  %-70s %9.2g %9.2g  %-34s %s %s%s\n", row.id, row.input, outcome.naive, outcome.ours(),
                       fixed_figure(outcome).c_str(), bound_figure(row).c_str(), row.unit,
                       outcome.kept() ? "" : "  BROKEN");
        kept += outcome.kept();
    }
    return text + format("%d of %zu laws hold\n", kept, outcomes.size());
}

std::string as_markdown(const std::vector<Outcome>& outcomes) {
    std::string text = "| case | input | what the textbook's formula does | what holds | naive | float | fixed | bound |\n"
                       "|---|---|---|---|---|---|---|---|\n";
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        text += format("| %s | %s | %s | %s | %.2g | %.2g | %s | %s %s |\n", row.id, row.input, row.failure, row.law,
                       outcome.naive, outcome.ours(), fixed_figure(outcome).c_str(), bound_figure(row).c_str(), row.unit);
    }
    return text;
}

std::string as_json(const std::vector<Outcome>& outcomes, Isa isa) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<JsonObject> rows;
    bool kept = true;
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        JsonObject entry;
        entry.text("case", row.id).text("input", row.input).text("failure", row.failure).text("law", row.law);
        entry.text("unit", row.unit).number("naive", outcome.naive).number("ours", outcome.ours());
        entry.number("bound", row.bound).number("fixed", outcome.in_fixed.error.value_or(kNone));
        entry.number("fixed_bound", bound_of(row, Number::fixed)).text("fixed_refuses", outcome.in_fixed.refused);
        rows.push_back(entry.flag("holds", outcome.kept()));
        kept = kept && outcome.kept();
    }
    JsonObject report;
    report.text("isa", name_of(isa)).flag("holds", kept).list("cases", rows);
    return report.str() + "\n";
}

ExitCode show_stability(const StabilityOptions& options) {
    const Isa isa = chosen_isa(options.isa);
    const std::vector<StiffCase> cases = stability::all_cases();
    const std::vector<Outcome> outcomes = play(cases, options.rows, isa);
    print_result(options.json       ? as_json(outcomes, isa)
                 : options.markdown ? as_markdown(outcomes)
                                    : as_text(outcomes, isa));
    for (const Outcome& outcome : outcomes) {
        if (!outcome.kept()) {
            throw Failure(ExitCode::internal_error, format("case %s breaks its law: %s", outcome.row->id, outcome.row->law));
        }
    }
    return ExitCode::ok;
}

}  // namespace

void add_stability_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<StabilityOptions>();
    CLI::App* command = app.add_subcommand("stability", "The stiff and extreme cases: our error and the textbook's");
    std::vector<std::string_view> ids;
    for (const StiffCase& row : stability::all_cases()) ids.emplace_back(row.id);
    command->add_option("CASE", options->rows, "Cases to play, for example S01 S32; default: all")->check(one_of(ids));
    add_isa_option(*command, options->isa);
    add_json_option(*command, options->json);
    command->add_flag("--markdown", options->markdown, "Print a Markdown table instead of text");
    command->get_option("--markdown")->excludes("--json");
    command->callback([options, &action] { action = [options] { return show_stability(*options); }; });
}

}  // namespace zerkalo
