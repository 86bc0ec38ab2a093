// See stage.hpp.
#include "tools/stability/stage.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::stability {

Rgb<float> Picture::at(int x, int y) const {
    const float* pixel = rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                           static_cast<std::size_t>(x));
    return {pixel[0], pixel[1], pixel[2]};
}

bool Picture::finite() const {
    for (const float value : rgb) {
        if (!std::isfinite(value)) return false;
    }
    return true;
}

Refused::Refused(const Status& status)
    : std::runtime_error(std::string(name_of(status.part)) + ": " + status.field + ": " + status.reason),
      field(status.field) {}

Prepared::Prepared(const Scene& scene, const Settings& settings, Isa isa, Number number) : isa_(isa) {
    if (number == Number::fixed) {
        fixed_plan_ = std::make_unique<FixedPlan>();
    } else {
        plan_ = std::make_unique<Plan>();
    }
    const Status status = with_plan([&](auto& plan) { return prepare(scene, settings, plan); });
    if (!status.ok()) throw Refused(status);
}

const PlanHead& Prepared::head() const {
    if (plan_) return *plan_;
    return *fixed_plan_;
}

void Prepared::draw(const Rect& tile, const LinearImage& image) const {
    RayCounts unused;
    with_plan([&](const auto& plan) { kernel_for(plan, isa_)(plan, tile, image, unused); });
}

Prepared Stage::prepared(const Scene& scene, int width, int height, Settings settings) const {
    settings.width = width;
    settings.height = height;
    return Prepared(scene, settings, isa_, number_);
}

Picture Stage::render(const Scene& scene, int width, int height, const Settings& settings) const {
    const Prepared frame = prepared(scene, width, height, settings);
    Picture picture{width, height, {}};
    picture.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const LinearImage image{picture.rgb.data(), width, height, std::ptrdiff_t{12} * width};
    for (int i = 0; i < frame.tiles(); ++i) frame.draw(frame.tile(i), image);
    return picture;
}

Rgb<float> Stage::look(Scene scene, const Vec3<double>& origin, const Vec3<double>& view,
                       const Settings& settings) const {
    constexpr double kAnyAngle = 0.1;  // the centre of the only pixel lies on the axis
    scene.camera = camera_at(origin, view, kAnyAngle);
    return render(scene, 1, 1, settings).at(0, 0);
}

std::string Stage::refused_field(const Scene& scene) const {
    try {
        Prepared(scene, {}, isa_, number_);
    } catch (const Refused& refused) {
        return refused.field;
    }
    return "";
}

bool Stage::beyond_formats(const Scene& scene, const char* field) const {
    if (!fixed() || refused_field(scene) != field) return false;
    refused_ = field;
    return true;
}

std::vector<Isa> stages(Number number) {
    const auto any_fixed_plan = std::make_unique<FixedPlan>();
    std::vector<Isa> isas;
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        const auto shares_kernel = [&](Isa before) {
            return number == Number::fixed && kernel_for(*any_fixed_plan, before) == kernel_for(*any_fixed_plan, isa);
        };
        if (available(isa) && std::none_of(isas.begin(), isas.end(), shares_kernel)) isas.push_back(isa);
    }
    return isas;
}

int pixels_apart(const Picture& a, const Picture& b, double tolerance) {
    if (a.rgb.size() != b.rgb.size()) return a.width * a.height;
    int apart = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool near = true;
        for (std::size_t c = i; c < i + 3; ++c) {
            near = near && std::abs(double{a.rgb[c]} - double{b.rgb[c]}) <= tolerance;
        }
        apart += !near;
    }
    return apart;
}

double largest_difference(const Picture& a, const Picture& b) {
    if (a.rgb.size() != b.rgb.size()) return kInfinity;
    double largest = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const double difference = std::abs(double{a.rgb[i]} - double{b.rgb[i]});
        if (!(difference <= largest)) largest = std::isnan(difference) ? kInfinity : difference;
    }
    return largest;
}

}  // namespace zerkalo::stability
