// What validate() refuses is shown where it was written.
#include "tests/scene_file/bad_scene.hpp"

namespace zerkalo {
namespace {

const std::string kMirrorAt = "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n";
const std::string kSecond =
    "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = 'disc', radius = 1 }\n" + kMirrorAt;
const std::string kMesh = "[[solid]]\nkind = 'mesh'\nposition = [0, 0, 0]\n";

TEST(SceneFile, WhatOnlyTheWholeSceneTellsIsShownAtItsKey) {
    const BadScene cases[] = {
        {kTop + "[camera]\nview = [0, 0, -1]\nposition = [1e15, 0, 0]\nmove = ^[1e15, 0, 0]\nvertical_fov_deg = 40\n",
         "\"move\" leads farther", ""},
        {kTop + "[camera]\nview = [0, 0, -1]\nposition = [0, 0, 0]\nvertical_fov_deg = ^5e-324\n",
         "\"vertical_fov_deg\" must", ""},
        {kHead + "[[light]]\nposition = [0, 0, 0]\n[[light]]\nmove = ^[-1e15, 0, 0]\nposition = [-1e15, 0, 0]\n",
         "\"move\" leads farther", ""},
        {kHead + kSecond + "curvature_radius = ^1\nboundary = { shape = 'disc', radius = 1 }\n",
         "\"curvature_radius\" must be greater", ""},
        {kHead + kSecond + "curvature_radius = ^-2\nboundary = { shape = 'rectangle', width = 4, height = 1 }\n",
         "\"curvature_radius\" must be greater", ""},
        {kHead + kMirrorAt + "boundary = { shape = 'polygon', points = ^[[0, 0], [2, 0], [0.1, 0.1], [0, 2]] }\n",
         "convex", ""},
        {kHead + kMirrorAt + "[mirror.boundary]\nshape = 'polygon'\npoints = ^[[0, 0], [1, 1], [2, 2]]\n", "convex",
         ""},
        {kHead + kMesh +
             "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
             "triangles = ^[[0, 2, 1], [0, 1, 3], [0, 3, 2], [0, 3, 2]]\n",
         "closed surface", ""},
        {kHead + kMesh +
             "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
             "triangles = ^[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]\n",
         "counter-clockwise", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
}

}  // namespace
}  // namespace zerkalo
