// Pictures in double: those of float but for rounding, sample by sample, and those of the reference tracer.
#include "tests/laws/oracle.hpp"
#include "tests/laws/shipped.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

/// Pixels that see another surface, and the RMSE and the largest difference of the others, in linear light.
struct Rounding {
    double share_off = 0, rmse = 0, most = 0;
};

Rounding rounding_between(const reference::Picture& a, const reference::Picture& b, double another_surface) {
    Rounding result;
    double squares = 0, off = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double r = std::abs(a.pixels[i].r - b.pixels[i].r), g = std::abs(a.pixels[i].g - b.pixels[i].g);
        const double c = std::abs(a.pixels[i].b - b.pixels[i].b), largest = std::max({r, g, c});
        if (!(largest <= another_surface)) {
            ++off;
        } else {
            squares += r * r + g * g + c * c;
            result.most = std::max(result.most, largest);
        }
    }
    const auto pixels = static_cast<double>(a.pixels.size());
    result.share_off = off / pixels;
    result.rmse = std::sqrt(squares / (3 * (pixels - off)));
    return result;
}

void record(const std::string& name, const Rounding& rounding) {
    testing::Test::RecordProperty(name + "-off", std::to_string(rounding.share_off));
    testing::Test::RecordProperty(name + "-rmse", std::to_string(1e9 * rounding.rmse) + "e-9");
    testing::Test::RecordProperty(name + "-most", std::to_string(1e9 * rounding.most) + "e-9");
}

void expect_float_picture(const std::string& name, const Scene& scene, const Settings& settings) {
    constexpr double kAnotherSurface = 1e-4, kMostRmse = 1e-6;
    const Rounding rounding = rounding_between(picture_of(render_double(scene, settings)),
                                               picture_of(render(scene, settings)), kAnotherSurface);
    EXPECT_LE(rounding.share_off, kSilhouetteShare) << name;
    EXPECT_LE(rounding.rmse, kMostRmse) << name;
    record(name, rounding);
}

TEST(DoublePictures, OfPolishedMirrorsAreThoseOfFloatButForRounding) {
    for (const auto& [name, scene] : shipped_scenes()) {
        expect_float_picture(name, sharpened(scene), of_size(160, 120));
    }
}

TEST(DoublePictures, OfUnpolishedMirrorsHaveTheSamplesOfFloat) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t rotation : {0, 5}) {
            Settings settings = of_size(160, 120);
            settings.rotation = rotation;
            expect_float_picture(name + "-" + std::to_string(rotation), scene, settings);
        }
    }
}

TEST(DoublePictures, OfEveryRuleHaveTheSamplesOfFloat) {
    for (const auto& [name, scene] : shipped_scenes()) {
        if (name != "gold-mirror-5" && name != "two-mirrors") continue;
        for (int rule = 0; rule < kEstimatorCount; ++rule) {
            // What float covers, double samples.
            if (static_cast<Estimator>(rule) == Estimator::fibonacci_coverage) continue;
            Settings settings = of_size(160, 120);
            settings.estimator = static_cast<Estimator>(rule);
            settings.rotation = 3;
            expect_float_picture(name + "-" + name_of(settings.estimator), scene, settings);
        }
    }
}

TEST(DoublePictures, OfManyCameraRaysHaveTheSamplesOfFloat) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(80, 60);
        settings.samples = 3;
        settings.antialias = 5;
        expect_float_picture(name, scene, settings);
    }
}

TEST(DoublePictures, OfSharpShippedScenesAreThoseOfTheReference) {
    // What rounding a pixel to float costs light below 4.
    constexpr double kMost = 0x1p-23;
    constexpr std::uint64_t kUnusedSeed = 1;
    for (const auto& [name, scene] : shipped_scenes()) {
        const Scene sharp = sharpened(scene);
        const Settings settings = of_size(160, 120);
        const reference::Picture actual = picture_of(render_double(sharp, settings));
        const reference::Picture expected = reference_picture(sharp, settings, 1, kUnusedSeed);
        const Rounding rounding = rounding_between(actual, expected, kMost);
        EXPECT_LE(rounding.share_off, kSilhouetteShare)
            << name << ": "
            << reference::save_failure(testing::TempDir() + "zerkalo-double-" + name, actual, expected);
        record(name, rounding);
    }
}

TEST(DoublePictures, SendTheRaysThatTheGeneralKernelSendsInFloat) {
    for (const auto& [name, scene] : shipped_scenes()) {
        const Image doubles = render_double(sharpened(scene), of_size(64, 48));
        const Image floats = render(sharpened(scene), of_size(64, 48));
        EXPECT_EQ(doubles.rays.primary, floats.rays.primary) << name;
        // A silhouette pixel may see another surface: a few rays in a thousand.
        const auto expect_near = [&name = name](std::uint64_t a, std::uint64_t b) {
            EXPECT_LE(std::abs(double(a) - double(b)), 5e-3 * double(b) + 4) << name;
        };
        expect_near(doubles.rays.reflected, floats.rays.reflected);
        expect_near(doubles.rays.refracted, floats.rays.refracted);
        expect_near(doubles.rays.shadow, floats.rays.shadow);
    }
}

TEST(DoublePictures, DoNotChangeWithCulling) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(64, 48);
        settings.samples = 5;
        const Image culled = render_double(scene, settings);
        settings.exact_plan = true;
        EXPECT_EQ(render_double(scene, settings).hash(), culled.hash()) << name;
    }
}

}  // namespace
}  // namespace zerkalo::laws
