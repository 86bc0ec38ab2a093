// Compiled once for each instruction set, with the flags of core/render/kernel.cpp. ZERKALO_STAGES: the function's
// name.
#include "tests/proofs/matrix/stages.hpp"

#include "core/render/general.hpp"

namespace zerkalo::matrix {
namespace {

using R = Real<ZERKALO_WIDTH>;

/// One value a lane, to its place in the images of the pixels that are there.
class Scatter {
public:
    Scatter(const Plan& plan, const Rect& tile, int first, StageImages& out) : out_(out) {
        for (int lane = 0; lane < kWidth<R>; ++lane) {
            const int x = (first + lane) % kTileSide, y = (first + lane) / kTileSide;
            const bool there = x < tile.width && y < tile.height;
            pixel_[lane] = there ? (tile.top + y) * plan.width + tile.left + x : -1;
        }
    }

    void put(Stage stage, std::initializer_list<R> values) {
        int place = 0;
        for (const R& value : values) {
            alignas(64) float lanes[kWidth<R>];
            store(lanes, value);
            for (int lane = 0; lane < kWidth<R>; ++lane) {
                if (pixel_[lane] < 0) continue;
                const auto at = static_cast<std::size_t>(pixel_[lane]) * kStageValues[stage];
                out_.values[stage][at + static_cast<std::size_t>(place)] = lanes[lane];
            }
            ++place;
        }
    }

private:
    StageImages& out_;
    std::int32_t pixel_[kWidth<R>];
};

Vec3<R> normal_of(const Plan& plan, const CameraRay<R>& ray, const AnyHit<R>& hit, Mask<R> active) {
    Vec3<R> n = spread<R>(Vec3<float>{0, 0, 0});
    for (std::int32_t k = 0; k < plan.solid_count; ++k) {
        const Mask<R> here = Mask<R>(active & (hit.id == R(plan.solids[k].id)));
        if (none(here)) continue;
        n = select(here, normal_towards<R>(plan, plan.solids[k], ray.o + ray.d * hit.t, hit.face, ray.d, here), n);
    }
    for (std::int32_t m = 0; m < plan.mirror_count; ++m) {
        const Mask<R> here = Mask<R>(active & (hit.id == R(float(kMaxSolids + m))));
        if (any(here)) n = select(here, mirror_normal(plan.mirrors[m].shape, hit.x, hit.y, hit.z), n);
    }
    return n;
}

}  // namespace

void ZERKALO_STAGES(const Plan& plan, StageImages& out) {
    const CandidateMask everything = first_bits(plan.solid_count) | first_bits(plan.mirror_count) << kMaxSolids;
    const bool close = (plan.features & kFeatureInside) != 0;
    for (int stage = 0; stage < kStageCount; ++stage) {
        out.values[stage].assign(static_cast<std::size_t>(plan.width * plan.height * kStageValues[stage]), 0);
    }
    for (int i = 0; i < tile_count(plan); ++i) {
        const Rect tile = tile_at(plan, i);
        const auto at = sub_pixel<Uniform<R>>(0, 1);
        TileColumns<R> columns;
        fill_columns(columns, plan, tile, at);
        for (int first = 0; first < tile.height * kTileSide; first += kWidth<R>) {
            const Mask<R> active = Mask<R>(lanes_of<R>(Tile(tile), first));
            const CameraRay<R> ray = camera_ray<R>(plan, columns, tile, first, at);
            const AnyHit<R> hit = nearest_anywhere<R>(
                plan, everything, false, ray.o, ray.d, departure_of_camera<R>(plan.camera, ray.d), active, ray.t_min, close);
            const Vec3<R> n = normal_of(plan, ray, hit, active);
            Scatter scatter(plan, tile, first, out);
            scatter.put(kCameraRay, {ray.o.x, ray.o.y, ray.o.z, ray.d.x, ray.d.y, ray.d.z, ray.t_min});
            scatter.put(kHit, {hit.t, hit.id, hit.face, select(hit.from_inside, R(1), R(0))});
            scatter.put(kNormal, {n.x, n.y, n.z});
        }
    }
}

}  // namespace zerkalo::matrix
