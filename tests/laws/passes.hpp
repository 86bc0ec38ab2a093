// Pictures in passes for tests: the caller's memory and the loop around core/render/progressive.hpp.
#pragma once

#include "core/render/progressive.hpp"
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include <memory>
#include <vector>

namespace zerkalo::laws {

/// AnyPlan: Plan, FixedPlan, DoublePlan.
template <class AnyPlan>
class PassesOf {
public:
    PassesOf(const Scene& scene, const Settings& settings, Isa isa = best_isa());

    /// The order in which tiles are rendered: the last one first.
    void reverse_tiles() { backwards_ = true; }

    /// Goes on where another one stands, with nothing of it but the picture, the tiles and the number of the rotation.
    void resume(const PassesOf& other);

    /// One pass alone over all tiles.
    const Image& single(std::int32_t samples);

    void survey();
    /// Pass `number` of those that are the survey.
    void survey_pass(int number);
    /// The first passes for an error of a group of tiles, where passes tell it themselves.
    void first(int group, double error);
    /// And the samples that they would have.
    std::int32_t samples_of_first(double error) { return first_samples(*plan_, accumulator(), error); }
    bool plan(double error) { return plan_round(*plan_, accumulator(), error); }
    void round();

    /// The survey for an error and rounds until the estimate is at most that; it is returned.
    double refine(double error);

    /// Whether a pass alone tells its error.
    bool tells() const { return kernel_.spread != nullptr; }
    double estimate() { return estimated_error(*plan_, accumulator()); }
    const Image& picture() const { return picture_; }
    const RayCounts& rays() const { return picture_.rays; }
    const std::vector<float>& variances() const { return variances_; }
    const std::vector<TileProgress>& tiles() const { return tiles_; }

private:
    Accumulator accumulator() { return {picture_.view(), variances_.data(), tiles_.data()}; }
    /// Of the tiles with wanted(number, progress).
    template <class Wanted>
    void run(const Pass& pass, const Wanted& wanted);

    std::unique_ptr<AnyPlan> plan_;
    decltype(pass_kernel_for(AnyPlan(), Isa::scalar)) kernel_;
    Image picture_;
    std::vector<float> variances_;
    std::vector<TileProgress> tiles_;
    std::int32_t rotation_;
    bool backwards_ = false;
};
using Passes = PassesOf<Plan>;
using FixedPasses = PassesOf<FixedPlan>;
using DoublePasses = PassesOf<DoublePlan>;

/// The limit of many samples, by the same kernel: the mean of independent placements.
Image converged(const Scene& scene, const Settings& settings);

/// The shipped scenes with an unpolished mirror.
const std::vector<ShippedScene>& unpolished_scenes();

/// The limit of such a scene's picture of that size, computed once.
const Image& limit_of(const std::string& scene, int width, int height);

/// Root of the mean square of the differences over pixels and channels.
double distance(const Image& a, const Image& b);

/// Estimates of errors against the errors themselves: each not above what was asked for, right within a factor of 3,
/// and nineteen of twenty within 1.5. Tells those that are not.
class JudgedEstimates {
public:
    void judge(const std::string& name, double asked, double estimate, double truth);
    void expect_nineteen_of_twenty() const;

private:
    int pictures_ = 0, off_ = 0;
};

}  // namespace zerkalo::laws
