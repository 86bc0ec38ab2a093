#include "tools/zerkalo/options.hpp"

#include "core/render/edges.hpp"
#include "tools/scene_file/suggestion.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <thread>

namespace zerkalo {
namespace {

constexpr int kMaxThreads = 1024;

std::optional<std::int64_t> parse_whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<ImageSize> parse_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto width = parse_whole_number(text.substr(0, cross)), height = parse_whole_number(text.substr(cross + 1));
    if (!width || !height || *width < 1 || *height < 1) return std::nullopt;
    if (*width > kMaxImageSide || *height > kMaxImageSide || *width * *height > kMaxPixels) return std::nullopt;
    return ImageSize{static_cast<std::int32_t>(*width), static_cast<std::int32_t>(*height)};
}

std::vector<std::string_view> isa_names() {
    std::vector<std::string_view> names;
    for (int i = 0; i < kIsaCount; ++i) names.emplace_back(name_of(static_cast<Isa>(i)));
    return names;
}

void add_whole_option(CLI::App& command, const std::string& name, std::int32_t& value, std::int64_t min,
                      std::int64_t max, const std::string& what) {
    command.add_option(name, value, what)->check(whole_number(min, max))->capture_default_str()->type_name("N");
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string_view>& candidates) {
    const std::string question = scene_file::did_you_mean(word, candidates, "");
    return question.empty() ? "" : "; " + question;
}

CLI::Validator whole_number(std::int64_t min, std::int64_t max) {
    const auto check = [min, max](std::string& text) -> std::string {
        const auto value = parse_whole_number(text);
        if (value && *value >= min && *value <= max) return "";
        return format("'%s' is not a whole number from %lld to %lld", text.c_str(), static_cast<long long>(min),
                      static_cast<long long>(max));
    };
    return CLI::Validator(check, "");
}

CLI::Validator positive_number() {
    const auto check = [](std::string& text) -> std::string {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = error == std::errc() && end == text.data() + text.size();
        if (whole && std::isfinite(value) && value > 0) return "";
        return "'" + text + "' is not a finite number above 0, for example 0.002";
    };
    return CLI::Validator(check, "");
}

CLI::Validator one_of(const std::vector<std::string_view>& names) {
    const auto check = [names](std::string& text) -> std::string {
        if (std::find(names.begin(), names.end(), text) != names.end()) return "";
        return "'" + text + "' is not one of: " + scene_file::listed(names) + suggestion(text, names);
    };
    return CLI::Validator(check, "");
}

void add_size_option(CLI::App& command, Settings& settings) {
    const auto take = [&settings](const std::string& text) {
        const auto size = parse_size(text);
        if (!size) {
            throw CLI::ValidationError("--size", "'" + text +
                                                     "' is not WIDTHxHEIGHT with sides from 1 to 65536 and at "
                                                     "most 268435456 pixels, for example 640x480");
        }
        settings.width = size->width;
        settings.height = size->height;
    };
    command.add_option_function<std::string>("--size", take, "Size of the picture, default: the scene's")
        ->type_name("WxH");
}

void add_estimator_option(CLI::App& command, Estimator& estimator) {
    const std::vector<std::string_view> names(std::begin(kEstimatorNames), std::end(kEstimatorNames));
    const auto take = [&estimator, names](const std::string& text) {
        estimator = static_cast<Estimator>(std::find(names.begin(), names.end(), text) - names.begin());
    };
    command
        .add_option_function<std::string>("--estimator", take, "How lobe rays are placed: " + scene_file::listed(names))
        ->check(one_of(names))
        ->type_name("NAME");
}

// A number for all pixels, or "auto".
void add_antialias_option(CLI::App& command, Settings& settings) {
    const auto take = [&settings](const std::string& text) {
        settings.edge_antialias = text == "auto" ? kEdgeAntialias : 0;
        settings.antialias = text == "auto" ? 1 : std::stoi(text);
    };
    const CLI::Validator number = whole_number(1, kMaxAntialias);
    const auto check = [number](std::string& text) -> std::string {
        if (text == "auto") return "";
        const std::string wrong = number(text);
        return wrong.empty() ? "" : wrong + ", or auto";
    };
    command
        .add_option_function<std::string>(
            "--antialias", take, "Camera rays per pixel, or auto: 16 where a pixel differs from those beside it, else 1")
        ->check(CLI::Validator(check, ""))
        ->type_name("N");
}

void add_quality_options(CLI::App& command, Settings& settings) {
    add_whole_option(command, "--samples", settings.samples, 1, kMaxSamples,
                     "Lobe rays per hit of an unpolished mirror");
    add_antialias_option(command, settings);
    add_whole_option(command, "--depth-limit", settings.depth_limit, 0, kMaxDepth,
                     "Reflections and refractions that a ray may have behind it");
    add_estimator_option(command, settings.estimator);
    add_whole_option(command, "--rotation", settings.rotation, 0, kMaxRotation,
                     "Which of the equally good placements of the lobe rays");
    command.add_flag("--exact-plan", settings.exact_plan, "No culling: every ray asks every solid");
}

void add_number_option(CLI::App& command, Number& number) {
    const std::vector<std::string_view> names(std::begin(kNumberNames), std::end(kNumberNames));
    const auto take = [&number, names](const std::string& text) {
        number = static_cast<Number>(std::find(names.begin(), names.end(), text) - names.begin());
    };
    command
        .add_option_function<std::string>("--number", take,
                                          "Number type of the kernels: " + scene_file::listed(names))
        ->check(one_of(names))
        ->type_name("NAME");
}

void add_isa_option(CLI::App& command, std::optional<Isa>& isa) {
    const auto names = isa_names();
    const auto take = [&isa, names](const std::string& text) {
        isa = static_cast<Isa>(std::find(names.begin(), names.end(), text) - names.begin());
    };
    command
        .add_option_function<std::string>(
            "--isa", take, "Instruction set: " + scene_file::listed(names) + "; default: the widest that this CPU has")
        ->check(one_of(names))
        ->type_name("NAME");
}

void add_threads_option(CLI::App& command, int& threads) {
    threads = hardware_threads();
    command.add_option("--threads", threads, "Threads that render, default: all that this process may use")
        ->check(whole_number(1, kMaxThreads))
        ->type_name("N");
}

void add_json_option(CLI::App& command, bool& json) {
    command.add_flag("--json", json, "Print one JSON object instead of text");
}

int hardware_threads() {
    const unsigned threads = std::thread::hardware_concurrency();
    return threads == 0 ? 1 : static_cast<int>(std::min<unsigned>(threads, kMaxThreads));
}

std::string available_isas() {
    std::vector<std::string_view> names;
    for (int i = 0; i < kIsaCount; ++i) {
        if (available(static_cast<Isa>(i))) names.emplace_back(name_of(static_cast<Isa>(i)));
    }
    return scene_file::listed(names);
}

Isa chosen_isa(const std::optional<Isa>& wanted) {
    if (!wanted) return best_isa();
    if (!available(*wanted)) {
        throw Failure(ExitCode::no_device,
                      format("--isa: this CPU cannot run '%s'; it has %s", name_of(*wanted), available_isas().c_str()));
    }
    return *wanted;
}

}  // namespace zerkalo
