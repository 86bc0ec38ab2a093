// A table of wrong scene files: each text holds a '^' directly before the place that the error must point to.
#pragma once

#include "tools/scene_file/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace zerkalo {

struct BadScene {
    std::string text;     // with the mark
    std::string message;  // a part of the error's message
    std::string help;     // a part of its help; "" when there must be none
};

inline const std::string kTop = "version = 1\nimage = { width = 8, height = 6 }\n";
inline const std::string kCamera = "camera = { position = [0, 1, 5], look_at = [0, 0, 0], vertical_fov_deg = 40 }\n";
inline const std::string kHead = kTop + kCamera;

/// The scene with these lines and nothing else.
inline LoadResult load_text(const std::string& text) {
    return load_scene_text(text, "scene.toml", ZERKALO_SOURCE_DIR "/firmware/scenes");
}

/// Exactly one error, at the mark, with this message and help, exit code 3, and no scene.
inline void expect_one_error(const BadScene& bad) {
    SCOPED_TRACE(bad.text);
    const std::size_t mark = bad.text.find('^');
    ASSERT_NE(mark, std::string::npos) << "the text has no mark";
    std::string text = bad.text;
    text.erase(mark, 1);
    const std::string before = text.substr(0, mark);
    const std::size_t line_start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
    const auto line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
    const auto is_first_byte = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    const auto column = static_cast<int>(std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start),
                                                       before.end(), is_first_byte)) +
                        1;
    const LoadResult result = load_text(text);
    EXPECT_FALSE(result.ok());
    EXPECT_EQ(result.exit_code, 3);
    ASSERT_EQ(result.diagnostics.size(), 1u) << to_text(result);
    const Diagnostic& found = result.diagnostics[0];
    EXPECT_EQ(found.file, "scene.toml");
    EXPECT_EQ(found.at.line, line) << to_text(result);
    EXPECT_EQ(found.at.column, column) << to_text(result);
    EXPECT_NE(found.message.find(bad.message), std::string::npos) << to_text(result);
    EXPECT_EQ(found.help.empty(), bad.help.empty()) << to_text(result);
    EXPECT_NE(found.help.find(bad.help), std::string::npos) << to_text(result);
}

}  // namespace zerkalo
