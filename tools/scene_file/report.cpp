#include "tools/scene_file/report.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace zerkalo::scene_file {
namespace {

constexpr std::size_t kMaxStored = 500;  // bounds the memory that a hostile file can ask for

}  // namespace

void Report::add(Entry entry) {
    ++count_;
    if (entries_.size() < kMaxStored) entries_.push_back(std::move(entry));
}

void Report::error(Position at, std::string message, std::string help) {
    add({at, true, {source_.name(), at, printable(message), printable(help), {}, 0}});
}

void Report::error_in(const SourceText& other, Position at, std::string message, Position named_at) {
    const std::string help = "the scene names this file at " + source_.name() + ":" + std::to_string(named_at.line) +
                             ":" + std::to_string(named_at.column);
    Diagnostic diagnostic{other.name(), at, printable(message), printable(help), {}, 0};
    attach_line(diagnostic, other.line(at.line));
    add({named_at, false, std::move(diagnostic)});
}

std::vector<Diagnostic> Report::take(int limit) {
    std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.order.line, a.order.column) < std::tie(b.order.line, b.order.column);
    });
    std::vector<Diagnostic> taken;
    for (Entry& entry : entries_) {
        if (static_cast<int>(taken.size()) == limit) break;
        if (entry.in_scene_file) attach_line(entry.diagnostic, source_.line(entry.order.line));
        taken.push_back(std::move(entry.diagnostic));
    }
    entries_.clear();
    return taken;
}

}  // namespace zerkalo::scene_file
