// Where the stiff cases are played: scenes through the public renderer on one instruction set, as pictures or rays.
#pragma once

#include "core/render/render.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace zerkalo::stability {

/// A case met a scene that prepare() refuses: a fault of the case.
struct Refused : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Linear RGB, row-major without padding.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    Rgb<float> at(int x, int y) const;
    bool finite() const;
};

class Stage {
public:
    explicit Stage(Isa isa) : isa_(isa) {}

    Isa isa() const { return isa_; }

    /// The picture of a scene. Throws Refused when prepare() refuses, with its reason.
    Picture render(const Scene& scene, int width, int height, Settings settings = {}) const;

    /// What arrives at `origin` from the direction `view` of any length.
    Rgb<float> look(Scene scene, const Vec3<double>& origin, const Vec3<double>& view, const Settings& settings = {}) const;

private:
    Isa isa_;
};

/// Every instruction set that this program has and this CPU can run.
std::vector<Isa> stages();

/// The field that prepare() names when it refuses the scene; empty when it accepts it.
std::string refused_field(const Scene& scene, const Settings& settings = {});

/// Pixels of which a channel differs by more than `tolerance`; every pixel for pictures of different sizes.
int pixels_apart(const Picture& a, const Picture& b, double tolerance = 0);

/// The largest difference of a channel; infinite where one holds a NaN or the sizes differ.
double largest_difference(const Picture& a, const Picture& b);

/// A surface that shows its colour whatever the light: C = color, K_a = 1, all else 0.
Material glowing(const Rgb<double>& color);

/// A surface of which only the matte share is left: K_d = 1, white.
Material chalk();

Solid ball(const Vec3<double>& centre, double radius, const Material& material);

/// A pyramid, prism, cylinder or cone on its base.
Solid upright(SolidKind kind, const Vec3<double>& base, double radius, double height, const Material& material);

Light lamp(const Vec3<double>& position);

/// A polished square that only reflects, all of it, and faces along `normal`.
Mirror ideal_mirror(const Vec3<double>& position, const Vec3<double>& normal, double side);

/// A camera at `position` that looks along `view`, `fov` radians across.
Camera camera_at(const Vec3<double>& position, const Vec3<double>& view, double fov);

void add(Scene& scene, const Solid& solid);
void add(Scene& scene, const Light& light);
void add(Scene& scene, const Mirror& mirror);

}  // namespace zerkalo::stability
