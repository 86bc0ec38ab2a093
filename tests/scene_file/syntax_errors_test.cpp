// Text that is not TOML: the parser's complaint, and what to write where the slip is a common one.
#include "tests/scene_file/bad_scene.hpp"

namespace zerkalo {
namespace {

TEST(SceneFile, DecimalCommasAreNamed) {
    const BadScene cases[] = {
        {kHead + "[[light]]\nintensity = ^0,8\n", "a comma inside a number", "write 0.8, with a point"},
        {kHead + "[[light]]\nintensity = ^-12,75 # яркость\n", "a comma inside a number", "write -12.75, with a point"},
        {kHead + "[[light]]\ncolor = [^0,9 0,1 0,1]\n", "a comma inside a number", "write 0.9, with a point"},
        {kHead + "[[light]]\ncolor = [^0,9; 0,1; 0,1]\n", "a comma inside a number", "write 0.9, with a point"},
        {kHead + "[[mirror]]\nboundary = { shape = 'disc', radius = ^1,5 }\n", "a comma inside a number", "write 1.5"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, CommonSlipsAreToldWhatToWrite) {
    const BadScene cases[] = {
        {kHead + "[[solid]]\nkind = ^sphere\n", "could not determine value type", "words stand in quotes: \"sphere\""},
        {kHead + "[[light]]\nintensity = ^.8\n", "expected decimal digit", "write 0.8"},
        {kHead + "[[light]]\nintensity = 8.^\n", "expected decimal digit", "write 8.0"},
        {kHead + "[[mirror]]\ncurvature_radius = ^Infinity\n", "expected 'inf'", "write inf"},
        {kHead + "[[light]]\nposition = 1^, 2, 3\n", "expected a comment or whitespace", "numbers stand in brackets"},
        {kHead + "[[light]]\nposition^: 3\n", "expected '=', saw ':'", "write = between"},
        {kHead + "[[light]]\n^рosition = [1, 2, 3]\n", "saw 'р'", "Latin letters"},
        {kHead + "[[light]]\nintensity = 1\nintensity = ^2\n", "cannot redefine existing integer 'intensity'", "once"},
        {kHead + "title = \"no end^\n", "unescaped control characters", "a string ends with its quote"},
        {kHead + "[light^\n", "expected ']'", "a table begins with [name]"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, OtherTextThatIsNotTomlIsAnErrorWhereItStops) {
    const BadScene cases[] = {
        {kHead + "[^]\n", "blank bare keys", "a table begins with [name]"},
        {kHead + "[ ^=]\n", "expected bare key", ""},
        {kHead + "[[light]]\nintensity =^\n", "expected value", ""},
        {kHead + "[[light]]\nintensity = 1e^\n", "expected decimal digit", ""},
        {kHead + "[[light]]\nposition = [1, 2\n^color = 3\n", "expected comma or closing ']'", ""},
        {kHead + "[[light]]\nintensity = 1 ^intensity = 2\n", "expected a comment or whitespace", ""},
        {kHead + "[[light]]\nintensity = 99999999999999999999^\n", "not representable in 64 bits", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, TextThatIsNotUtf8IsAnErrorAtItsFirstByte) {
    const BadScene cases[] = {
        {kHead + "# ^\xd6\xe2\xe5\xf2 in Windows-1251\n", "not UTF-8", "save the file as UTF-8"},
        {"^\xff\xfev\0e\0", "not UTF-8", "UTF-16"},
        {kHead + "# ж^\xc0\xaf an overlong slash\n", "not UTF-8", "save"},
        {kHead + "# ^\xed\xa0\x80 half a surrogate pair\n", "not UTF-8", "save"},
        {kHead + "# ^\xf4\x90\x80\x80 above the last character\n", "not UTF-8", "save"},
        {kHead + "# ^\xe2\x82", "not UTF-8", "save"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

}  // namespace
}  // namespace zerkalo
