// The pictures of the rules that place lobe rays depend on neither the machine nor the kernel nor what it counts with.
#include "tests/laws/rules.hpp"
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

Scene unpolished(Scene scene, Lobe lobe, double exponent) {
    scene.mirrors[0].lobe = lobe;
    scene.mirrors[0].lobe_exponent = exponent;
    return scene;
}

/// A scene for the kernel of one bounce, one for the general kernel, and a wide lobe at a grazing view.
std::vector<Scene> scenes() {
    Scene grazing = unpolished(simple_scene(), Lobe::phong, 3);
    grazing.camera = camera_at({6, 1.2, -0.6}, {-1, 0, -0.05}, 0.8);
    return {unpolished(simple_scene(), Lobe::phong, 300), unpolished(simple_scene(), Lobe::max_phong, 20),
            unpolished(five_solids_before_mirror_aslant(-8), Lobe::max_phong, 100), grazing};
}

TEST(EstimatorPictures, HaveTheSameBytesWithEveryInstructionSet) {
    for (const Estimator rule : kKeyed) {
        for (const Scene& scene : scenes()) {
            for (const std::int32_t samples : {1, 5, 70}) {
                for (const std::int32_t antialias : {1, 2}) {
                    Settings settings = placed_by(rule, samples, 1);
                    settings.width = 33, settings.height = 17, settings.antialias = antialias;
                    const Image serial = render(scene, settings, Isa::scalar);
                    for (const Isa isa : available_isas()) {
                        EXPECT_EQ(render(scene, settings, isa).hash(), serial.hash())
                            << name_of(rule) << ", " << samples << " samples, " << name_of(isa);
                    }
                }
            }
        }
    }
}

TEST(EstimatorPictures, DoNotChangeWithCulling) {
    for (const Estimator rule : kKeyed) {
        for (const Scene& scene : scenes()) {
            for (const std::int32_t samples : {5, 70}) {
                Settings settings = placed_by(rule, samples, 2);
                settings.width = 48, settings.height = 36;
                const Image culled = render(scene, settings);
                settings.exact_plan = true;
                EXPECT_EQ(pixels_apart(culled, render(scene, settings)), 0)
                    << name_of(rule) << ", " << samples << " samples";
            }
        }
    }
}

/// Pixels that differ by more than rounding: a ray runs so close to an edge that one kernel hits and one does not.
double share_apart(const Image& a, const Image& b) {
    constexpr double kRounding = 1e-4;
    int apart = 0;
    for (std::size_t k = 0; k < a.rgb.size(); k += 3) {
        double most = 0;
        for (std::size_t c = k; c < k + 3; ++c) most = std::max(most, std::abs(double(a.rgb[c]) - double(b.rgb[c])));
        apart += most > kRounding;
    }
    return 3.0 * apart / static_cast<double>(a.rgb.size());
}

TEST(EstimatorPictures, AreTheSameOfTheGeneralKernelAndTheSpecialOne) {
    for (const Estimator rule : kRules) {
        for (Scene scene : scenes()) {
            Settings settings = placed_by(rule, 9, 1);
            settings.width = 64, settings.height = 48, settings.antialias = 2;
            const Image special = render(scene, settings);
            // A second mirror that nobody sees asks for the general kernel.
            add(scene, ideal_mirror({0, 1, -50}, {0, 0, -1}, 1));
            EXPECT_LE(share_apart(render(scene, settings), special), 0.01) << name_of(rule);
        }
    }
}

TEST(EstimatorPictures, AreTheSameInFixedPointAndDouble) {
    for (const Estimator rule : kRules) {
        for (const Scene& scene : scenes()) {
            Settings settings = placed_by(rule, 6, 3);
            settings.width = 64, settings.height = 48;
            const Image floats = render(scene, settings);
            EXPECT_LE(share_apart(render_fixed(scene, settings), floats), 0.01) << name_of(rule) << ", fixed point";
            EXPECT_LE(share_apart(render_double(scene, settings), floats), 0.01) << name_of(rule) << ", double";
        }
    }
}

TEST(EstimatorPictures, DifferByRuleAndRotation) {
    const Scene scene = scenes()[0];
    std::vector<std::uint64_t> hashes;
    for (const Estimator rule : kRules) {
        for (const std::int32_t rotation : {0, 1, 2}) {
            Settings settings = placed_by(rule, 5, rotation);
            settings.width = 33, settings.height = 17;
            hashes.push_back(render(scene, settings).hash());
        }
    }
    std::sort(hashes.begin(), hashes.end());
    EXPECT_EQ(std::adjacent_find(hashes.begin(), hashes.end()), hashes.end());
}

}  // namespace
}  // namespace zerkalo::laws
