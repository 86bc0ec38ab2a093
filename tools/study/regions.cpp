#include "tools/study/regions.hpp"

#include "core/optics/shares.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace zerkalo::study {
namespace {

constexpr int kLobeSamples = 256;
constexpr double kMirrorAmbient = 0.5;

double step_of(const Scene& scene) { return 1.0 / (scene.solid_count + scene.mirror_count + 1); }

Material flat_material(const Rgb<double>& color) {
    Material material;
    material.color = color;
    material.ambient = 1;
    material.diffuse = material.specular = material.reflection = material.transmission = 0;
    return material;
}

// Mirrors that show what they reflect and nothing else, every ray with the same weight.
void show_reflections_alone(Scene& scene) {
    for (int k = 0; k < scene.mirror_count; ++k) {
        Mirror& mirror = scene.mirrors[k];
        mirror.lobe = Lobe::phong;
        mirror.color = {1, 1, 1};
        mirror.ambient = mirror.diffuse = mirror.specular = 0;
        mirror.reflection = 1;
    }
}

// No lights, ambient light alone: a solid's colour is (its number, 1, its number squared), the background (0, 1, 0).
std::unique_ptr<Scene> numbered(const Scene& scene) {
    auto ids = std::make_unique<Scene>(scene);
    ids->light_count = 0;
    ids->ambient = {1, 1, 1};
    ids->background = {0, 1, 0};
    for (int k = 0; k < ids->solid_count; ++k) {
        const double id = (k + 1) * step_of(scene);
        ids->solids[k].material = flat_material({id, 1, id * id});
    }
    show_reflections_alone(*ids);
    return ids;
}

Settings settings_for(const ImageSize& size, int depth_limit) {
    Settings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.depth_limit = depth_limit;
    settings.samples = kLobeSamples;
    return settings;
}

constexpr int kChannels = 3;

// Lights `first` and the next two, each in a channel of its own; solids are white where they are lit and black
// elsewhere: a highlight with the exponent 0 is the same from everywhere.
std::unique_ptr<Scene> lit(const Scene& scene, int first) {
    auto shadows = std::make_unique<Scene>(scene);
    shadows->ambient = shadows->background = {0, 0, 0};
    shadows->light_count = std::min(kChannels, scene.light_count - first);
    for (int j = 0; j < shadows->light_count; ++j) {
        Light& light = shadows->lights[j] = scene.lights[first + j];
        light.color = {j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0};
        light.intensity = 1;
        light.falloff = Falloff::none;
    }
    for (int k = 0; k < shadows->solid_count; ++k) {
        Material& material = shadows->solids[k].material = flat_material({1, 1, 1});
        material.ambient = 0;
        material.specular = 1;
        material.shininess = 0;
    }
    show_reflections_alone(*shadows);
    return shadows;
}

// The object that the camera ray meets first: red is its number.
LightPicture objects_of(const Renderer& renderer, const Scene& scene, const ImageSize& size) {
    const auto ids = numbered(scene);
    for (int k = 0; k < ids->mirror_count; ++k) {
        ids->mirrors[k].ambient = 1;
        ids->mirrors[k].color = {(scene.solid_count + k + 1) * step_of(scene), 0, 0};
        ids->mirrors[k].reflection = 0;
    }
    return rendered(renderer, *ids, settings_for(size, 0), Number::floating);
}

// What the polished mirrors show. The front of a mirror adds what it reflects to its own grey, its back does not.
LightPicture images_of(const Renderer& renderer, const Scene& scene, const ImageSize& size) {
    const auto ids = numbered(scene);
    for (int k = 0; k < ids->mirror_count; ++k) {
        ids->mirrors[k].ambient = kMirrorAmbient;
        ids->mirrors[k].lobe_exponent = kInfinity;
    }
    return rendered(renderer, *ids, settings_for(size, 1), Number::floating);
}

class PixelGrid {
public:
    PixelGrid(const LightPicture& objects, const LightPicture& images) : objects_(objects), images_(images) {}

    double object(std::size_t pixel) const { return objects_.rgb[3 * pixel]; }
    bool front(std::size_t pixel) const { return images_.rgb[3 * pixel + 1] > 1.25 * kMirrorAmbient; }

    // True when the two pixels see different objects, or different images in a mirror.
    bool apart(std::size_t a, std::size_t b) const {
        return object(a) != object(b) || images_.rgb[3 * a] != images_.rgb[3 * b] ||
               images_.rgb[3 * a + 1] != images_.rgb[3 * b + 1];
    }

private:
    const LightPicture &objects_, &images_;
};

Mask silhouettes_of(const PixelGrid& grid, const ImageSize& size) {
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    Mask mask(width * height);
    const auto compare = [&](std::size_t a, std::size_t b) {
        if (grid.apart(a, b)) mask[a] = mask[b] = true;
    };
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t pixel = y * width + x;
            if (x + 1 < width) compare(pixel, pixel + 1);
            if (y + 1 < height) compare(pixel, pixel + width);
        }
    }
    return mask;
}

// Takes the pixels away whose lobe meets lit and unlit places.
void leave_out_shadow_rims(const Renderer& renderer, const Scene& scene, const ImageSize& size, Mask& mask) {
    constexpr float kRounding = 1e-5f;  // far below what the ray at the rim of a lobe counts for
    for (int first = 0; first < scene.light_count; first += kChannels) {
        const LightPicture lights = rendered(renderer, *lit(scene, first), settings_for(size, 1), Number::floating);
        for (std::size_t i = 0; i < lights.rgb.size(); ++i) {
            if (lights.rgb[i] > kRounding && lights.rgb[i] < 1 - kRounding) mask[i / kChannels] = false;
        }
    }
}

}  // namespace

std::int64_t pixels_of(const Mask& mask) { return std::count(mask.begin(), mask.end(), true); }

Regions regions_of(const Renderer& renderer, const Scene& scene, const ImageSize& size) {
    const LightPicture objects = objects_of(renderer, scene, size), images = images_of(renderer, scene, size);
    const LightPicture lobes = rendered(renderer, *numbered(scene), settings_for(size, 1), Number::floating);
    const PixelGrid grid(objects, images);
    const double step = step_of(scene), mirrors_begin = (scene.solid_count + 0.5) * step;
    const double least_ray = weight_at_rim<double>(0, kLobeSamples) / rays_in_all(Estimator::fibonacci, kLobeSamples);
    const std::size_t pixels = objects.rgb.size() / 3;

    Regions regions;
    for (Mask& mask : regions) mask.assign(pixels, false);
    regions[static_cast<std::size_t>(Region::picture)].assign(pixels, true);
    regions[static_cast<std::size_t>(Region::silhouettes)] = silhouettes_of(grid, size);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        if (grid.object(pixel) < mirrors_begin || !grid.front(pixel)) continue;
        regions[static_cast<std::size_t>(Region::mirror)][pixel] = true;
        // One stray ray of the lobe moves the variance of the numbers by step^2 times what it counts for.
        const double mean = lobes.rgb[3 * pixel], variance = lobes.rgb[3 * pixel + 2] - mean * mean;
        const bool one_object = variance < step * step * least_ray / 2;
        if (!one_object) regions[static_cast<std::size_t>(Region::edges)][pixel] = true;
        if (one_object && mean > step / 2) regions[static_cast<std::size_t>(Region::smooth)][pixel] = true;
    }
    leave_out_shadow_rims(renderer, scene, size, regions[static_cast<std::size_t>(Region::smooth)]);
    return regions;
}

}  // namespace zerkalo::study
