// See fields.hpp. The structured bindings below name every member of every part: one more, and they do not compile.
#include "tests/bad_input/fields.hpp"

#include <cstring>

namespace zerkalo::bad_input {
namespace {

/// Collects the fields of one part of the scene.
struct Collector {
    const Scene& scene;
    std::vector<Field>& fields;
    Part part;
    std::int32_t index;

    void add(const void* at, std::size_t size, FieldType type, const char* name, const char* also,
             std::uint8_t choices = 0) {
        const auto offset =
            static_cast<std::size_t>(static_cast<const char*>(at) - reinterpret_cast<const char*>(&scene));
        fields.push_back({part, index, name, also, type, offset, size, choices});
    }
    void real(const double& x, const char* name, const char* also = "") {
        add(&x, sizeof x, FieldType::real, name, also);
    }
    void whole(const std::int32_t& x, const char* name, const char* also = "") {
        add(&x, sizeof x, FieldType::whole, name, also);
    }
    template <class Choice>
    void choice(const Choice& x, const char* name, Choice last) {
        static_assert(sizeof x == 1);
        add(&x, 1, FieldType::choice, name, "", static_cast<std::uint8_t>(static_cast<int>(last) + 1));
    }
    void truth(const bool& x, const char* name) { add(&x, 1, FieldType::truth, name, "transmission"); }
    void vector(const Vec3<double>& v, const char* name, const char* also = "") {
        const auto& [x, y, z] = v;
        real(x, name, also), real(y, name, also), real(z, name, also);
    }
    void colour(const Rgb<double>& c, const char* name) {
        const auto& [r, g, b] = c;
        real(r, name), real(g, name), real(b, name);
    }
};

void visit(Collector to, const ImageSize& image) {
    const auto& [width, height] = image;
    to.whole(width, "width", "height"), to.whole(height, "height");
}

void visit(Collector to, const Camera& camera) {
    const auto& [position, view, up, fov, fov_axis] = camera;
    to.vector(position, "position"), to.vector(view, "view"), to.vector(up, "up");
    to.real(fov, camera.fov_axis == FovAxis::vertical ? "vertical_fov_deg" : "horizontal_fov_deg");
    to.choice(fov_axis, "fov_axis", FovAxis::vertical);
}

void visit(Collector to, const Light& light) {
    const auto& [position, color, intensity, falloff] = light;
    to.vector(position, "position"), to.colour(color, "color"), to.real(intensity, "intensity");
    to.choice(falloff, "falloff", Falloff::inverse_square);
}

void visit(Collector to, const Material& material) {
    const auto& [color, ambient, diffuse, specular, shininess, reflection, transmission, refractive_index, fresnel] =
        material;
    to.colour(color, "color"), to.real(ambient, "ambient"), to.real(diffuse, "diffuse");
    to.real(specular, "specular"), to.real(shininess, "shininess");
    to.real(reflection, "reflection", "transmission"), to.real(transmission, "transmission", "fresnel");
    to.real(refractive_index, "refractive_index"), to.truth(fresnel, "fresnel");
}

void visit(Collector to, const Solid& solid) {
    const auto& [kind, position, rotation, radius, height, taper, scale, sides, first, count, material] = solid;
    to.choice(kind, "kind", SolidKind::mesh);
    to.vector(position, "position"), to.vector(rotation, "rotate_deg");
    to.real(radius, "radius"), to.real(height, "height"), to.real(taper, "taper"), to.real(scale, "scale");
    to.whole(sides, "sides"), to.whole(first, "triangles"), to.whole(count, "triangles");
    visit(to, material);
}

void visit(Collector to, const Boundary& boundary) {
    const char* radius_of_curvature = "curvature_radius";
    const auto& [shape, width, height, radius, corner_count, corners] = boundary;
    to.choice(shape, "boundary.shape", BoundaryShape::polygon);
    to.real(width, "boundary.width", radius_of_curvature), to.real(height, "boundary.height", radius_of_curvature);
    to.real(radius, "boundary.radius", radius_of_curvature);
    to.whole(corner_count, "boundary.points");
    for (const Vec2<double>& corner : corners) {
        const auto& [x, y] = corner;
        to.real(x, "boundary.points", radius_of_curvature), to.real(y, "boundary.points", radius_of_curvature);
    }
}

void visit(Collector to, const Mirror& mirror) {
    const auto& [position, normal, up, boundary, curvature_radius, lobe, lobe_exponent, color, ambient, diffuse,
                 specular, shininess, reflection] = mirror;
    to.vector(position, "position"), to.vector(normal, "normal"), to.vector(up, "up");
    visit(to, boundary);
    to.real(curvature_radius, "curvature_radius"), to.choice(lobe, "lobe", Lobe::ggx);
    to.real(lobe_exponent, "lobe_exponent"), to.colour(color, "color"), to.real(ambient, "ambient");
    to.real(diffuse, "diffuse"), to.real(specular, "specular"), to.real(shininess, "shininess");
    to.real(reflection, "reflection");
}

void visit(Collector to, const Triangle& triangle) {
    const auto& [a, b, c] = triangle;
    for (const Vec3<double>* corner : {&a, &b, &c}) to.vector(*corner, "vertices", "triangles");
}

/// The mesh that a triangle belongs to; -1 for none.
std::int32_t owner_of(const Scene& scene, std::int32_t triangle) {
    for (std::int32_t k = 0; k < scene.solid_count; ++k) {
        const Solid& solid = scene.solids[k];
        if (solid.kind != SolidKind::mesh) continue;
        if (triangle >= solid.first_triangle && triangle < solid.first_triangle + solid.triangle_count) return k;
    }
    return -1;
}

}  // namespace

std::vector<Field> all_fields(const Scene& scene) {
    const auto& [image, camera, ambient, background, light_count, solid_count, mirror_count, triangle_count, lights,
                 solids, mirrors, triangles] = scene;
    std::vector<Field> fields;
    const auto collector = [&](Part part, std::ptrdiff_t index) {
        return Collector{scene, fields, part, static_cast<std::int32_t>(index)};
    };
    visit(collector(Part::image, 0), image);
    visit(collector(Part::camera, 0), camera);
    Collector whole_scene = collector(Part::scene, 0);
    whole_scene.colour(ambient, "ambient"), whole_scene.colour(background, "background");
    whole_scene.whole(light_count, "light"), whole_scene.whole(solid_count, "solid");
    whole_scene.whole(mirror_count, "mirror"), whole_scene.whole(triangle_count, "triangles");
    for (const Light& light : lights) visit(collector(Part::light, &light - lights), light);
    for (const Solid& solid : solids) visit(collector(Part::solid, &solid - solids), solid);
    for (const Mirror& mirror : mirrors) {
        visit(collector(Part::mirror, &mirror - mirrors), mirror);
    }
    for (const Triangle& triangle : triangles) {
        const auto owner = owner_of(scene, static_cast<std::int32_t>(&triangle - triangles));
        visit(collector(Part::solid, owner), triangle);
    }
    return fields;
}

std::vector<Field> fields_in_use(const Scene& scene) {
    std::vector<Field> used;
    std::int32_t corner_number = 0, corner_owner = -1;  // of the mirror whose corners come now
    for (const Field& field : all_fields(scene)) {
        const bool corner = field.name == "boundary.points" && field.type == FieldType::real;
        if (field.part == Part::light && field.index >= scene.light_count) continue;
        if (field.part == Part::solid && (field.index < 0 || field.index >= scene.solid_count)) continue;
        if (field.part == Part::mirror && field.index >= scene.mirror_count) continue;
        if (corner) {
            corner_number = field.index == corner_owner ? corner_number + 1 : 0;
            corner_owner = field.index;
            if (corner_number / 2 >= scene.mirrors[field.index].boundary.corner_count) continue;
        }
        used.push_back(field);
    }
    return used;
}

void set(Scene& scene, const Field& field, double value) {
    std::memcpy(reinterpret_cast<char*>(&scene) + field.offset, &value, sizeof value);
}

void set(Scene& scene, const Field& field, std::int32_t value) {
    std::memcpy(reinterpret_cast<char*>(&scene) + field.offset, &value, sizeof value);
}

void set(Scene& scene, const Field& field, std::uint8_t value) {
    std::memcpy(reinterpret_cast<char*>(&scene) + field.offset, &value, sizeof value);
}

bool names(const Status& status, const Field& field) {
    // The number of all triangles is named by the mesh that reaches beyond it.
    const bool pool = field.part == Part::scene && field.name == "triangles";
    if (!pool && (status.part != field.part || status.index != field.index)) return false;
    return status.field == field.name || status.field == field.also;
}

std::string text_of(const Field& field) {
    return std::string(name_of(field.part)) + " " + std::to_string(field.index) + " " + field.name + " (byte " +
           std::to_string(field.offset) + ")";
}

}  // namespace zerkalo::bad_input
