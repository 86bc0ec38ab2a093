// What solids hide of each other, as the estimator fibonacci+coverage takes it off their coverage.
#include "tests/laws/covering.hpp"

namespace zerkalo::laws {
namespace {

/// All of a solid sends the same light to everywhere.
Solid flat(Solid solid, const Rgb<double>& color) {
    solid.material = glowing(color);
    return solid;
}

constexpr double kExponents[] = {8, 30, 300};

/// Solid A before solid B, which it hides in part. All pixels look to where it does.
Scene one_before_another(SolidKind before, SolidKind behind, double exponent) {
    Scene scene = before_a_mirror(exponent, Lobe::phong);
    scene.camera = camera_at({0, 0, 1.5}, {0, 0, -1}, 0.3);
    add(scene, flat(of_kind(before, {-0.5, -0.3, 2.4}), {0.9, 0.2, 0.1}));
    Solid solid = flat(of_kind(behind, {0.35, 0.25, 4.3}), {0.1, 0.8, 0.3});
    solid.radius = 0.9;
    solid.height = 1.7;
    solid.rotation = {-0.7, 0.2, 0.9};
    add(scene, solid);
    return scene;
}

std::string name_of_pair(SolidKind before, SolidKind behind, double exponent) {
    return "kind " + std::to_string(static_cast<int>(before)) + " before " + std::to_string(static_cast<int>(behind)) +
           ", n " + std::to_string(exponent);
}

/// The mean over sixteen rotations of 2^14 rays each: a sum of many more in float would lose what is asked for.
Image of_quarter_million(const Scene& scene, int side) {
    constexpr int kRotations = 16;
    Settings settings = plain(side, 1 << 14);
    Image mean = render(scene, settings);
    std::vector<double> sums(mean.rgb.size());
    for (int k = 1; k <= kRotations; ++k) {
        settings.rotation = k;
        const Image one = render(scene, settings);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += double(one.rgb[i]) / kRotations;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) mean.rgb[i] = float(sums[i]);
    return mean;
}

/// With one light a solid and what is hidden known, a ray has nothing to add: the picture is the integral alone, with
/// one ray as with any number.
void expect_known_to_the_integrals(const Scene& scene, int side, const std::string& what) {
    constexpr double kIntegrals = 1e-4, kLattice = 1.5e-4;
    const Image wanted = of_quarter_million(scene, side), got = render(scene, covered(side, 1));
    EXPECT_LE(largest_difference(got, wanted), kIntegrals + kLattice) << what;
    EXPECT_EQ(got.rays.sampled, 0u) << what;
}

TEST(Hidden, CoverageOfEachPairIsThatOfAQuarterOfAMillionDirections) {
    std::size_t pair = 0;
    for (const SolidKind before : kKinds) {
        for (const SolidKind behind : kKinds) {
            // One of the exponents each, for many directions take long.
            const double n = kExponents[pair++ % std::size(kExponents)];
            expect_known_to_the_integrals(one_before_another(before, behind, n), 4, name_of_pair(before, behind, n));
        }
    }
}

/// Two wide tubes aslant, with all of their rims inside of the lobes: more sides than are kept.
Scene tube_before_tube() {
    Scene scene = one_before_another(SolidKind::cylinder, SolidKind::cylinder, 30);
    scene.solids[0].position = {-0.5, 0.1, 2.4}, scene.solids[1].position = {0.5, -0.1, 4.4};
    scene.solids[0].radius = 0.9, scene.solids[1].radius = 1.6;
    scene.solids[0].height = 0.8, scene.solids[1].height = 1.2;
    scene.solids[0].rotation = {1, 0.1, 0}, scene.solids[1].rotation = {2.2, -0.1, 0};
    return scene;
}

TEST(Hidden, CoverageOfOutlinesOfManySidesIsTheSame) {
    const Scene scene = tube_before_tube();
    expect_known_to_the_integrals(scene, 4, "tubes along their axes");
    const Image serial = render(scene, covered(20, 2), Isa::scalar);
    for (const Isa isa : available_isas()) EXPECT_EQ(render(scene, covered(20, 2), isa).hash(), serial.hash());
}

TEST(Hidden, EveryWidthTakesOffTheSame) {
    for (const double n : kExponents) {
        for (const SolidKind before : kKinds) {
            for (const SolidKind behind : kKinds) {
                const Scene scene = one_before_another(before, behind, n);
                const Image serial = render(scene, covered(20, 2), Isa::scalar);
                for (const Isa isa : available_isas()) {
                    EXPECT_EQ(render(scene, covered(20, 2), isa).hash(), serial.hash())
                        << name_of(isa) << ", " << name_of_pair(before, behind, n);
                }
            }
        }
    }
}

TEST(Hidden, IsTakenOffWithoutBias) {
    for (const SolidKind kind : {SolidKind::prism, SolidKind::sphere, SolidKind::cone}) {
        const SolidKind other = kind == SolidKind::cone ? SolidKind::pyramid : SolidKind::cone;
        Scene scene = one_before_another(kind, other, 200);
        for (int k = 0; k < 2; ++k) scene.solids[k].material = of_kind(kind, {}).material;
        expect_unbiased(scene, name_of_pair(kind, other, 200));
    }
    // Two that stand in each other: each hides the other.
    Scene crossed = before_a_mirror(200, Lobe::phong);
    add(crossed, of_kind(SolidKind::cylinder, {0, 0, 3}));
    add(crossed, of_kind(SolidKind::sphere, {0.2, 0.4, 3.1}));
    expect_unbiased(crossed, "two in each other");
    // Three in a row, where the last is hidden twice.
    Scene row = before_a_mirror(200, Lobe::phong);
    add(row, of_kind(SolidKind::sphere, {-0.3, 0, 2.4}));
    add(row, of_kind(SolidKind::cone, {0, -0.2, 3.6}));
    add(row, of_kind(SolidKind::prism, {0.3, 0.2, 5}));
    expect_unbiased(row, "three in a row");
}

TEST(Hidden, OutlinesLeaveAThirdOfThePlainErrorOfFlatSolids) {
    constexpr int kSide = 96;
    Scene scene = crowd(200);
    for (int k = 0; k < scene.solid_count; ++k) {
        scene.solids[k].material = glowing({0.2 + 0.2 * k, 0.9 - 0.2 * k, 0.1 + 0.1 * k});
    }
    const Image truth = render(scene, plain(kSide, 1 << 14));
    for (const std::int32_t samples : {1, 4, 16}) {
        EXPECT_LE(3 * rmse_of(scene, covered(kSide, samples), truth), rmse_of(scene, plain(kSide, samples), truth))
            << samples << " rays";
    }
}

}  // namespace
}  // namespace zerkalo::laws
