// Values: of the wrong type, outside their range, not numbers, too many or too few.
#include "tests/scene_file/bad_scene.hpp"

namespace zerkalo {
namespace {

const std::string kSphere = "[[solid]]\nkind = 'sphere'\nposition = [0, 0, 0]\nradius = 1\n";
const std::string kFlat =
    "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = 'disc', radius = 1 }\n";
const std::string kAngleless = "[camera]\nposition = [0, 1, 5]\nview = [0, 0, -1]\n";

TEST(SceneFile, ValuesOfTheWrongTypeAreErrors) {
    const BadScene cases[] = {
        {kHead + kSphere + "diffuse = ^'much'\n", "\"diffuse\" must be a number from 0 to 1, not a string", ""},
        {kHead + kSphere + "diffuse = ^'0,7'\n", "\"diffuse\" must be a number", "write 0.7, without quotes"},
        {kHead + kSphere + "diffuse = ^true\n", "not a truth value", ""},
        {kHead + kSphere + "diffuse = ^1979-05-27\n", "not a date or time", ""},
        {kHead + kSphere + "diffuse = ^[0.7]\n", "not an array", ""},
        {kHead + kSphere + "diffuse = ^{ r = 1 }\n", "not a table", ""},
        {kHead + kSphere + "color = ^'#ff0000'\n", "\"color\" must be an array of 3 numbers, not a string", ""},
        {kHead + kSphere + "color = [0.5, ^'a', 0.5]\n",
         "number 2 of \"color\" must be a number from 0 to 1, not a string", ""},
        {kHead + kSphere + "transmission = 1\nfresnel = ^1\n", "\"fresnel\" must be true or false, not 1", ""},
        {kHead + "title = ^5\n", "\"title\" must be a string in quotes, not 5", ""},
        {"version = 1\nimage = { width = ^640.0, height = 480 }\n" + kCamera,
         "must be a whole number from 1 to 65536, not 640", ""},
        {"version = 1\nimage = { width = ^'640', height = 480 }\n" + kCamera, "not a string",
         "write 640, without quotes"},
        {"version = ^2\nimage = 7\n", "\"version\" must be 1", ""},
        {"version = ^1.0\nimage = 7\n", "\"version\" must be 1", ""},
        {kHead + "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = ^'disc'\n",
         "\"boundary\" must be a table", "for example"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, UnknownWordsAreErrorsWithTheNearestSuggestion) {
    const BadScene cases[] = {
        {kHead + "[[solid]]\nkind = ^'spher'\nposition = [0, 0, 0]\nradius = 1\n", "unknown kind \"spher\"",
         "\"sphere\"?"},
        {kHead + "[[solid]]\nkind = ^'torus'\nposition = [0, 0, 0]\nradius = 1\n", "unknown kind \"torus\"",
         "it is one of: pyramid, prism, sphere, cylinder, cone, mesh"},
        {kHead + "[[light]]\nposition = [0, 0, 0]\nfalloff = ^'inverse square'\n", "unknown falloff",
         "\"inverse_square\"?"},
        {kHead + kFlat + "lobe = ^'maxphong'\n", "unknown lobe", "\"max_phong\"?"},
        {kHead + kFlat + "lobe = ^'gxx'\n", "unknown lobe \"gxx\"", "\"ggx\"?"},
        {kHead + kFlat + "lobe = ^'beckmann'\n", "unknown lobe", "it is one of: phong, max_phong, ggx"},
        {kHead + "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = ^'circle', radius = 1 }\n",
         "unknown shape \"circle\"", "rectangle, disc, ellipse, polygon"},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, NumbersOutsideTheirRangeAreErrors) {
    const BadScene cases[] = {
        {kHead + kSphere + "diffuse = ^1.5\n", "\"diffuse\" must be a number from 0 to 1, not 1.5", ""},
        {kHead + kSphere + "ambient = ^-0.1\n", "\"ambient\" must be a number from 0 to 1, not -0.1", ""},
        {kHead + kSphere + "specular = ^nan\n", "\"specular\" must be a number from 0 to 1, not nan", ""},
        {kHead + kSphere + "color = [^255, 0, 0]\n", "number 1 of \"color\" must be a number from 0 to 1, not 255", ""},
        {kHead + kSphere + "shininess = ^-1\n", "\"shininess\" must be a finite number, 0 or above, not -1", ""},
        {kHead + kSphere + "shininess = ^inf\n", "\"shininess\" must be a finite number, 0 or above, not inf", ""},
        {kHead + kSphere + "refractive_index = ^0\n", "\"refractive_index\" must be a finite number above 0, not 0",
         ""},
        {kHead + kSphere + "reflection = 0.6\ntransmission = ^0.5\n", "together must be at most 1", ""},
        {kHead + kSphere + "fresnel = ^true\n", "\"fresnel\" is for a solid that transmits light", "\"transmission\""},
        {kHead + kSphere + "fresnel = true\ntransmission = ^1.5\n", "\"transmission\" must be a number from 0 to 1",
         ""},
        {kHead + kSphere + "rotate_deg = [0, ^inf, 0]\n",
         "number 2 of \"rotate_deg\" must be a number of degrees from -1e7 to 1e7, not inf", ""},
        {kHead + "[[solid]]\nkind = 'sphere'\nposition = [0, 0, ^2e15]\nradius = 1\n", "from -1e15 to 1e15, not 2e+15",
         ""},
        {kHead + "[[solid]]\nkind = 'sphere'\nposition = [0, 0, 0]\nradius = ^0\n",
         "\"radius\" must be a number above 0, at most 1e15, not 0", ""},
        {kHead + "[[solid]]\nkind = 'prism'\nposition = [0, 0, 0]\nradius = 1\nheight = 1\nsides = ^2\n",
         "3 to 64, not 2", ""},
        {kHead + "[[solid]]\nkind = 'prism'\nposition = [0, 0, 0]\nradius = 1\nheight = 1\nsides = ^65\n",
         "3 to 64, not 65", ""},
        {kHead + "[[solid]]\nkind = 'prism'\nposition = [0, 0, 0]\nradius = 1\nheight = ^-1\nsides = 3\n", "\"height\"",
         ""},
        {kHead + "[[solid]]\nkind = 'cone'\nposition = [0, 0, 0]\nradius = 1\nheight = 1\ntaper = ^-0.1\n", "\"taper\"",
         ""},
        {kHead + "[[solid]]\nkind = 'mesh'\nposition = [0, 0, 0]\nstl = 'gem.stl'\nscale = ^0\n", "\"scale\"", ""},
        {kHead + "ambient = [1, 1, ^-1]\n", "number 3 of \"ambient\" must be a finite number, 0 or above, not -1", ""},
        {kHead + "[[light]]\nposition = [0, 0, 0]\nintensity = ^-2\n",
         "\"intensity\" must be a finite number, 0 or above", ""},
        {kHead + "[[light]]\nposition = [0, 0, 0]\ncolor = [1, ^inf, 1]\n", "number 2 of \"color\"", ""},
        {kHead + "[[light]]\nposition = [0, ^nan, 0]\n", "number 2 of \"position\"", ""},
        {kHead + kFlat + "polish = ^1.01\n", "\"polish\" must be a number from 0 to 1, not 1.01", ""},
        {kHead + kFlat + "lobe_exponent = ^-1\n", "\"lobe_exponent\" must be a number, 0 or above, or inf", ""},
        {kHead + kFlat + "curvature_radius = ^0\n", "\"curvature_radius\" must not be 0", "write inf"},
        {kHead + kFlat + "curvature_radius = ^nan\n", "\"curvature_radius\" must be a number other than 0", ""},
        {kTop + kAngleless + "vertical_fov_deg = ^0\n", "\"vertical_fov_deg\" must be an angle above 0 and below 180",
         ""},
        {kTop + kAngleless + "horizontal_fov_deg = ^180\n",
         "\"horizontal_fov_deg\" must be an angle above 0 and below 180", ""},
        {kTop + kAngleless + "vertical_fov_deg = 40\nturn_deg = [0, 0, ^nan]\n", "number 3 of \"turn_deg\"", ""},
        {"version = 1\nimage = { width = ^0, height = 480 }\n" + kCamera, "from 1 to 65536, not 0", ""},
        {"version = 1\nimage = { width = 1, height = ^65537 }\n" + kCamera, "from 1 to 65536, not 65537", ""},
        {"version = 1\nimage = { width = ^65536, height = 8192 }\n" + kCamera,
         "at most 268435456 pixels, not 536870912", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, DirectionsAreNotZero) {
    const BadScene cases[] = {
        {kTop + "[camera]\nposition = [0, 0, 0]\nview = ^[0, 0, 0]\nvertical_fov_deg = 40\n", "\"view\" is a direction",
         ""},
        {kTop + kAngleless + "vertical_fov_deg = 40\nup = ^[0, 0.0, -0.0]\n", "\"up\" is a direction", ""},
        {kTop + "[camera]\nposition = [1, 2, 3]\nlook_at = ^[1, 2, 3]\nvertical_fov_deg = 40\n", "own position", ""},
        {kHead + "[[mirror]]\nposition = [0, 0, 0]\nnormal = ^[0, 0, 0]\nboundary = { shape = 'disc', radius = 1 }\n",
         "\"normal\" is a direction", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

TEST(SceneFile, ArraysHaveAsManyNumbersAsTheyNeed) {
    const std::string polygon =
        "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n[mirror.boundary]\nshape = 'polygon'\n";
    const BadScene cases[] = {
        {kHead + kSphere + "color = ^[1, 1]\n", "\"color\" needs 3 numbers, here are 2", ""},
        {kHead + kSphere + "color = ^[1, 1, 1, 1]\n", "\"color\" needs 3 numbers, here are 4", ""},
        {kHead + kSphere + "color = ^[0,8, 1, 0]\n", "\"color\" needs 3 numbers, here are 4",
         "write 0.8, with a point"},
        {kHead + kSphere + "rotate_deg = ^[0, -1,5, 0]\n", "needs 3 numbers, here are 4", "write -1.5, with a point"},
        {kHead + polygon + "points = ^[[0, 0], [1, 0]]\n", "\"points\" must be 3 to 16 corners [x, y], not 2", ""},
        {kHead + polygon + "points = [[0, 0], [1, 0], ^[1, 1, 1]]\n",
         "corner 3 of \"points\" needs 2 numbers, here are 3", ""},
        {kHead + polygon + "points = [[0, 0], [1, 0], [1, ^inf]]\n", "number 2 of corner 3", ""},
        {kHead + polygon + "points = ^'square'\n", "\"points\" must be 3 to 16 corners [x, y], not a string", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

}  // namespace
}  // namespace zerkalo
