// The estimator fibonacci+coverage: the integral of plain sampling with less error, whatever hides what.
#include "tests/laws/covering.hpp"

namespace zerkalo::laws {
namespace {

void expect_same_limit(const Scene& scene, const std::string& what) {
    // What the integrals and the plain lattice of so many rays may leave.
    constexpr double kMean = 4e-4, kWorst = 3e-3;
    constexpr std::int32_t kRays = 4096;
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
