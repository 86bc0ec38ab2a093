// Collects the errors of one scene file and of the files it names, in the order of the scene file's text.
#pragma once

#include "tools/scene_file/source_text.hpp"

#include <string>
#include <vector>

namespace zerkalo::scene_file {

class Report {
public:
    explicit Report(const SourceText& source) : source_(source) {}

    /// An error at a place of the scene file.
    void error(Position at, std::string message, std::string help = {});

    /// An error in another file, which the scene file names at `named_at`.
    void error_in(const SourceText& other, Position at, std::string message, Position named_at);

    const SourceText& source() const { return source_; }
    int count() const { return count_; }

    /// The first `limit` errors in the order of the scene file's text. Leaves the report without entries.
    std::vector<Diagnostic> take(int limit);

private:
    struct Entry {
        Position order;  // in the scene file
        bool in_scene_file;
        Diagnostic diagnostic;
    };
    void add(Entry entry);

    const SourceText& source_;
    std::vector<Entry> entries_;
    int count_ = 0;
};

}  // namespace zerkalo::scene_file
