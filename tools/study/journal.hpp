// The rows of a study on disk: appended whole, one line each, so that a study goes on where it was stopped.
#pragma once

#include "tools/study/row.hpp"

#include <string>

namespace zerkalo::study {

/// DIR/rows.csv, and DIR/plan.txt that says what the rows belong to.
class Journal {
public:
    /// Makes the folder if need be, or takes up the study in it. A last line without its end is dropped. Throws
    /// Failure: io_failed when the folder cannot be written or another study is writing there; usage when it holds
    /// another plan.
    Journal(const std::string& folder, const std::string& plan_text);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    const std::vector<Row>& rows() const { return rows_; }

    /// On the disk when it returns. Throws Failure(io_failed).
    void append(const Row& row);

private:
    void take_up(const std::string& path);
    void write(const std::string& line);

    std::string path_;
    int file_ = -1;
    std::vector<Row> rows_;
};

/// The rows of a finished or unfinished study, without touching it. Throws Failure(io_failed) when `folder` holds none
/// or a line is damaged.
std::vector<Row> read_rows(const std::string& folder);

/// Its plan.txt. Throws Failure(io_failed).
std::string read_plan_text(const std::string& folder);

/// The first line of `there` that `here` has otherwise, as "'THERE' there, 'HERE' here".
std::string first_difference(const std::string& there, const std::string& here);

/// Writes a file whole. Throws Failure(io_failed).
void write_text(const std::string& path, const std::string& text);

/// Makes a folder and those above it. Throws Failure(io_failed).
void make_folder(const std::string& path);

}  // namespace zerkalo::study
