// Pictures in fixed point: the float picture and the reference tracer's, to the last step of 255 but for silhouettes.
#include "tests/laws/oracle.hpp"
#include "tests/laws/shipped.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr double kSilhouettes = 5e-4;  // of the pixels
constexpr double kMostRmse = 0.02;     // 8-bit steps, over the pixels that are not on a silhouette

/// How far two pictures are apart in 8-bit steps: pixels off by more than one, and the RMSE of the others, before the
/// steps are rounded.
struct Steps {
    double share_off = 0, rmse = 0;
};

double stored(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

Steps steps_between(const reference::Picture& a, const reference::Picture& b) {
    Steps steps;
    double squares = 0;
    std::int64_t off = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double r = std::abs(stored(a.pixels[i].r) - stored(b.pixels[i].r));
        const double g = std::abs(stored(a.pixels[i].g) - stored(b.pixels[i].g));
        const double c = std::abs(stored(a.pixels[i].b) - stored(b.pixels[i].b));
        // Less than a whole step apart, two values are stored at most one apart.
        if (std::max({r, g, c}) >= 1) {
            ++off;
        } else {
            squares += r * r + g * g + c * c;
        }
    }
    const auto pixels = static_cast<double>(a.pixels.size());
    steps.share_off = static_cast<double>(off) / pixels;
    steps.rmse = std::sqrt(squares / (3 * (pixels - static_cast<double>(off))));
    return steps;
}

void expect_same_picture(const std::string& name, const reference::Picture& actual,
                         const reference::Picture& expected) {
    const Steps steps = steps_between(actual, expected);
    EXPECT_LE(steps.share_off, kSilhouettes)
        << name << ": " << reference::save_failure(testing::TempDir() + "zerkalo-fixed-" + name, actual, expected);
    EXPECT_LE(steps.rmse, kMostRmse) << name;
    testing::Test::RecordProperty(name + "-off", std::to_string(steps.share_off));
    testing::Test::RecordProperty(name + "-rmse", std::to_string(steps.rmse));
}

TEST(FixedPictures, OfShippedScenesAreTheFloatPictures) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(160, 120);
        settings.samples = 8;
        expect_same_picture(name, picture_of(render_fixed(scene, settings)), picture_of(render(scene, settings)));
    }
}

TEST(FixedPictures, OfSharpShippedScenesAreThoseOfTheReference) {
    constexpr std::uint64_t kUnusedSeed = 1;
    for (const auto& [name, scene] : shipped_scenes()) {
        const Scene sharp = sharpened(scene);
        const Settings settings = of_size(160, 120);
        expect_same_picture("sharp-" + name, picture_of(render_fixed(sharp, settings)),
                            reference_picture(sharp, settings, 1, kUnusedSeed));
    }
}

TEST(FixedPictures, SendTheRaysThatFloatSends) {
    for (const ShippedScene& shipped : shipped_scenes()) {
        const std::string& name = shipped.name;
        const Scene& scene = shipped.scene;
        const Image fixed = render_fixed(sharpened(scene), of_size(64, 48));
        const Image floats = render(sharpened(scene), of_size(64, 48));
        EXPECT_EQ(fixed.rays.primary, floats.rays.primary) << name;
        // A silhouette pixel may see another surface: a few rays in a thousand.
        const auto expect_near = [&](std::uint64_t a, std::uint64_t b) {
            EXPECT_LE(std::abs(double(a) - double(b)), 5e-3 * double(b) + 4) << name;
        };
        expect_near(fixed.rays.reflected, floats.rays.reflected);
        expect_near(fixed.rays.refracted, floats.rays.refracted);
        expect_near(fixed.rays.shadow, floats.rays.shadow);
    }
}

TEST(FixedPictures, HaveTheSameBytesForEveryInstructionSet) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t antialias : {1, 3}) {
            Settings settings = of_size(33, 17);
            settings.samples = 5;
            settings.antialias = antialias;
            const Image serial = render_fixed(scene, settings, Isa::scalar);
            for (const Isa isa : available_isas()) {
                EXPECT_EQ(render_fixed(scene, settings, isa).hash(), serial.hash()) << name << ": " << name_of(isa);
            }
        }
    }
}

TEST(FixedPictures, DoNotChangeWithCulling) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(64, 48);
        settings.samples = 5;
        const Image culled = render_fixed(scene, settings);
        settings.exact_plan = true;
        EXPECT_EQ(render_fixed(scene, settings).hash(), culled.hash()) << name;
    }
}

}  // namespace
}  // namespace zerkalo::laws
