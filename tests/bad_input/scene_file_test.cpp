// Bad numbers in scene files: one at a time and in pairs, every text becomes a scene with a finite picture, or one
// diagnostic a wrong number, which names its key and its place.
#include "tools/scene_file/scene_file.hpp"
#include "tests/bad_input/scene_text.hpp"
#include "tests/bad_input/verdict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>

namespace zerkalo::bad_input {
namespace {

constexpr const char* kLiterals[] = {"nan",   "inf",  "-inf", "5e-324", "1.7976931348623157e308",
                                     "1e-40", "0.0",  "-0.0", "-1.0",   "1e30",
                                     "1e-30", "1e15", "0",    "-1",     "9223372036854775807"};

// Without ZERKALO_ALL_PAIRS in the environment so many pairs a text are drawn; with it all are tried.
constexpr int kPairs = 4000;
constexpr unsigned kSeed = 20261123;
constexpr int kShownFailures = 20;

/// Rules that bind two keys: the other one may be named.
struct Bond {
    const char* changed;
    const char* named;
};
constexpr Bond kBonds[] = {{"height", "width"},
                           {"width", "curvature_radius"},
                           {"height", "curvature_radius"},
                           {"radius", "curvature_radius"},
                           {"points", "curvature_radius"},
                           {"vertices", "triangles"},
                           {"reflection", "transmission"},
                           {"transmission", "reflection"},
                           {"position", "move"},
                           {"position", "look_at"},
                           {"look_at", "position"}};

bool speaks_of(const Diagnostic& diagnostic, const std::string& key) {
    const std::string& message = diagnostic.message;
    return message.find('"' + key + '"') != std::string::npos || message.find('.' + key + '"') != std::string::npos;
}

bool names(const Diagnostic& diagnostic, const NumberToken& token) {
    if (speaks_of(diagnostic, token.key) && diagnostic.at.line == token.line) return true;
    return std::any_of(std::begin(kBonds), std::end(kBonds), [&](const Bond& bond) {
        return token.key == bond.changed && speaks_of(diagnostic, bond.named);
    });
}

/// "" when all is well; else what is wrong.
std::string verdict(Judge& judge, const SceneText& text, const std::vector<Replacement>& changes, int& refused) {
    const LoadResult result = load_scene_text(replaced(text, changes), text.name, ".");
    if (result.ok()) return judge.verdict(*result.scene, {});
    ++refused;
    if (result.exit_code != 3) return "exit code " + std::to_string(result.exit_code);
    if (result.diagnostics.empty()) return "no diagnostic";
    if (result.diagnostics.size() > changes.size()) return "too many diagnostics: " + to_text(result);
    for (const Diagnostic& diagnostic : result.diagnostics) {
        const bool placed = diagnostic.file == text.name && diagnostic.at.line > 0 && diagnostic.at.column > 0;
        const bool named = std::any_of(changes.begin(), changes.end(),
                                       [&](const Replacement& change) { return names(diagnostic, *change.token); });
        if (!placed || !named) return "another key or place: " + to_text(result);
    }
    return "";
}

std::string text_of(const Replacement& change) {
    return std::to_string(change.token->line) + ":" + std::to_string(change.token->column) + " " + change.token->key +
           " = " + change.literal;
}

TEST(BadInput, OneBadNumberInAFileIsNamedWithItsPlaceOrGivesAFinitePicture) {
    for (const SceneText& text : scene_texts()) {
        Judge judge(Thoroughness::every_isa);
        int refused = 0;
        for (const NumberToken& token : text.numbers) {
            for (const char* literal : kLiterals) {
                const Replacement change{&token, literal};
                EXPECT_EQ(verdict(judge, text, {change}, refused), "") << text.name << ":" << text_of(change);
            }
        }
        EXPECT_GT(judge.accepted(), 100) << text.name;
        EXPECT_GT(refused, 100) << text.name;
    }
}

TEST(BadInput, TwoBadNumbersInAFileAreNamedWithTheirPlacesOrGiveAFinitePicture) {
    for (const SceneText& text : scene_texts()) {
        Judge judge(Thoroughness::one_other_isa);
        int refused = 0, failures = 0;
        const auto try_pair = [&](const Replacement& a, const Replacement& b) {
            const std::string fault = verdict(judge, text, {a, b}, refused);
            if (fault.empty() || ++failures > kShownFailures) return;
            ADD_FAILURE() << text.name << ":" << text_of(a) << ", " << text_of(b) << ": " << fault;
        };
        const std::vector<NumberToken>& numbers = text.numbers;
        if (std::getenv("ZERKALO_ALL_PAIRS") != nullptr) {
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                for (std::size_t j = i + 1; j < numbers.size(); ++j) {
                    for (const char* a : kLiterals) {
                        for (const char* b : kLiterals) try_pair({&numbers[i], a}, {&numbers[j], b});
                    }
                }
            }
        } else {
            std::mt19937 random(kSeed);
            const auto literal = [&random] { return kLiterals[random() % std::size(kLiterals)]; };
            for (int k = 0; k < kPairs; ++k) {
                const std::size_t i = random() % (numbers.size() - 1);
                const std::size_t j = i + 1 + random() % (numbers.size() - 1 - i);
                const char* a = literal();
                try_pair({&numbers[i], a}, {&numbers[j], literal()});
            }
        }
        EXPECT_EQ(failures, 0) << text.name;
        EXPECT_GT(judge.accepted(), kPairs / 10) << text.name;
        EXPECT_GT(refused, kPairs / 10) << text.name;
    }
}

/// The keys that the loader itself names when a table holds one that it does not know: "a sphere has: kind, ...".
std::vector<std::string> keys_offered(const std::string& text) {
    const LoadResult result = load_scene_text(text, "probe.toml", ".");
    std::vector<std::string> keys;
    for (const Diagnostic& diagnostic : result.diagnostics) {
        const std::size_t list = diagnostic.help.find(" has: ");
        if (diagnostic.message.find("\"zzz\"") == std::string::npos || list == std::string::npos) continue;
        std::string key;
        for (const char c : diagnostic.help.substr(list + 6) + ",") {
            if (c == ',') keys.push_back(std::exchange(key, ""));
            if (c != ',' && c != ' ') key += c;
        }
    }
    return keys;
}

TEST(BadInput, TheFilesHoldEveryKeyThatTakesANumber) {
    std::set<std::string> held{"title", "kind", "falloff", "stl", "lobe", "shape"};  // these take words,
    held.insert("fresnel");                                                          // this true or false,
    held.insert({"image", "camera", "light", "solid", "mirror", "boundary"});        // and these are tables
    for (const SceneText& text : scene_texts()) {
        for (const NumberToken& token : text.numbers) held.insert(token.key);
    }
    std::vector<std::string> probes{"version = 1\nzzz = 1\n", "version = 1\n[image]\nzzz = 1\n",
                                    "version = 1\n[camera]\nzzz = 1\n", "version = 1\n[[light]]\nzzz = 1\n",
                                    "version = 1\n[[mirror]]\nzzz = 1\n"};
    for (const char* kind : {"pyramid", "prism", "sphere", "cylinder", "cone", "mesh"}) {
        probes.push_back("version = 1\n[[solid]]\nkind = '" + std::string(kind) + "'\nzzz = 1\n");
    }
    for (const char* shape : {"rectangle", "disc", "ellipse", "polygon"}) {
        probes.push_back("version = 1\n[[mirror]]\nboundary = { shape = '" + std::string(shape) + "', zzz = 1 }\n");
    }
    for (const std::string& probe : probes) {
        const std::vector<std::string> keys = keys_offered(probe);
        EXPECT_GE(keys.size(), 2u) << probe;
        for (const std::string& key : keys) EXPECT_TRUE(held.count(key)) << key << " of " << probe;
    }
}

TEST(BadInput, TheFilesAreGoodAsTheyAre) {
    for (const SceneText& text : scene_texts()) {
        const LoadResult result = load_scene_text(text.text, text.name, ".");
        EXPECT_TRUE(result.ok()) << to_text(result);
        EXPECT_GT(text.numbers.size(), 50u) << text.name;
    }
}

}  // namespace
}  // namespace zerkalo::bad_input
