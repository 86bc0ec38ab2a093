// Keys and tables: unknown, missing, in the wrong place, given twice.
#include "tests/scene_file/bad_scene.hpp"

namespace zerkalo {
namespace {

const std::string kSolidAt = "[[solid]]\nposition = [0, 0, 0]\n";
const std::string kMirrorAt = "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string kDisc = "boundary = { shape = 'disc', radius = 1 }\n";

TEST(SceneFile, UnknownKeysAreErrorsWithTheNearestSuggestion) {
    const BadScene cases[] = {
        {kHead + "^backround = [0, 0, 0]\n", "unknown key \"backround\"", "did you mean \"background\"?"},
        {kHead + "[[^lights]]\nposition = [0, 0, 0]\n", "unknown key \"lights\"", "did you mean \"light\"?"},
        {kTop + "[camera]\nposition = [0, 1, 5]\nview = [0, 0, -1]\nvertical_fov_deg = 40\n^lookat = [0, 0, 0]\n",
         "unknown key \"lookat\"", "did you mean \"look_at\"?"},
        {kTop + "[camera]\nposition = [0, 1, 5]\nview = [0, 0, -1]\nvertical_fov_deg = 40\n^roll = 3\n",
         "unknown key \"roll\"", "the camera has: position, look_at, view, up"},
        {kHead + "[[light]]\nposition = [0, 0, 0]\n^colour = [1, 1, 1]\n", "unknown key \"colour\"", "\"color\"?"},
        {kHead + kSolidAt + "kind = 'sphere'\nradius = 1\n^rotate = [0, 0, 0]\n", "unknown key \"rotate\"",
         "\"rotate_deg\"?"},
        {kHead + kSolidAt + "kind = 'sphere'\nradius = 1\n^mass = 2\n", "unknown key \"mass\"",
         "a sphere has: kind, position, radius"},
        {kHead + kMirrorAt + kDisc + "^polsih = 0.5\n", "unknown key \"polsih\"", "did you mean \"polish\"?"},
        {kHead + kMirrorAt + "boundary = { shape = 'disc', radius = 1, ^raduis = 2 }\n", "unknown key", "\"radius\"?"},
        {"version = 1\nimage = { width = 8, height = 6, ^depth = 3 }\n" + kCamera, "unknown key \"depth\"",
         "width, height"},
        {kHead + "[[light]]\nposition = [0, 0, 0]\n^background = [1, 1, 1]\n",
         "\"background\" does not belong to a light", "before the first table"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, KeysOfAnotherKindAreErrors) {
    const BadScene cases[] = {
        {kHead + kSolidAt + "kind = 'sphere'\nradius = 1\n^height = 2\n", "\"height\" does not belong to a sphere",
         "radius"},
        {kHead + kSolidAt + "kind = 'sphere'\nradius = 1\n^sides = 4\n", "\"sides\" does not belong to a sphere",
         "radius"},
        {kHead + kSolidAt + "kind = 'prism'\nsides = 4\nradius = 1\nheight = 1\n^taper = 1\n",
         "does not belong to a prism", "sides"},
        {kHead + kSolidAt + "kind = 'cone'\nradius = 1\nheight = 1\n^sides = 9\n", "does not belong to a cone",
         "taper"},
        {kHead + kSolidAt + "kind = 'cylinder'\nradius = 1\nheight = 1\n^scale = 9\n", "does not belong to a cylinder",
         "taper"},
        {kHead + kSolidAt + "kind = 'mesh'\nstl = 'gem.stl'\n^radius = 9\n", "does not belong to a mesh", "stl"},
        {kHead + kMirrorAt + "boundary = { shape = 'disc', radius = 1, ^width = 2 }\n", "does not belong to a disc",
         "radius"},
        {kHead + kMirrorAt + "boundary = { shape = 'ellipse', width = 2, height = 1, ^radius = 2 }\n",
         "does not belong to an ellipse", "width"},
        {kHead + kMirrorAt + "boundary = { shape = 'rectangle', width = 2, height = 1, ^points = [] }\n",
         "does not belong to a rectangle", "width"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, RequiredKeysAreMissedAtTheirTablesHeader) {
    const BadScene cases[] = {
        {"^image = { width = 8, height = 6 }\n" + kCamera, "missing key \"version\": a scene needs it", ""},
        {"^version = 1\n" + kCamera, "missing key \"image\"", ""},
        {"^" + kTop, "missing key \"camera\"", ""},
        {"version = 1\nimage = ^{ width = 8 }\n" + kCamera, "missing key \"height\": the image needs it", ""},
        {kTop + "^[camera]\nview = [0, 0, -1]\nvertical_fov_deg = 40\n",
         "missing key \"position\": the camera needs it", ""},
        {kTop + "^[camera]\nposition = [0, 0, 0]\nvertical_fov_deg = 40\n", "missing key \"look_at\" or \"view\"", ""},
        {kTop + "^[camera]\nposition = [0, 0, 0]\nview = [0, 0, -1]\n",
         "missing key \"horizontal_fov_deg\" or \"vertical_fov_deg\"", ""},
        {kHead + "^[[light]]\nintensity = 1\n", "missing key \"position\": a light needs it", ""},
        {kHead + "^[[solid]]\nposition = [0, 0, 0]\n", "missing key \"kind\": a solid needs it", ""},
        {kHead + "^[[solid]]\nkind = 'sphere'\nradius = 1\n", "missing key \"position\": a sphere needs it", ""},
        {kHead + "^" + kSolidAt + "kind = 'sphere'\n", "missing key \"radius\": a sphere needs it", ""},
        {kHead + "^" + kSolidAt + "kind = 'pyramid'\nradius = 1\nheight = 1\n",
         "missing key \"sides\": a pyramid needs it", ""},
        {kHead + "^" + kSolidAt + "kind = 'cone'\nradius = 1\n", "missing key \"height\": a cone needs it", ""},
        {kHead + "^" + kSolidAt + "kind = 'mesh'\n", "a mesh needs \"stl\", or \"vertices\" and \"triangles\"", ""},
        {kHead + "^" + kSolidAt + "kind = 'mesh'\nvertices = [[0, 0, 0]]\n", "missing key \"triangles\"", ""},
        {kHead + "^" + kMirrorAt, "missing key \"boundary\": a mirror needs it", ""},
        {kHead + "^[[mirror]]\nposition = [0, 0, 0]\n" + kDisc, "missing key \"normal\"", ""},
        {kHead + kMirrorAt + "boundary = ^{ radius = 1 }\n", "missing key \"shape\": a boundary needs it", ""},
        {kHead + kMirrorAt + "boundary = ^{ shape = 'rectangle', width = 1 }\n", "missing key \"height\": a rectangle",
         ""},
        {kHead + kMirrorAt + "^[mirror.boundary]\nshape = 'polygon'\n", "missing key \"points\": a polygon needs it",
         ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, ExclusiveKeysAreErrorsAtTheLaterOne) {
    const BadScene cases[] = {
        {kTop + "[camera]\nposition = [0, 0, 0]\nview = [0, 0, -1]\n^look_at = [0, 0, -1]\nvertical_fov_deg = 40\n",
         "\"look_at\" and \"view\" exclude each other", "keep one"},
        {kTop + "[camera]\nposition = [0, 0, 0]\nview = [0, 0, -1]\nvertical_fov_deg = 40\n^horizontal_fov_deg = 50\n",
         "\"horizontal_fov_deg\" and \"vertical_fov_deg\" exclude each other", "keep one"},
        {kHead + kMirrorAt + kDisc + "lobe_exponent = 9\n^polish = 0.5\n", "\"polish\" and \"lobe_exponent\" exclude",
         "keep one"},
        {kHead + kSolidAt + "kind = 'mesh'\nstl = 'gem.stl'\n^vertices = []\n", "\"stl\" and \"vertices\" exclude",
         "keep one"},
        {kHead + kSolidAt + "kind = 'mesh'\nstl = 'gem.stl'\n^triangles = []\n", "\"stl\" and \"triangles\" exclude",
         "keep one"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, SingleAndDoubleBracketsAreToldApart) {
    const BadScene cases[] = {
        {kHead + "^[light]\nposition = [0, 0, 0]\n", "\"light\" must be a list of tables, not a table",
         "write [[light]]"},
        {kHead + "^[solid]\nkind = 'sphere'\n", "\"solid\" must be a list of tables, not a table", "write [[solid]]"},
        {kHead + "[light]\nposition = [0, 0, 0]\n^[light]\n", "cannot redefine existing table 'light'", "[[light]]"},
        {kTop + "^[[camera]]\nposition = [0, 0, 0]\n", "\"camera\" must be one table, not a list of tables",
         "write [camera]"},
        {kHead + "mirror = ^3\n", "\"mirror\" must be a list of tables, not 3", "write [[mirror]]"},
        {kHead + "mirror = [^3]\n", "every mirror must be a table, not 3", "write [[mirror]]"},
        {"version = 1\nimage = ^'640x480'\n" + kCamera, "\"image\" must be one table, not a string", "write [image]"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

}  // namespace
}  // namespace zerkalo
