#include "tools/zerkalo/json.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace zerkalo {
namespace {

// Length of the well-formed UTF-8 sequence at the head of `text`; 0 when there is none (RFC 3629, section 4).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const auto tail = [&](std::size_t i) { return (byte(i) & 0xc0u) == 0x80u; };
    const unsigned head = byte(0);
    if (head < 0x80) return 1;
    if (head >= 0xc2 && head <= 0xdf) return tail(1) ? 2 : 0;
    if (head >= 0xe0 && head <= 0xef) {
        const bool overlong = head == 0xe0 && byte(1) < 0xa0, surrogate = head == 0xed && byte(1) > 0x9f;
        return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (head >= 0xf0 && head <= 0xf4) {
        const bool overlong = head == 0xf0 && byte(1) < 0x90, too_large = head == 0xf4 && byte(1) > 0x8f;
        return tail(1) && tail(2) && tail(3) && !overlong && !too_large ? 4 : 0;
    }
    return 0;
}

void append_quoted(std::string& out, std::string_view text) {
    out += '"';
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char head = text.front();
        if (length == 0) {
            out += "\xef\xbf\xbd";
        } else if (head == '"' || head == '\\') {
            out += '\\';
            out += head;
        } else if (static_cast<unsigned char>(head) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(head));
            out += escape;
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    out += '"';
}

template <class Item, class Append>
void append_list(std::string& out, const std::vector<Item>& items, Append append) {
    out += '[';
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) out += ", ";
        append(items[i]);
    }
    out += ']';
}

}  // namespace

std::string& JsonObject::member(std::string_view name) {
    if (!members_.empty()) members_ += ", ";
    append_quoted(members_, name);
    return members_ += ": ";
}

JsonObject& JsonObject::text(std::string_view name, std::string_view value) {
    append_quoted(member(name), value);
    return *this;
}

JsonObject& JsonObject::number(std::string_view name, double value) {
    std::string& out = member(name);
    if (!std::isfinite(value)) {
        out += "null";
        return *this;
    }
    char digits[32];
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    return *this;
}

JsonObject& JsonObject::integer(std::string_view name, std::int64_t value) {
    member(name) += std::to_string(value);
    return *this;
}

JsonObject& JsonObject::flag(std::string_view name, bool value) {
    member(name) += value ? "true" : "false";
    return *this;
}

JsonObject& JsonObject::object(std::string_view name, const JsonObject& value) {
    member(name) += value.str();
    return *this;
}

JsonObject& JsonObject::list(std::string_view name, const std::vector<std::string>& values) {
    std::string& out = member(name);
    append_list(out, values, [&](const std::string& value) { append_quoted(out, value); });
    return *this;
}

JsonObject& JsonObject::list(std::string_view name, const std::vector<JsonObject>& values) {
    std::string& out = member(name);
    append_list(out, values, [&](const JsonObject& value) { out += value.str(); });
    return *this;
}

}  // namespace zerkalo
