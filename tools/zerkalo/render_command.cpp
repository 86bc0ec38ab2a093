// zerkalo render: a scene file becomes a picture file, and a line (or a JSON object) that tells what it cost.
#include "core/image/hash.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/frame.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/picture_file.hpp"
#include "tools/zerkalo/progress.hpp"
#include "tools/zerkalo/refine.hpp"
#include "tools/zerkalo/scene_input.hpp"
#include "tools/zerkalo/stop_signals.hpp"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace zerkalo {
namespace {

constexpr int kMaxRepeat = 1000000;

struct RenderOptions {
    std::string scene, output;
    Settings settings;
    int depth = 8;
    std::optional<Isa> isa;
    int threads = 1;
    int repeat = 1;
    Number number = Number::floating;
    std::optional<double> error, time_ms;
    bool json = false;
};

JsonObject rays_json(const RayCounts& rays) {
    const auto count = [](std::uint64_t value) { return static_cast<std::int64_t>(value); };
    JsonObject json;
    json.integer("primary", count(rays.primary)).integer("reflected", count(rays.reflected));
    json.integer("lobe", count(rays.lobe)).integer("refracted", count(rays.refracted));
    json.integer("shadow", count(rays.shadow));
    // Lobes, not rays: of the estimator fibonacci+coverage alone.
    if (rays.covered + rays.sampled > 0) {
        json.integer("covered_lobes", count(rays.covered)).integer("sampled_lobes", count(rays.sampled));
    }
    return json;
}

// Largest resident memory of this process so far, in bytes; 0 where the kernel does not tell. Not getrusage(): its
// figure begins with that of the program that started this one.
std::int64_t peak_memory() {
    std::int64_t kilobytes = 0;
    std::FILE* file = std::fopen("/proc/self/status", "r");
    if (!file) return 0;
    char line[256];
    while (std::fgets(line, sizeof line, file)) {
        long long value = 0;
        if (std::sscanf(line, "VmHWM: %lld kB", &value) == 1) kilobytes = value;
    }
    std::fclose(file);
    return kilobytes * 1024;
}

// What was asked for, what is estimated, what it took.
void add_refinement(JsonObject& json, const RenderOptions& options, const Refined& refined) {
    JsonObject asked, spent;
    if (options.error) asked.number("error", *options.error);
    if (options.time_ms) asked.number("time_ms", *options.time_ms);
    spent.integer("passes", refined.passes).integer("most_samples", refined.most_samples);
    spent.integer("lobe_rays", static_cast<std::int64_t>(refined.cost.rays.lobe));
    spent.number("seconds", median(refined.cost.seconds));
    json.object("asked", asked).number("estimated_error", refined.estimated).flag("reached", refined.reached);
    json.object("spent", spent).flag("deterministic", options.error.has_value());
}

std::string json_report(const RenderOptions& options, const Frame& frame, const FrameCost& cost,
                        const std::optional<Refined>& refined) {
    JsonObject json;
    json.text("scene", options.scene).integer("width", frame.image.width).integer("height", frame.image.height);
    json.number("seconds", median(cost.seconds));
    if (options.repeat > 1) {
        const auto [min, max] = std::minmax_element(cost.seconds.begin(), cost.seconds.end());
        json.integer("repeat", options.repeat).number("seconds_min", *min).number("seconds_max", *max);
    }
    json.text("isa", name_of(frame.isa)).integer("lanes", frame.lanes).text("number", name_of(options.number));
    json.integer("threads", frame.threads);
    if (!refined) json.integer("samples", options.settings.samples);
    json.integer("antialias", options.settings.antialias);
    if (options.settings.edge_antialias > 0) {
        json.integer("edge_antialias", options.settings.edge_antialias).integer("edge_pixels", cost.edge_pixels);
    }
    json.integer("depth_limit", options.settings.depth_limit);
    json.text("estimator", name_of(options.settings.estimator)).flag("exact_plan", options.settings.exact_plan);
    if (refined) add_refinement(json, options, *refined);
    json.object("rays", rays_json(cost.rays)).list("features", features_of(frame.head()));
    json.text("hash", format("%016llx", static_cast<unsigned long long>(hash_of(frame.image))));
    return json.integer("peak_bytes", peak_memory()).text("output", options.output).str() + "\n";
}

std::string text_report(const RenderOptions& options, const Frame& frame, const FrameCost& cost,
                        const std::optional<Refined>& refined) {
    const double seconds = median(cost.seconds);
    const double rays = static_cast<double>(total_of(cost.rays));
    const int lanes = frame.lanes;
    const std::string error = refined ? format(", estimated error %.3g", refined->estimated) : "";
    return format("%s: %dx%d in %.3f ms, %.1f Mray/s (%s, %d lane%s, %d thread%s)%s\n", options.output.c_str(),
                  frame.image.width, frame.image.height, 1e3 * seconds, 1e-6 * rays / seconds, name_of(frame.isa),
                  lanes, lanes == 1 ? "" : "s", frame.threads, frame.threads == 1 ? "" : "s", error.c_str());
}

// Standard output holds either the picture or the report.
void check_standard_output(const RenderOptions& options) {
    if (options.output != "-") return;
    if (options.json) throw Failure(ExitCode::usage, "--json and '-o -' both want standard output; choose one");
    if (isatty(STDOUT_FILENO) == 1) {
        throw Failure(ExitCode::usage, "-o -: standard output is a terminal; redirect it to a file or a pipe");
    }
}

// --error and --time choose the samples themselves.
void check_refinement(const RenderOptions& options, bool samples_given) {
    if (!options.error && !options.time_ms) return;
    const std::string option = options.error ? "--error" : "--time";
    const auto refuse = [](const std::string& text) { throw Failure(ExitCode::usage, text); };
    if (options.error && options.time_ms) refuse("--error and --time both say when to stop; choose one");
    if (samples_given) refuse(option + " chooses the samples itself; leave --samples out");
    if (options.time_ms && options.repeat > 1) refuse("--time takes the time it is given; leave --repeat out");
}

Refined refine(const RenderOptions& options, const Frame& frame) {
    const StopSignals signals;
    const bool progress = progress_wanted();
    if (options.time_ms) {
        return refine_for(frame, std::chrono::duration<double, std::milli>(*options.time_ms), signals.stopped(),
                          progress);
    }
    Refined refined = refine_to_error(frame, *options.error, signals.stopped(), progress);
    for (int i = 1; i < options.repeat && !signals.stopped(); ++i) {
        std::vector<double> seconds = refined.cost.seconds;
        refined = refine_to_error(frame, *options.error, signals.stopped(), progress);
        seconds.push_back(refined.cost.seconds.front());
        refined.cost.seconds = seconds;
    }
    return refined;
}

// The picture is kept: it is whole, only not as good as was asked for.
void require_reached(const RenderOptions& options, const Refined& refined) {
    if (refined.reached) return;
    throw Failure(ExitCode::pictures_differ,
                  format("--error %g: not reached: the estimate is %.3g after at most %lld lobe rays a hit; "
                         "the picture is kept",
                         *options.error, refined.estimated, static_cast<long long>(refined.most_samples)));
}

ExitCode run_render(const RenderOptions& options) {
    check_standard_output(options);
    const PictureKind kind = picture_kind(options.output, options.depth);
    const Isa isa = chosen_isa(options.isa);
    const SceneInput input = read_scene(options.scene);
    WholeFile file;
    open_picture(file, options.output);

    const Frame frame = prepare_frame(*input.scene, options.settings, isa, options.threads, options.number);
    std::optional<Refined> refined;
    if (options.error || options.time_ms) refined = refine(options, frame);
    const FrameCost cost = refined ? refined->cost : render_frame(frame, options.repeat, progress_wanted());
    write_picture(file, frame.image, kind);
    if (options.output != "-") {
        print_result(options.json ? json_report(options, frame, cost, refined) : text_report(options, frame, cost, refined));
    }
    if (refined) require_reached(options, *refined);
    return ExitCode::ok;
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Renders a scene into a picture file");
    command->add_option("SCENE", options->scene, "Scene file (TOML)")->required();
    command->add_option("-o,--output", options->output, "NAME.png, NAME.pfm (linear floats), or - for PNG on stdout")
        ->required()
        ->type_name("OUT");
    command->add_option("--depth", options->depth, "Bits a channel of a PNG: 8 or 16")
        ->check(one_of({"8", "16"}))
        ->type_name("BITS");
    add_size_option(*command, options->settings);
    add_quality_options(*command, options->settings);
    add_number_option(*command, options->number);
    add_isa_option(*command, options->isa);
    add_threads_option(*command, options->threads);
    command->add_option("--repeat", options->repeat, "Render so many times and report the median")
        ->check(whole_number(1, kMaxRepeat))
        ->type_name("N");
    command->add_option("--error", options->error,
                        "Render until the estimated root mean square error is at most E; the same picture everywhere")
        ->check(positive_number())
        ->type_name("E");
    command->add_option("--time", options->time_ms,
                        "The best picture in so many milliseconds: not the same every time (Ctrl-C ends it early)")
        ->check(positive_number())
        ->type_name("MS");
    add_json_option(*command, options->json);
    command->callback([options, command, &action] {
        const bool samples_given = command->count("--samples") > 0;
        action = [options, samples_given] {
            check_refinement(*options, samples_given);
            return run_render(*options);
        };
    });
}

}  // namespace zerkalo
