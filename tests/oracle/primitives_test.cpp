// Every primitive against its closed form in long double, a million random rays each (ZERKALO_ORACLE_RAYS of them in
// tools/long_checks.sh): error of t, growth with the incidence, hits and misses, and the same bits at every width.
#include "tests/oracle/primitives.hpp"
#include "tests/oracle/ray_count.hpp"

#include "tests/core/support/widths.hpp"

#include <iostream>

namespace zerkalo::test {
namespace {

constexpr std::size_t kBatch = 4096;

// Ulps of t, times the cosine of incidence, of a ray from anywhere.
constexpr Real80 kUlps = 8;
// Roundings of the way: no ray is misjudged that passes a surface by more, and none that meets it as deeply.
constexpr Real80 kBand = 6;

/// The bits of all hits, in order.
class BitsOfHits {
public:
    void add(const Answers& answers) {
        for (std::size_t k = 0; k < answers.size(); ++k) {
            const bool hit = answers.entry[k] <= answers.exit[k];
            // Beyond a miss nothing is promised.
            add_word(hit ? bits_of_float(answers.entry[k]) : 0);
            add_word(hit ? bits_of_float(answers.exit[k]) : 1);
        }
    }
    std::uint64_t hash() const { return hash_; }

private:
    // Source: Fowler, Noll, Vo, FNV-1a, by words.
    void add_word(std::uint32_t word) { hash_ = (hash_ ^ word) * 0x100000001b3u; }
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

std::vector<Width> widths_of_this_cpu() {
    std::vector<Width> usable;
    for (const Width& width : all_widths()) {
        if (available(width.isa)) usable.push_back(width);
    }
    return usable;
}

/// The same rays asked of all widths; the first one, one lane, is judged.
class PrimitiveOracle : public testing::TestWithParam<Primitive> {
protected:
    void run(std::uint64_t rays_wanted) {
        widths_ = widths_of_this_cpu();
        hashes_.resize(widths_.size());
        Random random(81);
        RayList rays;
        while (near_.rays + far_.rays < rays_wanted) {
            const Instance instance = GetParam().next(random);
            fill_rays(rays, instance, kBatch, random);
            for (std::size_t w = 0; w < widths_.size(); ++w) {
                const Answers answers = instance.ask(widths_[w].probes->shapes, rays);
                hashes_[w].add(answers);
                if (w == 0) judge(instance, rays, answers);
            }
        }
    }

    std::vector<Width> widths_;
    std::vector<BitsOfHits> hashes_;
    Tally near_, far_;

private:
    void judge(const Instance& instance, const RayList& rays, const Answers& answers) {
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const Real80 way = length(rays.o[k] - instance.centre) + instance.size;
            instance.judge(is_recentred(k) ? near_ : far_, rays, answers, k, kU * way);
        }
    }
};

void print(const char* name, const char* kind, const Tally& tally) {
    char line[256];
    std::snprintf(line, sizeof line,
                  "| %s, %s | %llu | %.2f / cos | %.2f | %.2f | %.2f | %.2f |", name, kind,
                  static_cast<unsigned long long>(tally.rays), double(tally.error.value), double(tally.head_on.value),
                  double(tally.steep.value), double(tally.tangent.value), double(tally.band.value));
    std::cout << line << std::endl;
}

void expect_bounds(const Tally& tally, Real80 error, Real80 shift) {
    const auto expect_below = [](const Worst& worst, Real80 bound, const char* what) {
        EXPECT_LE(double(worst.value), double(bound)) << what << ": " << worst.ray;
    };
    expect_below(tally.error, error, "ulps of t times the cosine of incidence");
    expect_below(tally.tangent, shift, "roundings of a tangent ray");
    expect_below(tally.band, shift, "roundings between a hit and a miss");
    // Otherwise the rays would say little.
    EXPECT_GT(tally.hits, tally.rays / 32);
    EXPECT_GT(tally.rays - tally.hits, tally.rays / 32);
    EXPECT_GT(tally.grazing_ends, tally.rays / 4000);
    EXPECT_LT(tally.unjudged, tally.rays / 20);
}

// Whatever the incidence: a float discriminant is off by the square of the size times a rounding, and its root, which
// is the cosine of incidence times the size, turns that into 1 / cosine.
TEST_P(PrimitiveOracle, ErrorIsAFewUlpsOverTheCosineAtEveryWidth) {
    run(count_from("ZERKALO_ORACLE_RAYS"));
    print(GetParam().name, "recentred", near_);
    print(GetParam().name, "from afar", far_);
    expect_bounds(near_, GetParam().recentred_ulps, kBand);
    expect_bounds(far_, kUlps, kBand);
    for (std::size_t w = 1; w < widths_.size(); ++w) {
        EXPECT_EQ(hashes_[w].hash(), hashes_[0].hash()) << text(widths_[w]);
    }
}

INSTANTIATE_TEST_SUITE_P(Every, PrimitiveOracle, testing::ValuesIn(primitives()),
                         [](const testing::TestParamInfo<Primitive>& info) { return info.param.name; });

}  // namespace
}  // namespace zerkalo::test
