// What the machine does in its own way: the order of tiles, the number of threads, the mode of the float unit.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include "core/image/hash.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <thread>

namespace zerkalo::stability {
namespace {

// S53. A scene in normal sizes with subnormal coordinates, the same scene 2^-70 and 2^-130 as large, a lamp of 1e-38;
// with the float unit as it is, and with subnormals flushed to zero.

/// Switches flushing on for its life.
class Flushing {
public:
    Flushing() : before_(mode()) { set(before_ | kFlush); }
    ~Flushing() { set(before_); }
    Flushing(const Flushing&) = delete;
    Flushing& operator=(const Flushing&) = delete;

private:
#if defined(__x86_64__)
    using Mode = unsigned;
    static constexpr Mode kFlush = 0x8040;  // MXCSR: results and operands
    static Mode mode() { return __builtin_ia32_stmxcsr(); }
    static void set(Mode mode) { __builtin_ia32_ldmxcsr(mode); }
#elif defined(__aarch64__)
    using Mode = std::uint64_t;
    static constexpr Mode kFlush = Mode{1} << 24;  // FPCR.FZ
    static Mode mode() {
        Mode now;
        asm volatile("mrs %0, fpcr" : "=r"(now));
        return now;
    }
    static void set(Mode mode) { asm volatile("msr fpcr, %0" : : "r"(mode) : "memory"); }
#else
#error "no switch for subnormals is known here"
#endif
    Mode before_;
};

struct Tiny {
    double size;        // of everything
    double coordinate;  // where a scene of size 1 has a zero
    double intensity;
};
constexpr Tiny kTiny[] = {{1, 1e-40, 1}, {1, 1e-310, 1}, {0x1p-70, 0, 1}, {0x1p-130, 0, 1}, {1, 0, 1e-38}};
constexpr int kSide = 32;           // pixels a side
constexpr double kHalfView = 0.35;  // tangent of half the angle of view

/// Values of the pictures that flushing changes. draw(case) -> picture.
template <class Draw>
double changed_values(const Draw& draw) {
    double changed = 0;
    for (const Tiny& tiny : kTiny) {
        const Picture plain = draw(tiny);
        const Flushing flushing;
        changed += pixels_apart(plain, draw(tiny));
    }
    return changed;
}

double s53_ours(const Stage& stage) {
    return changed_values([&](const Tiny& tiny) {
        const double s = tiny.size, o = tiny.coordinate;
        Scene scene;
        scene.ambient = {tiny.intensity, tiny.intensity, tiny.intensity};
        scene.camera = camera_at({o, o, 4 * s}, {o, 0, -1}, 2 * std::atan(kHalfView));
        add(scene, ball({o, o, o}, s, Material{}));
        add(scene, upright(SolidKind::cone, {s, -s, o}, s / 2, s, Material{}));
        add(scene, ideal_mirror({0, o, -2 * s}, {o, o, 1}, 4 * s));
        add(scene, lamp({2 * s, 3 * s, 4 * s}));
        scene.lights[0].intensity = tiny.intensity;
        return stage.render(scene, kSide, kSide);
    });
}

/// Lambert's light of a ball, by the textbook's quadratic.
[[gnu::noinline]] float lambert(const float* size, const float* intensity, float x, float y) {
    const Vec3<float> eye{0, 0, 4 * *size}, lamp_at{2 * *size, 3 * *size, 4 * *size};
    const Vec3<float> d = naive::unit({x, y, -1});
    const auto roots = naive::sphere(eye, d, {0, 0, 0}, *size);
    if (!roots.real) return 0;
    const Vec3<float> p = naive::along(eye, roots.first, d);
    const Vec3<float> n = naive::times(p, 1 / *size), l = naive::unit(naive::minus(lamp_at, p));
    return *intensity * std::max(0.0f, naive::dot(n, l));
}

double s53_naive() {
    return changed_values([](const Tiny& tiny) {
        const float size = float(tiny.size), intensity = float(tiny.intensity);
        Picture picture{kSide, kSide, {}};
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const float x = float(kHalfView * (2 * (i + 0.5) / kSide - 1));
                const float y = float(kHalfView * (1 - 2 * (j + 0.5) / kSide));
                picture.rgb.insert(picture.rgb.end(), 3, lambert(&size, &intensity, x, y));
            }
        }
        return picture;
    });
}

// S57. Tiles of a picture with lobes, in any order, by 1 to 64 threads that take them from one counter.

constexpr int kWidth = 60, kHeight = 44;  // whole tiles, and parts of tiles at two edges
constexpr int kThreads[] = {1, 2, 3, 7, 64};

/// Judges draw(order, threads) -> the picture's hash: how many of the ways differ from row after row by one thread.
template <class Draw>
double other_pictures(int tiles, const Draw& draw) {
    std::vector<int> forwards(static_cast<std::size_t>(tiles));
    std::iota(forwards.begin(), forwards.end(), 0);
    const std::uint64_t expected = draw(forwards, 1);
    std::mt19937 random(57);
    int other = 0;
    for (const int threads : kThreads) {
        std::vector<int> order = forwards;
        other += draw(order, threads) != expected;
        std::reverse(order.begin(), order.end());
        other += draw(order, threads) != expected;
        std::shuffle(order.begin(), order.end(), random);
        other += draw(order, threads) != expected;
    }
    return other;
}

/// Each thread takes the next tile until there is none.
template <class Render>
void on_threads(const std::vector<int>& order, int threads, const Render& render) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t k = next++; k < order.size(); k = next++) render(order[k]);
    };
    std::vector<std::thread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
}

double s57_ours(const Stage& stage) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    scene.camera = camera_at({0, 0, 4}, {0, 0, -1}, 0.9);
    add(scene, ball({0.2, 0.1, 0}, 0.6, Material{}));
    add(scene, upright(SolidKind::prism, {-0.9, -0.8, 0.5}, 0.4, 0.9, Material{}));
    add(scene, lamp({2, 3, 4}));
    for (const double curvature_radius : {kInfinity, 9.0}) {  // two mirrors: the second one's lobe rays are random
        Mirror mirror = ideal_mirror({0, 0, -2}, {0, 0, 1}, 6);
        mirror.curvature_radius = curvature_radius;
        mirror.lobe_exponent = 30;
        if (curvature_radius < kInfinity) mirror.position = {0, 0, 6}, mirror.normal = {0, 0, -1};
        add(scene, mirror);
    }
    Settings settings;
    settings.samples = 4;
    const Prepared frame = stage.prepared(scene, kWidth, kHeight, settings);
    return other_pictures(frame.tiles(), [&](const std::vector<int>& order, int threads) {
        std::vector<float> pixels(std::size_t{3} * kWidth * kHeight);
        const LinearImage image{pixels.data(), kWidth, kHeight, std::ptrdiff_t{12} * kWidth};
        on_threads(order, threads, [&](int tile) { frame.draw(frame.tile(tile), image); });
        return hash_of(image);
    });
}

/// Lobe rays from the one random generator that all tiles share, here by a single thread.
double s57_naive() {
    constexpr int kTiles = 48, kPixels = 64, kSamples = 4;
    return other_pictures(kTiles, [](const std::vector<int>& order, int) {
        std::vector<float> pixels(std::size_t{3} * kTiles * kPixels);
        std::minstd_rand shared(1);
        for (const int tile : order) {
            for (int k = 0; k < kPixels; ++k) {
                float sum = 0;
                for (int s = 0; s < kSamples; ++s) sum += float(shared()) / float(shared.max()) / kSamples;
                pixels[3 * static_cast<std::size_t>(tile * kPixels + k)] = sum;
            }
        }
        return hash_of({pixels.data(), kPixels, kTiles, std::ptrdiff_t{12} * kPixels});
    });
}

constexpr StiffCase kRows[] = {
    {"S53", "subnormal coordinates, sizes and lamps, flushed or not", "two modes of the float unit, two pictures",
     "the same picture to the last bit", "pixels apart", 0, s53_ours, s53_naive},
    {"S57", "tiles forwards, backwards, shuffled, by 1 to 64 threads", "a random generator that all tiles share",
     "one hash", "other hashes", 0, s57_ours, s57_naive},
};

}  // namespace

std::span<const StiffCase> machine_rows() { return kRows; }

}  // namespace zerkalo::stability
