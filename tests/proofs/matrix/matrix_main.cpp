// Renders every scene of a list with every instruction set of this CPU, and with the widest one in several tile orders
// and thread counts; prints one line a hash:
//
//     <instruction set> <tile order>:<threads> <scene> <number type> <stage> <hash as 16 hex digits>
//
// Usage: matrix SCENES.bin
#include "core/image/hash.hpp"
#include "core/render/render.hpp"
#include "tests/proofs/matrix/scene_list.hpp"
#include "tests/proofs/matrix/stages.hpp"

#include <algorithm>
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <memory>
#include <numeric>
#include <random>
#include <thread>

namespace zerkalo::matrix {
namespace {

// No lane width divides the columns; both sides end inside a tile.
constexpr Settings kSettings{.width = 45, .height = 33, .samples = 5};

#if defined(ZERKALO_HAS_avx512)
constexpr StageFunction kStages[kIsaCount] = {stages_scalar, stages_sse2,   stages_sse4_2,
                                              stages_avx2,   stages_avx512, nullptr};
#elif defined(ZERKALO_HAS_avx2)
constexpr StageFunction kStages[kIsaCount] = {stages_scalar, nullptr, nullptr, stages_avx2, nullptr, nullptr};
#elif defined(ZERKALO_HAS_neon)
constexpr StageFunction kStages[kIsaCount] = {stages_scalar, nullptr, nullptr, nullptr, nullptr, stages_neon};
#else
constexpr StageFunction kStages[kIsaCount] = {stages_scalar};
#endif

struct Schedule {
    const char* order;
    int threads;
};
constexpr Schedule kInTurn{"rows", 1};
constexpr Schedule kSchedules[] = {{"backwards", 1}, {"shuffled", 1}, {"rows", 2}, {"shuffled", 3}, {"backwards", 8}};

std::vector<int> tiles_in_order(const PlanHead& plan, std::string_view order) {
    std::vector<int> tiles(static_cast<std::size_t>(tile_count(plan)));
    std::iota(tiles.begin(), tiles.end(), 0);
    if (order == "backwards") std::reverse(tiles.begin(), tiles.end());
    if (order == "shuffled") std::shuffle(tiles.begin(), tiles.end(), std::mt19937(7));
    return tiles;
}

template <class AnyPlan>
std::uint64_t radiance_hash(const AnyPlan& plan, Isa isa, const Schedule& schedule) {
    std::vector<float> pixels(std::size_t{3} * plan.width * plan.height);
    const LinearImage image{pixels.data(), plan.width, plan.height, std::ptrdiff_t{12} * plan.width};
    const std::vector<int> tiles = tiles_in_order(plan, schedule.order);
    const auto render_tile = kernel_for(plan, isa);
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        RayCounts counts;
        for (std::size_t i = next++; i < tiles.size(); i = next++) {
            render_tile(plan, tile_at(plan, tiles[i]), image, counts);
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < schedule.threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& thread : others) thread.join();
    return hash_of(image);
}

/// Where a hash belongs, but for its stage.
struct Place {
    const char* scene;
    const char* number;
    Isa isa;
    Schedule schedule;
};

void print(const Place& at, const char* stage, std::uint64_t hash) {
    std::printf("%s %s:%d %s %s %s %016" PRIx64 "\n", name_of(at.isa), at.schedule.order, at.schedule.threads, at.scene,
                at.number, stage, hash);
}

void print_stages(const Plan& plan, const Place& at) {
    StageImages images;
    kStages[static_cast<int>(at.isa)](plan, images);
    for (int stage = 0; stage < kStageCount; ++stage) {
        std::vector<float>& values = images.values[stage];
        // As a picture of one column: three floats a pixel.
        values.resize((values.size() + 2) / 3 * 3);
        const auto rows = static_cast<std::int32_t>(values.size() / 3);
        print(at, kStageNames[stage], hash_of(LinearImage{values.data(), 1, rows, 12}));
    }
}

/// Everything about one plan: its stages and pictures by every instruction set, its pictures by every schedule.
template <class AnyPlan>
void print_plan(const AnyPlan& plan, const char* scene, const char* number) {
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        if (!available(isa)) continue;
        // The kernels in fixed point and double are one for all instruction sets and have no stages here.
        if constexpr (std::is_same_v<AnyPlan, Plan>) print_stages(plan, {scene, number, isa, kInTurn});
        print({scene, number, isa, kInTurn}, "radiance", radiance_hash(plan, isa, kInTurn));
    }
    for (const Schedule& schedule : kSchedules) {
        print({scene, number, best_isa(), schedule}, "radiance", radiance_hash(plan, best_isa(), schedule));
    }
}

template <class AnyPlan>
bool print_number_type(const NamedScene& named, const char* number) {
    const auto plan = std::make_unique<AnyPlan>();
    const Status status = prepare(named.scene, kSettings, *plan);
    if (!status.ok()) return std::fprintf(stderr, "%s: %s %s\n", named.name, status.field, status.reason), false;
    print_plan(*plan, named.name, number);
    return true;
}

bool print_scene(const NamedScene& named) {
    return print_number_type<Plan>(named, "float") && print_number_type<FixedPlan>(named, "fixed") &&
           print_number_type<DoublePlan>(named, "double");
}

}  // namespace
}  // namespace zerkalo::matrix

int main(int count, char** arguments) {
    using namespace zerkalo::matrix;
    std::FILE* file = count == 2 ? std::fopen(arguments[1], "rb") : nullptr;
    if (file == nullptr) return std::fputs("usage: matrix SCENES.bin\n", stderr), 2;
    SceneListHeader header{};
    const bool begun = std::fread(&header, sizeof header, 1, file) == 1;
    if (!begun || header.scene_size != sizeof(NamedScene)) return std::fputs("another layout of scenes\n", stderr), 1;
    const auto named = std::make_unique<NamedScene>();
    for (std::uint64_t i = 0; i < header.count; ++i) {
        if (std::fread(named.get(), sizeof *named, 1, file) != 1) return std::fputs("scenes are cut off\n", stderr), 1;
        if (!print_scene(*named)) return 1;
    }
    std::fclose(file);
    return 0;
}
