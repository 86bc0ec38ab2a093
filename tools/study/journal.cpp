#include "tools/study/journal.hpp"

#include "platform/whole_file.hpp"
#include "platform/write_all.hpp"
#include "tools/study/row_text.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>

namespace zerkalo::study {
namespace {

std::string plan_path(const std::string& folder) { return folder + "/plan.txt"; }
std::string rows_path(const std::string& folder) { return folder + "/rows.csv"; }

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
    throw Failure(ExitCode::io_failed, format("%s: %s: %s", path.c_str(), what, std::strerror(error)));
}

std::string read_text(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "cannot read", errno);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::vector<Row> rows_of(const std::string& path, const std::string& text) {
    const std::vector<std::string> lines = lines_of(text);
    std::vector<Row> rows;
    if (!lines.empty() && lines[0] != csv_header()) {
        throw Failure(ExitCode::io_failed, path + ":1: its columns are not those of this version of the program");
    }
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const auto row = row_of(lines[i]);
        if (!row) throw Failure(ExitCode::io_failed, format("%s:%zu: is not a whole row", path.c_str(), i + 1));
        rows.push_back(*row);
    }
    return rows;
}

}  // namespace

Journal::Journal(const std::string& folder, const std::string& plan_text) : path_(rows_path(folder)) {
    make_folder(folder);
    if (access(plan_path(folder).c_str(), F_OK) == 0) {
        const std::string there = read_text(plan_path(folder));
        if (there != plan_text) {
            throw Failure(ExitCode::usage, "-o " + folder + ": holds a study of another plan (" +
                                               first_difference(there, plan_text) + "); choose another folder");
        }
    } else {
        write_text(plan_path(folder), plan_text);
    }
    take_up(path_);
}

void Journal::take_up(const std::string& path) {
    file_ = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file_ < 0) fail(path, "cannot write", errno);
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
        close(file_);
        throw Failure(ExitCode::io_failed, path + ": another study is writing it");
    }
    try {
        std::string text = read_text(path);
        const std::size_t whole = text.rfind('\n') + 1;
        if (whole < text.size() && ftruncate(file_, static_cast<off_t>(whole)) != 0) {
            fail(path, "cannot write", errno);
        }
        text.resize(whole);
        rows_ = rows_of(path, text);
        if (text.empty()) write(csv_header());
    } catch (...) {
        close(file_);
        throw;
    }
}

Journal::~Journal() { close(file_); }

void Journal::write(const std::string& line) {
    const std::string whole = line + "\n";
    const int error = write_all(file_, whole.data(), whole.size());
    if (error != 0) fail(path_, "cannot write", error);
    if (fdatasync(file_) != 0) fail(path_, "cannot write", errno);
}

void Journal::append(const Row& row) {
    write(csv_line(row));
    rows_.push_back(row);
}

std::vector<Row> read_rows(const std::string& folder) {
    return rows_of(rows_path(folder), read_text(rows_path(folder)));
}

std::string read_plan_text(const std::string& folder) { return read_text(plan_path(folder)); }

std::string first_difference(const std::string& there, const std::string& here) {
    const std::vector<std::string> a = lines_of(there), b = lines_of(here);
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
    const auto line = [i](const std::vector<std::string>& lines) {
        return i < lines.size() ? "'" + lines[i] + "'" : "nothing";
    };
    return line(a) + " there, " + line(b) + " here";
}

void write_text(const std::string& path, const std::string& text) {
    WholeFile file;
    const auto require = [](const IoStatus& status) {
        if (!status.ok()) throw Failure(ExitCode::io_failed, status.text);
    };
    require(file.open(path.c_str()));
    require(file.write(text.data(), text.size()));
    require(file.commit());
}

void make_folder(const std::string& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) fail(path, "cannot make the folder", error.value());
}

}  // namespace zerkalo::study
