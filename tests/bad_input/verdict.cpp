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

// "" when every value is light.
std::string darkness(const laws::Image& image, const Rgb<float>& behind, const char* picture) {
    const float background = std::max({behind.r, behind.g, behind.b});
    const auto bad = std::find_if_not(image.rgb.begin(), image.rgb.end(),
                                      [background](float value) { return is_light(value, background); });
    if (bad == image.rgb.end()) return "";
    return "accepted, and value " + std::to_string(bad - image.rgb.begin()) + " of " + picture + " is " +
           std::to_string(*bad);
}

}  // namespace

Judge::Judge(Thoroughness thoroughness)
    : thoroughness_(thoroughness), isas_(laws::available_isas()), plan_(std::make_unique<Plan>()),
      double_plan_(std::make_unique<DoublePlan>()) {
    std::erase(isas_, Isa::scalar);
}

std::string Judge::verdict(const Scene& scene, std::span<const Field> changed) {
    const Status status = prepare(scene, kSettings, *plan_);
    const Status gate = validate(scene);
    if (status.ok() != gate.ok()) return "prepare() and validate() disagree: " + described(gate.ok() ? status : gate);
    if (status.ok()) {
        ++accepted_;
        const std::string fault = picture_fault();
        return fault.empty() ? fault_in_double(scene) : fault;
    }
    ++refused_;
    if (std::string_view(status.field) != gate.field) return "prepare() names " + described(status);
    const bool named = std::any_of(changed.begin(), changed.end(), [&](const Field& f) { return names(status, f); });
    return named ? "" : "refused for another field: " + described(status);
}

std::string Judge::fault_in_double(const Scene& scene) {
    const Status status = prepare(scene, kSettings, *double_plan_);
    if (!status.ok()) return "float accepts and double refuses: " + described(status);
    return darkness(laws::render(*double_plan_), plan_->background, "the picture in double");
}

std::string Judge::picture_fault() {
    const laws::Image serial = laws::render(*plan_, Isa::scalar);
    if (const std::string dark = darkness(serial, plan_->background, "the picture"); !dark.empty()) return dark;
    const bool all = thoroughness_ == Thoroughness::every_isa;
    for (std::size_t i = 0; i < (all ? isas_.size() : std::min<std::size_t>(1, isas_.size())); ++i) {
        const Isa isa = isas_[all ? i : turn_++ % isas_.size()];
        if (laws::render(*plan_, isa).rgb != serial.rgb) return std::string(name_of(isa)) + " gives another picture";
    }
    return "";
}

}  // namespace zerkalo::bad_input
