// One scene and one set of settings give one picture, bit for bit, whatever instruction set renders it.
#include "tests/laws/rendering.hpp"
#include "tests/laws/shipped.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <sstream>

namespace zerkalo {

bool operator==(const RayCounts& a, const RayCounts& b) {
    return a.primary == b.primary && a.reflected == b.reflected && a.lobe == b.lobe && a.refracted == b.refracted &&
           a.shadow == b.shadow && a.covered == b.covered && a.sampled == b.sampled;
}

void PrintTo(const RayCounts& rays, std::ostream* out) {
    *out << rays.primary << " primary, " << rays.reflected << " reflected, " << rays.lobe << " lobe, " << rays.refracted
         << " refracted, " << rays.shadow << " shadow rays, " << rays.covered << " covered, " << rays.sampled
         << " sampled lobes";
}

namespace laws {
namespace {

std::string text_of(const std::string& name, const Settings& s) {
    std::ostringstream text;
    text << name << ", " << s.width << "x" << s.height << ", " << s.samples << " samples, " << s.antialias
         << " camera rays";
    return text.str();
}

void expect_equal_bytes(const std::string& name, const Scene& scene, const Settings& settings) {
    const auto plan = std::make_unique<Plan>();
    prepare_or_throw(scene, settings, *plan);
    const Image serial = render(*plan, Isa::scalar);
    for (const Isa isa : available_isas()) {
        const Image image = render(*plan, isa);
        EXPECT_EQ(image.hash(), serial.hash()) << text_of(name, settings) << ": " << name_of(isa) << " and scalar";
        EXPECT_EQ(image.rays, serial.rays) << text_of(name, settings) << ": " << name_of(isa) << " and scalar";
    }
}

struct Size {
    int width, height;
};
constexpr Size kSmallSizes[] = {{33, 17}, {1, 1}, {7, 5}};

TEST(EqualBytes, EveryInstructionSetRendersUnpolishedMirrorsAlike) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t samples : {1, 5, 16, 100}) {
            for (const Size size : kSmallSizes) {
                for (const std::int32_t antialias : {1, 3}) {
                    Settings settings = of_size(size.width, size.height);
                    settings.samples = samples;
                    settings.antialias = antialias;
                    expect_equal_bytes(name, scene, settings);
                }
            }
            Settings settings = of_size(64, 48);
            settings.samples = samples;
            expect_equal_bytes(name, scene, settings);
        }
    }
}

TEST(EqualBytes, EveryInstructionSetCoversSolidsAlike) {
    for (const auto& [name, scene] : shipped_scenes()) {
        if (scene.mirrors[0].lobe == Lobe::ggx) continue;  // has no coverage
        for (const std::int32_t samples : {1, 4, 100}) {
            Settings settings = of_size(64, 48);
            settings.estimator = Estimator::fibonacci_coverage;
            settings.samples = samples;
            expect_equal_bytes(name + " (coverage)", scene, settings);
            settings.width = 33, settings.height = 17, settings.antialias = 3;
            expect_equal_bytes(name + " (coverage)", scene, settings);
        }
    }
}

TEST(EqualBytes, EveryInstructionSetRendersPolishedMirrorsAlike) {
    for (const auto& [name, scene] : shipped_scenes()) {
        for (const std::int32_t antialias : {1, 3}) {
            Settings settings = of_size(64, 48);
            settings.antialias = antialias;
            expect_equal_bytes(name + " (polished)", sharpened(scene), settings);
            for (const Size size : kSmallSizes) {
                settings.width = size.width;
                settings.height = size.height;
                expect_equal_bytes(name + " (polished)", sharpened(scene), settings);
            }
        }
    }
}

TEST(EqualBytes, PicturesOfDifferentScenesDiffer) {
    const std::vector<ShippedScene>& scenes = shipped_scenes();
    for (std::size_t i = 1; i < scenes.size(); ++i) {
        const Settings settings = of_size(33, 17);
        EXPECT_NE(render(scenes[i].scene, settings).hash(), render(scenes[0].scene, settings).hash()) << scenes[i].name;
    }
}

}  // namespace
}  // namespace laws
}  // namespace zerkalo
