// A piece of the picture by every estimator side by side: at equal time, and at equal error.
#pragma once

#include "tools/study/plan.hpp"
#include "tools/study/row_runner.hpp"
#include "tools/study/series.hpp"

namespace zerkalo::study {

/// What the others are compared with: the lattice in float with the most samples up to 16. nullptr without such a row.
const Row* benchmark_row(const std::vector<const Row*>& rows);

/// In float, of every estimator, the row with the most samples that takes at most a tenth longer than `benchmark`.
std::vector<const Row*> equal_time_rows(const std::vector<const Row*>& rows, const Row& benchmark);

/// In float, of every estimator, the cheapest row whose error is at most that of `benchmark`.
std::vector<const Row*> equal_error_rows(const std::vector<const Row*>& rows, const Row& benchmark);

/// A sixteenth of the picture, where most pixels of the region `edges` are.
Rect crop_window(const Regions& regions, const ImageSize& size);

/// Writes a PNG: the window of every picture, from left to right, enlarged, with white between them. Throws
/// Failure(io_failed).
void write_crops(const std::string& path, const std::vector<LightPicture>& pictures, const Rect& window);

/// Writes FOLDER/crops/SCENE-equal-time.png and SCENE-equal-error.png: the reference, then the rows of
/// equal_time_rows() or equal_error_rows(). Nothing without benchmark_row(). Throws as rendered() does.
void draw_crops(const std::string& folder, const StudyPlan& plan, int scene, const std::vector<const Row*>& rows,
                const SceneFacts& facts, const Renderer& renderer);

}  // namespace zerkalo::study
