// Meshes whose triangles stand in the scene file.
#include "tests/scene_file/bad_scene.hpp"

#include <cmath>

namespace zerkalo {
namespace {

const std::string kMesh = "[[solid]]\nkind = 'mesh'\nposition = [0, 0, 0]\n";
const std::string kVertices = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
const std::string kTetrahedron = kMesh + kVertices + "triangles = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]\n";

/// A closed band of `sides` quadrilaterals with two poles: 4 * sides triangles.
std::string spindle(int sides) {
    std::string vertices = "vertices = [[0, 2, 0], [0, -2, 0]", triangles = "triangles = [";
    for (int k = 0; k < sides; ++k) {
        const double a = 6.283185307179586 * k / sides;
        const std::string x = std::to_string(std::cos(a)), z = std::to_string(std::sin(a));
        vertices += ", [" + x + ", 1, " + z + "], [" + x + ", -1, " + z + "]";
        const int up = 2 + 2 * k, down = up + 1, next_up = 2 + 2 * ((k + 1) % sides), next_down = next_up + 1;
        const int faces[4][3] = {
            {0, next_up, up}, {1, down, next_down}, {up, next_up, next_down}, {up, next_down, down}};
        for (const auto& f : faces) {
            triangles += "[" + std::to_string(f[0]) + ", " + std::to_string(f[1]) + ", " + std::to_string(f[2]) + "], ";
        }
    }
    return kMesh + vertices + "]\n" + triangles + "]\n";
}

TEST(InlineMesh, TrianglesArriveWithTheirCornersInOrder) {
    const LoadResult result = load_text(kHead + kTetrahedron + "scale = 2\n");
    ASSERT_TRUE(result.ok()) << to_text(result);
    const Scene& scene = *result.scene;
    EXPECT_EQ(scene.triangle_count, 4);
    EXPECT_EQ(scene.solids[0].kind, SolidKind::mesh);
    EXPECT_EQ(scene.solids[0].first_triangle, 0);
    EXPECT_EQ(scene.solids[0].triangle_count, 4);
    EXPECT_EQ(scene.solids[0].scale, 2);
    const Triangle& last = scene.triangles[3];
    EXPECT_TRUE(last.a.x == 1 && last.b.y == 1 && last.c.z == 1 && last.a.y == 0 && last.b.z == 0 && last.c.x == 0);
}

TEST(InlineMesh, SecondMeshFollowsTheFirst) {
    const LoadResult result = load_text(kHead + kTetrahedron + spindle(3));
    ASSERT_TRUE(result.ok()) << to_text(result);
    EXPECT_EQ(result.scene->solids[1].first_triangle, 4);
    EXPECT_EQ(result.scene->solids[1].triangle_count, 12);
    EXPECT_EQ(result.scene->triangle_count, 16);
}

TEST(InlineMesh, CapacityIsReachedExactlyAndNotExceeded) {
    const LoadResult full = load_text(kHead + spindle(128));
    ASSERT_TRUE(full.ok()) << to_text(full);
    EXPECT_EQ(full.scene->triangle_count, kMaxTriangles);
    for (const std::string& text : {kHead + spindle(129), kHead + spindle(127) + spindle(3)}) {
        const LoadResult over = load_text(text);
        ASSERT_EQ(over.diagnostics.size(), 1u);
        EXPECT_NE(over.diagnostics[0].message.find("a scene holds at most 512 triangles"), std::string::npos)
            << to_text(over);
    }
}

TEST(InlineMesh, WrongVerticesAndTrianglesAreErrorsAtTheirPlace) {
    const BadScene cases[] = {
        {kHead + kMesh + kVertices + "triangles = [[0, 2, 1], [0, 1, ^4]]\n",
         "triangle 1 of \"triangles\": a vertex number must be a whole number from 0 to 3", ""},
        {kHead + kMesh + kVertices + "triangles = [[^-1, 2, 1]]\n", "from 0 to 3, not -1", ""},
        {kHead + kMesh + kVertices + "triangles = [[0, ^1.0, 2]]\n", "from 0 to 3, not 1", ""},
        {kHead + kMesh + kVertices + "triangles = [^[0, 1]]\n", "triangle 0 of \"triangles\" must be three vertex numbers", ""},
        {kHead + kMesh + kVertices + "triangles = ^[]\n",
         "\"triangles\" must be an array of arrays, not an empty array", "for example"},
        {kHead + kMesh + kVertices + "triangles = ^5\n", "\"triangles\" must be an array of arrays, not 5",
         "for example"},
        {kHead + kMesh + "triangles = [[0, 1, 2]]\nvertices = ^'cube'\n", "\"vertices\" must be an array of arrays",
         "for example"},
        {kHead + kMesh + "triangles = [[0, 1, 1]]\nvertices = [[0, 0, 0], ^[0, 1]]\n",
         "vertex 1 of \"vertices\" needs 3 numbers, here are 2", ""},
        {kHead + kMesh + "triangles = [[0, 1, 1]]\nvertices = [[0, 0, 0], [0, ^nan, 1]]\n", "number 2 of vertex 1", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

}  // namespace
}  // namespace zerkalo
