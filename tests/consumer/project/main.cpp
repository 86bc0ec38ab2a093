// Renders a ball before a golden mirror with the widest instruction set of this CPU and prints the picture's hash.
#include "core/image/hash.hpp"
#include "core/render/render.hpp"

#include <cinttypes>
#include <cstdio>
#include <memory>
#include <vector>

int main() {
    auto scene = std::make_unique<zerkalo::Scene>();
    scene->camera.position = {0, 1, 6};
    scene->light_count = scene->solid_count = scene->mirror_count = 1;
    scene->lights[0].position = {-3, 4, 4};
    scene->solids[0].position = {0, 1, 0};
    scene->mirrors[0].position = {0, 1, -2};
    scene->mirrors[0].color = {0.95, 0.80, 0.45};
    scene->mirrors[0].boundary.width = scene->mirrors[0].boundary.height = 4;

    zerkalo::Settings settings;
    settings.width = 33;
    settings.height = 25;
    auto plan = std::make_unique<zerkalo::Plan>();
    const zerkalo::Status status = zerkalo::prepare(*scene, settings, *plan);
    if (!status.ok()) {
        std::fprintf(stderr, "%s.%s: %s\n", zerkalo::name_of(status.part), status.field, status.reason);
        return 3;
    }

    std::vector<float> pixels(3u * 33u * 25u);
    const zerkalo::LinearImage image{pixels.data(), 33, 25, 3 * 33 * static_cast<std::ptrdiff_t>(sizeof(float))};
    zerkalo::RayCounts counts;
    const zerkalo::TileFunction render_tile = zerkalo::kernel_for(*plan, zerkalo::best_isa());
    for (int i = 0; i < zerkalo::tile_count(*plan); ++i) {
        render_tile(*plan, zerkalo::tile_at(*plan, i), image, counts);
    }
    std::printf("%016" PRIx64 " after %" PRIu64 " camera rays\n", zerkalo::hash_of(image), counts.primary);
    return counts.primary == 33u * 25u && counts.reflected > 0 ? 0 : 1;
}
