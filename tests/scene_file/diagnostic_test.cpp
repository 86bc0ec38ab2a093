// What the user reads.
#include "tests/scene_file/bad_scene.hpp"
#include "tools/scene_file/source_text.hpp"
#include "tools/scene_file/utf8.hpp"

namespace zerkalo {
namespace {

TEST(Diagnostic, ReadsLikeACompilersMessage) {
    const LoadResult result = load_text(
        "version = 1\n"
        "image = { width = 8, height = 6 }\n"
        "[camera]\n"
        "position = [0, 1, 5]\n"
        "\tlookat   = [0, 0, 0] # цель\n"
        "view = [0, 0, -1]\n"
        "vertical_fov_deg = 270\n");
    EXPECT_EQ(to_text(result),
              "scene.toml:5:2: error: unknown key \"lookat\"\n"
              "     lookat   = [0, 0, 0] # цель\n"
              "     ^~~~~~\n"
              "    help: did you mean \"look_at\"?\n"
              "scene.toml:7:20: error: \"vertical_fov_deg\" must be an angle above 0 and below 180 degrees, not 270\n"
              "    vertical_fov_deg = 270\n"
              "                       ^~~\n");
}

TEST(Diagnostic, IndependentErrorsAreAllReportedInTheOrderOfTheText) {
    const LoadResult result = load_text(kHead +
                                        "[[solid]]\nradius = -1\ncolour = 3\nkind = 'sphere'\nambient = 7\n"
                                        "[[light]]\nposition = [1, 2]\n[[mirror]]\nnormal = [0, 0, 0]\n");
    ASSERT_EQ(result.diagnostics.size(), 8u) << to_text(result);
    const int lines[] = {4, 5, 6, 8, 10, 11, 11, 12};
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(result.diagnostics[i].at.line, lines[i]) << to_text(result);
    EXPECT_EQ(result.more_errors, 0);
}

TEST(Diagnostic, AtMostTwentyErrorsAreShownAndTheOthersCounted) {
    std::string text = kHead;
    for (int i = 0; i < 30; ++i) text += "wrong_" + std::to_string(i) + " = 1\n";
    const LoadResult result = load_text(text);
    EXPECT_EQ(result.diagnostics.size(), 20u);
    EXPECT_EQ(result.more_errors, 10);
    EXPECT_NE(to_text(result).find("and 10 more errors\n"), std::string::npos);
}

TEST(Diagnostic, LongLinesAreShortenedAroundThePlace) {
    const std::string blanks(5000, ' ');
    const LoadResult result = load_text(kHead + "title =" + blanks + "7" + blanks + "# end\n");
    const std::string text = to_text(result);
    EXPECT_LT(text.size(), 400u);
    EXPECT_NE(text.find("    ...   "), std::string::npos) << text;
    EXPECT_NE(text.find("   ...\n"), std::string::npos) << text;
    const std::size_t caret = text.find("^\n");
    const std::size_t line = text.rfind('\n', caret);
    const std::size_t source = text.rfind('\n', line - 1);
    ASSERT_NE(caret, std::string::npos) << text;
    EXPECT_EQ(text[source + (caret - line)], '7') << text;
}

TEST(Diagnostic, CaretStandsUnderItsCharacterForEveryColumn) {
    for (const int size : {1, 99, 100, 101, 150, 400}) {
        for (int column = 1; column <= size; ++column) {
            std::string line;
            for (int i = 1; i < column; ++i) line += "ж";
            line += "X";
            for (int i = column; i < size; ++i) line += "ж";
            Diagnostic diagnostic{"f", {1, column, 1}, "m", {}, {}, 0};
            scene_file::attach_line(diagnostic, line);
            const auto shown = scene_file::characters_of(diagnostic.excerpt);
            ASSERT_LT(diagnostic.caret, static_cast<int>(shown.size())) << size << " " << column;
            ASSERT_EQ(shown[static_cast<std::size_t>(diagnostic.caret)], "X") << size << " " << column;
            ASSERT_LE(shown.size(), 106u);
        }
    }
}

TEST(Diagnostic, ControlCharactersAndStrayBytesAreNotPassedOn) {
    EXPECT_EQ(scene_file::printable("a\tb\x1b[31m\x7f\xffж\xc2\x9b"), "a b?[31m??ж?");
    const LoadResult result = load_text(kHead + "\"\\u001b[31mred\" = 1\n");
    EXPECT_EQ(to_text(result).find('\x1b'), std::string::npos);
    EXPECT_EQ(scene_file::in_quotes(std::string(100, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

TEST(SourceText, PositionsAndBytesAreInverse) {
    const scene_file::SourceText source("f", "ab\nжж\r\n\nend");
    const std::size_t starts[] = {0, 1, 3, 5, 9, 10, 12};
    for (const std::size_t byte : starts) {
        const Position at = source.position_at(byte);
        EXPECT_EQ(source.byte_at(at.line, at.column), byte) << byte;
    }
    EXPECT_EQ(source.position_at(5).line, 2);
    EXPECT_EQ(source.position_at(5).column, 2);
    EXPECT_EQ(source.line(2), "жж");
    EXPECT_EQ(source.line(4), "end");
    EXPECT_EQ(source.line(0), "");
    EXPECT_EQ(source.line(5), "");
}

}  // namespace
}  // namespace zerkalo
