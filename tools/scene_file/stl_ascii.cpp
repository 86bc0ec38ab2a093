// The ASCII form of STL: solid NAME { facet normal x y z, outer loop, 3 x vertex x y z, endloop, endfacet } endsolid.
#include "tools/scene_file/stl.hpp"

#include <charconv>

namespace zerkalo::scene_file {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

class AsciiStl {
public:
    explicit AsciiStl(const SourceText& file) : file_(file), text_(file.text()) {}

    bool at_end() const { return text_.find_first_not_of(kSpace, next_) == std::string_view::npos; }

    bool next_is(std::string_view word) const {
        const std::size_t first = text_.find_first_not_of(kSpace, next_);
        return first != std::string_view::npos && is_word(word_from(first), word);
    }

    /// Reads one keyword. False after a fault.
    bool expect(std::string_view word) {
        const std::string_view found = take();
        if (is_word(found, word)) return true;
        return fail(found, "expected " + in_quotes(word));
    }

    bool expect_all(std::initializer_list<std::string_view> words) {
        for (const std::string_view word : words) {
            if (!expect(word)) return false;
        }
        return true;
    }

    /// Reads one number; a facet's normal may be any, a coordinate must be within `limit`.
    bool number(double& value, double limit) {
        std::string_view found = take();
        const std::string_view digits = found.starts_with('+') ? found.substr(1) : found;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool whole = status == std::errc{} && end == digits.data() + digits.size();
        if (whole && (limit == kInfinity || (value >= -limit && value <= limit))) return true;
        return fail(found, "expected a number from -1e15 to 1e15");
    }

    bool point(Vec3<double>& p, double limit) { return number(p.x, limit) && number(p.y, limit) && number(p.z, limit); }

    void skip_line() { next_ = std::min(text_.find('\n', next_), text_.size()); }

    StlFault fault_here(std::string message) const {
        return {file_.position_at(word_start_, static_cast<int>(word_size_)), std::move(message)};
    }
    const StlFault& fault() const { return fault_; }

private:
    std::string_view word_from(std::size_t first) const {
        return text_.substr(first, std::min(text_.find_first_of(kSpace, first), text_.size()) - first);
    }

    std::string_view take() {
        const std::size_t last_end = next_;
        const std::size_t first = text_.find_first_not_of(kSpace, next_);
        word_start_ = first == std::string_view::npos ? last_end : first;
        const std::string_view word = first == std::string_view::npos ? std::string_view{} : word_from(first);
        word_size_ = std::max<std::size_t>(1, word.size());
        next_ = word_start_ + word.size();
        return word;
    }

    bool fail(std::string_view found, const std::string& expected) {
        fault_ = fault_here(expected + (found.empty() ? ", but the file ends here" : ", not " + in_quotes(found)));
        return false;
    }

    static bool is_word(std::string_view found, std::string_view word) {
        if (found.size() != word.size()) return false;
        for (std::size_t i = 0; i < word.size(); ++i) {
            if ((found[i] | 0x20) != word[i]) return false;
        }
        return true;
    }

    const SourceText& file_;
    std::string_view text_;
    std::size_t next_ = 0, word_start_ = 0, word_size_ = 1;
    StlFault fault_;
};

bool read_facet(AsciiStl& stl, Triangle& triangle) {
    Vec3<double> normal{};
    return stl.expect_all({"facet", "normal"}) && stl.point(normal, kInfinity) &&
           stl.expect_all({"outer", "loop", "vertex"}) && stl.point(triangle.a, kMaxCoordinate) &&
           stl.expect("vertex") && stl.point(triangle.b, kMaxCoordinate) && stl.expect("vertex") &&
           stl.point(triangle.c, kMaxCoordinate) && stl.expect_all({"endloop", "endfacet"});
}

}  // namespace

std::optional<StlFault> read_ascii_stl(const SourceText& file, int room, std::vector<Triangle>& triangles) {
    AsciiStl stl(file);
    int count = 0;
    do {
        if (!stl.expect("solid")) return stl.fault();
        stl.skip_line();
        while (!stl.next_is("endsolid")) {
            Triangle triangle{};
            if (!read_facet(stl, triangle)) return stl.fault();
            if (++count > room) return stl.fault_here("more triangles than fit: " + too_many_triangles(room));
            triangles.push_back(triangle);
        }
        if (!stl.expect("endsolid")) return stl.fault();
        stl.skip_line();
    } while (!stl.at_end());
    return std::nullopt;
}

}  // namespace zerkalo::scene_file
