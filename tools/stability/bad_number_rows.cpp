// Numbers that are none, one at a time in every field of a scene.
#include "tools/stability/naive.hpp"
#include "tools/stability/stiff_case.hpp"

#include <limits>
#include <numbers>
#include <string>

namespace zerkalo::stability {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A cylinder, a mesh, a ball and three mirrors before a camera and a lamp; every number of them in turn.

void add_tetrahedron(Scene& scene) {
    const Vec3<double> a{3, 0, 0}, b{4, 0, 0}, c{3, 1, 0}, d{3, 0, 1};
    for (const Triangle& face : {Triangle{a, c, b}, {a, b, d}, {a, d, c}, {b, c, d}}) {
        scene.triangles[scene.triangle_count++] = face;
    }
    Solid mesh;
    mesh.kind = SolidKind::mesh;
    mesh.triangle_count = 4;
    add(scene, mesh);
}

Scene sound_scene() {
    Scene scene;
    scene.camera = camera_at({0, 0, 4}, {0, 0, -1}, 0.5);
    scene.background = {0.5, 0.5, 0.5};
    add(scene, lamp({2, 3, 4}));
    scene.lights[0].falloff = Falloff::inverse_square;
    add(scene, ball({0, 0, 0}, 1, Material{}));
    add(scene, upright(SolidKind::cylinder, {-3, 0, 0}, 0.5, 1, Material{}));
    add_tetrahedron(scene);
    for (const BoundaryShape shape : {BoundaryShape::rectangle, BoundaryShape::disc, BoundaryShape::polygon}) {
        Mirror mirror = ideal_mirror({0, 0, -3}, {0, 0, 1}, 1);
        mirror.boundary.shape = shape;
        mirror.boundary.corner_count = 3;
        mirror.boundary.corners[1].x = mirror.boundary.corners[2].y = 1;
        add(scene, mirror);
    }
    return scene;
}

struct Number {
    const char* field;
    double* value;
    bool may_be_infinite = false, may_be_minus_infinite = false;

    bool allows(double x) const {
        return (x == kInfinity && may_be_infinite) || (x == -kInfinity && may_be_minus_infinite);
    }
};

struct Numbers {
    std::vector<Number> all;

    void add(const char* field, double& x) { all.push_back({field, &x}); }
    void add(const char* field, Vec3<double>& v) {
        for (double* x : {&v.x, &v.y, &v.z}) all.push_back({field, x});
    }
    void add(const char* field, Rgb<double>& c) {
        for (double* x : {&c.r, &c.g, &c.b}) all.push_back({field, x});
    }
};

void add_solids(Numbers& numbers, Scene& scene) {
    Solid& round = scene.solids[0];
    Solid& tube = scene.solids[1];
    numbers.add("position", round.position);
    numbers.add("radius", round.radius);
    numbers.add("rotate_deg", tube.rotation);
    numbers.add("height", tube.height);
    numbers.add("taper", tube.taper);
    numbers.add("scale", scene.solids[2].scale);
    for (Triangle* t = scene.triangles; t < scene.triangles + scene.triangle_count; ++t) numbers.add("vertices", t->b);
    Material& material = round.material;
    numbers.add("color", material.color);
    numbers.add("ambient", material.ambient);
    numbers.add("diffuse", material.diffuse);
    numbers.add("specular", material.specular);
    numbers.add("shininess", material.shininess);
    numbers.add("reflection", material.reflection);
    numbers.add("transmission", material.transmission);
    numbers.add("refractive_index", material.refractive_index);
}

void add_mirrors(Numbers& numbers, Scene& scene) {
    Mirror& mirror = scene.mirrors[0];
    numbers.add("position", mirror.position);
    numbers.add("normal", mirror.normal);
    numbers.add("up", mirror.up);
    numbers.add("boundary.width", mirror.boundary.width);
    numbers.add("boundary.height", mirror.boundary.height);
    numbers.add("boundary.radius", scene.mirrors[1].boundary.radius);
    numbers.add("boundary.points", scene.mirrors[2].boundary.corners[1].x);
    numbers.all.push_back({"curvature_radius", &mirror.curvature_radius, true, true});
    numbers.all.push_back({"lobe_exponent", &mirror.lobe_exponent, true});
    numbers.add("color", mirror.color);
    numbers.add("ambient", mirror.ambient);
    numbers.add("diffuse", mirror.diffuse);
    numbers.add("specular", mirror.specular);
    numbers.add("shininess", mirror.shininess);
    numbers.add("reflection", mirror.reflection);
}

Numbers numbers_of(Scene& scene) {
    Numbers numbers;
    numbers.add("ambient", scene.ambient);
    numbers.add("background", scene.background);
    numbers.add("position", scene.camera.position);
    numbers.add("view", scene.camera.view);
    numbers.add("up", scene.camera.up);
    numbers.add("horizontal_fov_deg", scene.camera.fov);
    numbers.add("position", scene.lights[0].position);
    numbers.add("color", scene.lights[0].color);
    numbers.add("intensity", scene.lights[0].intensity);
    add_solids(numbers, scene);
    add_mirrors(numbers, scene);
    return numbers;
}

/// How many of the numbers, set to NaN and to both infinities, get a wrong answer.
template <class Wrong>
double wrong_answers(const Wrong& wrong) {
    Scene scene = sound_scene();
    int count = 0;
    for (const Number& number : numbers_of(scene).all) {
        const double sound = *number.value;
        for (const double bad : {kNaN, kInfinity, -kInfinity}) {
            if (number.allows(bad)) continue;
            *number.value = bad;
            count += wrong(scene, number);
        }
        *number.value = sound;
    }
    return count;
}

double s51_ours(const Stage& stage) {
    if (!stage.render(sound_scene(), 8, 8).finite()) return kInfinity;
    return wrong_answers([](const Scene& scene, const Number& number) { return refused_field(scene) != number.field; });
}

/// Whitted's local light at the ball of sound_scene(), in red, beside the middle. The textbook asks nothing.
float pixel(const Scene& scene) {
    const Solid& solid = scene.solids[0];
    const Material& m = solid.material;
    const Light& light = scene.lights[0];
    const Vec3<float> eye = naive::rounded(scene.camera.position), up = naive::rounded(scene.camera.up);
    const Vec3<float> view = naive::unit(naive::rounded(scene.camera.view));
    const Vec3<float> right = naive::unit(naive::cross(view, up));
    const float aside = std::tan(float(scene.camera.fov) / 2) / 8;
    const Vec3<float> d = naive::unit(naive::along(view, aside, right)), centre = naive::rounded(solid.position);
    const auto roots = naive::sphere(eye, d, centre, float(solid.radius));
    if (!roots.real) return float(scene.background.r);
    const Vec3<float> p = naive::along(eye, roots.first, d);
    const Vec3<float> n = naive::times(naive::minus(p, centre), 1 / float(solid.radius));
    const Vec3<float> way = naive::minus(naive::rounded(light.position), p), l = naive::unit(way);
    const float cosine = std::max(0.0f, naive::dot(n, l));
    const Vec3<float> r = naive::minus(naive::times(n, 2 * cosine), l);
    const float highlight = std::pow(std::max(0.0f, -naive::dot(r, d)), float(m.shininess));
    const float e = float(light.color.r) * float(light.intensity) / naive::dot(way, way);
    return float(m.color.r * m.ambient * scene.ambient.r) +
           e * (float(m.diffuse * m.color.r) * cosine + float(m.specular) * highlight);
}

double s51_naive() {
    return wrong_answers([](const Scene& scene, const Number&) { return !std::isfinite(pixel(scene)); });
}

constexpr StiffCase kRows[] = {
    {"S51", "NaN, inf or -inf in each number of a scene, one at a time", "shows NaN, or an infinite light",
     "refused, and the field named", "wrong answers", 0, s51_ours, s51_naive},
};

}  // namespace

std::span<const StiffCase> bad_number_rows() { return kRows; }

}  // namespace zerkalo::stability
