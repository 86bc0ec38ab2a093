// See pictures.hpp.
#include "tests/proofs/pictures/pictures.hpp"

#include "core/image/hash.hpp"
#include "core/render/render.hpp"
#include "core/render/settings.hpp"
#include "tests/proofs/pictures/scenes.hpp"

#include <cstdint>

namespace zerkalo::pictures {
namespace {

// 45 columns: no lane width divides them, so the last packet of a row has dead lanes.
constexpr std::int32_t kWidth = 45, kHeight = 32;

Plan plan;
DoublePlan double_plan;
FixedPlan fixed_plan;
float pixels[kWidth * kHeight * 3];

template <class AnyPlan>
std::uint64_t hash_with(const AnyPlan& plan, Isa isa) {
    const LinearImage image{pixels, kWidth, kHeight, kWidth * 3 * static_cast<std::ptrdiff_t>(sizeof(float))};
    const auto render_tile = kernel_for(plan, isa);
    RayCounts counts;
    for (int i = 0; i < tile_count(plan); ++i) {
        render_tile(plan, tile_at(plan, i), image, counts);
    }
    return hash_of(image);
}

char* append(char* end, const char* text) {
    while (*text != '\0') {
        *end++ = *text++;
    }
    *end = '\0';
    return end;
}

void describe(Picture picture, const char* number, Isa isa, std::uint64_t hash, char* line) {
    char* end = append(append(append(append(append(line, name_of(picture)), number), " "), zerkalo::name_of(isa)), " ");
    for (int shift = 60; shift >= 0; shift -= 4) {
        *end++ = "0123456789abcdef"[(hash >> shift) & 15u];
    }
    append(end, "\n");
}

using Write = void (*)(const char* line);

/// One line for each instruction set; false where two of them differ.
template <class AnyPlan>
bool write_hashes(Picture picture, const char* number, const AnyPlan& plan, Write write) {
    const std::uint64_t serial = hash_with(plan, Isa::scalar);
    bool same = true;
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        if (!available(isa)) {
            continue;
        }
        const std::uint64_t hash = hash_with(plan, isa);
        same = same && hash == serial;
        char line[64];
        describe(picture, number, isa, hash, line);
        write(line);
    }
    return same;
}

/// The plans of all number types.
Status prepare_all(const Scene& scene, const Settings& settings) {
    Status status = prepare(scene, settings, plan);
    if (status.ok()) {
        status = prepare(scene, settings, double_plan);
    }
    if (status.ok()) {
        status = prepare(scene, settings, fixed_plan);
    }
    return status;
}

}  // namespace

const char* name_of(Picture picture) {
    constexpr const char* kNames[kPictureCount] = {"sharp", "glossy", "everything"};
    return kNames[static_cast<int>(picture)];
}

bool render_all(Write write) {
    Settings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.samples = 5;
    bool same = true;
    for (int p = 0; p < kPictureCount; ++p) {
        const Status status = prepare_all(kScenes[p], settings);
        if (!status.ok()) {
            write(status.reason);
            write("\n");
            return false;
        }
        const auto picture = static_cast<Picture>(p);
        same = write_hashes(picture, "", plan, write) && same;
        same = write_hashes(picture, ".fixed", fixed_plan, write) && same;
        char line[64];
        describe(picture, ".double", Isa::scalar, hash_with(double_plan, Isa::scalar), line);
        write(line);
    }
    return same;
}

}  // namespace zerkalo::pictures
