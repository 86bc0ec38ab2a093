#include "tools/study/light_picture.hpp"

#include "tools/zerkalo/refine.hpp"

namespace zerkalo::study {

LightPicture light_of(const LinearImage& image) {
    LightPicture light{image.width, image.height, {}};
    light.rgb.reserve(std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (std::int32_t y = 0; y < image.height; ++y) {
        const float* row = image.row(y);
        light.rgb.insert(light.rgb.end(), row, row + std::ptrdiff_t{3} * image.width);
    }
    return light;
}

LightPicture rendered(const Renderer& renderer, const Scene& scene, const Settings& settings, Number number,
                      RayCounts* rays) {
    if (renderer.stopped && renderer.stopped->load(std::memory_order_relaxed)) throw Interrupted();
    const Frame frame = prepare_frame(scene, settings, renderer.isa, renderer.threads, number);
    const FrameCost cost = render_frame(frame, 1, false);
    if (rays) *rays = cost.rays;
    return light_of(frame.image);
}

LightPicture rendered_to_error(const Renderer& renderer, const Scene& scene, const Settings& settings, double error,
                               RayCounts* rays) {
    if (renderer.stopped && renderer.stopped->load(std::memory_order_relaxed)) throw Interrupted();
    const Frame frame = prepare_frame(scene, settings, renderer.isa, renderer.threads, Number::floating);
    const std::atomic<bool> never{false};
    const Refined refined = refine_to_error(frame, error, never, false);
    if (rays) *rays = refined.cost.rays;
    return light_of(frame.image);
}

LightPicture rendered_exactly(const Renderer& renderer, const Scene& scene, const Settings& settings) {
    return rendered(renderer, scene, settings, Number::double_precision);
}

}  // namespace zerkalo::study
