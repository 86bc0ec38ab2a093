// See stiff_case.hpp.
#include "tools/stability/stiff_case.hpp"

#include <algorithm>
#include <cstring>

namespace zerkalo::stability {

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
