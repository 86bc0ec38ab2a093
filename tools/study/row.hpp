// One row of a study and its columns. The list of columns stands once, here: reader, writers and tables walk it.
//
// The first block is deterministic: the same bytes for any threads, instruction set and shards. The second one was
// measured.
#pragma once

#include "tools/study/error_figures.hpp"
#include "tools/study/statistics.hpp"

#include <string>

namespace zerkalo::study {

/// Errors of one region. The RMSE of rotation 0 is split by where it comes from.
struct RegionErrors {
    std::int64_t pixels = 0;
    ErrorFigures total;                                       // against the mean of the references
    double arithmetic = 0;                                    // against the same rays in double
    double quadrature = 0;                                    // these rays in double against the references
    double quantised8 = 0, quantised10 = 0, quantised16 = 0;  // the clipped picture against its sRGB codes
    MeanAndSpread over_rotations;                             // of the total RMSE
    double zone = 0;                                          // between the two references: less cannot be told apart
};

struct Row {
    std::string scene, lobe, number, estimator;
    double lobe_exponent = 0;
    double asked_error = 0;  // above 0: rendered until the picture's estimated error was that; then samples is 0
    std::int64_t samples = 0, antialias = 0, width = 0, height = 0, rotations = 0;
    RayCounts rays;
    std::array<RegionErrors, kRegionCount> regions;

    std::string isa;
    std::int64_t lanes = 0, threads = 0, repetitions = 0;
    Estimate seconds;

    const RegionErrors& of(Region region) const { return regions[static_cast<std::size_t>(region)]; }
    /// False when the references cannot tell this row's error (mean over the rotations, mirror region) from theirs.
    bool resolved() const { return of(Region::mirror).over_rotations.mean > of(Region::mirror).zone; }
    std::uint64_t all_rays() const { return total_of(rays); }
};

/// visit(name, field) for every deterministic column, in the order of the file. Fields are std::string, std::int64_t,
/// std::uint64_t or double. `RowType` is Row or const Row.
template <class RowType, class Visit>
void visit_exact(RowType& row, const Visit& visit) {
    visit("scene", row.scene), visit("lobe", row.lobe), visit("lobe_exponent", row.lobe_exponent);
    visit("number", row.number), visit("estimator", row.estimator);
    visit("samples", row.samples), visit("antialias", row.antialias), visit("asked_error", row.asked_error);
    visit("width", row.width), visit("height", row.height), visit("rotations", row.rotations);
    visit("rays_primary", row.rays.primary), visit("rays_reflected", row.rays.reflected);
    visit("rays_lobe", row.rays.lobe), visit("rays_refracted", row.rays.refracted);
    visit("rays_shadow", row.rays.shadow);
    for (int r = 0; r < kRegionCount; ++r) {
        auto& region = row.regions[static_cast<std::size_t>(r)];
        const auto of_region = [&](const char* name, auto& field) {
            visit(std::string(name) + "_" + kRegionNames[r], field);
        };
        of_region("pixels", region.pixels);
        of_region("rmse", region.total.rmse), of_region("max", region.total.max);
        of_region("p999", region.total.p999), of_region("psnr", region.total.psnr);
        of_region("arithmetic", region.arithmetic), of_region("quadrature", region.quadrature);
        of_region("quantised8", region.quantised8), of_region("quantised10", region.quantised10);
        of_region("quantised16", region.quantised16);
        of_region("rmse_mean", region.over_rotations.mean);
        of_region("rmse_deviation", region.over_rotations.deviation);
        of_region("zone", region.zone);
    }
}

/// The measured columns, and what they were measured with.
template <class RowType, class Visit>
void visit_measured(RowType& row, const Visit& visit) {
    visit("isa", row.isa), visit("lanes", row.lanes), visit("threads", row.threads);
    visit("repetitions", row.repetitions), visit("seconds", row.seconds.value);
    visit("seconds_low", row.seconds.low), visit("seconds_high", row.seconds.high);
}

/// What tells rows of one plan apart: scene, number, estimator, antialias, samples or the error asked for.
std::string key_of(const Row& row);

}  // namespace zerkalo::study
