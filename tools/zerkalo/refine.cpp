#include "tools/zerkalo/refine.hpp"

#include "tools/thread_tiles.hpp"
#include "tools/zerkalo/progress.hpp"

#include <algorithm>
#include <optional>

namespace zerkalo {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kGrowth = 4;  // lobe rays of a round beside all before: what the clock cuts off is then not all

class Refinement {
public:
    Refinement(const Frame& frame, const std::atomic<bool>& stopped, bool progress)
        : frame_(frame),
          stopped_(stopped),
          progress_(progress),
          kernel_(spread_kernel_for(*frame.plan, frame.isa)),
          first_rotation_(static_cast<std::uint32_t>(frame.rotation)),
          tiles_(static_cast<std::size_t>(tile_count(*frame.plan))),
          counts_(static_cast<std::size_t>(frame.threads)) {
        accumulator_.picture = frame.image;
        accumulator_.tiles = tiles_.data();
    }

    void end_at(Clock::time_point deadline) { deadline_ = deadline; }
    bool out_of_time() const { return stopped_.load(std::memory_order_relaxed) || Clock::now() >= deadline_; }

    const PlanHead& plan() const { return *frame_.plan; }
    const Accumulator& accumulator() const { return accumulator_; }
    double estimated() const { return estimated_error(plan(), accumulator_); }
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    double seconds_left() const { return std::chrono::duration<double>(deadline_ - Clock::now()).count(); }

    void survey() {
        std::vector<int> all(tiles_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
        run({kFirstSamples, frame_.rotation, true}, all, false);
    }

    /// The passes that the tiles have been given; what is out of time is left out.
    void round() {
        ++rounds_;
        const auto rotation = static_cast<std::int32_t>((first_rotation_ + rounds_) & kMaxRotation);
        std::vector<int> of_step[kLadderSteps];
        for (int step = 0; step < kLadderSteps; ++step) {
            for (std::size_t i = 0; i < tiles_.size(); ++i) {
                if (tiles_[i].next == samples_of_step(step)) of_step[step].push_back(static_cast<int>(i));
            }
        }
        for (int step = 0; step < kLadderSteps; ++step) {
            if (!of_step[step].empty()) run({samples_of_step(step), rotation}, of_step[step], true);
        }
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
        result.cost = {{seconds()}, rays()};
        return result;
    }

private:
    void run(const Pass& pass, const std::vector<int>& tiles, bool may_stop) {
        // The ladder's samples and a masked rotation are what begin_pass() takes.
        (void)begin_pass(*frame_.plan, pass);
        ++passes_;
        std::optional<Progress> line;
        if (progress_) line.emplace(static_cast<std::int64_t>(tiles.size()));
        thread_tiles(static_cast<int>(tiles.size()), frame_.threads, [&](int i, int thread) {
            if (may_stop && out_of_time()) return;
            RayCounts& rays = counts_[static_cast<std::size_t>(thread)].rays;
            const std::uint64_t before = total_of(rays);
            add_pass(*frame_.plan, kernel_, tiles[static_cast<std::size_t>(i)], accumulator_, rays);
            if (!line) return;
            line->add_step(total_of(rays) - before);
            if (thread == 0) line->show();
        });
    }

    const Frame& frame_;
    const std::atomic<bool>& stopped_;
    bool progress_;
    SpreadFunction kernel_;
    std::uint32_t first_rotation_;
    std::vector<TileProgress> tiles_;
    std::vector<ThreadCounts> counts_;
    Accumulator accumulator_;
    Clock::time_point start_ = Clock::now(), deadline_ = Clock::time_point::max();
    std::uint32_t rounds_ = 0;
    std::int32_t passes_ = 0;
};

}  // namespace

Refined refine_to_error(const Frame& frame, double error, const std::atomic<bool>& stopped, bool progress) {
    Refinement work(frame, stopped, progress);
    work.survey();
    while (work.estimated() > error) {
        if (work.out_of_time() || !plan_round(work.plan(), work.accumulator(), error)) return work.result(false);
        work.round();
    }
    return work.result(true);
}

Refined refine_for(const Frame& frame, std::chrono::duration<double> time, const std::atomic<bool>& stopped,
                   bool progress) {
    Refinement work(frame, stopped, progress);
    work.end_at(Clock::now() + std::chrono::duration_cast<Clock::duration>(time));
    work.survey();
    while (!work.out_of_time()) {
        const double lobe_rays = static_cast<double>(work.rays().lobe), rate = lobe_rays / work.seconds();
        const double affordable = std::min(kGrowth * lobe_rays, rate * work.seconds_left());
        if (!plan_round_of(work.plan(), work.accumulator(), affordable)) break;
        work.round();
    }
    return work.result(true);
}

}  // namespace zerkalo
