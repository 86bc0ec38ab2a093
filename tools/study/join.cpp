#include "tools/study/join.hpp"

#include "tools/study/journal.hpp"
#include "tools/study/plan.hpp"
#include "tools/study/row_text.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"

#include <map>

namespace zerkalo::study {
namespace {

using RowsByKey = std::map<std::string, std::pair<Row, std::string>>;  // with the folder that it is from

void take_rows(RowsByKey& rows, const std::string& folder) {
    for (const Row& row : read_rows(folder)) {
        const auto [place, is_new] = rows.try_emplace(key_of(row), row, folder);
        const auto& [there, its_folder] = place->second;
        if (is_new || exact_csv_line(there) == exact_csv_line(row)) continue;
        throw Failure(ExitCode::pictures_differ, "--join: " + its_folder + " and " + folder +
                                                     " have different errors for the same row, " + key_of(row));
    }
}

}  // namespace

Joined joined(const std::vector<std::string>& folders) {
    Joined all{read_plan_text(folders.front()), {}};
    RowsByKey rows;
    for (const std::string& folder : folders) {
        const std::string text = read_plan_text(folder);
        if (text != all.plan_text) {
            throw Failure(ExitCode::usage, "--join: " + folder + " and " + folders.front() +
                                               " are of different plans (" + first_difference(text, all.plan_text) +
                                               ")");
        }
        take_rows(rows, folder);
    }
    const std::vector<std::string> keys = keys_of(all.plan_text);
    std::size_t missing = 0;
    std::string first_missing;
    for (const std::string& key : keys) {
        const auto place = rows.find(key);
        if (place != rows.end()) {
            all.rows.push_back(place->second.first);
        } else if (missing++ == 0) {
            first_missing = key;
        }
    }
    if (missing > 0) {
        throw Failure(ExitCode::io_failed,
                      format("--join: %zu of %zu rows are in none of the folders, the first is %s; run the shards to "
                             "their end",
                             missing, keys.size(), first_missing.c_str()));
    }
    return all;
}

}  // namespace zerkalo::study
