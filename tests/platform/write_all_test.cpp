// Writing to the end, and the two signals that must not end the program.
#include "platform/write_all.hpp"

#include "tests/platform/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace zerkalo {
namespace {

TEST(WriteAll, WaitsForANonBlockingPipe) {
    int ends[2];
    ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
    std::string sent(1 << 20, '\0');
    for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<char>(i % 251);
    std::string received;
    std::thread reader([&] {
        char buffer[4096];
        while (received.size() < sent.size()) {
            const ssize_t size = ::read(ends[0], buffer, sizeof buffer);
            if (size > 0)
                received.append(buffer, static_cast<std::size_t>(size));
            else
                ::usleep(1000);
        }
    });
    EXPECT_EQ(write_all(ends[1], sent.data(), sent.size()), 0);
    reader.join();
    EXPECT_TRUE(received == sent);
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(WriteAll, ClosedPipeIsAValueNotASignal) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    EXPECT_EQ(write_all(ends[1], "x", 1), EPIPE);
    sigset_t pending;
    sigpending(&pending);
    EXPECT_EQ(sigismember(&pending, SIGPIPE), 0) << "the signal would come later";
    ::close(ends[1]);
}

TEST(WriteAll, SizeLimitIsAValueNotASignal) {
    const ScratchFolder folder;
    const int file = ::open((folder / "limited").c_str(), O_CREAT | O_WRONLY, 0600);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit tight{1000, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const std::string data(5000, 'x');
    const int error = write_all(file, data.data(), data.size());
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_EQ(error, EFBIG);
    ::close(file);
}

TEST(WriteAll, FullDeviceIsNamedByItsError) {
    const int file = ::open("/dev/full", O_WRONLY);
    ASSERT_GE(file, 0);
    EXPECT_EQ(write_all(file, "x", 1), ENOSPC);
    ::close(file);
}

}  // namespace
}  // namespace zerkalo
