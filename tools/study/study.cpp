#include "tools/study/study.hpp"

#include "tools/study/crops.hpp"
#include "tools/study/diagrams.hpp"
#include "tools/study/join.hpp"
#include "tools/study/journal.hpp"
#include "tools/study/report.hpp"
#include "tools/study/results.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/progress.hpp"

#include <charconv>
#include <cstdio>
#include <map>
#include <set>

namespace zerkalo::study {
namespace {

std::vector<Setting> rows_of_shard(const StudyPlan& plan, const Shard& shard) {
    std::vector<Setting> rows;
    for (std::size_t i = static_cast<std::size_t>(shard.number) - 1; i < plan.rows.size();
         i += static_cast<std::size_t>(shard.of)) {
        rows.push_back(plan.rows[i]);
    }
    return rows;
}

// What the rows of a scene and an antialiasing share: made when the first of them comes, one at a time.
class FactsOfScenes {
public:
    FactsOfScenes(const StudyPlan& plan, const StudyOptions& options)
        : plan_(plan), options_(options), folder_(options.references) {
        if (folder_.empty()) folder_ = options.folder + "/references";
        make_folder(folder_);
    }

    const SceneFacts& facts_of(const Setting& setting) {
        if (facts_ && setting.scene == scene_ && setting.antialias == antialias_) return *facts_;
        const PlannedScene& planned = plan_.scene_of(setting);
        const ImageSize& size = plan_.wish.size;
        SceneFacts facts;
        facts.regions = regions_of(options_.renderer, *planned.scene, size);
        const std::string name =
            setting.antialias == 1 ? planned.name : format("%s-antialias%d", planned.name.c_str(), setting.antialias);
        facts.references =
            references_of(options_.renderer, *planned.scene, size, {plan_.wish.reference_samples, setting.antialias},
                          facts.regions, folder_, name);
        check(planned, facts.references);
        scene_ = setting.scene;
        antialias_ = setting.antialias;
        return facts_.emplace(std::move(facts));
    }

private:
    void check(const PlannedScene& planned, const References& references) const {
        const double zone = references.zone[static_cast<std::size_t>(Region::mirror)];
        if (zone <= options_.tolerance) return;
        throw Failure(ExitCode::pictures_differ,
                      format("%s: the two references are %.2g apart in the mirror (RMSE), more than %.2g: no error "
                             "can be told; more --reference-samples than %d bring them together",
                             planned.name.c_str(), zone, options_.tolerance, plan_.wish.reference_samples));
    }

    const StudyPlan& plan_;
    const StudyOptions& options_;
    std::string folder_;
    int scene_ = -1, antialias_ = 0;
    std::optional<SceneFacts> facts_;
};

[[noreturn]] void give_up(const StudyOptions& options, std::size_t done, std::size_t all) {
    throw Failure(ExitCode::interrupted, format("interrupted; %zu of %zu rows are in %s, and the same command goes on "
                                                "from there",
                                                done, all, options.folder.c_str()));
}

void draw_all_crops(const StudyPlan& plan, const StudyOptions& options, FactsOfScenes& scenes,
                    const std::vector<Row>& rows) {
    for (std::size_t i = 0; i < plan.scenes.size(); ++i) {
        const int scene = static_cast<int>(i);
        const std::vector<const Row*> of_scene = rows_of_scene(rows, plan.scenes[i].name);
        const SceneFacts& facts = scenes.facts_of({scene, Number::floating, {}, 1, plan.wish.antialias.front()});
        draw_crops(options.folder, plan, scene, of_scene, facts, options.renderer);
    }
}

void write_everything(const std::string& folder, const std::string& plan_text, const std::vector<Row>& rows,
                      bool crops) {
    write_results(folder, plan_text, rows);
    const bool drawn = draw_diagrams(folder, rows);
    write_text(folder + "/study.md", report_text(rows, plan_text, drawn, crops));
    if (!drawn) {
        std::fprintf(stderr,
                     "zerkalo: note: gnuplot (Debian package gnuplot-nox) is missing: %s/diagrams has the data and the "
                     "scripts, but no pictures\n",
                     folder.c_str());
    }
}

}  // namespace

void run_study(const StudyPlan& plan, const StudyOptions& options) {
    Journal journal(options.folder, plan.text);
    FactsOfScenes scenes(plan, options);
    const std::vector<Setting> settings = rows_of_shard(plan, options.shard);
    std::set<std::string> there;
    for (const Row& row : journal.rows()) there.insert(key_of(row));
    std::vector<Setting> missing;
    for (const Setting& setting : settings) {
        if (there.count(key_of(plan, setting)) == 0) missing.push_back(setting);
    }
    try {
        Progress line(static_cast<std::int64_t>(missing.size()));
        for (const Setting& setting : missing) {
            journal.append(run_row(plan, setting, scenes.facts_of(setting), options.renderer, options.timing));
            line.add_step(journal.rows().back().all_rays());
            if (options.progress) line.show();
        }
    } catch (const Interrupted&) {
        give_up(options, journal.rows().size(), settings.size());
    }
    if (options.shard.of > 1) return;
    const std::vector<Row> rows = in_plan_order(plan, journal.rows());
    try {
        draw_all_crops(plan, options, scenes, rows);
    } catch (const Interrupted&) {
        give_up(options, rows.size(), settings.size());
    }
    write_everything(options.folder, plan.text, rows, true);
}

void join_study(const std::vector<std::string>& folders, const StudyOptions& options) {
    const Joined all = joined(folders);
    Journal journal(options.folder, all.plan_text);
    std::set<std::string> there;
    for (const Row& row : journal.rows()) there.insert(key_of(row));
    for (const Row& row : all.rows) {
        if (there.count(key_of(row)) == 0) journal.append(row);
    }
    write_everything(options.folder, all.plan_text, all.rows, false);
}

std::optional<Shard> shard_of(const std::string& text) {
    Shard shard;
    const char *begin = text.data(), *end = begin + text.size();
    const auto [slash, error] = std::from_chars(begin, end, shard.number);
    if (error != std::errc() || slash == end || *slash != '/') return std::nullopt;
    const auto [stop, second_error] = std::from_chars(slash + 1, end, shard.of);
    if (second_error != std::errc() || stop != end || shard.number < 1 || shard.number > shard.of) return std::nullopt;
    return shard;
}

std::vector<Row> in_plan_order(const StudyPlan& plan, const std::vector<Row>& rows) {
    std::map<std::string, const Row*> by_key;
    for (const Row& row : rows) by_key.emplace(key_of(row), &row);
    std::vector<Row> ordered;
    for (const Setting& setting : plan.rows) {
        const auto place = by_key.find(key_of(plan, setting));
        if (place != by_key.end()) ordered.push_back(*place->second);
    }
    return ordered;
}

}  // namespace zerkalo::study
