// The console is left alone where it is none. The real one is tested on a real framebuffer: tests/vm.
#include "platform/console.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace zerkalo {
namespace {

TEST(Console, UntouchedOpensNothing) {
    Console console;
    EXPECT_TRUE(console.take(ConsoleMode::untouched, "/nowhere").ok());
}

TEST(Console, MissingDeviceIsNamed) {
    Console console;
    EXPECT_STREQ(console.take(ConsoleMode::cursor_off, "/nowhere").text,
                 "/nowhere: cannot open the console: No such file or directory");
}

// A serial line or a terminal window must not get escapes meant for a virtual terminal.
TEST(Console, TerminalThatIsNotVirtualGetsNoEscapes) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_GE(master, 0);
    ASSERT_EQ(::grantpt(master), 0);
    ASSERT_EQ(::unlockpt(master), 0);
    const std::string name = ::ptsname(master);
    const int slave = ::open(name.c_str(), O_RDWR | O_NOCTTY);  // keeps what is sent, if anything is
    for (const ConsoleMode mode : {ConsoleMode::cursor_off, ConsoleMode::graphics}) {
        Console console;
        const std::string text = console.take(mode, name.c_str()).text;
        EXPECT_EQ(text.rfind(name + ": not a virtual terminal: ", 0), 0u) << text;
    }
    char byte;
    EXPECT_EQ(::read(master, &byte, 1), -1) << "the terminal was sent " << byte;
    ::close(slave);
    ::close(master);
}

}  // namespace
}  // namespace zerkalo
