#include "core/image/resolve.hpp"

#include "core/numeric/setup.hpp"

#include <bit>

namespace zerkalo {
namespace {

constexpr double fifth_root(double a) {
    // Newton from above falls monotonically; 80 steps reach the last bit for every a in (0, 1].
    double r = 1;
    for (int k = 0; k < 80; ++k) r -= (r - a / (r * r * r * r)) / 5;
    return r;
}

/// The sRGB curve backwards: stored 0..1 -> linear 0..1.
constexpr double linear_of(double stored) {
    if (stored <= 0.04045) return stored / 12.92;
    const double y = (stored + 0.055) / 1.055;
    return y * y * fifth_root(y * y);  // y^2.4
}

// Buckets of equal leading float bits: 128 in each octave from 2^-13 to 1. A bucket holds at most one code boundary.
constexpr std::uint32_t kFirstBucket = 0x39000000u >> 16;  // 2^-13
constexpr std::uint32_t kLastBucket = 0x3f800000u >> 16;   // 1
constexpr int kBuckets = static_cast<int>(kLastBucket - kFirstBucket) + 1;

struct Table8 {
    double from[257];             // the least linear value that is stored as code k
    std::uint8_t code[kBuckets];  // of a bucket's lowest value
};

constexpr Table8 make_table() {
    Table8 table{};
    for (int k = 1; k < 256; ++k) table.from[k] = linear_of((k - 0.5) / 255);
    table.from[256] = 2;
    int code = 0;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        const std::uint32_t bits = (kFirstBucket + static_cast<std::uint32_t>(bucket)) << 16;
        const double x = std::bit_cast<float>(bits);
        while (x >= table.from[code + 1]) ++code;
        table.code[bucket] = static_cast<std::uint8_t>(code);
    }
    return table;
}

constexpr Table8 kTable = make_table();

double cube_root(double a) {
    // A third of the exponent is a guess to 6 %; each Halley step triples the digits.
    double r = std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) / 3 + 0x2a9f7893782da1ceu);
    for (int k = 0; k < 3; ++k) {
        const double cube = r * r * r;
        r *= (cube + 2 * a) / (2 * cube + a);
    }
    return r;
}

/// The sRGB curve forwards for x in [0, 1].
double stored_of(double x) {
    if (x <= 0.0031308) return 12.92 * x;
    const double s = square_root(square_root(x));
    return 1.055 * s * cube_root(s * s) - 0.055;  // x^(1/2.4) = s^(5/3)
}

}  // namespace

void resolve8(const float* linear, std::uint8_t* codes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        float x = linear[i];
        x = x > 0 ? x : 0;  // also NaN
        x = x < 1 ? x : 1;
        const std::uint32_t bucket = std::bit_cast<std::uint32_t>(x) >> 16;
        const std::uint8_t low = bucket >= kFirstBucket ? kTable.code[bucket - kFirstBucket] : std::uint8_t{0};
        codes[i] = static_cast<std::uint8_t>(low + (double(x) >= kTable.from[low + 1]));
    }
}

void resolve16(const float* linear, std::uint16_t* codes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        double x = linear[i];
        x = x > 0 ? x : 0;
        x = x < 1 ? x : 1;
        codes[i] = static_cast<std::uint16_t>(65535 * stored_of(x) + 0.5);
    }
}

}  // namespace zerkalo
