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

struct Field {
    const char* name;
    double* value;
    bool may_be_infinite = false, may_be_minus_infinite = false;

    bool allows(double x) const {
        return (x == kInfinity && may_be_infinite) || (x == -kInfinity && may_be_minus_infinite);
    }
};

struct Fields {
    std::vector<Field> all;

    void add(const char* field, double& x) { all.push_back({field, &x}); }
    void add(const char* field, Vec3<double>& v) {
        for (double* x : {&v.x, &v.y, &v.z}) all.push_back({field, x});
    }
    void add(const char* field, Rgb<double>& c) {
        for (double* x : {&c.r, &c.g, &c.b}) all.push_back({field, x});
    }
};

void add_solids(Fields& fields, Scene& scene) {
    Solid& round = scene.solids[0];
    Solid& tube = scene.solids[1];
    fields.add("position", round.position);
    fields.add("radius", round.radius);
    fields.add("rotate_deg", tube.rotation);
    fields.add("height", tube.height);
    fields.add("taper", tube.taper);
    fields.add("scale", scene.solids[2].scale);
    for (Triangle* t = scene.triangles; t < scene.triangles + scene.triangle_count; ++t) fields.add("vertices", t->b);
    Material& material = round.material;
    fields.add("color", material.color);
    fields.add("ambient", material.ambient);
    fields.add("diffuse", material.diffuse);
    fields.add("specular", material.specular);
    fields.add("shininess", material.shininess);
    fields.add("reflection", material.reflection);
    fields.add("transmission", material.transmission);
    fields.add("refractive_index", material.refractive_index);
}

void add_mirrors(Fields& fields, Scene& scene) {
    Mirror& mirror = scene.mirrors[0];
    fields.add("position", mirror.position);
    fields.add("normal", mirror.normal);
    fields.add("up", mirror.up);
    fields.add("boundary.width", mirror.boundary.width);
    fields.add("boundary.height", mirror.boundary.height);
    fields.add("boundary.radius", scene.mirrors[1].boundary.radius);
    fields.add("boundary.points", scene.mirrors[2].boundary.corners[1].x);
    fields.all.push_back({"curvature_radius", &mirror.curvature_radius, true, true});
    fields.all.push_back({"lobe_exponent", &mirror.lobe_exponent, true});
    fields.add("color", mirror.color);
    fields.add("ambient", mirror.ambient);
    fields.add("diffuse", mirror.diffuse);
    fields.add("specular", mirror.specular);
    fields.add("shininess", mirror.shininess);
    fields.add("reflection", mirror.reflection);
}

Fields fields_of(Scene& scene) {
    Fields fields;
    fields.add("ambient", scene.ambient);
    fields.add("background", scene.background);
    fields.add("position", scene.camera.position);
    fields.add("view", scene.camera.view);
    fields.add("up", scene.camera.up);
    fields.add("horizontal_fov_deg", scene.camera.fov);
    fields.add("position", scene.lights[0].position);
    fields.add("color", scene.lights[0].color);
    fields.add("intensity", scene.lights[0].intensity);
    add_solids(fields, scene);
    add_mirrors(fields, scene);
    return fields;
}

/// How many of the numbers, set to NaN and to both infinities, get a wrong answer.
template <class Wrong>
double wrong_answers(const Wrong& wrong) {
    Scene scene = sound_scene();
    int count = 0;
    for (const Field& field : fields_of(scene).all) {
        const double sound = *field.value;
        for (const double bad : {kNaN, kInfinity, -kInfinity}) {
            if (field.allows(bad)) continue;
            *field.value = bad;
            count += wrong(scene, field);
        }
        *field.value = sound;
    }
    return count;
}

double s51_ours(const Stage& stage) {
    if (!stage.render(sound_scene(), 8, 8).finite()) return kInfinity;
    return wrong_answers(
        [&](const Scene& scene, const Field& field) { return stage.refused_field(scene) != field.name; });
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
    return wrong_answers([](const Scene& scene, const Field&) { return !std::isfinite(pixel(scene)); });
}

constexpr StiffCase kRows[] = {
    {"S51", "NaN, inf or -inf in each number of a scene, one at a time", "shows NaN, or an infinite light",
     "refused, and the field named", "wrong answers", 0, s51_ours, s51_naive},
};

}  // namespace

std::span<const StiffCase> bad_number_rows() { return kRows; }

}  // namespace zerkalo::stability
