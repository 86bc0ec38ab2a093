#include "tests/bad_input/bad_values.hpp"

#include <iterator>
#include <sstream>

namespace zerkalo::bad_input {
namespace {

std::uint8_t meaningless(const Field& field, int value) {
    return value == 0 ? field.choices : std::numeric_limits<std::uint8_t>::max();
}

}  // namespace

int value_count(const Field& field) {
    switch (field.type) {
        case FieldType::real: return static_cast<int>(std::size(kBadReals));
        case FieldType::whole: return static_cast<int>(std::size(kBadWholes));
        case FieldType::choice:
        case FieldType::truth: break;
    }
    return 2;
}

void spoil(Scene& scene, const Field& field, int value) {
    switch (field.type) {
        case FieldType::real: return set(scene, field, kBadReals[value]);
        case FieldType::whole: return set(scene, field, kBadWholes[value]);
        case FieldType::choice: return set(scene, field, meaningless(field, value));
        case FieldType::truth: return set(scene, field, static_cast<std::uint8_t>(value));
    }
}

std::string text_of(const Field& field, int value) {
    std::ostringstream text;
    text << text_of(field) << " = ";
    switch (field.type) {
        case FieldType::real: text << kBadReals[value]; break;
        case FieldType::whole: text << kBadWholes[value]; break;
        case FieldType::choice: text << "choice " << int{meaningless(field, value)}; break;
        case FieldType::truth: text << (value == 0 ? "false" : "true"); break;
    }
    return text.str();
}

}  // namespace zerkalo::bad_input
