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
    constexpr double kMean = 4e-4, kWorst = 3e-3;
    constexpr std::int32_t kRays = 8192;
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

/// Mean and variance of the mean of a picture's values over the rotations of its lattice.
struct Moments {
    std::vector<double> mean, variance;
};

Moments over_rotations(const Scene& scene, Settings settings, int rotations) {
    Moments moments;
    for (int k = 1; k <= rotations; ++k) {
        settings.rotation = k;
        const Image image = render(scene, settings);
        moments.mean.resize(image.rgb.size()), moments.variance.resize(image.rgb.size());
        for (std::size_t i = 0; i < image.rgb.size(); ++i) {
            moments.mean[i] += image.rgb[i] / double(rotations);
            moments.variance[i] += double(image.rgb[i]) * image.rgb[i] / rotations;
        }
    }
    for (std::size_t i = 0; i < moments.mean.size(); ++i) {
        moments.variance[i] = std::max(0.0, moments.variance[i] - moments.mean[i] * moments.mean[i]) / rotations;
    }
    return moments;
}

/// The means over rotations, value by value and of the picture, are apart by at most four standard deviations and what
/// the integrals may be off by.
void expect_unbiased(const Scene& scene, double integrals, const char* what) {
    constexpr int kRotations = 400, kSide = 12, kRays = 3;
    // Where no ray of all rotations has met a solid there is no deviation to see: as much light as one in four may bring.
    constexpr double kUnseen = 4.0 / (kRotations * kRays);
    const Moments one = over_rotations(scene, plain(kSide, kRays), kRotations);
    const Moments two = over_rotations(scene, covered(kSide, kRays), kRotations);
    double apart_in_all = 0, variance_of_all = 0;
    for (std::size_t i = 0; i < one.mean.size(); ++i) {
        const double variance = one.variance[i] + two.variance[i], apart = one.mean[i] - two.mean[i];
        EXPECT_LE(std::abs(apart), 4.5 * std::sqrt(variance) + kUnseen + integrals) << what << ", value " << i;
        apart_in_all += apart, variance_of_all += variance;
    }
    // Neighbours share lattices: as if all four pixels of a block were one.
    EXPECT_LE(std::abs(apart_in_all), 4 * std::sqrt(12 * variance_of_all) + integrals * double(one.mean.size()) / 4)
        << what;
}

TEST(Coverage, IsUnbiased) {
    expect_unbiased(crowd(200), 3e-4, "a crowd");
    expect_unbiased(crowd(200, Lobe::max_phong), 3e-4, "a crowd by max_phong");
    for (const SolidKind kind : kKinds) expect_unbiased(with_one(kind, 200), 3e-4, "one solid");
}

TEST(Coverage, IsUnbiasedWhateverItsShadesAre) {
    // A lamp so near to the solids that the one shade of a tile is wrong by factors for nearly all of its rays.
    for (const SolidKind kind : kKinds) {
        Scene scene = with_one(kind, 60);
        scene.lights[0].position = {0.1, 0.1, 2.2};
        scene.lights[0].falloff = Falloff::inverse_square;
        scene.lights[0].intensity = 5;
        expect_unbiased(scene, 3e-3, "a lamp close by");
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

TEST(Coverage, LeavesTwoThirdsOfThePlainErrorOfARoundSolidOrLess) {
    for (const SolidKind kind : {SolidKind::sphere, SolidKind::cylinder, SolidKind::cone}) {
        const Scene scene = with_one(kind, 1000);
        const Image truth = render(scene, plain(48, 1 << 16));
        for (const std::int32_t samples : {1, 4, 16}) {
            EXPECT_LE(1.5 * rmse_of(scene, covered(48, samples), truth), rmse_of(scene, plain(48, samples), truth))
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
    // Scouts start from the middle of a tile: its pixels must look nearly the same way.
    const Image one = render(wall, covered(320, 4)), two = render(both, covered(320, 4));
    // But for tiles in which no scout meets it at all: there it fills less than a thirty-second of a lobe, and its rays
    // bring noise (0.006).
    EXPECT_LE(rmse(two, one), 8e-3);
    EXPECT_GT(two.rays.sampled, 100u);
    EXPECT_EQ(one.rays.sampled, 0u);
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
