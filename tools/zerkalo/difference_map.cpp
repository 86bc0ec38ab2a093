#include "tools/zerkalo/difference_map.hpp"

#include <algorithm>

namespace zerkalo {
namespace {

const std::array<std::uint8_t, 3>& color_of(int steps) {
    return std::find_if(std::begin(kMapScale), std::end(kMapScale),
                        [steps](const MapClass& entry) { return steps <= entry.up_to; })
        ->color;
}

}  // namespace

std::string map_legend() {
    std::string legend;
    int before = -1;
    for (const MapClass& entry : kMapScale) {
        if (!legend.empty()) legend += ", ";
        legend += std::string(entry.name) + (entry.up_to == before + 1 ? " " : " to ") + std::to_string(entry.up_to);
        before = entry.up_to;
    }
    return legend;
}

std::vector<std::uint8_t> difference_map(const Picture& a, const Picture& b, const std::vector<bool>& mask) {
    std::vector<std::uint8_t> codes(a.codes.size());
    for (std::size_t pixel = 0; pixel < codes.size() / 3; ++pixel) {
        const bool counts = mask.empty() || mask[pixel];
        const auto& color = counts ? color_of(steps_apart(a, b, pixel)) : kMapMasked;
        std::copy(color.begin(), color.end(), codes.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
    }
    return codes;
}

}  // namespace zerkalo
