// What is wrong with a file as a whole, and which exit code it has.
#include "tests/scene_file/bad_scene.hpp"

#include <filesystem>
#include <fstream>

namespace zerkalo {
namespace {

std::filesystem::path written(const std::string& name, const std::string& text) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

std::string message_of(const LoadResult& result) {
    return result.diagnostics.empty() ? "" : result.diagnostics[0].message;
}

TEST(SceneFile, UnreadableFilesHaveExitCodeOne) {
    const LoadResult missing = load_scene("/no/such/scene.toml");
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_EQ(to_text(missing), "/no/such/scene.toml: error: cannot read it: No such file or directory\n");
    const LoadResult directory = load_scene(testing::TempDir());
    EXPECT_EQ(directory.exit_code, 1);
    EXPECT_EQ(message_of(directory), "cannot read it: Is a directory");
}

TEST(SceneFile, FilesAboveOneMebibyteAreRefused) {
    const std::string fill = "#" + std::string(kMaxSceneFileSize - kHead.size() - 2, 'x') + "\n";
    const auto full = written("zerkalo_full.toml", kHead + fill);
    EXPECT_TRUE(load_scene(full).ok());
    const auto over = written("zerkalo_over.toml", kHead + fill + "\n");
    const LoadResult result = load_scene(over);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(message_of(result), "a scene file has at most 1 MiB (1048576 bytes)");
    EXPECT_EQ(message_of(load_text(kHead + fill + "\n")), message_of(result));
    EXPECT_EQ(load_scene("/dev/zero").exit_code, 3);
    std::filesystem::remove(full);
    std::filesystem::remove(over);
}

TEST(SceneFile, TextNestedDeeperThanSixtyFourIsRefusedWhateverItsLength) {
    const BadScene cases[] = {
        {kHead + "title = " + std::string(64, '[') + "^[1" + std::string(65, ']') + "\n",
         "nested deeper than 64 levels", ""},
    };
    for (const BadScene& bad : cases) expect_one_error(bad);
    std::string keys = "[a";
    for (int i = 0; i < 500000; ++i) keys += ".a";
    EXPECT_EQ(message_of(load_text(keys + "]\n")), "nested deeper than 64 levels");
    EXPECT_EQ(message_of(load_text("a = " + std::string(1000000, '['))), "nested deeper than 64 levels");
    EXPECT_EQ(message_of(load_text("a = " + std::string(1000000, '{'))), "nested deeper than 64 levels");
}

TEST(SceneFile, MoreThanTheCapacityIsAnErrorThatNamesTheLimit) {
    const std::string light = "[[light]]\nposition = [0, 0, 0]\n";
    const std::string solid = "[[solid]]\nkind = 'sphere'\nradius = 1\nposition = [0, 0, 0]\n";
    const std::string mirror =
        "[[mirror]]\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\nboundary = { shape = 'disc', radius = 1 }\n";
    const struct {
        std::string table, message;
        int limit;
    } cases[] = {
        {light, "a scene holds at most 8 tables [[light]], here are 9", kMaxLights},
        {solid, "a scene holds at most 32 tables [[solid]], here are 33", kMaxSolids},
        {mirror, "a scene holds at most 8 tables [[mirror]], here are 9", kMaxMirrors},
    };
    for (const auto& over : cases) {
        std::string text = kHead;
        for (int i = 0; i < over.limit; ++i) text += over.table;
        expect_one_error({text + "^" + over.table, over.message, ""});
    }
}

TEST(SceneFile, EmptyTextMissesEverythingThatIsRequired) {
    for (const std::string text : {"", "\n", "# nothing", "\xef\xbb\xbf"}) {
        const LoadResult result = load_text(text);
        EXPECT_EQ(result.exit_code, 3);
        EXPECT_EQ(result.diagnostics.size(), 3u) << to_text(result);
    }
}

TEST(SceneFile, RelativeStlPathsBeginAtTheSceneFile) {
    const std::filesystem::path directory = std::filesystem::path(testing::TempDir()) / "zerkalo_beside";
    std::filesystem::create_directories(directory);
    std::filesystem::copy_file(ZERKALO_SOURCE_DIR "/firmware/scenes/gem.stl", directory / "g.stl",
                               std::filesystem::copy_options::overwrite_existing);
    std::ofstream(directory / "scene.toml")
        << kHead << "[[solid]]\nkind = 'mesh'\nposition = [0, 0, 0]\nstl = 'g.stl'\n";
    const LoadResult result = load_scene(directory / "scene.toml");
    EXPECT_TRUE(result.ok()) << to_text(result);
    std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace zerkalo
