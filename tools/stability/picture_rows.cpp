// Pictures of every size, from one pixel to 2^28.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <bit>
#include <numbers>
#include <optional>

namespace zerkalo::stability {
namespace {

// S55. Small pictures as cut-outs of a larger one with the same rays.

struct Size {
    int width, height;
};
constexpr Size kSmall[] = {{1, 1}, {1, 40}, {40, 1}, {7, 5}, {33, 17}, {8, 8}};
constexpr int kMargin = 12;           // pixels that the larger picture has more, on each side
constexpr double kPixel = 0x1p-6;     // tangent of a pixel's angle of view
constexpr std::ptrdiff_t kPadding = 5;  // floats behind each row, and a row before and behind the picture
constexpr std::uint32_t kGuard = 0x7fbadbad;  // a NaN that nobody computes

double fov_of(int width) { return 2 * std::atan(kPixel * width / 2); }

/// Judges draw(size) -> the picture of that size, or nothing where memory around it was touched: pixels that are not
/// those of the larger picture.
template <class Draw>
double pixels_unlike_the_larger(const Draw& draw, double tolerance = 0) {
    double wrong = 0;
    for (const Size size : kSmall) {
        const std::optional<Picture> small = draw(size);
        const std::optional<Picture> large = draw({size.width + 2 * kMargin, size.height + 2 * kMargin});
        if (!small || !large) return kInfinity;
        Picture cut{size.width, size.height, {}};
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const Rgb<float> c = large->at(x + kMargin, y + kMargin);
                cut.rgb.insert(cut.rgb.end(), {c.r, c.g, c.b});
            }
        }
        wrong += pixels_apart(cut, *small, tolerance);
    }
    return wrong;
}

Scene ball_and_mirror(double curvature_radius) {
    Scene scene;
    scene.background = {0.1, 0.2, 0.3};
    add(scene, ball({0.1, 0.05, 0}, 0.4, Material{}));
    add(scene, lamp({2, 3, 4}));
    Mirror mirror = ideal_mirror({0, 0, -1}, {0, 0.25, 1}, 2);
    mirror.diffuse = 0.5;
    mirror.curvature_radius = curvature_radius;
    add(scene, mirror);
    return scene;
}

std::optional<Picture> drawn_between_guards(const Stage& stage, const Scene& scene, Size size) {
    const Prepared frame = stage.prepared(scene, size.width, size.height);
    const std::ptrdiff_t row = 3 * size.width + kPadding;
    std::vector<float> memory(static_cast<std::size_t>(row * (size.height + 2)), std::bit_cast<float>(kGuard));
    const LinearImage image{memory.data() + row, size.width, size.height, 4 * row};
    for (int i = 0; i < frame.tiles(); ++i) frame.draw(frame.tile(i), image);
    Picture picture{size.width, size.height, {}};
    for (std::ptrdiff_t i = 0; i < std::ssize(memory); ++i) {
        const std::ptrdiff_t y = i / row - 1;
        const bool own = y >= 0 && y < size.height && i % row < 3 * size.width;
        const float value = memory[static_cast<std::size_t>(i)];
        if (own == (std::bit_cast<std::uint32_t>(value) == kGuard)) return std::nullopt;
        if (own) picture.rgb.push_back(value);
    }
    return picture;
}

double s55_ours(const Stage& stage) {
    double wrong = 0;
    // In fixed point the rays of a wide picture are scaled down before they are normalised: other roundings.
    const double tolerance = stage.fixed() ? 8 * 0x1p-24 : 0;
    for (const double curvature_radius : {kInfinity, 5.0}) {  // the sharp kernel and the general one
        const auto draw = [&](Size size) {
            Scene scene = ball_and_mirror(curvature_radius);
            scene.camera = camera_at({0, 0, 3}, {0, 0, -1}, fov_of(size.width));
            return drawn_between_guards(stage, scene, size);
        };
        wrong += pixels_unlike_the_larger(draw, tolerance);
    }
    return wrong;
}

/// The share of the picture's width as i / (width - 1), with neither half a pixel nor a thought for one column.
double s55_naive() {
    return pixels_unlike_the_larger([](Size size) -> std::optional<Picture> {
        Picture picture{size.width, size.height, {}};
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                const float u = float(i) / float(size.width - 1), v = float(j) / float(size.height - 1);
                const float x = float(kPixel) * float(size.width) * (u - 0.5f);
                const float y = float(kPixel) * float(size.height) * (0.5f - v);
                const auto roots = naive::sphere({0, 0, 3}, naive::unit({x, y, -1}), {0.1f, 0.05f, 0}, 0.4f);
                const float t = roots.real ? roots.first : 0;
                picture.rgb.insert(picture.rgb.end(), {t, t, t});
            }
        }
        return picture;
    });
}

// S56. A chalk wall at distance 1, the lamp at the eye: each pixel's shade is the cosine of its angle.

constexpr Size kHuge[] = {{65536, 1}, {8192, 8192}, {65536, 4096}};
constexpr int kStrip = 8;  // rows at the lower edge that are looked at
constexpr int kEnd = 256;  // pixels at either end of them

/// Memory of a whole picture, of which only what is touched exists.
class HugePicture {
public:
    explicit HugePicture(Size size)
        : bytes_(std::size_t{12} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {
        constexpr int kNoFile = -1;
        void* const memory =
            mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, kNoFile, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        pixels_ = static_cast<float*>(memory);
    }
    ~HugePicture() { munmap(pixels_, bytes_); }
    HugePicture(const HugePicture&) = delete;
    HugePicture& operator=(const HugePicture&) = delete;

    float* pixels() { return pixels_; }
    std::size_t bytes() const { return bytes_; }

private:
    std::size_t bytes_;
    float* pixels_;
};

/// Pixels at both ends of the lower rows whose shade is not the closed form. fill(size, picture) draws them.
template <class Fill>
double misplaced_pixels(const Fill& fill) {
    int wrong = 0;
    for (const Size size : kHuge) {
        HugePicture picture(size);
        fill(size, picture);
        for (int y = std::max(0, size.height - kStrip); y < size.height; ++y) {
            for (int k = 0; k < 2 * kEnd; ++k) {
                const int x = k < kEnd ? k : size.width - 2 * kEnd + k;
                const double across = (2 * (x + 0.5) - size.width) / size.width;
                const double upwards = (size.height - 2 * (y + 0.5)) / size.width;
                const double cosine = 1 / std::sqrt(1 + across * across + upwards * upwards);
                const std::size_t place = std::size_t(y) * std::size_t(size.width) + std::size_t(x);
                wrong += !(std::abs(double{picture.pixels()[3 * place]} - cosine) < 1e-6);
            }
        }
    }
    return wrong;
}

double s56_ours(const Stage& stage) {
    return misplaced_pixels([&](Size size, HugePicture& picture) {
        Scene scene;
        scene.camera = camera_at({0, 0, 1}, {0, 0, -1}, std::numbers::pi / 2);
        add(scene, lamp({0, 0, 1}));
        Mirror wall = ideal_mirror({0, 0, 0}, {0, 0, 1}, 4);
        wall.reflection = 0;
        wall.diffuse = 1;
        add(scene, wall);
        const Prepared frame = stage.prepared(scene, size.width, size.height);
        const LinearImage image{picture.pixels(), size.width, size.height, std::ptrdiff_t{12} * size.width};
        for (int i = 0; i < frame.tiles(); ++i) {
            const Rect tile = frame.tile(i);
            const bool looked_at = tile.top + tile.height > size.height - kStrip &&
                                   (tile.left < kEnd || tile.left + tile.width > size.width - kEnd);
            if (looked_at) frame.draw(tile, image);
        }
    });
}

/// The same shades, put where an int says: (y width + x) 12 bytes, modulo 2^32.
double s56_naive() {
    return misplaced_pixels([](Size size, HugePicture& picture) {
        for (int y = std::max(0, size.height - kStrip); y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const float across = (2 * (float(x) + 0.5f) - float(size.width)) / float(size.width);
                const float upwards = (float(size.height) - 2 * (float(y) + 0.5f)) / float(size.width);
                const auto place = std::uint32_t(y) * std::uint32_t(size.width) + std::uint32_t(x);
                const auto offset = std::int32_t(place * 12);
                if (offset < 0 || std::size_t(offset) >= picture.bytes()) continue;  // outside: a crash, or worse
                picture.pixels()[offset / 4] = 1 / std::sqrt(1 + across * across + upwards * upwards);
            }
        }
    });
}

constexpr StiffCase kRows[] = {
    {"S55", "pictures of 1x1, 1x40, 40x1, 7x5, 33x17 pixels", "i / (width - 1) is 0/0, and no cut-out agrees",
     "a cut-out of a larger picture, to the last bit, and no byte around it touched", "pixels apart", 0,
     s55_ours, s55_naive},
    {"S56", "pictures of 65536x1, 8192x8192, 65536x4096 pixels", "the byte's place overflows an int: pixels elsewhere",
     "the last rows show the shade of their place", "wrong pixels", 0, s56_ours, s56_naive},
};

}  // namespace

std::span<const StiffCase> picture_rows() { return kRows; }

}  // namespace zerkalo::stability
