// See rendering.hpp.
#include "tests/laws/rendering.hpp"

#include "core/image/hash.hpp"

#include <bit>
#include <memory>
#include <stdexcept>
#include <string>

namespace zerkalo::laws {
namespace {

template <class AnyPlan>
Image tiles_of(const AnyPlan& plan, Isa isa) {
    Image image{plan.width, plan.height, {}, {}};
    image.rgb.resize(std::size_t{3} * plan.width * plan.height);
    const auto render_tile = kernel_for(plan, isa);
    for (int i = 0; i < tile_count(plan); ++i) render_tile(plan, tile_at(plan, i), image.view(), image.rays);
    return image;
}

template <class AnyPlan>
Image rendered(const Scene& scene, const Settings& settings, Isa isa) {
    const auto plan = std::make_unique<AnyPlan>();
    prepare_or_throw(scene, settings, *plan);
    return tiles_of(*plan, isa);
}

}  // namespace

LinearImage Image::view() const {
    // The view is only read: LinearImage has no const form.
    return {const_cast<float*>(rgb.data()), width, height, std::ptrdiff_t{12} * width};
}

Rgb<float> Image::at(int x, int y) const {
    const float* pixel = rgb.data() + 3 * (static_cast<std::size_t>(y) * width + x);
    return {pixel[0], pixel[1], pixel[2]};
}

std::uint64_t Image::hash() const { return hash_of(view()); }

template <class AnyPlan>
void prepare_or_throw(const Scene& scene, const Settings& settings, AnyPlan& plan) {
    const Status status = prepare(scene, settings, plan);
    if (!status.ok()) {
        throw std::runtime_error(std::string(name_of(status.part)) + ": " + status.field + ": " + status.reason);
    }
}

template void prepare_or_throw(const Scene&, const Settings&, Plan&);
template void prepare_or_throw(const Scene&, const Settings&, FixedPlan&);
template void prepare_or_throw(const Scene&, const Settings&, DoublePlan&);

Image render(const Plan& plan, Isa isa) { return tiles_of(plan, isa); }
Image render(const DoublePlan& plan) { return tiles_of(plan, Isa::scalar); }

Image render(const Scene& scene, const Settings& settings, Isa isa) { return rendered<Plan>(scene, settings, isa); }
Image render_fixed(const Scene& scene, const Settings& settings, Isa isa) {
    return rendered<FixedPlan>(scene, settings, isa);
}
Image render_double(const Scene& scene, const Settings& settings) {
    return rendered<DoublePlan>(scene, settings, Isa::scalar);
}

std::vector<Isa> available_isas() {
    std::vector<Isa> isas;
    for (int i = 0; i < kIsaCount; ++i) {
        if (available(static_cast<Isa>(i))) isas.push_back(static_cast<Isa>(i));
    }
    return isas;
}

double largest_difference(const Image& a, const Image& b) {
    return reference::compare(picture_of(a), picture_of(b), 0).max;
}

int pixels_apart(const Image& a, const Image& b) {
    if (a.rgb.size() != b.rgb.size()) throw std::invalid_argument("pictures of different sizes cannot be compared");
    int apart = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool same = true;
        for (std::size_t c = i; c < i + 3; ++c) {
            same = same && std::bit_cast<std::uint32_t>(a.rgb[c]) == std::bit_cast<std::uint32_t>(b.rgb[c]);
        }
        apart += !same;
    }
    return apart;
}

Image scaled(Image image, float factor) {
    for (float& value : image.rgb) value *= factor;
    return image;
}

Image flipped(const Image& image) {
    Image out = image;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Rgb<float> pixel = image.at(image.width - 1 - x, y);
            float* to = out.rgb.data() + 3 * (static_cast<std::size_t>(y) * image.width + x);
            to[0] = pixel.r, to[1] = pixel.g, to[2] = pixel.b;
        }
    }
    return out;
}

}  // namespace zerkalo::laws
