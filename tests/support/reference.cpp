// Pixels and pictures by the reference tracer.
#include "tests/support/reference.hpp"

#include <atomic>
#include <thread>

namespace zerkalo {
namespace {

ImageSize size_of(const Scene& scene, const Settings& settings) {
    return {settings.width > 0 ? settings.width : scene.image.width,
            settings.height > 0 ? settings.height : scene.image.height};
}

Rgb<double> pixel(const reference::Tracer& tracer, const Camera& camera, ImageSize size, int x, int y,
                  std::uint64_t seed) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)};
    reference::Random random(sequence);
    const reference::Color c = tracer.radiance(reference::camera_ray(camera, size.width, size.height, x, y), random);
    return {c.x, c.y, c.z};
}

}  // namespace

Rgb<double> reference_pixel(const Scene& scene, const Settings& settings, int x, int y, unsigned lobe_samples,
                            std::uint64_t seed) {
    const reference::Tracer tracer(scene, settings, lobe_samples);
    return pixel(tracer, scene.camera, size_of(scene, settings), x, y, seed);
}

reference::Picture reference_picture(const Scene& scene, const Settings& settings, unsigned lobe_samples,
                                     std::uint64_t seed) {
    const reference::Tracer tracer(scene, settings, lobe_samples);
    const ImageSize size = size_of(scene, settings);
    reference::Picture picture{size.width, size.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(size.width) * size.height);
    std::atomic<int> next_row{0};
    const auto work = [&] {
        for (int y = next_row++; y < size.height; y = next_row++)
            for (int x = 0; x < size.width; ++x)
                picture.pixels[static_cast<std::size_t>(y) * size.width + x] =
                    pixel(tracer, scene.camera, size, x, y, seed);
    };
    std::thread second(work);
    work();
    second.join();
    return picture;
}

}  // namespace zerkalo
