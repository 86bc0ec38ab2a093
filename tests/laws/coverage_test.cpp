// The estimator fibonacci+coverage: the integral of plain sampling with less error, whatever hides what.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace zerkalo::laws {
namespace {

Settings with(Estimator estimator, int side, std::int32_t samples) {
    Settings settings = of_size(side, side);
    settings.estimator = estimator;
    settings.samples = samples;
    return settings;
}
Settings plain(int side, std::int32_t samples) { return with(Estimator::fibonacci, side, samples); }
Settings covered(int side, std::int32_t samples) { return with(Estimator::fibonacci_coverage, side, samples); }

constexpr Vec3<double> kFace{0, 0, 1};

/// A lamp, a mirror in z = 0 that only reflects and fills the picture, and a camera that sees no solid but in it.
Scene before_a_mirror(double exponent, Lobe lobe) {
    Scene scene;
    scene.background = {0.1, 0.3, 0.6};
    scene.camera = camera_at({0, 0, 1.5}, {0, 0, -1}, 0.8);
    add(scene, lamp({-3, 5, 3}));
    Mirror mirror = ideal_mirror({0, 0, 0}, kFace, 4);
    mirror.lobe = lobe;
    mirror.lobe_exponent = exponent;
    mirror.diffuse = mirror.ambient = 0;
    add(scene, mirror);
    return scene;
}

Solid of_kind(SolidKind kind, const Vec3<double>& position) {
    Solid solid;
    solid.kind = kind;
    solid.position = position;
    solid.rotation = {0.4, 0.3, -0.5};
    solid.radius = 0.6;
    solid.height = 1.1;
    solid.taper = kind == SolidKind::cone ? 0 : 1;
    solid.sides = 6;
    solid.material.color = {0.9, 0.5, 0.2};
    return solid;
}

constexpr SolidKind kKinds[] = {SolidKind::pyramid, SolidKind::prism, SolidKind::sphere, SolidKind::cylinder,
                                SolidKind::cone};

Scene with_one(SolidKind kind, double exponent, Lobe lobe = Lobe::phong) {
    Scene scene = before_a_mirror(exponent, lobe);
    add(scene, of_kind(kind, {0.1, -0.2, 3}));
    return scene;
}

/// Solids before and behind each other, as the mirror sees them.
Scene crowd(double exponent, Lobe lobe = Lobe::phong) {
    Scene scene = before_a_mirror(exponent, lobe);
    add(scene, of_kind(SolidKind::cone, {-0.8, -0.5, 2.6}));
    add(scene, of_kind(SolidKind::prism, {-0.2, -0.3, 3.6}));
    add(scene, of_kind(SolidKind::sphere, {0.4, 0.2, 2.8}));
    add(scene, of_kind(SolidKind::cylinder, {0.9, -0.4, 4.2}));
    return scene;
}

double rmse(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::pow(double(a.rgb[k]) - b.rgb[k], 2);
    return std::sqrt(sum / double(a.rgb.size()));
}

double rmse_of(const Scene& scene, const Settings& settings, const Image& truth) {
    return rmse(render(scene, settings), truth);
}

void expect_same_limit(const Scene& scene, const std::string& what) {
    // What the integrals and the plain lattice of so many rays may leave.
    constexpr double kMean = 4.5e-4, kWorst = 3e-3;
    constexpr std::int32_t kRays = 2048;
    const Image wanted = render(scene, plain(16, kRays)), got = render(scene, covered(16, kRays));
    EXPECT_GT(got.rays.covered, 10u) << what;
    EXPECT_LE(rmse(got, wanted), kMean) << what;
    EXPECT_LE(largest_difference(got, wanted), kWorst) << what;
}

TEST(Coverage, TendsToThePictureOfThePlainLattice) {
    for (const double n : {20.0, 200.0, 2000.0, 30000.0}) {
        for (const SolidKind kind : kKinds) {
            const std::string what = "kind " + std::to_string(static_cast<int>(kind)) + ", n " + std::to_string(n);
            expect_same_limit(with_one(kind, n, kind == SolidKind::cone ? Lobe::max_phong : Lobe::phong), what);
        }
        expect_same_limit(crowd(n), "a crowd, n " + std::to_string(n));
    }
}

/// Sums over the first rotations of the lattice, of plain and covered pictures of one scene.
class Rotations {
public:
    static constexpr int kSide = 12, kRays = 3;

    explicit Rotations(const Scene& scene) : scene_(scene) {}

    void add_until(int count) {
        for (; count_ < count; ++count_) {
            Settings settings = plain(kSide, kRays);
            settings.rotation = count_ + 1;
            const Image one = render(scene_, settings);
            settings.estimator = Estimator::fibonacci_coverage;
            add(one, render(scene_, settings));
        }
    }

    std::size_t size() const { return apart_.size(); }
    /// By how much the means are apart, and the standard deviation of that, by value and of the mean value.
    double apart(std::size_t value) const { return apart_[value].mean(count_); }
    double deviation(std::size_t value) const { return apart_[value].deviation(count_); }
    double apart_in_mean() const { return of_mean_.mean(count_); }
    double deviation_of_mean() const { return of_mean_.deviation(count_); }
    double brightest() const { return brightest_; }

    /// Roots of the mean squares over all values.
    double rms_apart() const { return rms(&Rotations::apart); }
    double rms_deviation() const { return rms(&Rotations::deviation); }

private:
    struct Sums {
        double first = 0, second = 0;
        void add(double x) { first += x, second += x * x; }
        double mean(int count) const { return first / count; }
        double deviation(int count) const {
            return std::sqrt(std::max(0.0, second / count - mean(count) * mean(count)) / count);
        }
    };

    void add(const Image& one, const Image& two) {
        apart_.resize(one.rgb.size());
        double sum = 0;
        for (std::size_t i = 0; i < apart_.size(); ++i) {
            const double apart = double(one.rgb[i]) - double(two.rgb[i]);
            apart_[i].add(apart);
            sum += apart;
            brightest_ = std::max(brightest_, double(one.rgb[i]));
        }
        of_mean_.add(sum / double(apart_.size()));
    }
    double rms(double (Rotations::*of)(std::size_t) const) const {
        double squares = 0;
        for (std::size_t i = 0; i < size(); ++i) squares += (this->*of)(i) * (this->*of)(i);
        return std::sqrt(squares / double(size()));
    }

    const Scene& scene_;
    std::vector<Sums> apart_;
    Sums of_mean_;
    double brightest_ = 0;
    int count_ = 0;
};

/// The means over rotations come together, value by value and of the picture: what they are apart by is what so many
/// rotations leave, and falls as the root of their number, down to what the integrals may be off by.
void expect_unbiased(const Scene& scene, const std::string& what) {
    constexpr int kFew = 100, kMany = 1600;
    constexpr double kIntegrals = 1e-4, kDeviations = 4.5;
    Rotations rotations(scene);
    rotations.add_until(kFew);
    const double early = rotations.rms_apart();
    rotations.add_until(kMany);
    // Where few rays of all rotations have met a solid there is hardly a deviation to see: as much light as one ray in
    // so many may bring that it is missed by all of them once in a thousand pixels.
    const double integrals = kIntegrals * rotations.brightest();
    const double unseen = 7 * rotations.brightest() / (kMany * Rotations::kRays);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        EXPECT_LE(std::abs(rotations.apart(i)), kDeviations * rotations.deviation(i) + unseen + integrals)
            << what << ", value " << i;
    }
    EXPECT_LE(std::abs(rotations.apart_in_mean()), kDeviations * rotations.deviation_of_mean() + integrals) << what;
    EXPECT_LE(rotations.rms_apart(), 1.25 * rotations.rms_deviation() + integrals) << what;
    EXPECT_LE(rotations.rms_apart(), early / 3) << what;
}

TEST(Coverage, IsUnbiased) {
    expect_unbiased(crowd(200), "a crowd");
    expect_unbiased(crowd(200, Lobe::max_phong), "a crowd by max_phong");
    for (const SolidKind kind : kKinds) {
        expect_unbiased(with_one(kind, 200), "kind " + std::to_string(static_cast<int>(kind)));
    }
}

TEST(Coverage, IsUnbiasedWhateverItsShadesAre) {
    // A lamp so near to the solids that the one shade of a tile is wrong by factors for nearly all of its rays.
    for (const SolidKind kind : kKinds) {
        Scene scene = with_one(kind, 60);
        scene.lights[0].position = {0.1, 0.1, 2.2};
        scene.lights[0].falloff = Falloff::inverse_square;
        scene.lights[0].intensity = 5;
        expect_unbiased(scene, "a lamp close to kind " + std::to_string(static_cast<int>(kind)));
    }
}

TEST(Coverage, LeavesATenthOfThePlainErrorOfAPolyhedron) {
    for (const SolidKind kind : {SolidKind::prism, SolidKind::pyramid}) {
        const Scene scene = with_one(kind, 1000);
        const Image truth = render(scene, plain(48, 1 << 16));
        for (const std::int32_t samples : {1, 4, 16}) {
            EXPECT_LE(10 * rmse_of(scene, covered(48, samples), truth), rmse_of(scene, plain(48, samples), truth))
                << samples << " rays";
        }
    }
}

TEST(Coverage, IsThatOfTheSameTubeHoweverItIsTurnedAboutItsAxis) {
    for (const SolidKind kind : {SolidKind::cylinder, SolidKind::cone}) {
        Scene scene = with_one(kind, 200);
        scene.solids[0].rotation = {0, 0, 0};
        const Image straight = render(scene, covered(48, 4));
        scene.solids[0].rotation = {0, 0.3, 0};
        EXPECT_EQ(render(scene, covered(48, 4)).hash(), straight.hash()) << "kind " << static_cast<int>(kind);
    }
}

// The upper end of the solid comes into view from one row of pixels to the next, wherever the tiles lie.
TEST(Coverage, LeavesATenthOfThePlainErrorWhereAFaceComesIntoView) {
    constexpr int kSide = 120;
    for (const SolidKind kind : {SolidKind::prism, SolidKind::cylinder}) {
        for (int row = 0; row < kTileSide; ++row) {
            Scene scene = before_a_mirror(1000, Lobe::phong);
            Solid solid = of_kind(kind, {0.05, -1.1, 2.5});
            solid.rotation = {0, 0.3, 0};
            add(scene, solid);
            // One row of pixels is so much of the mirror's plane.
            scene.camera.position.y = 2 * 1.5 * std::tan(0.4) / kSide * row;
            const Image truth = render(scene, plain(kSide, 4096));
            const double less = rmse_of(scene, plain(kSide, 16), truth) / rmse_of(scene, covered(kSide, 16), truth);
            EXPECT_GT(less, kind == SolidKind::prism ? 10 : 2) << "row " << row;
        }
    }
}

TEST(Coverage, LeavesHalfOfThePlainErrorOfARoundSolidOrLess) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone}) {
        const Scene scene = with_one(kind, 1000);
        const Image truth = render(scene, plain(48, 1 << 16));
        for (const std::int32_t samples : {1, 4, 16}) {
            EXPECT_LE(2 * rmse_of(scene, covered(48, samples), truth), rmse_of(scene, plain(48, samples), truth))
                << "kind " << static_cast<int>(kind) << ", " << samples << " rays";
        }
    }
}

TEST(Coverage, IsThePlainLatticeWhereNothingHasAnOutline) {
    Scene scene = with_one(SolidKind::prism, 100);
    scene.solids[0].sides = 13;
    const Image got = render(scene, covered(40, 5)), wanted = render(scene, plain(40, 5));
    EXPECT_EQ(got.hash(), wanted.hash());
    EXPECT_EQ(got.rays.covered, 0u);
    EXPECT_GT(got.rays.sampled, 100u);
    scene.solids[0].sides = 12;
    const Image twelve = render(scene, covered(40, 5));
    EXPECT_GT(twelve.rays.covered, 100u);
    EXPECT_EQ(twelve.rays.sampled, 0u);
    EXPECT_NE(twelve.hash(), render(scene, plain(40, 5)).hash());
}

TEST(Coverage, LeavesASolidBehindAnotherToTheRays) {
    // A ball wholly behind a wall: covered as if it were alone it would bring noise where there is nothing to see.
    Scene wall = before_a_mirror(300, Lobe::phong), both = wall;
    const Solid screen = box({0, -2, 5}, 4, 4, glowing({0.5, 0.5, 0.5}));
    add(wall, screen), add(both, screen);
    add(both, ball({0, 0, 9}, 1, glowing({1, 0, 0})));
    for (const int side : {40, 320}) {
        const Image one = render(wall, covered(side, 4)), two = render(both, covered(side, 4));
        EXPECT_EQ(two.hash(), one.hash()) << side;
        EXPECT_GT(two.rays.sampled, 100u) << side;
        EXPECT_EQ(one.rays.sampled, 0u) << side;
    }
}

TEST(Coverage, IsThePlainLatticeInTheOtherKernels) {
    Scene curved = crowd(100);
    curved.mirrors[0].curvature_radius = 20;
    EXPECT_EQ(render(curved, covered(32, 4)).hash(), render(curved, plain(32, 4)).hash());
    const Scene flat = crowd(100);
    EXPECT_EQ(render_fixed(flat, covered(16, 4)).hash(), render_fixed(flat, plain(16, 4)).hash());
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(curved, covered(32, 4), *plan);
    EXPECT_FALSE(plan->features & kFeatureCoverage);
    prepare_or_throw(flat, covered(32, 4), *plan);
    EXPECT_TRUE(plan->features & kFeatureCoverage);
    prepare_or_throw(flat, plain(32, 4), *plan);
    EXPECT_FALSE(plan->features & kFeatureCoverage);
}

}  // namespace
}  // namespace zerkalo::laws
