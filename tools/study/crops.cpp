#include "tools/study/crops.hpp"

#include "core/image/resolve.hpp"
#include "tools/study/journal.hpp"
#include "tools/zerkalo/picture_file.hpp"

#include <algorithm>

namespace zerkalo::study {
namespace {

constexpr std::int64_t kBenchmarkSamples = 16;
constexpr double kTimeRoom = 1.1;
constexpr int kCropShare = 4;     // of each side
constexpr int kCropPixels = 160;  // of an enlarged crop's width, about
constexpr std::size_t kGap = 4;

bool plain(const Row& row, const Row& benchmark) {
    return row.number == "float" && row.antialias == benchmark.antialias && row.asked_error == 0;
}

// The best row of each estimator, in the order of their first rows; `better(a, b)`: a rather than b.
template <class Fits, class Better>
std::vector<const Row*> best_rows(const std::vector<const Row*>& rows, const Fits& fits, const Better& better) {
    std::vector<const Row*> best;
    for (const Row* row : rows) {
        if (!fits(*row)) continue;
        const auto place = std::find_if(best.begin(), best.end(),
                                        [&](const Row* other) { return other->estimator == row->estimator; });
        if (place == best.end()) {
            best.push_back(row);
        } else if (better(*row, **place)) {
            *place = row;
        }
    }
    return best;
}

LightPicture picture_of_row(const StudyPlan& plan, const Row& row, const Renderer& renderer) {
    for (const Setting& setting : plan.rows) {
        if (key_of(plan, setting) != key_of(row)) continue;
        return rendered(renderer, *plan.scene_of(setting).scene, settings_of(setting, plan.wish.size, 0),
                        setting.number);
    }
    return {};
}

// Pixels of `mask` in the rectangle.
int count_in(const Mask& mask, const Rect& window, std::int32_t width) {
    int count = 0;
    for (std::int32_t y = window.top; y < window.top + window.height; ++y) {
        for (std::int32_t x = window.left; x < window.left + window.width; ++x) {
            count += mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
        }
    }
    return count;
}

}  // namespace

const Row* benchmark_row(const std::vector<const Row*>& rows) {
    const Row* best = nullptr;
    for (const Row* row : rows) {
        if (row->number != "float" || row->estimator != zerkalo::name_of(Estimator::fibonacci)) continue;
        if (row->asked_error > 0) continue;
        if (row->samples > kBenchmarkSamples || (best && row->antialias != best->antialias)) continue;
        if (!best || row->samples > best->samples) best = row;
    }
    return best;
}

std::vector<const Row*> equal_time_rows(const std::vector<const Row*>& rows, const Row& benchmark) {
    const auto fits = [&](const Row& row) {
        return plain(row, benchmark) && row.seconds.value <= kTimeRoom * benchmark.seconds.value;
    };
    return best_rows(rows, fits, [](const Row& a, const Row& b) { return a.samples > b.samples; });
}

std::vector<const Row*> equal_error_rows(const std::vector<const Row*>& rows, const Row& benchmark) {
    const auto fits = [&](const Row& row) {
        return plain(row, benchmark) && error_in(row, Region::mirror) <= error_in(benchmark, Region::mirror);
    };
    return best_rows(rows, fits, [](const Row& a, const Row& b) { return a.seconds.value < b.seconds.value; });
}

Rect crop_window(const Regions& regions, const ImageSize& size) {
    Rect window{0, 0, std::max(size.width / kCropShare, 1), std::max(size.height / kCropShare, 1)}, best = window;
    int most = -1;
    for (window.top = 0; window.top + window.height <= size.height; window.top += 4) {
        for (window.left = 0; window.left + window.width <= size.width; window.left += 4) {
            const int count = count_in(mask_of(regions, Region::edges), window, size.width);
            if (count <= most) continue;
            most = count;
            best = window;
        }
    }
    return best;
}

void write_crops(const std::string& path, const std::vector<LightPicture>& pictures, const Rect& window) {
    const std::size_t scale = static_cast<std::size_t>(std::max(kCropPixels / window.width, 1));
    const std::size_t tile_width = scale * static_cast<std::size_t>(window.width);
    const std::size_t width = pictures.size() * (tile_width + kGap) - kGap;
    const std::size_t height = scale * static_cast<std::size_t>(window.height);
    std::vector<float> linear(3 * width * height, 1.0f);
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        for (std::size_t y = 0; y < height; ++y) {
            for (std::size_t x = 0; x < tile_width; ++x) {
                const std::size_t row = static_cast<std::size_t>(window.top) + y / scale;
                const std::size_t column = static_cast<std::size_t>(window.left) + x / scale;
                const std::size_t from = 3 * (row * static_cast<std::size_t>(pictures[k].width) + column);
                const std::size_t to = 3 * (y * width + k * (tile_width + kGap) + x);
                for (std::size_t c = 0; c < 3; ++c) linear[to + c] = static_cast<float>(pictures[k].rgb[from + c]);
            }
        }
    }
    std::vector<std::uint8_t> codes(linear.size());
    resolve8(linear.data(), codes.data(), codes.size());
    WholeFile file;
    open_picture(file, path);
    write_codes(file, {codes.data(), static_cast<std::int32_t>(width), static_cast<std::int32_t>(height),
                       static_cast<std::ptrdiff_t>(3 * width)});
}

void draw_crops(const std::string& folder, const StudyPlan& plan, int scene, const std::vector<const Row*>& rows,
                const SceneFacts& facts, const Renderer& renderer) {
    const Row* benchmark = benchmark_row(rows);
    if (!benchmark) return;
    make_folder(folder + "/crops");
    const std::string name = folder + "/crops/" + plan.scenes[static_cast<std::size_t>(scene)].name;
    const Rect window = crop_window(facts.regions, plan.wish.size);
    const auto draw = [&](const std::vector<const Row*>& chosen, const char* ending) {
        std::vector<LightPicture> pictures{facts.references.mean};
        for (const Row* row : chosen) pictures.push_back(picture_of_row(plan, *row, renderer));
        write_crops(name + ending, pictures, window);
    };
    draw(equal_time_rows(rows, *benchmark), "-equal-time.png");
    draw(equal_error_rows(rows, *benchmark), "-equal-error.png");
}

}  // namespace zerkalo::study
