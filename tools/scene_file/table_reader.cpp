#include "tools/scene_file/table_reader.hpp"

#include "tools/scene_file/decimal_comma.hpp"
#include "tools/scene_file/suggestion.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace zerkalo::scene_file {
namespace {

constexpr std::array<std::string_view, 4> kRootKeys{"version", "title", "ambient", "background"};

bool contains(Words words, std::string_view word) { return std::find(words.begin(), words.end(), word) != words.end(); }

std::string shortest(double value) {
    std::array<char, 32> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    return std::string(buffer.data(), end);
}

/// A number that somebody put in quotes, with a point or a comma.
std::string help_for_number_in_quotes(const toml::node& node) {
    if (!node.is_string()) return {};
    std::string text = node.as_string()->get();
    if (text.empty() || text.size() > 32) return {};
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool is_number = status == std::errc{} && end == text.data() + text.size();
    return is_number ? "write " + text + ", without quotes" : std::string{};
}

std::string must_be(std::string_view name, std::string_view words, const toml::node& node) {
    return std::string(name) + " must be " + std::string(words) + ", not " + described(node);
}

}  // namespace

std::string described(const toml::node& node) {
    if (const auto* value = node.as_floating_point()) return shortest(value->get());
    if (const auto* value = node.as_integer()) return std::to_string(value->get());
    if (node.is_string()) return "a string";
    if (node.is_boolean()) return "a truth value";
    if (node.is_table()) return "a table";
    if (node.is_array_of_tables()) return "a list of tables";
    return node.is_array() ? "an array" : "a date or time";
}

Position header_of(const toml::table& table) {
    const Position at = position_of(table.source());
    return at.line > 0 ? at : Position{1, 1, 1};
}

TableReader::TableReader(const toml::table& table, std::string what, Report& report)
    : table_(table), what_(std::move(what)), report_(report) {}

const toml::node* TableReader::find(std::string_view key) const {
    return allowed_.empty() || contains(allowed_, key) ? table_.get(key) : nullptr;
}

void TableReader::allow(Words keys, Words keys_of_siblings) {
    allowed_.assign(keys.begin(), keys.end());
    for (auto&& [key, value] : table_) {
        if (contains(keys, key.str())) continue;
        const Position at = position_of(key.source());
        const std::string all = what_ + " has: " + listed(keys);
        const std::string misplaced = in_quotes(key.str()) + " does not belong to " + what_;
        if (contains(keys_of_siblings, key.str())) {
            report_.error(at, misplaced, all);
        } else if (contains(kRootKeys, key.str())) {
            report_.error(at, misplaced, "it stands at the top of the file, before the first table");
        } else {
            report_.error(at, "unknown key " + in_quotes(key.str()), did_you_mean(key.str(), keys, all));
        }
    }
}

void TableReader::require(std::string_view key) {
    if (has(key)) return;
    report_.error(header_of(table_), "missing key " + in_quotes(key) + ": " + what_ + " needs it");
}

void TableReader::require_reachable(std::string_view key, const Vec3<double>& place) {
    if (kCoordinate.contains(place.x) && kCoordinate.contains(place.y) && kCoordinate.contains(place.z)) return;
    report_.error(place_of(key), in_quotes(key) + " leads farther than 1e15 from the origin");
}

bool TableReader::at_most_one(std::string_view first, std::string_view second) {
    if (!has(first) || !has(second)) return true;
    const Position a = position_of_key(table_, first), b = position_of_key(table_, second);
    const bool second_is_later = std::pair(b.line, b.column) > std::pair(a.line, a.column);
    report_.error(second_is_later ? b : a, in_quotes(first) + " and " + in_quotes(second) + " exclude each other",
                  "keep one of them");
    return false;
}

bool TableReader::exactly_one(std::string_view first, std::string_view second) {
    if (has(first) || has(second)) return at_most_one(first, second);
    report_.error(header_of(table_),
                  "missing key " + in_quotes(first) + " or " + in_quotes(second) + ": " + what_ + " needs one of them");
    return false;
}

bool TableReader::number_in(const toml::node& node, const std::string& name, const Range& range, double& target) {
    const auto* whole = node.as_integer();
    const auto* real = node.as_floating_point();
    if (whole != nullptr || real != nullptr) {
        const double value = whole != nullptr ? static_cast<double>(whole->get()) : real->get();
        if (range.contains(value)) {
            target = value;
            return true;
        }
    }
    report_.error(position_of(node), must_be(name, range.words, node), help_for_number_in_quotes(node));
    return false;
}

bool TableReader::number(std::string_view key, const Range& range, double& target) {
    const toml::node* node = find(key);
    return node != nullptr && number_in(*node, in_quotes(key), range, target);
}

bool TableReader::integer(std::string_view key, std::int32_t low, std::int32_t high, std::int32_t& target) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const auto* value = node->as_integer();
    if (value == nullptr || value->get() < low || value->get() > high) {
        const std::string words = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
        report_.error(position_of(*node), must_be(in_quotes(key), words, *node), help_for_number_in_quotes(*node));
        return false;
    }
    target = static_cast<std::int32_t>(value->get());
    return true;
}

bool TableReader::text(std::string_view key, std::string& target) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    if (!node->is_string()) {
        report_.error(position_of(*node), must_be(in_quotes(key), "a string in quotes", *node));
        return false;
    }
    target = node->as_string()->get();
    return true;
}

bool TableReader::truth(std::string_view key, bool& target) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    if (!node->is_boolean()) {
        report_.error(position_of(*node), must_be(in_quotes(key), "true or false", *node));
        return false;
    }
    target = node->as_boolean()->get();
    return true;
}

int TableReader::index_of_word(std::string_view key, Words words) {
    std::string word;
    if (!text(key, word)) return -1;
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<int>(found - words.begin());
    const std::string all = "it is one of: " + listed(words);
    report_.error(place_of(key), "unknown " + std::string(key) + " " + in_quotes(word), did_you_mean(word, words, all));
    return -1;
}

void TableReader::wrong_count(const toml::array& array, std::string_view name, std::size_t count) {
    const Position at = position_of(array);
    const SourceText& source = report_.source();
    const std::size_t first = source.byte_at(at.line, at.column);
    const auto& end = array.source().end;
    const std::size_t last = source.byte_at(static_cast<int>(end.line), static_cast<int>(end.column));
    std::string help;
    if (array.size() > count) {
        const auto comma = decimal_comma_in_array(source.text().substr(first, last - first));
        if (comma) help = "write " + comma->repaired + ", with a point";
    }
    report_.error(
        at,
        std::string(name) + " needs " + std::to_string(count) + " numbers, here are " + std::to_string(array.size()),
        help);
}

std::optional<std::vector<double>> TableReader::numbers(const toml::node& node, std::string_view name,
                                                        std::size_t count, const Range& range) {
    const toml::array* array = node.as_array();
    if (array == nullptr) {
        report_.error(position_of(node), must_be(name, "an array of " + std::to_string(count) + " numbers", node));
        return std::nullopt;
    }
    if (array->size() != count) {
        wrong_count(*array, name, count);
        return std::nullopt;
    }
    std::vector<double> values(count);
    bool right = true;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string element = "number " + std::to_string(i + 1) + " of " + std::string(name);
        right = number_in((*array)[i], element, range, values[i]) && right;
    }
    return right ? std::optional(values) : std::nullopt;
}

bool TableReader::point(std::string_view key, Vec3<double>& target, const Range& range) {
    const toml::node* node = find(key);
    if (node == nullptr) return false;
    const auto values = numbers(*node, in_quotes(key), 3, range);
    if (values) target = {(*values)[0], (*values)[1], (*values)[2]};
    return values.has_value();
}

bool TableReader::direction(std::string_view key, Vec3<double>& target) {
    Vec3<double> value{};
    if (!point(key, value, kFinite)) return false;
    if (value.x == 0 && value.y == 0 && value.z == 0) {
        report_.error(place_of(key), in_quotes(key) + " is a direction: it must not be all zero");
        return false;
    }
    target = value;
    return true;
}

bool TableReader::color(std::string_view key, const Range& range, Rgb<double>& target) {
    Vec3<double> channels{};
    if (!point(key, channels, range)) return false;
    target = {channels.x, channels.y, channels.z};
    return true;
}

Position TableReader::place_of(std::string_view key) const {
    const toml::node* node = find(key);
    return node != nullptr ? position_of(*node) : header_of(table_);
}

}  // namespace zerkalo::scene_file
