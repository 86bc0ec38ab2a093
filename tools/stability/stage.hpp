// Where the stiff cases are played: scenes through the public renderer, as pictures or rays, by one instruction set and
// one number system.
#pragma once

#include "core/render/render.hpp"
#include "tools/number.hpp"
#include "tools/staging.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace zerkalo::stability {

using namespace staging;

/// A case met a scene that prepare() refuses: a fault of the case, or one that fixed point cannot hold.
struct Refused : std::runtime_error {
    explicit Refused(const Status& status);

    std::string field;
};

/// Linear RGB, row-major without padding.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    Rgb<float> at(int x, int y) const;
    bool finite() const;
};

/// A scene in the numbers of a stage, to be drawn tile by tile.
class Prepared {
public:
    /// Throws Refused when prepare() refuses.
    Prepared(const Scene& scene, const Settings& settings, Isa isa, Number number);

    int tiles() const { return tile_count(head()); }
    Rect tile(int index) const { return tile_at(head(), index); }
    void draw(const Rect& tile, const LinearImage& image) const;

    /// f(plan), with the plan of either number system.
    template <class F>
    auto with_plan(const F& f) const {
        return plan_ ? f(*plan_) : f(*fixed_plan_);
    }

private:
    const PlanHead& head() const;

    std::unique_ptr<Plan> plan_;  // one of the two
    std::unique_ptr<FixedPlan> fixed_plan_;
    Isa isa_;
};

class Stage {
public:
    explicit Stage(Isa isa, Number number = Number::floating) : isa_(isa), number_(number) {}

    Isa isa() const { return isa_; }
    bool fixed() const { return number_ == Number::fixed; }

    /// Throws Refused when prepare() refuses.
    Prepared prepared(const Scene& scene, int width, int height, Settings settings = {}) const;

    /// The picture of a scene. Throws Refused when prepare() refuses, with its reason.
    Picture render(const Scene& scene, int width, int height, const Settings& settings = {}) const;

    /// What arrives at `origin` from the direction `view` of any length. Throws Refused as render() does.
    Rgb<float> look(Scene scene, const Vec3<double>& origin, const Vec3<double>& view,
                    const Settings& settings = {}) const;

    /// The field that prepare() names when it refuses the scene; empty when it accepts it.
    std::string refused_field(const Scene& scene) const;

    /// Whether the formats of fixed point cannot hold this scene: prepare() refuses it and names the field. Noted:
    /// see refused(). False of every scene in float.
    bool beyond_formats(const Scene& scene, const char* field) const;
    /// The field of the last scene beyond the formats; empty when there was none.
    const std::string& refused() const { return refused_; }

private:
    Isa isa_;
    Number number_;
    mutable std::string refused_;
};

/// Every instruction set that this program has and this CPU can run, of those that share a kernel the first.
std::vector<Isa> stages(Number number = Number::floating);

/// Pixels of which a channel differs by more than `tolerance`; every pixel for pictures of different sizes.
int pixels_apart(const Picture& a, const Picture& b, double tolerance = 0);

/// The largest difference of a channel; infinite where one holds a NaN or the sizes differ.
double largest_difference(const Picture& a, const Picture& b);

}  // namespace zerkalo::stability
