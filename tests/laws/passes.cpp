#include "tests/laws/passes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <tuple>

namespace zerkalo::laws {

template <class AnyPlan>
PassesOf<AnyPlan>::PassesOf(const Scene& scene, const Settings& settings, Isa isa)
    : plan_(std::make_unique<AnyPlan>()), rotation_(settings.rotation) {
    prepare_or_throw(scene, settings, *plan_);
    kernel_ = pass_kernel_for(*plan_, isa);
    const auto pixels = static_cast<std::size_t>(plan_->width) * static_cast<std::size_t>(plan_->height);
    picture_ = {plan_->width, plan_->height, std::vector<float>(3 * pixels), {}};
    variances_.resize(pixels);
    tiles_.resize(static_cast<std::size_t>(tile_count(*plan_)));
}

template <class AnyPlan>
template <class Wanted>
void PassesOf<AnyPlan>::run(const Pass& pass, const Wanted& wanted) {
    if (!begin_pass(*plan_, pass).ok()) throw std::runtime_error("a pass is refused");
    const int count = tile_count(*plan_);
    for (int i = 0; i < count; ++i) {
        const int tile = backwards_ ? count - 1 - i : i;
        if (wanted(tile, tiles_[static_cast<std::size_t>(tile)])) {
            add_pass(*plan_, kernel_, tile, accumulator(), picture_.rays);
        }
    }
}

template <class AnyPlan>
void PassesOf<AnyPlan>::resume(const PassesOf& other) {
    picture_ = other.picture_, variances_ = other.variances_;
    tiles_ = other.tiles_, rotation_ = other.rotation_;
}

template <class AnyPlan>
const Image& PassesOf<AnyPlan>::single(std::int32_t samples) {
    tiles_.assign(tiles_.size(), {});
    run({samples, rotation_, true}, [](int, const TileProgress&) { return true; });
    return picture_;
}

template <class AnyPlan>
void PassesOf<AnyPlan>::survey_pass(int number) {
    if (number == 0) {
        single(kernel_.survey_samples());
    } else {
        run({kernel_.survey_samples(), ++rotation_}, [](int, const TileProgress& tile) { return tile.next > 0; });
    }
}

template <class AnyPlan>
void PassesOf<AnyPlan>::survey() {
    for (int k = 0; k < kernel_.survey_passes(); ++k) survey_pass(k);
}

template <class AnyPlan>
void PassesOf<AnyPlan>::first(int group, double error) {
    if (group == 0) tiles_.assign(tiles_.size(), {});
    run({samples_of_first(error), rotation_, true},
        [&](int tile, const TileProgress&) { return first_group(*plan_, tile) == group; });
}

template <class AnyPlan>
void PassesOf<AnyPlan>::round() {
    ++rotation_;
    for (int step = 0; step < kLadderSteps; ++step) {
        const std::int32_t samples = samples_of_step(step);
        run({samples, rotation_}, [&](int, const TileProgress& tile) { return tile.next == samples; });
    }
}

template <class AnyPlan>
double PassesOf<AnyPlan>::refine(double error) {
    if (!tells()) survey();
    for (int group = 0; tells() && group < kFirstGroups; ++group) first(group, error);
    while (estimate() > error && plan(error)) round();
    return estimate();
}

template class PassesOf<Plan>;
template class PassesOf<FixedPlan>;
template class PassesOf<DoublePlan>;

Image converged(const Scene& scene, const Settings& settings) {
    constexpr int kPlacements = 4;
    Settings many = settings;
    many.samples = 508 / settings.antialias + 1;
    std::vector<double> sum;
    Image image;
    for (int k = 1; k <= kPlacements; ++k) {
        many.rotation = 1000 + k;
        image = render(scene, many);
        sum.resize(image.rgb.size());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += double(image.rgb[i]) / kPlacements;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) image.rgb[i] = static_cast<float>(sum[i]);
    return image;
}

const std::vector<ShippedScene>& unpolished_scenes() {
    static const std::vector<ShippedScene> scenes = [] {
        const auto plan = std::make_unique<Plan>();
        std::vector<ShippedScene> found;
        for (const ShippedScene& shipped : shipped_scenes()) {
            prepare_or_throw(shipped.scene, of_size(8, 8), *plan);
            if (plan->features & kFeatureGlossy) found.push_back(shipped);
        }
        return found;
    }();
    return scenes;
}

const Image& limit_of(const std::string& scene, int width, int height) {
    static std::map<std::tuple<std::string, int, int>, Image> limits;
    const auto [place, fresh] = limits.try_emplace({scene, width, height});
    if (!fresh) return place->second;
    for (const ShippedScene& shipped : unpolished_scenes()) {
        if (shipped.name == scene) place->second = converged(shipped.scene, of_size(width, height));
    }
    return place->second;
}

double distance(const Image& a, const Image& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const double off = double(a.rgb[i]) - double(b.rgb[i]);
        squares += off * off;
    }
    return std::sqrt(squares / double(a.rgb.size()));
}

void JudgedEstimates::judge(const std::string& name, double asked, double estimate, double truth) {
    ++pictures_;
    if (!(truth < 1.5 * estimate && estimate < 1.5 * truth)) {
        ++off_;
        std::printf("%s: asked %g, estimated %g, true %g\n", name.c_str(), asked, estimate, truth);
    }
    EXPECT_LE(estimate, asked) << name;
    EXPECT_LT(truth, 3 * estimate) << name;
}

void JudgedEstimates::expect_nineteen_of_twenty() const {
    EXPECT_LE(off_ * 20, pictures_) << off_ << " of " << pictures_;
}

}  // namespace zerkalo::laws
