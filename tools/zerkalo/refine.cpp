#include "tools/zerkalo/refine.hpp"

#include "tools/thread_tiles.hpp"
#include "tools/zerkalo/edge_rays.hpp"
#include "tools/zerkalo/progress.hpp"

#include <algorithm>
#include <optional>

namespace zerkalo {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSparse = 4;  // what a camera ray costs where packets are not full, beside one where they are
constexpr double kGrowth = 4;  // lobe rays of a round beside all before: what the clock cuts off is then not all

/// AnyPlan: Plan, FixedPlan, DoublePlan.
template <class AnyPlan>
class Refinement {
public:
    Refinement(const Frame& frame, AnyPlan& plan, const std::atomic<bool>& stopped, bool progress)
        : frame_(frame),
          plan_(plan),
          stopped_(stopped),
          progress_(progress),
          kernel_(pass_kernel_for(plan, frame.isa)),
          tiles_(static_cast<std::size_t>(tile_count(plan))),
          counts_(static_cast<std::size_t>(frame.threads)) {
        accumulator_.picture = frame.image;
        accumulator_.tiles = tiles_.data();
    }

    void end_at(Clock::time_point deadline) { deadline_ = deadline; }
    bool out_of_time() const { return stopped_.load(std::memory_order_relaxed) || Clock::now() >= deadline_; }

    const PlanHead& plan() const { return plan_; }
    const Accumulator& accumulator() const { return accumulator_; }
    double estimated() const { return estimated_error(plan(), accumulator_); }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double seconds_left() const { return std::chrono::duration<double>(deadline_ - Clock::now()).count(); }

    void survey() {
        std::vector<int> tiles(tiles_.size());
        for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i] = static_cast<int>(i);
        for (int k = 0; k < kernel_.survey_passes(); ++k) {
            run({kernel_.survey_samples(), next_rotation(), k == 0}, tiles, false);
            // What is exact needs no second one.
            tiles.erase(std::remove_if(tiles.begin(), tiles.end(), [&](int tile) { return next_of(tile) == 0; }),
                        tiles.end());
        }
    }

    /// The survey for an error: of tiles that tell it themselves the first ones say how many samples the others need.
    void survey(double error) {
        if (!kernel_.spread) return survey();
        std::vector<int> of_group[kFirstGroups];
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            const int tile = static_cast<int>(i);
            of_group[first_group(plan(), tile)].push_back(tile);
        }
        const std::int32_t rotation = next_rotation();
        for (const std::vector<int>& tiles : of_group) {
            run({first_samples(plan(), accumulator_, error), rotation, true}, tiles, false);
        }
    }

    /// The passes that the tiles have been given; what is out of time is left out.
    void round() {
        const std::int32_t rotation = next_rotation();
        std::vector<int> of_step[kLadderSteps];
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            if (tiles_[i].next == 0) continue;
            int step = 0;
            while (tiles_[i].next != samples_of_step(step)) ++step;
            of_step[step].push_back(static_cast<int>(i));
        }
        for (int step = 0; step < kLadderSteps; ++step) {
            if (!of_step[step].empty()) run({samples_of_step(step), rotation}, of_step[step], true);
        }
    }

    /// Seconds that more camera rays at edges will take, from the picture so far.
    double seconds_of_edges() const {
        if (plan().edge_antialias == 0) return 0;
        const double camera_rays = static_cast<double>(find_edges(frame_).count) * plan().edge_antialias;
        return kSparse * seconds() * camera_rays / static_cast<double>(rays().primary);
    }

    /// Gives the pixels at edges their camera rays, which share the lobe rays that their tiles have had.
    void finish_edges() {
        if (plan().edge_antialias == 0) return;
        const EdgePixels edges = find_edges(frame_);
        std::vector<std::int32_t> samples;
        for (const TileProgress& tile : tiles_) {
            samples.push_back(static_cast<std::int32_t>(std::min<std::int64_t>(tile.samples, kMaxSamples)));
        }
        paint_edges(frame_, edges, samples, [&] { return out_of_time(); }, counts_.front().rays);
        edge_pixels_ = edges.count;
    }

    RayCounts rays() const {
        RayCounts sum;
        for (const ThreadCounts& of_thread : counts_) sum += of_thread.rays;
        return sum;
    }

    Refined result(bool reached) const {
        Refined result;
        result.estimated = estimated();
        result.reached = reached;
        result.passes = passes_;
        for (const TileProgress& tile : tiles_) {
            if (tile.hits > 0) result.most_samples = std::max(result.most_samples, tile.samples);
        }
        result.cost = {{seconds()}, rays(), edge_pixels_};
        return result;
    }

private:
    std::int32_t next_of(int tile) const { return tiles_[static_cast<std::size_t>(tile)].next; }

    std::int32_t next_rotation() {
        return static_cast<std::int32_t>((static_cast<std::uint32_t>(frame_.rotation) + rotations_++) & kMaxRotation);
    }

    void run(const Pass& pass, const std::vector<int>& tiles, bool may_stop) {
        // The ladder's samples and a masked rotation are what begin_pass() takes.
        (void)begin_pass(plan_, pass);
        ++passes_;
        std::optional<Progress> line;
        if (progress_) line.emplace(static_cast<std::int64_t>(tiles.size()));
        thread_tiles(static_cast<int>(tiles.size()), frame_.threads, [&](int i, int thread) {
            if (may_stop && out_of_time()) return;
            RayCounts& rays = counts_[static_cast<std::size_t>(thread)].rays;
            const std::uint64_t before = total_of(rays);
            add_pass(plan_, kernel_, tiles[static_cast<std::size_t>(i)], accumulator_, rays);
            if (!line) return;
            line->add_step(total_of(rays) - before);
            if (thread == 0) line->show();
        });
    }

    const Frame& frame_;
    AnyPlan& plan_;
    const std::atomic<bool>& stopped_;
    bool progress_;
    decltype(pass_kernel_for(AnyPlan(), Isa::scalar)) kernel_;
    std::vector<TileProgress> tiles_;
    std::vector<ThreadCounts> counts_;
    Accumulator accumulator_;
    Clock::time_point start_ = Clock::now(), deadline_ = Clock::time_point::max();
    std::uint32_t rotations_ = 0;
    std::int32_t passes_ = 0;
    std::int64_t edge_pixels_ = 0;
};

template <class AnyPlan>
Refined to_error(Refinement<AnyPlan>& work, double error) {
    work.survey(error);
    bool reached = true;
    while (reached && work.estimated() > error) {
        reached = !work.out_of_time() && plan_round(work.plan(), work.accumulator(), error);
        if (reached) work.round();
    }
    work.finish_edges();
    return work.result(reached);
}

template <class AnyPlan>
Refined in_time(Refinement<AnyPlan>& work, Clock::duration time) {
    const Clock::time_point deadline = Clock::now() + time;
    work.survey();
    work.end_at(deadline - std::chrono::duration_cast<Clock::duration>(
                               std::chrono::duration<double>(work.seconds_of_edges())));
    while (!work.out_of_time()) {
        const double samples = static_cast<double>(lobe_samples_of(work.rays())), rate = samples / work.seconds();
        const double affordable = std::min(kGrowth * samples, rate * work.seconds_left());
        if (!plan_round_of(work.plan(), work.accumulator(), affordable)) break;
        work.round();
    }
    work.end_at(deadline);
    work.finish_edges();
    return work.result(true);
}

/// Calls work(plan) for that of the three which the frame has.
template <class Work>
Refined with_plan(const Frame& frame, const Work& work) {
    if (frame.plan) return work(*frame.plan);
    if (frame.fixed_plan) return work(*frame.fixed_plan);
    return work(*frame.double_plan);
}

}  // namespace

Refined refine_to_error(const Frame& frame, double error, const std::atomic<bool>& stopped, bool progress) {
    return with_plan(frame, [&](auto& plan) {
        Refinement work(frame, plan, stopped, progress);
        return to_error(work, error);
    });
}

Refined refine_for(const Frame& frame, std::chrono::duration<double> time, const std::atomic<bool>& stopped,
                   bool progress) {
    return with_plan(frame, [&](auto& plan) {
        Refinement work(frame, plan, stopped, progress);
        return in_time(work, std::chrono::duration_cast<Clock::duration>(time));
    });
}

}  // namespace zerkalo
