// STL files: both formats, how they are told apart, and everything that can be wrong with them.
#include "tools/scene_file/stl.hpp"
#include "tests/scene_file/bad_scene.hpp"

#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>

namespace zerkalo {
namespace {

using scene_file::SourceText;
using scene_file::StlFault;

const std::string kFacet =
    " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1.5e0 -2\n  endloop\n endfacet\n";

std::string binary(const std::vector<std::array<float, 9>>& triangles, const std::string& comment = "") {
    std::string bytes = comment;
    bytes.resize(80, ' ');
    const auto put = [&bytes](std::uint32_t value) {
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xff);
    };
    put(static_cast<std::uint32_t>(triangles.size()));
    for (const auto& corners : triangles) {
        for (int i = 0; i < 3; ++i) put(0x7fc00000);  // the normal is NaN: it must not be looked at
        for (const float x : corners) put(std::bit_cast<std::uint32_t>(x));
        bytes += "xx";
    }
    return bytes;
}

struct Outcome {
    std::optional<StlFault> fault;
    std::vector<Triangle> triangles;
};

Outcome read(const std::string& bytes, int room = kMaxTriangles) {
    Outcome outcome;
    outcome.fault = scene_file::read_stl(SourceText("part.stl", bytes), room, outcome.triangles);
    return outcome;
}

TEST(Stl, BinaryTrianglesArriveExactly) {
    const Outcome outcome = read(binary({{0, 0.1f, 2, 3, 4, 5, 6, 7, -8}, {1, 1, 1, 2, 2, 2, 3, 3, 1e15f}}));
    ASSERT_FALSE(outcome.fault) << outcome.fault->message;
    ASSERT_EQ(outcome.triangles.size(), 2u);
    EXPECT_EQ(outcome.triangles[0].a.y, static_cast<double>(0.1f));
    EXPECT_EQ(outcome.triangles[0].c.z, -8);
    EXPECT_EQ(outcome.triangles[1].b.x, 2);
}

TEST(Stl, BinaryFileThatBeginsWithSolidIsBinary) {
    const Outcome outcome = read(binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, "solid made by a well-known program"));
    ASSERT_FALSE(outcome.fault) << outcome.fault->message;
    EXPECT_EQ(outcome.triangles.size(), 1u);
}

TEST(Stl, AsciiTrianglesArriveExactly) {
    for (const std::string& text : {"solid part of a thing\n" + kFacet + kFacet + "endsolid part\n",
                                    "  SOLID\n" + kFacet + "endsolid\nsolid b\n" + kFacet + "ENDSOLID b",
                                    "solid\r\n" + kFacet + "\t" + kFacet + "endsolid\r\n\r\n"}) {
        const Outcome outcome = read(text);
        ASSERT_FALSE(outcome.fault) << text << outcome.fault->message;
        ASSERT_EQ(outcome.triangles.size(), 2u) << text;
        EXPECT_EQ(outcome.triangles[1].b.x, 1);
        EXPECT_EQ(outcome.triangles[1].c.y, 1.5);
        EXPECT_EQ(outcome.triangles[1].c.z, -2);
    }
    EXPECT_FALSE(read("solid\nfacet normal nan NAN +1\n" + kFacet.substr(20) + "endsolid").fault)
        << "normals are not used";
}

TEST(Stl, WrongBinaryFilesAreRefused) {
    const std::string good = binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0}});
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const struct {
        std::string bytes, message;
    } cases[] = {
        {"", "neither a binary STL file"},
        {good.substr(0, 83), "neither a binary STL file"},
        {good.substr(0, 84), "states 2 triangles, which take 184 bytes, but has 84"},
        {good.substr(0, 183), "states 2 triangles, which take 184 bytes, but has 183"},
        {good + "x", "states 2 triangles, which take 184 bytes, but has 185"},
        {std::string(80, ' ') + "\xff\xff\xff\xff", "states 4294967295 triangles"},
        {binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, "solid").substr(0, 100), "states 1 triangles"},
        {binary({{0, 0, 0, 1, nan, 0, 0, 1, 0}}),
         "triangle 1, corner 2: a coordinate must be a number from -1e15 to 1e15"},
        {binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 1, 0, 0, 0, 1, -inf}}), "triangle 2, corner 3"},
        {binary({{2e15f, 0, 0, 1, 0, 0, 0, 1, 0}}), "triangle 1, corner 1"},
        {binary(std::vector<std::array<float, 9>>(513)), "513 triangles: a scene holds at most 512 triangles"},
    };
    for (const auto& bad : cases) {
        const Outcome outcome = read(bad.bytes);
        ASSERT_TRUE(outcome.fault) << bad.message;
        EXPECT_NE(outcome.fault->message.find(bad.message), std::string::npos) << outcome.fault->message;
        EXPECT_EQ(outcome.fault->at.line, 0);
    }
}

TEST(Stl, WrongAsciiFilesAreRefusedAtTheirLine) {
    const struct {
        std::string text, message;
        int line, column;
    } cases[] = {
        {"solid\n", "expected \"facet\", but the file ends here", 1, 6},
        {"solid\n" + kFacet, "expected \"facet\", but the file ends here", 8, 10},
        {"solid\n" + kFacet + "endsolid\nrest\n", "expected \"solid\", not \"rest\"", 10, 1},
        {"solid\nfacet norml 0 0 1\n", "expected \"normal\", not \"norml\"", 2, 7},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0,5 0\n", "expected a number from -1e15 to 1e15, not \"0,5\"",
         4, 10},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\n", "expected a number from -1e15 to 1e15, not \"nan\"",
         4, 8},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n", "not \"inf\"", 4, 12},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 2e15\n", "not \"2e15\"", 4, 12},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e999\n", "not \"1e999\"", 4, 12},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n",
         "expected a number from -1e15 to 1e15, not \"vertex\"", 5, 1},
        {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nendloop\n",
         "expected \"vertex\", not \"endloop\"", 6, 1},
    };
    for (const auto& bad : cases) {
        const Outcome outcome = read(bad.text);
        ASSERT_TRUE(outcome.fault) << bad.text;
        EXPECT_NE(outcome.fault->message.find(bad.message), std::string::npos) << bad.text << outcome.fault->message;
        EXPECT_EQ(outcome.fault->at.line, bad.line) << bad.text << outcome.fault->message;
        EXPECT_EQ(outcome.fault->at.column, bad.column) << bad.text << outcome.fault->message;
    }
}

TEST(Stl, RoomIsKept) {
    const std::string text = "solid\n" + kFacet + kFacet + kFacet + "endsolid\n";
    EXPECT_FALSE(read(text, 3).fault);
    const Outcome outcome = read(text, 2);
    ASSERT_TRUE(outcome.fault);
    EXPECT_NE(outcome.fault->message.find("the meshes before leave room for 2"), std::string::npos)
        << outcome.fault->message;
    EXPECT_EQ(outcome.triangles.size(), 2u);
    EXPECT_TRUE(read(binary(std::vector<std::array<float, 9>>(3)), 2).fault);
}

class StlInScene : public testing::Test {
protected:
    void SetUp() override {
        directory = std::filesystem::path(testing::TempDir()) /
                    (std::string("zerkalo_stl_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(directory);
    }
    void TearDown() override { std::filesystem::remove_all(directory); }

    LoadResult load(const std::string& name) const {
        return load_scene_text(kHead + "[[solid]]\nkind = 'mesh'\nposition = [0, 0, 0]\nstl = '" + name + "'\n",
                               "scene.toml", directory);
    }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(directory / name, std::ios::binary) << bytes;
    }

    std::filesystem::path directory;
};

TEST_F(StlInScene, BothFormatsOfOneSolidGiveTheSameTriangles) {
    const float corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::vector<std::array<float, 9>> triangles;
    std::string text = "solid\n";
    for (const auto& face : faces) {
        std::array<float, 9> nine{};
        text += "facet normal 0 0 0\nouter loop\n";
        for (std::size_t k = 0; k < 3; ++k) {
            text += "vertex";
            for (std::size_t i = 0; i < 3; ++i) {
                nine[3 * k + i] = corner[face[k]][i];
                text += " " + std::to_string(corner[face[k]][i]);
            }
            text += "\n";
        }
        text += "endloop\nendfacet\n";
        triangles.push_back(nine);
    }
    write("b.stl", binary(triangles));
    write("a.stl", text + "endsolid\n");
    const LoadResult a = load("a.stl"), b = load("b.stl");
    ASSERT_TRUE(a.ok()) << to_text(a);
    ASSERT_TRUE(b.ok()) << to_text(b);
    ASSERT_EQ(a.scene->triangle_count, 4);
    for (int k = 0; k < 4; ++k) {
        const Triangle &p = a.scene->triangles[k], &q = b.scene->triangles[k];
        EXPECT_TRUE(p.a.x == q.a.x && p.b.y == q.b.y && p.c.z == q.c.z && p.c.x == q.c.x) << k;
    }
}

TEST_F(StlInScene, FaultsNameTheFileAndThePlaceThatNamesIt) {
    write("broken.stl", "solid\nfacet normal 0 0 1\nouter lop\n");
    const LoadResult result = load("broken.stl");
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(to_text(result), (directory / "broken.stl").string() +
                                   ":3:7: error: expected \"loop\", not \"lop\"\n"
                                   "    outer lop\n"
                                   "          ^~~\n"
                                   "    help: the scene names this file at scene.toml:7:7\n");
    write("short.stl", binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}}).substr(0, 100));
    EXPECT_EQ(to_text(load("short.stl")), (directory / "short.stl").string() +
                                              ": error: states 1 triangles, which take 134 bytes, but has 100\n"
                                              "    help: the scene names this file at scene.toml:7:7\n");
}

TEST_F(StlInScene, OpenSurfacesAreShownWhereTheFileIsNamed) {
    write("open.stl", binary({{0, 0, 0, 1, 0, 0, 0, 1, 0}}));
    const LoadResult result = load("open.stl");
    ASSERT_EQ(result.diagnostics.size(), 1u) << to_text(result);
    EXPECT_EQ(result.diagnostics[0].at.line, 7);
    EXPECT_EQ(result.diagnostics[0].at.column, 7);
    EXPECT_NE(result.diagnostics[0].message.find("closed surface"), std::string::npos) << to_text(result);
}

TEST_F(StlInScene, FilesThatCannotBeReadAreWrongScenes) {
    write("large.stl", "solid\n" + std::string(1 << 20, '\n'));
    write("empty.stl", "solid\nendsolid\n");
    std::filesystem::create_directory(directory / "folder.stl");
    const struct {
        std::string name, message;
    } cases[] = {
        {"missing.stl", "cannot read \"" + (directory / "missing.stl").string() + "\": No such file or directory"},
        {"folder.stl", "folder.stl\": not a file"},
        {"", "not a file"},
        {"/dev/zero", "\"/dev/zero\": not a file"},
        {"large.stl", "larger than 1 MiB: a scene holds at most 512 triangles"},
        {"empty.stl", "no triangles"},
    };
    for (const auto& bad : cases) {
        const LoadResult result = load(bad.name);
        EXPECT_EQ(result.exit_code, 3) << bad.name;
        ASSERT_EQ(result.diagnostics.size(), 1u) << bad.name;
        EXPECT_NE(result.diagnostics[0].message.find(bad.message), std::string::npos) << to_text(result);
    }
}

}  // namespace
}  // namespace zerkalo
