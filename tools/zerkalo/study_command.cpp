// zerkalo study: error against run time of every way to render some scenes; rows, diagrams and tables in a folder.
#include "tools/study/study.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/progress.hpp"
#include "tools/zerkalo/stop_signals.hpp"

#include <algorithm>
#include <memory>

namespace zerkalo {
namespace {

using study::StudyOptions;
using study::Wish;

constexpr std::int32_t kMaxReferenceSamples = 1 << 24;
constexpr std::int32_t kMinRotations = 2, kMaxRotations = 1024;

struct CommandOptions {
    std::vector<std::string> scenes, join;
    Settings size;
    std::vector<std::string> estimators, numbers;
    std::vector<std::int32_t> samples, antialias;
    std::vector<double> errors;
    std::int32_t rotations = 0, reference_samples = 0;
    std::string shard = "1/1";
    std::optional<Isa> isa;
    bool quick = false;
    StudyOptions study;
};

std::vector<std::string_view> estimator_names() { return {std::begin(kEstimatorNames), std::end(kEstimatorNames)}; }

template <class Item>
std::vector<Item> without_repeats(const std::vector<Item>& items) {
    std::vector<Item> once;
    for (const Item& item : items) {
        if (std::find(once.begin(), once.end(), item) == once.end()) once.push_back(item);
    }
    return once;
}

Wish wish_of(const CommandOptions& options) {
    Wish wish = options.quick ? study::quick_wish() : study::full_wish();
    wish.scenes = options.scenes;
    if (options.size.width > 0) wish.size = {options.size.width, options.size.height};
    if (!options.samples.empty()) {
        wish.samples = wish.fixed_samples = without_repeats(options.samples);
        wish.fibonacci_samples.clear();
    }
    if (!options.antialias.empty()) wish.antialias = without_repeats(options.antialias);
    if (!options.errors.empty()) wish.errors = without_repeats(options.errors);
    if (options.rotations > 0) wish.rotations = options.rotations;
    if (options.reference_samples > 0) wish.reference_samples = options.reference_samples;
    if (!options.estimators.empty()) wish.estimators.clear();
    for (const std::string& name : without_repeats(options.estimators)) {
        const auto place = std::find(std::begin(kEstimatorNames), std::end(kEstimatorNames), name);
        wish.estimators.push_back(static_cast<Estimator>(place - std::begin(kEstimatorNames)));
    }
    if (!options.numbers.empty()) wish.numbers.clear();
    for (const std::string& name : without_repeats(options.numbers)) {
        wish.numbers.push_back(name == "fixed" ? Number::fixed : Number::floating);
    }
    return wish;
}

ExitCode run(const CommandOptions& options) {
    StudyOptions wanted = options.study;
    if (options.scenes.empty() == options.join.empty()) {
        throw Failure(ExitCode::usage, "give either scenes to study or --join with the folders of shards");
    }
    if (!options.join.empty()) {
        study::join_study(options.join, wanted);
        return ExitCode::ok;
    }
    const auto shard = study::shard_of(options.shard);
    if (!shard) throw Failure(ExitCode::usage, "--shard: '" + options.shard + "' is not K/N with 1 <= K <= N");
    wanted.shard = *shard;
    const StopSignals signals;
    wanted.renderer = {chosen_isa(options.isa), hardware_threads(), &signals.stopped()};
    wanted.progress = progress_wanted();
    const study::StudyPlan plan = study::plan_of(wish_of(options));
    study::run_study(plan, wanted);
    return ExitCode::ok;
}

void add_plan_options(CLI::App& command, CommandOptions& options) {
    add_size_option(command, options.size);
    const auto list = [&](const char* name, auto& values, const CLI::Validator& check, const char* what) {
        command.add_option(name, values, what)
            ->delimiter(',')
            ->check(check)
            ->type_name("LIST")
            ->allow_extra_args(false);
    };
    list("--samples", options.samples, whole_number(1, kMaxSamples), "Lobe rays per hit, for example 1,4,16");
    list("--antialias", options.antialias, whole_number(1, kMaxAntialias), "Camera rays per pixel, default 1");
    list("--errors", options.errors, positive_number(), "RMSE to be reached by render --error, default 0.002");
    list("--estimators", options.estimators, one_of(estimator_names()), "How lobe rays are placed, default: all");
    list("--numbers", options.numbers, one_of({"float", "fixed"}), "Number types, default: float,fixed");
    command.add_option("--rotations", options.rotations, "Placements of the lobe rays whose errors are averaged")
        ->check(whole_number(kMinRotations, kMaxRotations))
        ->type_name("N");
    command.add_option("--reference-samples", options.reference_samples, "Lobe rays of each of the two references")
        ->check(whole_number(1, kMaxReferenceSamples))
        ->type_name("N");
    command.add_flag("--quick", options.quick, "Small pictures and fewer samples: within a minute");
}

}  // namespace

void add_study_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<CommandOptions>();
    CLI::App* command = app.add_subcommand("study", "Error against run time: rows, diagrams and tables");
    command->add_option("SCENE", options->scenes, "Scene files; NAME.toml@N with the lobe exponent N");
    command->add_option("-o,--output", options->study.folder, "Folder of the results; a stopped study goes on there")
        ->required()
        ->type_name("DIR");
    add_plan_options(*command, *options);
    command->add_option("--shard", options->shard, "Only every N-th row, from row K on")->type_name("K/N");
    command->add_option("--references", options->study.references, "Folder of the references, default: in DIR")
        ->type_name("DIR");
    command
        ->add_option("--reference-tolerance", options->study.tolerance,
                     "How far the references may be apart, RMSE in the mirror")
        ->check(CLI::Range(1e-12, 1.0))
        ->capture_default_str()
        ->type_name("E");
    command->add_option("--join", options->join, "Merges the folders of shards into DIR")->type_name("DIR...");
    add_isa_option(*command, options->isa);
    command->add_option("--threads", options->study.timing.threads, "Threads of the renders that are timed")
        ->check(whole_number(1, 1024))
        ->capture_default_str()
        ->type_name("N");
    command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace zerkalo
