// Highlights and unpolished mirrors whose exponent is 0, huge or infinite.
#include "tools/stability/exact.hpp"
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <limits>

namespace zerkalo::stability {
namespace {

constexpr int kSide = 32;  // pixels a side

/// A floor z = 0 that shows nothing but highlights, seen straight from above.
Scene shining_floor(double shininess, const Vec3<double>& lamp_position, double fov) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    Mirror floor = ideal_mirror({0, 0, 0}, {0, 0, 1}, 8);
    floor.reflection = 0;
    floor.specular = 1;
    floor.shininess = shininess;
    add(scene, floor);
    add(scene, lamp(lamp_position));
    scene.camera = camera_at({0, 0, 1}, {0, 0, -1}, fov);
    return scene;
}

/// The largest error over the pixels of shining_floor(). error(i, j, p): of the one that sees point p of the floor.
template <class Error>
double largest_on_floor(const Scene& scene, const Error& error) {
    double largest = 0;
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const exact::Ray ray = exact::through_pixel(scene.camera, kSide, kSide, i, j);
            const double one = error(i, j, exact::at(ray, -ray.o.z / ray.d.z));
            if (std::isnan(one)) return one;
            largest = std::max(largest, one);
        }
    }
    return largest;
}

/// R.V at a point of the floor, in any number type.
template <class T>
T mirrored_cosine(const Scene& scene, const exact::Vec& p) {
    const auto towards = [&](const exact::Vec& to) {
        const T x = T(to.x - p.x), y = T(to.y - p.y), z = T(to.z);
        const T scale = 1 / std::sqrt(x * x + y * y + z * z);
        return Vec3<T>{x * scale, y * scale, z * scale};
    };
    const Vec3<T> l = towards(scene.lights[0].position), v = towards(scene.camera.position);
    return -l.x * v.x - l.y * v.y + l.z * v.z;
}

// ---- Exponent 0

Scene constant_highlight() { return shining_floor(0, {1.5, 0.2, 0.25}, 1.6); }

double s31_ours(const Stage& stage) {
    const Scene scene = constant_highlight();
    const Picture picture = stage.render(scene, kSide, kSide);
    const double highlight = largest_on_floor(
        scene, [&](int i, int j, const exact::Vec&) { return std::abs(double{picture.at(i, j).g} - 1); });
    // A lobe of exponent 0 about the normal is uniform over the hemisphere: white in a white room, weighed by the
    // cosine one half.
    const auto white_room = [&](Lobe lobe) {
        Scene room;
        room.background = {1, 1, 1};
        add(room, ideal_mirror({0, 0, 0}, {0, 0, 1}, 8));
        room.mirrors[0].lobe = lobe;
        room.mirrors[0].lobe_exponent = 0;
        Settings settings;
        settings.samples = 64;
        return double{stage.look(room, {0, 0, 1}, {0, 0, -1}, settings).g};
    };
    return std::max({highlight, std::abs(white_room(Lobe::phong) - 1), std::abs(white_room(Lobe::max_phong) - 0.5)});
}

double s31_naive() {
    const Scene scene = constant_highlight();
    return largest_on_floor(scene, [&](int, int, const exact::Vec& p) {
        const float cosine = std::fmax(0.0f, mirrored_cosine<float>(scene, p));
        return std::abs(double{std::exp(0 * std::log(cosine))} - 1);
    });
}

// ---- Exponent 1e6

constexpr double kNarrow = 1e6;

Scene narrow_highlight() { return shining_floor(kNarrow, {0, 0, 2}, 3e-3); }

template <class Shown>
double wrong_in_highlight(const Shown& shown) {
    const Scene scene = narrow_highlight();
    return largest_on_floor(scene, [&](int i, int j, const exact::Vec& p) {
        const exact::Vec l = exact::unit(exact::minus(scene.lights[0].position, p));
        const exact::Vec v = exact::unit(exact::minus(scene.camera.position, p));
        const exact::Vec chord = exact::minus({-l.x, -l.y, l.z}, v);
        const double closed = std::exp(kNarrow * std::log1p(-exact::dot(chord, chord) / 2));
        return std::abs(shown(i, j, p) / closed - 1);
    });
}

double s32_ours(const Stage& stage) {
    const Picture picture = stage.render(narrow_highlight(), kSide, kSide);
    return wrong_in_highlight([&](int i, int j, const exact::Vec&) { return double{picture.at(i, j).g}; });
}

double s32_naive() {
    const Scene scene = narrow_highlight();
    return wrong_in_highlight([&](int, int, const exact::Vec& p) {
        return double{std::pow(mirrored_cosine<float>(scene, p), float(kNarrow))};
    });
}

constexpr int kCoarse = 8;  // pixels a side: 0.05 rad each, where the lobe is 0.001 rad wide

/// A shaded ball that fills a mirror, seen in it alone.
Scene ball_in_mirror(double lobe_exponent) {
    Scene scene;
    scene.ambient = {0, 0, 0};
    add(scene, lamp({1, 1.5, 1}));
    add(scene, ball({-2, 0, 2}, 1.75, chalk()));
    add(scene, ideal_mirror({0, 0, 0}, {0, 0, 1}, 4));
    scene.mirrors[0].lobe = Lobe::phong;  // blurs alone; max-Phong also darkens, by about n^-1/2
    scene.mirrors[0].lobe_exponent = lobe_exponent;
    scene.camera = camera_at({2, 0, 2}, {-1, 0, -1}, 0.4);
    return scene;
}

/// The largest difference from the sharp mirror's picture, in pixels of that picture's steepest slope.
template <class Shown>
double blur(const Picture& sharp, const Shown& shown) {
    double steepest = 0, largest = 0;
    for (int j = 0; j < kCoarse; ++j) {
        for (int i = 0; i < kCoarse; ++i) {
            if (i > 0) steepest = std::max(steepest, std::abs(double{sharp.at(i, j).g} - sharp.at(i - 1, j).g));
            const double difference = std::abs(double{shown(i, j)} - sharp.at(i, j).g);
            if (std::isnan(difference)) return difference;
            largest = std::max(largest, difference);
        }
    }
    return largest / steepest;
}

double s33_ours(const Stage& stage) {
    const Picture sharp = stage.render(ball_in_mirror(kInfinity), kCoarse, kCoarse);
    Settings settings;
    settings.samples = 512;
    double widest = 0;
    for (const double exponent : {kNarrow, 1e12, std::numeric_limits<double>::max()}) {
        if (stage.beyond_formats(ball_in_mirror(exponent), "lobe_exponent")) continue;
        const Picture picture = stage.render(ball_in_mirror(exponent), kCoarse, kCoarse, settings);
        widest = std::max(widest, blur(sharp, [&](int i, int j) { return picture.at(i, j).g; }));
    }
    return widest;
}

/// 512 directions spread over the hemisphere, each weighed by cos^n about the mirror direction.
double s33_naive() {
    const Picture sharp = Stage(Isa::scalar).render(ball_in_mirror(kInfinity), kCoarse, kCoarse);
    return blur(sharp, [&](int i, int j) {
        const exact::Ray ray = exact::through_pixel(ball_in_mirror(kInfinity).camera, kCoarse, kCoarse, i, j);
        constexpr int kDirections = 512;
        float sum = 0, weights = 0;
        for (int k = 0; k < kDirections; ++k) {
            const float z = (float(k) + 0.5f) / kDirections, r = std::sqrt(1 - z * z), turn = 2.3999632f * float(k);
            const float cosine =
                r * std::cos(turn) * float(ray.d.x) + r * std::sin(turn) * float(ray.d.y) - z * float(ray.d.z);
            const float weight = std::pow(std::fmax(cosine, 0.0f), float(kNarrow));
            weights += weight;
            sum += weight * sharp.at(i, j).g;
        }
        return sum / weights;
    });
}

constexpr StiffCase kRows[] = {
    {"S31", "highlight and lobe with n = 0", "cos^0 as exp(n log cos) is 0 * infinity where the cosine is 0",
     "the highlight is K_s wherever light arrives; the lobe is uniform over the hemisphere", "brightness", 1e-6,
     s31_ours, s31_naive},
    {"S32", "a highlight with n = 1e6", "pow(R.V, n) multiplies the rounding of R.V by n",
     "cos^n of the true angle between R and V", "relative", 1e-4, s32_ours, s32_naive},
    {"S33", "an unpolished mirror with n = 1e6, 1e12 and the largest double",
     "of 512 directions over the hemisphere none has any weight: 0 / 0",
     "it shows the sharp mirror's picture, blurred by 1e-3 pixels at most", "pixels", 1e-3, s33_ours, s33_naive,
     {.refused = "lobe_exponent"}},
};

}  // namespace

std::span<const StiffCase> lobe_rows() { return kRows; }

}  // namespace zerkalo::stability
