// Reads the keys of one table of a scene file. Whatever is wrong becomes an error and leaves the target as it was.
#pragma once

#include "tools/scene_file/range.hpp"
#include "tools/scene_file/report.hpp"
#include "tools/scene_file/toml_tree.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace zerkalo::scene_file {

using Words = std::span<const std::string_view>;

class TableReader {
public:
    /// `what` names the table in messages, with its article: "the camera", "a sphere".
    TableReader(const toml::table& table, std::string what, Report& report);

    /// Every key that is not among `keys` is an error; one that is among `keys_of_siblings` does not belong here.
    /// From then on keys that are not allowed count as absent: one slip is one error.
    void allow(Words keys, Words keys_of_siblings = {});
    void require(std::string_view key);
    /// An error at `key`, which has moved something to `place`, where that is no coordinate any more.
    void require_reachable(std::string_view key, const Vec3<double>& place);
    /// Not both. Returns false after an error.
    bool at_most_one(std::string_view first, std::string_view second);
    /// Exactly one of the two. Returns false after an error.
    bool exactly_one(std::string_view first, std::string_view second);

    bool has(std::string_view key) const { return find(key) != nullptr; }
    const toml::node* find(std::string_view key) const;

    /// Each returns true when the key is there and right. Absent keys are no error.
    bool number(std::string_view key, const Range& range, double& target);
    bool integer(std::string_view key, std::int32_t low, std::int32_t high, std::int32_t& target);
    bool text(std::string_view key, std::string& target);
    bool truth(std::string_view key, bool& target);
    bool point(std::string_view key, Vec3<double>& target, const Range& range = kCoordinate);
    bool direction(std::string_view key, Vec3<double>& target);
    bool color(std::string_view key, const Range& range, Rgb<double>& target);

    /// A word out of a closed list, in the order of the enumeration.
    template <class E>
    bool choice(std::string_view key, Words words, E& target) {
        const int index = index_of_word(key, words);
        if (index >= 0) target = static_cast<E>(index);
        return index >= 0;
    }

    /// An array of exactly `count` numbers (a value of this table, or one nested in it). `name`: how messages call it.
    std::optional<std::vector<double>> numbers(const toml::node& node, std::string_view name, std::size_t count,
                                               const Range& range);

    /// The place of the key's value; of the table's header when the key is absent.
    Position place_of(std::string_view key) const;
    void error(Position at, std::string message, std::string help = {}) { report_.error(at, message, help); }
    Report& report() { return report_; }
    const std::string& what() const { return what_; }

private:
    int index_of_word(std::string_view key, Words words);
    bool number_in(const toml::node& node, const std::string& name, const Range& range, double& target);
    void wrong_count(const toml::array& array, std::string_view name, std::size_t count);

    const toml::table& table_;
    std::string what_;
    std::vector<std::string_view> allowed_;  // empty: every key
    Report& report_;
};

/// "a string", "nan", "-1", "0.5": what stands there, for "must be ..., not ...".
std::string described(const toml::node& node);

/// The position of any node's text.
inline Position position_of(const toml::node& node) { return position_of(node.source()); }

/// The place of a table's header; the first character of the file for the root.
Position header_of(const toml::table& table);

}  // namespace zerkalo::scene_file
