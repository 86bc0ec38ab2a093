#include "tests/bad_input/verdict.hpp"

#include "core/scene/validate.hpp"
#include "tests/laws/rendering.hpp"

#include <algorithm>
#include <limits>

namespace zerkalo::bad_input {
namespace {

// No lane width divides the columns; one tile and a bit.
constexpr Settings kSettings{.width = 11, .height = 9, .samples = 3, .antialias = 1, .depth_limit = 3};

std::string described(const Status& status) {
    return std::string(name_of(status.part)) + " " + std::to_string(status.index) + " " + status.field + ": " +
           status.reason;
}

// Finite; and not below 0 but for what is left when a lobe's rays take the background away again, which was added
// first.
bool is_light(float value, float background) {
    constexpr float kRounding = 0x1p-20f;
    return value >= -kRounding * background && value <= std::numeric_limits<float>::max();
}

}  // namespace

Judge::Judge(Thoroughness thoroughness)
    : thoroughness_(thoroughness), isas_(laws::available_isas()), plan_(std::make_unique<Plan>()) {
    std::erase(isas_, Isa::scalar);
}

std::string Judge::verdict(const Scene& scene, std::span<const Field> changed) {
    const Status status = prepare(scene, kSettings, *plan_);
    const Status gate = validate(scene);
    if (status.ok() != gate.ok()) return "prepare() and validate() disagree: " + described(gate.ok() ? status : gate);
    if (status.ok()) {
        ++accepted_;
        return picture_fault();
    }
    ++refused_;
    if (std::string_view(status.field) != gate.field) return "prepare() names " + described(status);
    const bool named = std::any_of(changed.begin(), changed.end(), [&](const Field& f) { return names(status, f); });
    return named ? "" : "refused for another field: " + described(status);
}

std::string Judge::picture_fault() {
    const laws::Image serial = laws::render(*plan_, Isa::scalar);
    const Rgb<float>& behind = plan_->background;
    const float background = std::max({behind.r, behind.g, behind.b});
    const auto bad = std::find_if_not(serial.rgb.begin(), serial.rgb.end(),
                                      [background](float value) { return is_light(value, background); });
    if (bad != serial.rgb.end()) {
        return "accepted, and value " + std::to_string(bad - serial.rgb.begin()) + " of the picture is " +
               std::to_string(*bad);
    }
    const bool all = thoroughness_ == Thoroughness::every_isa;
    for (std::size_t i = 0; i < (all ? isas_.size() : std::min<std::size_t>(1, isas_.size())); ++i) {
        const Isa isa = isas_[all ? i : turn_++ % isas_.size()];
        if (laws::render(*plan_, isa).rgb != serial.rgb) return std::string(name_of(isa)) + " gives another picture";
    }
    return "";
}

}  // namespace zerkalo::bad_input
