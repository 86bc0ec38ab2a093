// The ends of the scale of polish, and unpolished mirrors at grazing angles.
#include "core/scene/edit.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 32;  // pixels a side

// ---- Polish

constexpr double kNearlyOne = 1 - 0x1p-24;
constexpr double kNoPolish[] = {-0.5, -1e-30, 1.0000001, 1.5, std::numeric_limits<double>::quiet_NaN()};

Scene ball_before_mirror(double lobe_exponent) {
    Scene scene;
    scene.background = {0.25, 0.25, 0.25};
    add(scene, lamp({3, 3, 4}));
    add(scene, ball({0, 0, 1.5}, 1, chalk()));
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 6));
    scene.mirrors[0].lobe_exponent = lobe_exponent;
    scene.camera = camera_at({2, 1, 5}, {-2, -1, -4}, 0.8);
    return scene;
}

double s34_ours(const Stage& stage) {
    const auto picture = [&](double exponent) { return stage.render(ball_before_mirror(exponent), kSide, kSide); };
    const Picture sharp = picture(kInfinity);
    constexpr double kRounding = 1e-6;  // of the sum over the lobe's rays
    double wrong = pixels_apart(sharp, picture(exponent_of_polish(1)));
    const double nearly = exponent_of_polish(kNearlyOne);
    if (!stage.beyond_formats(ball_before_mirror(nearly), "lobe_exponent")) {
        wrong += pixels_apart(sharp, picture(nearly), kRounding);
    }
    wrong += exponent_of_polish(0) != 0;
    wrong += pixels_apart(sharp, picture(exponent_of_polish(0)), kRounding) == 0;
    for (const double polish : kNoPolish) {
        wrong += stage.refused_field(ball_before_mirror(exponent_of_polish(polish))) != "lobe_exponent";
    }
    return wrong;
}

/// The normalised lobe (n + 1) / (2 pi) cos^n near its axis, whatever the polish.
double s34_naive() {
    double wrong = 0;
    const auto density = [](float polish) {
        const float rough = 1 - polish, n = (1 / (rough * rough * rough * rough) - 1) / 2;
        return (n + 1) / (2 * std::numbers::pi_v<float>)*std::pow(0.999f, n);
    };
    for (const double polish : {1.0, kNearlyOne, 0.0}) wrong += !std::isfinite(density(float(polish)));
    for (const double polish : kNoPolish) wrong += std::isfinite(density(float(polish)));
    return wrong;
}

// ---- Grazing

constexpr double kGrazing = 0.01 * std::numbers::pi / 180;  // between the ray and the mirror
constexpr double kBackground = 0.5;
constexpr double kExponent = 100;

/// A mirror y = 0 that hides a bright block close below it, seen along its surface; nothing else has any light but the
/// background.
Scene skimming(Lobe lobe, double exponent) {
    Scene scene;
    scene.background = {kBackground, kBackground, kBackground};
    constexpr double kBelow = 0x1p-10;
    add(scene, upright(SolidKind::prism, {0, -1 - kBelow, 0}, 400, 1, glowing({1, 1, 1})));
    add(scene, ideal_mirror({0, 0, 0}, {0, 1, 0}, 256));
    scene.mirrors[0].up = {0, 0, -1};
    scene.mirrors[0].lobe = lobe;
    scene.mirrors[0].lobe_exponent = exponent;
    constexpr double kAway = 16;
    scene.camera =
        camera_at({0, kAway * std::tan(kGrazing), kAway}, {0, -std::sin(kGrazing), -std::cos(kGrazing)}, kGrazing);
    return scene;
}

double s35_ours(const Stage& stage) {
    double most = 0;
    for (const double exponent : {kExponent, 1e6, kInfinity}) {
        for (const Lobe lobe : {Lobe::phong, Lobe::max_phong}) {
            const Picture picture = stage.render(skimming(lobe, exponent), kSide, kSide);
            for (const float light : picture.rgb) {
                const double relative = light / kBackground - 1;
                // The weights of max-Phong may take light away, though not all of it.
                const bool darkens = lobe == Lobe::max_phong && exponent < kInfinity && light > 0;
                most = std::max(most, darkens ? relative : std::abs(relative));
            }
        }
    }
    return most;
}

/// The lobe about the mirror direction without a look at the horizon: what points below it sees the block.
double s35_naive() {
    constexpr int kRays = 256;
    const float up = float(std::sin(kGrazing)), along = float(std::cos(kGrazing));
    float sum = 0;
    for (int k = 0; k < kRays; ++k) {
        const float cosine = std::pow((float(k) + 0.5f) / kRays, 1 / (float(kExponent) + 1));
        const float sine = std::sqrt(1 - cosine * cosine), turn = 2.3999632f * float(k);
        const float y = up * cosine + along * sine * std::sin(turn);
        sum += y > 0 ? float(kBackground) : 1;
    }
    return sum / kRays / kBackground - 1;
}

constexpr StiffCase kRows[] = {
    {"S34", "polish 0, 1, 1 - 2^-24, below 0, above 1, NaN", "infinity * 0 for 1, a rough mirror for 1.5, NaN for NaN",
     "1 is the sharp mirror, 1 - 2^-24 the same to 1e-6, 0 is n = 0; others are refused", "wrong", 0, s34_ours,
     s34_naive, {.refused = "lobe_exponent"}},
    {"S35", "mirrors seen at 89.99 degrees, n = 100, 1e6, infinite", "half of the lobe dips below the mirror",
     "nothing from below the mirror is seen, and no more light returns than comes", "relative", 1e-6, s35_ours,
     s35_naive},
};

}  // namespace

std::span<const StiffCase> polish_rows() { return kRows; }

}  // namespace zerkalo::stability
