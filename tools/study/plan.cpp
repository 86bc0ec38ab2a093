#include "tools/study/plan.hpp"

#include "core/image/hash.hpp"
#include "tools/study/row.hpp"
#include "tools/study/row_text.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/scene_input.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace zerkalo::study {
namespace {

constexpr const char* kPlanVersion = "zerkalo study plan 1";
const std::string kRowWord = "row ";
constexpr const char* kLobeNames[] = {"phong", "max_phong", "ggx"};  // in the order of Lobe

struct SceneSpec {
    std::string path, name;
    std::optional<double> exponent;
};

// "PATH@N", unless a file has just that name.
SceneSpec spec_of(const std::string& word) {
    SceneSpec spec{word, "", {}};
    const std::size_t at = word.rfind('@');
    double exponent = 0;
    if (at != std::string::npos && access(word.c_str(), F_OK) != 0) {
        const char *begin = word.data() + at + 1, *end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(begin, end, exponent);
        if (error != std::errc() || stop != end || !(exponent >= 0) || !std::isfinite(exponent)) {
            throw Failure(ExitCode::usage, word + ": what follows '@' is not a lobe exponent, a number from 0 on");
        }
        spec = {word.substr(0, at), "", exponent};
    }
    const std::size_t slash = spec.path.rfind('/') + 1, dot = spec.path.rfind('.');
    spec.name = spec.path.substr(slash, dot == std::string::npos || dot < slash ? dot : dot - slash);
    if (spec.exponent) spec.name += word.substr(at);
    return spec;
}

PlannedScene planned_scene(const std::string& word) {
    const SceneSpec spec = spec_of(word);
    auto scene = std::make_unique<Scene>(*read_scene(spec.path).scene);
    PlannedScene planned{spec.name, nullptr, "", 0};
    for (int k = 0; k < scene->mirror_count; ++k) {
        Mirror& mirror = scene->mirrors[k];
        if (!std::isfinite(mirror.lobe_exponent)) continue;
        if (spec.exponent) mirror.lobe_exponent = *spec.exponent;
        if (!planned.lobe.empty()) continue;
        planned.lobe = kLobeNames[static_cast<int>(mirror.lobe)];
        planned.lobe_exponent = mirror.lobe_exponent;
    }
    if (planned.lobe.empty()) {
        throw Failure(ExitCode::usage, spec.path + ": has no unpolished mirror, so there is no error to study");
    }
    planned.scene = std::move(scene);
    return planned;
}

// A picture of one lobe ray a pixel tells scenes, and programs that draw them otherwise, apart.
std::string mark_of(const PlannedScene& planned, const ImageSize& size) {
    const Frame frame = prepare_frame(*planned.scene, settings_of({}, size, 0), best_isa(), 1, Number::floating);
    render_frame(frame, 1, false);
    return format("%016llx", static_cast<unsigned long long>(hash_of(frame.image)));
}

// Why the renderer cannot do this scene in this way; empty when it can.
std::string refusal_of(const PlannedScene& planned, const ImageSize& size, Number number, Estimator estimator) {
    Setting setting;
    setting.estimator = estimator;
    try {
        prepare_frame(*planned.scene, settings_of(setting, size, 0), Isa::scalar, 1, number);
        return "";
    } catch (const Failure& refusal) {
        return refusal.what();
    }
}

template <class Item, class Text>
std::string joined(const std::vector<Item>& items, const Text& text) {
    std::string all;
    for (const Item& item : items) all += (all.empty() ? "" : ",") + std::string(text(item));
    return all;
}

std::string text_of(const StudyPlan& plan) {
    const Wish& wish = plan.wish;
    const auto whole = [](std::int32_t value) { return std::to_string(value); };
    std::string text = format("%s\nsize %dx%d\n", kPlanVersion, wish.size.width, wish.size.height);
    text += "numbers " + joined(wish.numbers, [](Number number) { return name_of(number); }) + "\n";
    text += "estimators " + joined(wish.estimators, [](Estimator e) { return zerkalo::name_of(e); }) + "\n";
    text += "samples " + joined(wish.samples, whole) + "\nfixed_samples " + joined(wish.fixed_samples, whole) + "\n";
    text += "fibonacci_samples " + joined(wish.fibonacci_samples, whole) + "\n";
    text += "antialias " + joined(wish.antialias, whole) + "\nerrors " + joined(wish.errors, csv_number) + "\n";
    text += format("rotations %d\nreference_samples %d\n", wish.rotations, wish.reference_samples);
    for (const PlannedScene& scene : plan.scenes) {
        text += "scene " + csv_cell(scene.name) + " " + mark_of(scene, wish.size) + "\n";
    }
    for (const std::string& refusal : plan.refusals) text += "without " + refusal + "\n";
    for (const Setting& setting : plan.rows) text += kRowWord + key_of(plan, setting) + "\n";
    return text;
}

bool is_lattice(Estimator estimator) {
    return estimator == Estimator::fibonacci || estimator == Estimator::fibonacci_coverage;
}

std::vector<std::int32_t> samples_of(const Wish& wish, Number number, Estimator estimator) {
    if (number == Number::fixed) return wish.fixed_samples;
    std::vector<std::int32_t> samples = wish.samples;
    if (estimator != Estimator::fibonacci || wish.fibonacci_samples.empty()) return samples;
    samples.insert(samples.end(), wish.fibonacci_samples.begin(), wish.fibonacci_samples.end());
    std::sort(samples.begin(), samples.end());
    return samples;
}

void add_rows(StudyPlan& plan, int scene, Number number) {
    const Wish& wish = plan.wish;
    const PlannedScene& planned = plan.scenes[static_cast<std::size_t>(scene)];
    for (const Estimator estimator : wish.estimators) {
        const std::string refusal = refusal_of(planned, wish.size, number, estimator);
        if (!refusal.empty()) {
            plan.refusals.push_back(planned.name + ": " + name_of(number) + ": " + zerkalo::name_of(estimator) + ": " +
                                    refusal);
            continue;
        }
        for (const std::int32_t antialias : wish.antialias) {
            for (const std::int32_t samples : samples_of(wish, number, estimator)) {
                plan.rows.push_back({scene, number, estimator, samples, antialias, 0});
            }
            if (number != Number::floating || !is_lattice(estimator)) continue;
            for (const double error : wish.errors) plan.rows.push_back({scene, number, estimator, 0, antialias, error});
        }
    }
}

Wish wish_for(const ImageSize& size) {
    Wish wish;
    wish.size = size;
    for (int i = 0; i < kEstimatorCount; ++i) wish.estimators.push_back(static_cast<Estimator>(i));
    wish.numbers = {Number::floating, Number::fixed};
    wish.antialias = {1};
    wish.errors = {0.002};
    return wish;
}

}  // namespace

Wish full_wish() {
    Wish wish = wish_for({160, 120});
    wish.samples = {1, 2, 4, 8, 16, 32, 64, 128, 256};
    wish.fixed_samples = {1, 4, 16, 64};
    wish.fibonacci_samples = {3, 6, 12, 24, 48};
    return wish;
}

Wish quick_wish() {
    Wish wish = wish_for({64, 48});
    wish.samples = {1, 4, 16, 64};
    wish.fixed_samples = {1, 4, 16};
    wish.reference_samples = 4096;
    return wish;
}

std::string key_of(const StudyPlan& plan, const Setting& setting) {
    Row row;
    row.scene = plan.scene_of(setting).name;
    row.number = name_of(setting.number);
    row.estimator = zerkalo::name_of(setting.estimator);
    row.antialias = setting.antialias;
    row.samples = setting.samples;
    row.asked_error = setting.asked_error;
    return key_of(row);
}

std::vector<std::string> keys_of(const std::string& plan_text) {
    std::vector<std::string> keys;
    std::istringstream lines(plan_text);
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, kRowWord.size(), kRowWord) == 0) keys.push_back(line.substr(kRowWord.size()));
    }
    return keys;
}

StudyPlan plan_of(const Wish& wish) {
    StudyPlan plan;
    plan.wish = wish;
    for (const std::string& word : wish.scenes) {
        PlannedScene planned = planned_scene(word);
        for (const PlannedScene& other : plan.scenes) {
            if (other.name != planned.name) continue;
            throw Failure(ExitCode::usage, word + ": two scenes are called '" + planned.name +
                                               "'; a study tells its scenes apart by the names of their files");
        }
        const std::string refusal = refusal_of(planned, wish.size, Number::floating, Estimator::fibonacci);
        if (!refusal.empty()) throw Failure(ExitCode::scene_invalid, word + ": " + refusal);
        plan.scenes.push_back(std::move(planned));
    }
    for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
        for (const Number number : wish.numbers) add_rows(plan, static_cast<int>(i), number);
    }
    plan.text = text_of(plan);
    return plan;
}

}  // namespace zerkalo::study
