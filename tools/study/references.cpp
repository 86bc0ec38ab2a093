#include "tools/study/references.hpp"

#include "platform/pfm.hpp"
#include "tools/study/error_figures.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/picture_file.hpp"

#include <algorithm>
#include <unistd.h>

namespace zerkalo::study {
namespace {

struct Quadrature {
    const char* file;  // how its file's name ends
    Estimator estimator;
    std::int32_t first_rotation;  // far from those of the rows, which count from 0
};

constexpr Quadrature kQuadratureA{"-a.pfm", Estimator::fibonacci, 1'000'000};
constexpr Quadrature kQuadratureB{"-b.pfm", Estimator::sobol, 2'000'000};

LinearPicture mean_picture(const Renderer& renderer, const Scene& scene, const ImageSize& size,
                           const ReferenceEffort& effort, const Quadrature& quadrature) {
    Settings settings;
    settings.width = size.width;
    settings.height = size.height;
    settings.antialias = effort.antialias;
    settings.estimator = quadrature.estimator;
    settings.samples = std::min(effort.samples, kFrameSamples);
    const std::int32_t frames = std::max(effort.samples / kFrameSamples, 1);
    std::vector<double> sum(std::size_t{3} * static_cast<std::size_t>(size.width) *
                            static_cast<std::size_t>(size.height));
    for (std::int32_t frame = 0; frame < frames; ++frame) {
        settings.rotation = quadrature.first_rotation + frame;
        const LightPicture light = rendered_exactly(renderer, scene, settings);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light.rgb[i];
    }
    LinearPicture mean{size.width, size.height, {}};
    mean.rgb.reserve(sum.size());
    for (const double value : sum) mean.rgb.push_back(static_cast<float>(value / frames));
    return mean;
}

// A kept file serves only if it is whole and of the right size; else it is made again.
bool read_kept(const std::string& path, const ImageSize& size, LinearPicture& picture) {
    if (access(path.c_str(), R_OK) != 0) return false;
    const IoStatus status = read_pfm(path.c_str(), picture);
    return status.ok() && picture.width == size.width && picture.height == size.height;
}

LightPicture kept_or_rendered(const Renderer& renderer, const Scene& scene, const ImageSize& size,
                              const ReferenceEffort& effort, const Quadrature& quadrature, const std::string& path) {
    LinearPicture picture;
    if (!read_kept(path, size, picture)) {
        picture = mean_picture(renderer, scene, size, effort, quadrature);
        WholeFile file;
        open_picture(file, path);
        write_picture(file, picture.view(), PictureKind::pfm);
    }
    return light_of(picture.view());
}

}  // namespace

References references_of(const LightPicture& a, const LightPicture& b, const Regions& regions) {
    References references{a, {}};
    for (std::size_t i = 0; i < a.rgb.size(); ++i) references.mean.rgb[i] = (a.rgb[i] + b.rgb[i]) / 2;
    for (std::size_t r = 0; r < regions.size(); ++r) references.zone[r] = rmse_of(a, b, regions[r]);
    return references;
}

References references_of(const Renderer& renderer, const Scene& scene, const ImageSize& size,
                         const ReferenceEffort& effort, const Regions& regions, const std::string& folder,
                         const std::string& name) {
    const auto by = [&](const Quadrature& quadrature) {
        return kept_or_rendered(renderer, scene, size, effort, quadrature, folder + "/" + name + quadrature.file);
    };
    return references_of(by(kQuadratureA), by(kQuadratureB), regions);
}

}  // namespace zerkalo::study
