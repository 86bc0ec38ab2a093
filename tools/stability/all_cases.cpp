// See stiff_case.hpp.
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <cstring>

namespace zerkalo::stability {

Verdict judge(const StiffCase& row, Isa isa, Number number) {
    const Stage stage(isa, number);
    Verdict verdict{};
    try {
        verdict.error = row.ours(stage);
        verdict.refused = stage.refused();
    } catch (const Refused& refused) {
        if (number == Number::floating) throw;
        verdict.refused = refused.field;
    }
    const InFixed terms = number == Number::fixed ? row.in_fixed : InFixed{};
    const bool within = terms.every_scene ? !verdict.error : verdict.error && *verdict.error <= bound_of(row, number);
    verdict.holds = within && verdict.refused == terms.refused;
    return verdict;
}

std::vector<StiffCase> all_cases() {
    std::vector<StiffCase> cases;
    const std::span<const StiffCase> groups[] = {
        aimed_ray_rows(),
        bad_number_rows(),
        bounce_rows(),
        camera_frame_rows(),
        camera_place_rows(),
        contact_rows(),
        edge_rows(),
        far_camera_rows(),
        format_rows(),
        glass_rows(),
        hemisphere_rows(),
        lamp_rows(),
        light_rows(),
        lobe_rows(),
        machine_rows(),
        mirror_curvature_rows(),
        parallel_ray_rows(),
        picture_rows(),
        polish_rows(),
        refusal_rows(),
        scaling_rows(),
        solid_size_rows(),
        sphere_rows(),
        sun_rows(),
        symmetry_rows(),
        taper_rows(),
    };
    for (const auto& rows : groups) cases.insert(cases.end(), rows.begin(), rows.end());
    std::sort(cases.begin(), cases.end(),
              [](const StiffCase& a, const StiffCase& b) { return std::strcmp(a.id, b.id) < 0; });
    return cases;
}

}  // namespace zerkalo::stability
