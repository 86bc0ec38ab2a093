// Whole pictures through the public interface, for tests: one call from a scene to its pixels and ray counts.
#pragma once

#include "core/render/render.hpp"
#include "tests/support/images.hpp"

#include <vector>

namespace zerkalo::laws {

/// Linear RGB, row-major without padding, and the rays that it took.
struct Image {
    int width = 0, height = 0;
    std::vector<float> rgb;
    RayCounts rays;

    LinearImage view() const;
    Rgb<float> at(int x, int y) const;
    std::uint64_t hash() const;
};

/// The picture of a scene, tile by tile. Throws std::runtime_error when prepare() refuses, with its reason.
Image render(const Scene& scene, const Settings& settings, Isa isa = best_isa());

/// The same from a plan that is prepared already.
Image render(const Plan& plan, Isa isa = best_isa());
Image render(const DoublePlan& plan);

/// The picture in fixed point. Throws std::runtime_error when prepare() refuses.
Image render_fixed(const Scene& scene, const Settings& settings, Isa isa = best_isa());

/// The picture in double, rounded to float pixel by pixel. Throws std::runtime_error when prepare() refuses.
Image render_double(const Scene& scene, const Settings& settings);

/// Throws std::runtime_error when prepare() refuses.
template <class AnyPlan>
void prepare_or_throw(const Scene& scene, const Settings& settings, AnyPlan& plan);

/// Every instruction set that this program has and this CPU can run.
std::vector<Isa> available_isas();

inline Settings of_size(int width, int height) {
    Settings settings;
    settings.width = width;
    settings.height = height;
    return settings;
}

inline reference::Picture picture_of(const Image& image) { return reference::picture_of(image.view()); }

/// Largest difference of a channel between two pictures of one size; infinite where one holds a NaN.
double largest_difference(const Image& a, const Image& b);

/// Pixels in which two pictures of one size differ in any bit.
int pixels_apart(const Image& a, const Image& b);

/// Every value times `factor`.
Image scaled(Image image, float factor);

/// Right becomes left.
Image flipped(const Image& image);

}  // namespace zerkalo::laws
