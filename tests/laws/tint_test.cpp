// The colour of a mirror multiplies what it reflects, once a bounce and channel by channel.
#include "tests/laws/staging.hpp"

#include <gtest/gtest.h>

namespace zerkalo::laws {
namespace {

// Powers of two: the products are exact.
constexpr Rgb<double> kTint{1, 0.5, 0.25};

Image times(Image image, const Rgb<double>& c) {
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        image.rgb[i] *= static_cast<float>(c.r);
        image.rgb[i + 1] *= static_cast<float>(c.g);
        image.rgb[i + 2] *= static_cast<float>(c.b);
    }
    return image;
}

/// Every camera ray meets the mirror; the solids stand behind the camera.
Scene seen_in_the_mirror(const Rgb<double>& tint, double lobe_exponent) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, 8);
    add(scene, lamp({-3, 6, 2}));
    Mirror mirror = ideal_mirror({0, 1, 0}, {0, 0, 1}, 20);
    mirror.color = tint;
    mirror.lobe_exponent = lobe_exponent;
    add(scene, mirror);
    scene.camera = camera_at({0, 1, 5}, {0, 0, -1}, 0.8);
    return scene;
}

/// A periscope: every camera ray meets one mirror and then the other.
Scene periscope(const Rgb<double>& tint) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add_five_solids(scene, -8);
    for (int k = 0; k < scene.solid_count; ++k) scene.solids[k].position.y += 9;
    add(scene, lamp({-3, 16, 2}));
    for (const double side : {1.0, -1.0}) {
        Mirror mirror = ideal_mirror({0, side > 0 ? 0.0 : 10.0, 0}, {0, side, side}, 12);
        mirror.color = tint;
        add(scene, mirror);
    }
    scene.camera = camera_at({0, 0, 8}, {0, 0, -1}, 0.15);
    return scene;
}

TEST(P24, TintMultipliesEachChannelOfThePictureInTheMirror) {
    for (const double lobe_exponent : {kInfinity, 50.0}) {
        const Image white = render(seen_in_the_mirror({1, 1, 1}, lobe_exponent), of_size(64, 48));
        const Image tinted = render(seen_in_the_mirror(kTint, lobe_exponent), of_size(64, 48));
        EXPECT_EQ(pixels_apart(times(white, kTint), tinted), 0) << "lobe exponent " << lobe_exponent;
        EXPECT_GT(largest_difference(white, tinted), 0.1) << "lobe exponent " << lobe_exponent;
    }
}

TEST(P24, TintOfTwoMirrorsMultipliesTwice) {
    const Image white = render(periscope({1, 1, 1}), of_size(64, 48));
    const Image tinted = render(periscope(kTint), of_size(64, 48));
    EXPECT_EQ(pixels_apart(times(times(white, kTint), kTint), tinted), 0);
    // The periscope does see the solids.
    EXPECT_GT(largest_difference(white, flipped(white)), 0.1);
}

}  // namespace
}  // namespace zerkalo::laws
