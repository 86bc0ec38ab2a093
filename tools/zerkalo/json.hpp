// One JSON object, written member by member in the order of the calls (RFC 8259).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace zerkalo {

/// Numbers are printed with as many digits as identify them, independent of the locale; a number that JSON cannot
/// hold (NaN, infinity) becomes null. Bytes that are not UTF-8 become U+FFFD.
class JsonObject {
public:
    JsonObject& text(std::string_view name, std::string_view value);
    JsonObject& number(std::string_view name, double value);
    JsonObject& integer(std::string_view name, std::int64_t value);
    JsonObject& flag(std::string_view name, bool value);
    JsonObject& object(std::string_view name, const JsonObject& value);
    JsonObject& list(std::string_view name, const std::vector<std::string>& values);
    JsonObject& list(std::string_view name, const std::vector<JsonObject>& values);

    std::string str() const { return "{" + members_ + "}"; }

private:
    std::string& member(std::string_view name);

    std::string members_;
};

}  // namespace zerkalo
