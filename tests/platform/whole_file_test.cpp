// A file appears whole or not at all, whatever happens on the way. Every law holds for both kinds of draft.
#include "platform/whole_file.hpp"

#include "tests/platform/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace zerkalo {
namespace {

using Names = std::vector<std::string>;

class WholeFileBy : public testing::TestWithParam<Draft> {};

INSTANTIATE_TEST_SUITE_P(Drafts, WholeFileBy, testing::Values(Draft::unnamed, Draft::named),
                         [](const auto& info) { return info.param == Draft::unnamed ? "unnamed" : "named"; });

IoStatus write_text(WholeFile& file, const std::string& text) { return file.write(text.data(), text.size()); }

TEST_P(WholeFileBy, AppearsOnlyWhenCommitted) {
    const ScratchFolder folder;
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "out").c_str(), GetParam()).ok());
    ASSERT_TRUE(write_text(file, "one ").ok());
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    ASSERT_TRUE(write_text(file, "two").ok());
    ASSERT_TRUE(file.commit(Durability::flushed).ok());
    EXPECT_EQ(folder.names(), (Names{"out"}));
    EXPECT_EQ(content_of(folder / "out"), "one two");
}

TEST_P(WholeFileBy, WithoutCommitNothingIsLeftAndTheOldFileStays) {
    const ScratchFolder folder;
    put_content(folder / "old", "old");
    for (const char* name : {"old", "new"}) {
        WholeFile file;
        ASSERT_TRUE(file.open((folder / name).c_str(), GetParam()).ok());
        ASSERT_TRUE(write_text(file, "unfinished").ok());
    }
    EXPECT_EQ(folder.names(), (Names{"old"}));
    EXPECT_EQ(content_of(folder / "old"), "old");
}

TEST_P(WholeFileBy, ReplacedFileKeepsItsPermissionsAndANewOneHasTheUsual) {
    const ScratchFolder folder;
    put_content(folder / "old", "a longer text than the new one");
    ASSERT_EQ(::chmod((folder / "old").c_str(), 0604), 0);
    const mode_t mask = ::umask(027);
    for (const std::string name : {"old", "new"}) {
        WholeFile file;
        ASSERT_TRUE(file.open((folder / name).c_str(), GetParam()).ok());
        ASSERT_TRUE(write_text(file, "text").ok());
        ASSERT_TRUE(file.commit().ok());
        struct stat info {};
        ASSERT_EQ(::stat((folder / name).c_str(), &info), 0);
        EXPECT_EQ(info.st_mode & 07777u, name == "old" ? 0604u : 0640u) << name;
        EXPECT_EQ(content_of(folder / name), "text") << name;
    }
    ::umask(mask);
}

TEST_P(WholeFileBy, LinkIsFollowedNotReplaced) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "elsewhere");
    put_content(folder / "elsewhere/file", "old");
    std::filesystem::create_symlink("elsewhere/file", folder / "link");
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "link").c_str(), GetParam()).ok());
    ASSERT_TRUE(write_text(file, "new").ok());
    ASSERT_TRUE(file.commit().ok());
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(content_of(folder / "elsewhere/file"), "new");
}

TEST_P(WholeFileBy, WorksInTheCurrentFolder) {
    const ScratchFolder folder;
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder / ".");
    WholeFile file;
    EXPECT_TRUE(file.open("out", GetParam()).ok());
    EXPECT_TRUE(write_text(file, "text").ok());
    EXPECT_TRUE(file.commit().ok());
    std::filesystem::current_path(before);
    EXPECT_EQ(content_of(folder / "out"), "text");
}

TEST_P(WholeFileBy, TakenDraftNamesAreStepped) {
    const ScratchFolder folder;
    const std::string taken = ".zerkalo-" + std::to_string(::getpid()) + "-0";
    put_content(folder / taken, "somebody else's");
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "out").c_str(), GetParam()).ok());
    ASSERT_TRUE(write_text(file, "text").ok());
    ASSERT_TRUE(file.commit().ok());
    EXPECT_EQ(folder.names(), (Names{taken, "out"}));
    EXPECT_EQ(content_of(folder / taken), "somebody else's");
}

// The limit on file size stands for a full disk: the write fails half way, with the file open.
TEST_P(WholeFileBy, LeavesNothingOnAFullDisk) {
    const ScratchFolder folder;
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit tight{10000, before.rlim_max};
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "out.png").c_str(), GetParam()).ok());
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const std::string text(6000, 'x');
    const IoStatus first = write_text(file, text), second = write_text(file, text), third = write_text(file, "x");
    const IoStatus last = file.commit();
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_TRUE(first.ok());
    EXPECT_EQ(second.text, folder / "out.png" + ": cannot write: File too large");
    EXPECT_STREQ(third.text, second.text);
    EXPECT_STREQ(last.text, second.text);
    EXPECT_EQ(folder.names(), Names{});
}

TEST_P(WholeFileBy, LeavesNothingWhenTheTargetBecomesAFolder) {
    const ScratchFolder folder;
    WholeFile file;
    ASSERT_TRUE(file.open((folder / "out").c_str(), GetParam()).ok());
    std::filesystem::create_directory(folder / "out");
    EXPECT_EQ(file.commit().text, folder / "out" + ": cannot rename the finished file: Is a directory");
    EXPECT_EQ(folder.names(), (Names{"out"}));
}

// On a file system that is sure to have unnamed files.
TEST(WholeFile, KilledProgramLeavesNothing) {
    const ScratchFolder folder("/dev/shm");
    const std::string path = folder / "out";
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        WholeFile file;
        if (file.open(path.c_str()).ok() && file.write("text", 4).ok()) ::raise(SIGKILL);
        ::_exit(1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(folder.names(), Names{});
}

TEST(WholeFile, BadTargetsAreRefusedAtOnce) {
    const ScratchFolder folder;
    put_content(folder / "file", "");
    std::filesystem::create_directory(folder / "folder");
    const struct {
        std::string path, reason;
    } cases[] = {
        {folder / "missing/out", "cannot write: No such file or directory"},
        {folder / "file/out", "cannot write: Not a directory"},
        {folder / "folder", "cannot write: Is a directory"},
        {folder / "folder/", "cannot write: Is a directory"},
        {folder / "missing/", "cannot write: Is a directory"},
        {folder / std::string(300, 'x'), "cannot write: File name too long"},
        {std::string(5000, 'x'), "cannot write: File name too long"},
        {"", "cannot write to an empty name: No such file or directory"},
    };
    for (const auto& wrong : cases) {
        WholeFile file;
        const std::string text = file.open(wrong.path.c_str()).text;
        const std::string end = ": " + wrong.reason;
        ASSERT_GE(text.size(), end.size()) << wrong.path;
        EXPECT_EQ(text.substr(text.size() - end.size()), end) << wrong.path;
        EXPECT_FALSE(file.write("x", 1).ok()) << wrong.path;
        EXPECT_FALSE(file.commit().ok()) << wrong.path;
    }
    EXPECT_EQ(folder.names(), (Names{"file", "folder"}));
}

// Root may write anything: the law is about everybody else.
TEST(WholeFile, FileWithoutWritePermissionIsNotReplaced) {
    const ScratchFolder folder;
    put_content(folder / "file", "old");
    ASSERT_EQ(::chmod((folder / "file").c_str(), 0444), 0);
    ASSERT_EQ(::chmod((folder / ".").c_str(), 0777), 0);
    const std::string path = folder / "file";
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        if (::getuid() == 0 && ::setresuid(65534, 65534, 65534) != 0) ::_exit(2);
        WholeFile file;
        const std::string text = file.open(path.c_str()).text;
        ::_exit(text == path + ": cannot write: Permission denied" ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(content_of(path), "old");
}

// Shown with a pipe of the test's own: no test may lay hands on a device of the machine.
TEST(WholeFile, PipesAndDevicesAreWrittenNotReplaced) {
    const ScratchFolder folder;
    const std::string path = folder / "pipe";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    WholeFile file;
    ASSERT_TRUE(file.open(path.c_str()).ok());
    EXPECT_TRUE(write_text(file, "text").ok());
    EXPECT_TRUE(file.commit().ok());
    char received[8] = "";
    EXPECT_EQ(::read(reader, received, sizeof received), 4);
    EXPECT_STREQ(received, "text");
    EXPECT_TRUE(std::filesystem::is_fifo(path));

    ASSERT_TRUE(file.open(path.c_str()).ok());
    ::close(reader);
    EXPECT_EQ(write_text(file, "text").text, path + ": cannot write: Broken pipe");
    EXPECT_TRUE(std::filesystem::is_fifo(path));
    EXPECT_EQ(folder.names(), (Names{"pipe"}));
}

TEST(WholeFile, DashIsStandardOutput) {
    const ScratchFolder folder;
    const int saved = ::dup(STDOUT_FILENO);
    std::FILE* captured = std::fopen((folder / "captured").c_str(), "wb");
    ASSERT_GE(::dup2(::fileno(captured), STDOUT_FILENO), 0);
    WholeFile file;
    const bool written = file.open("-").ok() && write_text(file, "text").ok() && file.commit().ok();
    {
        WholeFile dropped;
        (void)dropped.open("-");
    }
    const bool still_open = ::write(STDOUT_FILENO, "!", 1) == 1;
    ::dup2(saved, STDOUT_FILENO);
    ::close(saved);
    std::fclose(captured);
    EXPECT_TRUE(written);
    EXPECT_TRUE(still_open);
    EXPECT_EQ(content_of(folder / "captured"), "text!");
    EXPECT_EQ(folder.names(), (Names{"captured"}));
}

}  // namespace
}  // namespace zerkalo
