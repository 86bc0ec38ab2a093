// The shipped scenes against the reference tracer: sharp pictures pixel by pixel, glossy ones within their noise.
#include "tests/laws/oracle.hpp"
#include "tests/laws/shipped.hpp"

#include <algorithm>
#include <cmath>

namespace zerkalo::laws {
namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr std::int32_t kSamples = 1024;  // the most for which culling leaves every byte
// Half as many. Random rays behind a second unpolished mirror are the same in both pictures for the samples that both
// have, so that the difference has the variance of 1/512 - 1/1024 of one ray's: that of the larger picture. The
// lattices have no point in common: there the difference has the errors of both.
constexpr std::int32_t kOtherSamples = 512;
constexpr unsigned kReferenceSamples = 256;
// The noise is itself estimated, from some thousand pixels with heavy tails: room for that estimate's own error.
constexpr double kSpread = 1.25;
// Standard errors of the mean: among a dozen pictures a larger one has a chance below 1 in 100000.
constexpr double kStandardErrors = 5;

using reference::Picture;

std::vector<double> channels_of(const Picture& picture) {
    std::vector<double> values;
    for (const Rgb<double>& p : picture.pixels) values.insert(values.end(), {p.r, p.g, p.b});
    return values;
}

/// Two independent estimates by the reference and two by the renderer, channel after channel.
struct Estimates {
    std::vector<double> reference1, reference2, renderer, other_samples;
};

/// Leaves out the pixels on silhouettes: the kSilhouetteShare of pixels that differ most.
void drop_silhouettes(Estimates& e) {
    std::vector<std::pair<double, std::size_t>> pixels;
    for (std::size_t i = 0; i < e.renderer.size(); i += 3) {
        double worst = 0;
        for (std::size_t c = i; c < i + 3; ++c) {
            worst = std::max(worst, std::abs(e.renderer[c] - (e.reference1[c] + e.reference2[c]) / 2));
        }
        pixels.push_back({worst, i});
    }
    std::sort(pixels.rbegin(), pixels.rend());
    const auto count = static_cast<std::size_t>(kSilhouetteShare * static_cast<double>(pixels.size()));
    for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t c = pixels[k].second; c < pixels[k].second + 3; ++c) {
            e.reference1[c] = e.reference2[c] = e.renderer[c] = e.other_samples[c] = 0;
        }
    }
}

/// Mean squares of what separates the estimates.
struct Errors {
    double apart = 0;      // renderer from the mean of both references
    double reference = 0;  // expected, of the mean of both references: a quarter of their squared difference
    double renderer = 0;   // bounds that of the renderer: the squared difference of its two pictures
    double bias = 0;       // mean, not square, of renderer - reference
};

Errors errors_of(const Estimates& e) {
    Errors errors;
    const auto n = static_cast<double>(e.renderer.size());
    for (std::size_t i = 0; i < e.renderer.size(); ++i) {
        const double apart = e.renderer[i] - (e.reference1[i] + e.reference2[i]) / 2;
        errors.apart += apart * apart / n;
        errors.bias += apart / n;
        errors.reference += std::pow(e.reference1[i] - e.reference2[i], 2) / (4 * n);
        errors.renderer += std::pow(e.renderer[i] - e.other_samples[i], 2) / n;
    }
    return errors;
}

TEST(Oracle, SharpShippedScenesAgreeButForSilhouettes) {
    for (const auto& [name, scene] : shipped_scenes()) {
        expect_agreement("sharp-" + name, sharpened(scene), of_size(160, 120));
    }
}

TEST(Oracle, GlossyShippedScenesAgreeWithinTheSamplingError) {
    for (const auto& [name, scene] : shipped_scenes()) {
        Settings settings = of_size(kWidth, kHeight);
        settings.samples = kOtherSamples;
        const Picture other = picture_of(render(scene, settings));
        settings.samples = kSamples;
        const Picture actual = picture_of(render(scene, settings));
        const Picture one = reference_picture(scene, settings, kReferenceSamples, 1);
        const Picture two = reference_picture(scene, settings, kReferenceSamples, 2);
        Estimates estimates{channels_of(one), channels_of(two), channels_of(actual), channels_of(other)};
        drop_silhouettes(estimates);
        const Errors errors = errors_of(estimates);
        // Independent errors add by their squares.
        const double noise = std::sqrt(errors.reference + errors.renderer);
        EXPECT_LE(std::sqrt(errors.apart), kSpread * noise)
            << name << ": " << reference::save_failure(testing::TempDir() + "zerkalo-glossy-" + name, actual, one);
        // The three channels of a pixel share their rays: a third as many independent values.
        const double independent = static_cast<double>(kWidth) * kHeight;
        EXPECT_LE(std::abs(errors.bias), kStandardErrors * noise / std::sqrt(independent)) << name;
    }
}

}  // namespace
}  // namespace zerkalo::laws
