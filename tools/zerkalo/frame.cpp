#include "tools/zerkalo/frame.hpp"

#include "tools/thread_tiles.hpp"
#include "tools/zerkalo/edge_rays.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/progress.hpp"

#include <algorithm>
#include <chrono>

namespace zerkalo {
namespace {

RayCounts render_tiles(const Frame& frame, Progress* progress, const std::atomic<bool>* stopped) {
    std::vector<ThreadCounts> counts(static_cast<std::size_t>(frame.threads));
    const auto render_tile = [&](int tile, int thread) {
        if (stopped && stopped->load(std::memory_order_relaxed)) return;
        RayCounts& rays = counts[static_cast<std::size_t>(thread)].rays;
        const std::uint64_t before = progress ? total_of(rays) : 0;
        frame.render_tile(tile_at(frame.head(), tile), rays);
        if (!progress) return;
        progress->add_step(total_of(rays) - before);
        if (thread == 0) progress->show();
    };
    thread_tiles(tile_count(frame.head()), frame.threads, render_tile);

    RayCounts sum;
    for (const ThreadCounts& of_thread : counts) sum += of_thread.rays;
    return sum;
}

/// `stopped` leaves out what is begun after it was set; null: nobody stops.
void render_once(const Frame& frame, Progress* progress, const std::atomic<bool>* stopped, FrameCost& cost) {
    cost.rays = render_tiles(frame, progress, stopped);
    if (frame.head().edge_antialias == 0) return;
    const auto is_stopped = [&] { return stopped && stopped->load(std::memory_order_relaxed); };
    const EdgePixels edges = find_edges(frame);
    const std::vector<std::int32_t> samples(edges.of_tile.size(), frame.samples);
    paint_edges(frame, edges, samples, is_stopped, cost.rays);
    cost.edge_pixels = edges.count;
}

// A setting is named as the option that sets it, a part of the scene by its table and place.
Failure refusal(const Status& status) {
    if (status.part != Part::settings) {
        return {ExitCode::scene_invalid,
                format("%s %d: %s: %s", name_of(status.part), status.index + 1, status.field, status.reason)};
    }
    std::string option = status.field;
    std::replace(option.begin(), option.end(), '_', '-');
    return {ExitCode::usage, "--" + option + ": " + status.reason};
}

template <class AnyPlan>
std::unique_ptr<AnyPlan> prepared(const Scene& scene, const Settings& settings) {
    auto plan = std::make_unique<AnyPlan>();
    if (const Status status = prepare(scene, settings, *plan); !status.ok()) throw refusal(status);
    return plan;
}

}  // namespace

void Frame::begin(const Pass& pass) const {
    // Their samples, camera rays and rotation are those of checked settings.
    if (plan) {
        (void)begin_pass(*plan, pass);
    } else if (fixed_plan) {
        (void)begin_pass(*fixed_plan, pass);
    } else {
        (void)begin_pass(*double_plan, pass);
    }
}

Frame prepare_frame(const Scene& scene, const Settings& settings, Isa isa, int threads, Number number) {
    Frame frame;
    frame.isa = isa;
    if (number == Number::fixed) {
        frame.fixed_plan = prepared<FixedPlan>(scene, settings);
        frame.fixed_kernel = kernel_for(*frame.fixed_plan, isa);
        frame.isa = fixed_isa_of(isa);
        frame.lanes = fixed_lanes_of(isa);
    } else if (number == Number::double_precision) {
        frame.double_plan = prepared<DoublePlan>(scene, settings);
        frame.double_kernel = kernel_for(*frame.double_plan, isa);
    } else {
        frame.plan = prepared<Plan>(scene, settings);
        frame.kernel = kernel_for(*frame.plan, isa);
        frame.lanes = lanes_of(isa);
    }
    const std::int32_t width = frame.head().width, height = frame.head().height;
    // Zeros touch every page now, so that no page fault is counted as rendering.
    frame.pixels =
        std::make_unique<float[]>(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    frame.image = {frame.pixels.get(), width, height, static_cast<std::ptrdiff_t>(3 * sizeof(float)) * width};
    frame.threads = threads;
    frame.samples = settings.samples, frame.rotation = settings.rotation;
    return frame;
}

FrameCost render_frame(const Frame& frame, int repeat, bool progress) {
    using Clock = std::chrono::steady_clock;
    FrameCost cost;
    Progress line(std::int64_t{repeat} * tile_count(frame.head()));
    for (int i = 0; i < repeat; ++i) {
        const Clock::time_point start = Clock::now();
        render_once(frame, progress ? &line : nullptr, nullptr, cost);
        cost.seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    return cost;
}

void render_until(const Frame& frame, const std::atomic<bool>& stopped) {
    FrameCost unused;
    render_once(frame, nullptr, &stopped, unused);
}

RayCounts& operator+=(RayCounts& sum, const RayCounts& more) {
    sum.primary += more.primary;
    sum.reflected += more.reflected;
    sum.lobe += more.lobe;
    sum.refracted += more.refracted;
    sum.shadow += more.shadow;
    sum.weighed += more.weighed;
    sum.covered += more.covered;
    sum.sampled += more.sampled;
    return sum;
}

std::uint64_t total_of(const RayCounts& rays) {
    return rays.primary + rays.reflected + rays.lobe + rays.refracted + rays.shadow;
}

std::vector<std::string> features_of(const PlanHead& plan) {
    constexpr int kMostFeatures = 64;
    const char* names[kMostFeatures];
    const int count = feature_names(plan, names, kMostFeatures);
    return {names, names + count};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

}  // namespace zerkalo
