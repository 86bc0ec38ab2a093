// zerkalo bench: nanoseconds per ray for each solid, the shadow ray, the mirror, the lobe sample, a tile, a frame and a
// pass over it, by instruction set. Google Benchmark repeats and reports; only the kernels' time is measured.
#include "core/render/progressive.hpp"
#include "tools/zerkalo/bench_scenes.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/frame.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/scene_input.hpp"

#include <benchmark/benchmark.h>

#include <ctime>
#include <regex>

namespace zerkalo {
namespace {

struct BenchOptions {
    std::string scene;
    std::string filter = ".";
    double min_time = 0.2;
    bool json = false;
};

// Time of this thread on a processor: another program that takes its turn does not count.
double cpu_nanoseconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

// The rays that "ns/ray" speaks of differ from kernel to kernel.
using CountedRays = std::uint64_t (*)(const RayCounts&);

std::uint64_t camera_rays(const RayCounts& rays) { return rays.primary; }
std::uint64_t shadow_rays(const RayCounts& rays) { return rays.shadow; }
std::uint64_t lobe_rays(const RayCounts& rays) { return rays.lobe; }

// Renders the tiles first..last-1 over and over.
void measure(benchmark::State& state, const Frame& frame, int first, int last, CountedRays counted) {
    RayCounts rays;
    const double start = cpu_nanoseconds();
    for ([[maybe_unused]] const auto iteration : state) {
        for (int tile = first; tile < last; ++tile) {
            frame.render_tile(tile_at(frame.head(), tile), rays);
        }
    }
    const double nanoseconds = cpu_nanoseconds() - start;
    const std::uint64_t count = counted(rays);
    if (count == 0) {
        state.SkipWithError("this scene sends no such ray");
        return;
    }
    state.counters["ns/ray"] = nanoseconds / static_cast<double>(count);
    state.counters["rays"] = static_cast<double>(count) / static_cast<double>(state.iterations());
    state.counters["lanes"] = frame.lanes;
}

int tile_in_the_middle(const PlanHead& plan) {
    const int columns = (plan.width + kTileSide - 1) / kTileSide, rows = (plan.height + kTileSide - 1) / kTileSide;
    return rows / 2 * columns + columns / 2;
}

// Adds a later pass to the tiles that have lobe rays, over and over.
void measure_pass(benchmark::State& state, const Frame& frame, std::int32_t samples) {
    Plan& plan = *frame.plan;
    std::vector<TileProgress> tiles(static_cast<std::size_t>(tile_count(plan)));
    const Accumulator accumulator{frame.image, nullptr, tiles.data()};
    const PassKernel<FloatFormats> kernel = pass_kernel_for(plan, frame.isa);
    RayCounts rays;
    frame.begin({kernel.survey_samples(), 0, true});
    double hits = 0;
    std::vector<int> with_lobe_rays;
    for (int tile = 0; tile < tile_count(plan); ++tile) {
        add_pass(plan, kernel, tile, accumulator, rays);
        const double of_tile = tiles[static_cast<std::size_t>(tile)].hits;
        if (of_tile > 0) with_lobe_rays.push_back(tile);
        hits += of_tile;
    }
    if (hits == 0) {
        state.SkipWithError("this scene sends no such ray");
        return;
    }
    frame.begin({samples, 1});
    rays = {};
    const double start = cpu_nanoseconds();
    for ([[maybe_unused]] const auto iteration : state) {
        for (const int tile : with_lobe_rays) add_pass(plan, kernel, tile, accumulator, rays);
    }
    const double nanoseconds = cpu_nanoseconds() - start, passes = static_cast<double>(state.iterations());
    state.counters["ns/hit"] = nanoseconds / passes / hits;
    state.counters["pixels/hit"] = static_cast<double>(rays.primary) / passes / hits;
    state.counters["lanes"] = frame.lanes;
}

enum class Extent { tile, frame, pass };

struct Entry {
    std::string name;
    Isa isa;
    std::shared_ptr<const Scene> scene;
    int samples;
    CountedRays counted;
    Extent extent;
    Number number = Number::floating;
};

void run_entry(benchmark::State& state, const Entry& entry) {
    Settings settings;
    settings.samples = entry.samples;
    const Frame frame = prepare_frame(*entry.scene, settings, entry.isa, 1, entry.number);
    if (entry.extent == Extent::pass) return measure_pass(state, frame, entry.samples);
    const int tiles = tile_count(frame.head());
    const bool one_tile = entry.extent == Extent::tile;
    // The tile in the middle of the picture, which shows more than background in most scenes.
    const int first = one_tile ? tile_in_the_middle(frame.head()) : 0;
    measure(state, frame, first, one_tile ? first + 1 : tiles, entry.counted);
}

void add_kernels(std::vector<Entry>& entries, Isa isa) {
    constexpr struct {
        const char* name;
        SolidKind kind;
    } kSolids[] = {{"pyramid", SolidKind::pyramid}, {"prism", SolidKind::prism},
                   {"sphere", SolidKind::sphere},   {"cylinder", SolidKind::cylinder},
                   {"cone", SolidKind::cone},       {"mesh_8_triangles", SolidKind::mesh}};
    const std::string end = std::string("/") + name_of(isa);
    for (const auto& solid : kSolids) {
        entries.push_back({"solid/" + (solid.name + end), isa, solid_scene(solid.kind), 1, camera_rays, Extent::frame});
    }
    entries.push_back({"shadow/sphere" + end, isa, shadow_scene(), 1, shadow_rays, Extent::frame});
    entries.push_back({"mirror/sharp" + end, isa, mirror_scene(kInfinity), 1, total_of, Extent::frame});
    // Many samples, so that the camera ray's share of a lobe ray is below one in a hundred.
    entries.push_back({"mirror/lobe_sample" + end, isa, mirror_scene(200), 128, lobe_rays, Extent::frame});
}

void add_frames(std::vector<Entry>& entries, Isa isa, const std::shared_ptr<const Scene>& scene) {
    for (const int samples : {1, 16, 64}) {
        const std::string end = "/samples:" + std::to_string(samples) + "/" + name_of(isa);
        entries.push_back({"tile" + end, isa, scene, samples, total_of, Extent::tile});
        entries.push_back({"frame" + end, isa, scene, samples, total_of, Extent::frame});
    }
    for (const int samples : {4, 32}) {
        const std::string name = "pass/samples:" + std::to_string(samples) + "/" + name_of(isa);
        entries.push_back({name, isa, scene, samples, lobe_rays, Extent::pass});
    }
}

void add_frames(std::vector<Entry>& entries, Number number, Isa isa, const std::shared_ptr<const Scene>& scene) {
    for (const int samples : {1, 16}) {
        const std::string name = "frame/samples:" + std::to_string(samples) + "/" + name_of(number) + "/" + name_of(isa);
        entries.push_back({name, isa, scene, samples, total_of, Extent::frame, number});
    }
}

std::vector<Entry> entries_for(const BenchOptions& options) {
    const std::shared_ptr<const Scene> scene =
        options.scene.empty() ? ordinary_scene() : read_scene(options.scene).scene;
    std::vector<Entry> entries;
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        if (!available(isa)) continue;
        add_kernels(entries, isa);
        add_frames(entries, isa, scene);
        if (fixed_isa_of(isa) == isa) add_frames(entries, Number::fixed, isa, scene);
    }
    // The kernel in double is the same for every instruction set.
    add_frames(entries, Number::double_precision, Isa::scalar, scene);
    return entries;
}

std::regex filter_of(const BenchOptions& options) {
    try {
        return std::regex(options.filter);
    } catch (const std::regex_error&) {
        throw Failure(ExitCode::usage, "--filter: '" + options.filter + "' is not a regular expression");
    }
}

ExitCode run_bench(const BenchOptions& options) {
    const std::regex filter = filter_of(options);
    const std::vector<Entry> entries = entries_for(options);
    int matched = 0;
    for (const Entry& entry : entries) {
        if (!std::regex_search(entry.name, filter)) continue;
        const auto run = [&entry](benchmark::State& state) { run_entry(state, entry); };
        benchmark::RegisterBenchmark(entry.name.c_str(), run);
        ++matched;
    }
    if (matched == 0) throw Failure(ExitCode::usage, "--filter: no benchmark matches '" + options.filter + "'");

    std::string arguments[] = {"zerkalo bench", format("--benchmark_min_time=%g", options.min_time),
                               std::string("--benchmark_format=") + (options.json ? "json" : "console"),
                               "--benchmark_counters_tabular=true"};
    char* argv[std::size(arguments)];
    for (std::size_t i = 0; i < std::size(arguments); ++i) argv[i] = arguments[i].data();
    int argc = static_cast<int>(std::size(arguments));
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return ExitCode::ok;
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* command = app.add_subcommand("bench", "Measures the kernels: nanoseconds per ray, by instruction set");
    command->add_option("SCENE", options->scene, "Scene file for the tile and frame figures, default: a built-in one");
    command->add_option("--filter", options->filter, "Only benchmarks whose name matches this regular expression")
        ->type_name("REGEX");
    command->add_option("--min-time", options->min_time, "Seconds to spend on each benchmark")
        ->check(CLI::Range(0.001, 3600.0))
        ->capture_default_str()
        ->type_name("SECONDS");
    add_json_option(*command, options->json);
    command->callback([options, &action] { action = [options] { return run_bench(*options); }; });
}

}  // namespace zerkalo
