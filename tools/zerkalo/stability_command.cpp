// zerkalo stability: the stiff and extreme cases, the renderer's error beside that of the textbook's formula.
#include "tools/stability/stiff_case.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"

#include <algorithm>
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
    double naive, ours;

    bool kept() const { return stability::holds(*row, ours); }
};

std::vector<Outcome> play(const std::vector<StiffCase>& cases, const std::vector<std::string>& wanted, Isa isa) {
    const stability::Stage stage(isa);
    std::vector<Outcome> outcomes;
    for (const StiffCase& row : cases) {
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), row.id) == wanted.end()) continue;
        outcomes.push_back({&row, row.naive(), row.ours(stage)});
    }
    return outcomes;
}

std::string as_text(const std::vector<Outcome>& outcomes, Isa isa) {
    std::string text = format("instruction set %s\n%-4s  %-70s %9s %9s %9s  %s\n", name_of(isa), "case", "input", "naive",
                              "ours", "bound", "unit");
    int kept = 0;
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        text += format("%-4s  %-70s %9.2g %9.2g %9.2g  %s%s\n", row.id, row.input, outcome.naive, outcome.ours,
                       row.bound, row.unit, outcome.kept() ? "" : "  BROKEN");
        kept += outcome.kept();
    }
    return text + format("%d of %zu laws hold\n", kept, outcomes.size());
}

std::string as_markdown(const std::vector<Outcome>& outcomes) {
    std::string text = "| case | input | what the textbook's formula does | what holds | naive | ours | bound |\n"
                       "|---|---|---|---|---|---|---|\n";
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        text += format("| %s | %s | %s | %s | %.2g | %.2g | %.2g %s |\n", row.id, row.input, row.failure, row.law,
                       outcome.naive, outcome.ours, row.bound, row.unit);
    }
    return text;
}

std::string as_json(const std::vector<Outcome>& outcomes, Isa isa) {
    std::vector<JsonObject> rows;
    bool kept = true;
    for (const Outcome& outcome : outcomes) {
        const StiffCase& row = *outcome.row;
        JsonObject entry;
        entry.text("case", row.id).text("input", row.input).text("failure", row.failure).text("law", row.law);
        entry.text("unit", row.unit).number("naive", outcome.naive).number("ours", outcome.ours);
        rows.push_back(entry.number("bound", row.bound).flag("holds", outcome.kept()));
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
