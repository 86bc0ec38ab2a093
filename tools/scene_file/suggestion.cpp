#include "tools/scene_file/suggestion.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace zerkalo::scene_file {
namespace {

constexpr std::size_t kLongestWord = 64;  // no key is nearly that long

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t columns = b.size() + 1;
    std::vector<int> table((a.size() + 1) * columns);
    const auto cell = [&](std::size_t i, std::size_t j) -> int& { return table[i * columns + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) cell(i, 0) = static_cast<int>(i);
    for (std::size_t j = 0; j <= b.size(); ++j) cell(0, j) = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            cell(i, j) = std::min({cell(i - 1, j) + 1, cell(i, j - 1) + 1, cell(i - 1, j - 1) + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) cell(i, j) = std::min(cell(i, j), cell(i - 2, j - 2) + 1);
        }
    }
    return cell(a.size(), b.size());
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.empty() || word.size() > kLongestWord) return {};
    std::string_view best;
    int best_distance = static_cast<int>(word.size() + 2) / 3 + 1;
    for (const std::string_view candidate : candidates) {
        const int distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    if (!best.empty() || word.size() < 3) return best;
    for (const std::string_view candidate : candidates) {
        if (candidate.find(word) != std::string_view::npos) return candidate;
    }
    return {};
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates, std::string fallback) {
    const std::string_view near = nearest(word, candidates);
    return near.empty() ? std::move(fallback) : "did you mean \"" + std::string(near) + "\"?";
}

std::string listed(std::span<const std::string_view> words) {
    std::string text;
    for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

}  // namespace zerkalo::scene_file
