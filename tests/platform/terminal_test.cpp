// What a terminal shows after our output, found out by a small terminal of the test's own.
#include "platform/terminal.hpp"

#include "tests/platform/random_picture.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <sys/ioctl.h>
#include <unistd.h>

namespace zerkalo {
namespace {

using Color = std::array<int, 3>;
constexpr Color kDefault{-1, -1, -1};

struct Cell {
    Color upper = kDefault, lower = kDefault;
};

// Understands exactly what the driver may send: SGR 0, 38;2 and 48;2, cursor up and down, newline, half block, space.
class Screen {
public:
    void feed(const std::string& text) {
        for (std::size_t i = 0; i < text.size();) {
            if (text[i] == '\n') {
                EXPECT_TRUE(foreground_ == kDefault && background_ == kDefault)
                    << "colours at the end of line " << line_;
                ++line_;
                column_ = 0;
                ++i;
            } else if (text[i] == ' ') {
                put({background_, background_});
                ++i;
            } else if (text.compare(i, 3, "\xe2\x96\x80") == 0) {
                put({foreground_, background_});
                i += 3;
            } else {
                i = escape(text, i);
            }
        }
    }

    const std::map<std::pair<int, int>, Cell>& cells() const { return cells_; }
    int line() const { return line_; }
    int column() const { return column_; }

private:
    void put(const Cell& cell) { cells_[{line_, column_++}] = cell; }

    std::size_t escape(const std::string& text, std::size_t i) {
        int n[5] = {0, 0, 0, 0, 0};
        char end = 0;
        const std::size_t stop = text.find_first_of("mAB", i);
        if (stop == std::string::npos || text.compare(i, 2, "\033[") != 0) {
            ADD_FAILURE() << "unknown output at byte " << i;
            return text.size();
        }
        end = text[stop];
        const int count = std::sscanf(text.c_str() + i + 2, "%d;%d;%d;%d;%d", n, n + 1, n + 2, n + 3, n + 4);
        if (end == 'A')
            line_ -= n[0];
        else if (end == 'B')
            line_ += n[0];
        else if (count == 1 && n[0] == 0)
            foreground_ = background_ = kDefault;
        else if (count == 5 && n[0] == 38 && n[1] == 2)
            foreground_ = {n[2], n[3], n[4]};
        else if (count == 5 && n[0] == 48 && n[1] == 2)
            background_ = {n[2], n[3], n[4]};
        else
            ADD_FAILURE() << "unknown colour " << text.substr(i + 1, stop - i);
        return stop + 1;
    }

    std::map<std::pair<int, int>, Cell> cells_;
    int line_ = 0, column_ = 0;
    Color foreground_ = kDefault, background_ = kDefault;
};

// The driver writes into a pipe that is large enough for the test's pictures.
class Pipe {
public:
    Pipe() {
        EXPECT_EQ(::pipe2(ends_, O_NONBLOCK), 0);
        ::fcntl(ends_[1], F_SETPIPE_SZ, 1 << 20);
    }
    ~Pipe() {
        ::close(ends_[0]);
        ::close(ends_[1]);
    }
    int input() const { return ends_[1]; }
    std::string taken() {
        std::string text(1 << 20, '\0');
        const ssize_t size = ::read(ends_[0], text.data(), text.size());
        text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
        return text;
    }

private:
    int ends_[2] = {-1, -1};
};

void expect_shows(const Screen& screen, const SrgbPart& picture, unsigned seed) {
    const int lines = (picture.height + 1) / 2;
    ASSERT_EQ(screen.cells().size(), static_cast<std::size_t>(lines * picture.width)) << "seed " << seed;
    for (std::int32_t y = 0; y < 2 * lines; ++y)
        for (std::int32_t x = 0; x < picture.width; ++x) {
            const Cell& cell = screen.cells().at({y / 2, x});
            const std::uint8_t* rgb = y < picture.height ? picture.row(y) + 3 * x : nullptr;
            const Color expected = rgb == nullptr ? kDefault : Color{rgb[0], rgb[1], rgb[2]};
            ASSERT_EQ(y % 2 == 0 ? cell.upper : cell.lower, expected) << "pixel " << x << "," << y << ", seed " << seed;
        }
    EXPECT_EQ(screen.line(), lines) << "the cursor stands below the picture";
    EXPECT_EQ(screen.column(), 0);
}

// Few colours, so that equal neighbours (nothing to send) are frequent.
RandomCodes poster(std::int32_t width, std::int32_t height, unsigned seed) {
    RandomCodes picture(width, height, seed);
    for (std::uint8_t& code : picture.rgb) code = code < 128 ? 0 : 200;
    return picture;
}

TEST(Terminal, ShowsEveryPixel) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        const RandomCodes picture =
            poster(static_cast<std::int32_t>(random() % 80 + 1), static_cast<std::int32_t>(random() % 50 + 1), seed);
        Pipe pipe;
        Terminal terminal(pipe.input(), {picture.width, picture.height});
        ASSERT_TRUE(terminal.present(picture.all(), {0, 0}).ok());
        Screen screen;
        screen.feed(pipe.taken());
        expect_shows(screen, picture.all(), seed);
    }
}

TEST(Terminal, LaterPartsAreDrawnOverTheFirstFrame) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        const std::int32_t width = static_cast<std::int32_t>(random() % 30 + 1),
                           height = static_cast<std::int32_t>(random() % 30 + 1);
        RandomCodes shown = poster(width, height, seed);
        Pipe pipe;
        Screen screen;
        Terminal terminal(pipe.input(), {width, height});
        ASSERT_TRUE(terminal.present(shown.all(), {0, 0}).ok());
        screen.feed(pipe.taken());
        for (int part = 0; part < 10; ++part) {
            const RandomCodes tile = poster(static_cast<std::int32_t>(random() % 12 + 1),
                                            static_cast<std::int32_t>(random() % 12 + 1), seed + 100);
            const Point at{static_cast<std::int32_t>(random() % 40) - 10,
                           static_cast<std::int32_t>(random() % 40) - 10};
            pack_part(kBgr888, shown.rgb.data(), static_cast<std::size_t>(3 * width), {width, height}, tile.all(), at);
            ASSERT_TRUE(terminal.present(tile.all(), at).ok());
            screen.feed(pipe.taken());
            ASSERT_NO_FATAL_FAILURE(expect_shows(screen, shown.all(), seed));
        }
    }
}

TEST(Terminal, EqualNeighboursSendNoColourTwice) {
    const std::vector<std::uint8_t> grey(3 * 80 * 48, 77);
    Pipe pipe;
    Terminal terminal(pipe.input(), {80, 48});
    ASSERT_TRUE(terminal.present({grey.data(), 80, 48, 240}, {0, 0}).ok());
    std::string line = "\033[48;2;77;77;77m" + std::string(80, ' ') + "\033[0m\n", expected;
    for (int i = 0; i < 24; ++i) expected += line;
    EXPECT_EQ(pipe.taken(), expected);
}

TEST(Terminal, PartOutsideSendsNothing) {
    const RandomCodes picture(6, 6, 31);
    Pipe pipe;
    Terminal terminal(pipe.input(), {6, 6});
    ASSERT_TRUE(terminal.present(picture.all(), {0, 0}).ok());
    EXPECT_NE(pipe.taken(), "");
    for (const std::int32_t y : {-6, 6}) ASSERT_TRUE(terminal.present(picture.all(), {0, y}).ok());
    EXPECT_EQ(pipe.taken(), "");
}

TEST(Terminal, GoneTerminalIsAnErrorNotASignal) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    ::close(ends[0]);
    Terminal terminal(ends[1], {1, 1});
    const std::uint8_t pixel[3] = {1, 2, 3};
    EXPECT_STREQ(terminal.present({pixel, 1, 1, 3}, {0, 0}).text, "terminal: cannot write: Broken pipe");
    ::close(ends[1]);
}

TEST(Terminal, BoundsAreTheTerminalsOwnElseTheEnvironmentsElse80x24) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
    winsize size{};
    size.ws_col = 132;
    size.ws_row = 43;
    ASSERT_EQ(::ioctl(master, TIOCSWINSZ, &size), 0);
    EXPECT_EQ(terminal_bounds(master), (Extent{132, 84}));
    ::close(master);

    const Pipe pipe;
    ::setenv("COLUMNS", "100", 1);
    ::setenv("LINES", "31", 1);
    EXPECT_EQ(terminal_bounds(pipe.input()), (Extent{100, 60}));
    ::setenv("COLUMNS", "-3", 1);
    ::setenv("LINES", "many", 1);
    EXPECT_EQ(terminal_bounds(pipe.input()), (Extent{80, 46}));
    ::unsetenv("COLUMNS");
    ::unsetenv("LINES");
    EXPECT_EQ(terminal_bounds(pipe.input()), (Extent{80, 46}));
}

}  // namespace
}  // namespace zerkalo
