// Damaged scene files: whatever bytes change, the loader gives a valid scene or diagnostics, and nothing else.
#include "core/scene/validate.hpp"
#include "tests/scene_file/bad_scene.hpp"
#include "tools/scene_file/stl.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <vector>

namespace zerkalo {
namespace {

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t limit) { return random() % limit; }

/// Pieces that do more harm than single bytes.
constexpr const char* kPieces[] = {"[",
                                   "]",
                                   "[[",
                                   "{",
                                   "}",
                                   "=",
                                   ",",
                                   ".",
                                   "\"",
                                   "'",
                                   "\"\"\"",
                                   "#",
                                   "\n",
                                   "nan",
                                   "inf",
                                   "-",
                                   "1e999",
                                   "0x",
                                   "\\u0000",
                                   "1979-05-27",
                                   "\xff",
                                   "\xd0",
                                   "99999999999999999999",
                                   "\n[[solid]]\n",
                                   "true"};

std::string mutated(std::string text, Random& random) {
    const std::size_t changes = 1 + below(random, 6);
    for (std::size_t i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t at = below(random, text.size());
        const std::size_t size = std::min(text.size() - at, 1 + below(random, 30));
        switch (below(random, 5)) {
            case 0: text[at] = static_cast<char>(random()); break;
            case 1: text.erase(at, size); break;
            case 2: text.insert(at, text.substr(below(random, text.size()), size)); break;
            case 3: text.insert(at, kPieces[below(random, std::size(kPieces))]); break;
            default: text[at] = static_cast<char>('0' + below(random, 10)); break;
        }
    }
    return text;
}

std::vector<std::string> texts_with(const std::string& extension) {
    std::vector<std::string> texts;
    for (const auto& entry : std::filesystem::directory_iterator(ZERKALO_SOURCE_DIR "/firmware/scenes")) {
        if (entry.path().extension() != extension) continue;
        std::stringstream text;
        text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
        texts.push_back(text.str());
    }
    return texts;
}

TEST(SceneFile, DamagedFilesGiveAValidSceneOrDiagnostics) {
    constexpr int kRounds = 400;  // of every shipped scene
    int valid = 0, wrong = 0;
    Random random(20240229);
    for (const std::string& text : texts_with(".toml")) {
        for (int round = 0; round < kRounds; ++round) {
            const std::string damaged = mutated(text, random);
            const LoadResult result = load_text(damaged);
            SCOPED_TRACE(damaged);
            if (result.ok()) {
                ++valid;
                ASSERT_TRUE(validate(*result.scene).ok());
                ASSERT_TRUE(result.diagnostics.empty());
                continue;
            }
            ++wrong;
            ASSERT_EQ(result.exit_code, 3);
            ASSERT_FALSE(result.diagnostics.empty());
            ASSERT_LE(result.diagnostics.size(), static_cast<std::size_t>(kMaxDiagnostics));
            const auto lines = static_cast<int>(std::count(damaged.begin(), damaged.end(), '\n')) + 1;
            for (const Diagnostic& diagnostic : result.diagnostics) {
                ASSERT_FALSE(diagnostic.message.empty());
                ASSERT_LE(diagnostic.at.line, lines);
                ASSERT_GE(diagnostic.at.column, diagnostic.at.line > 0 ? 1 : 0);
            }
        }
    }
    EXPECT_GT(valid, 100);
    EXPECT_GT(wrong, 1000);
}

TEST(Stl, DamagedFilesGiveFiniteTrianglesOrAFault) {
    constexpr int kRounds = 3000;
    int good = 0, faults = 0;
    Random random(20240301);
    const std::vector<std::string> texts = texts_with(".stl");
    ASSERT_FALSE(texts.empty());
    for (int round = 0; round < kRounds; ++round) {
        const std::string damaged = mutated(texts[below(random, texts.size())], random);
        std::vector<Triangle> triangles;
        const auto fault =
            scene_file::read_stl(scene_file::SourceText("damaged.stl", damaged), kMaxTriangles, triangles);
        (fault ? faults : good) += 1;
        for (const Triangle& t : triangles) {
            for (const double x : {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z}) {
                ASSERT_LE(std::abs(x), kMaxCoordinate) << damaged;
            }
        }
        ASSERT_LE(triangles.size(), static_cast<std::size_t>(kMaxTriangles));
    }
    EXPECT_GT(good, 30);
    EXPECT_GT(faults, 1000);
}

}  // namespace
}  // namespace zerkalo
