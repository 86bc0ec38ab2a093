// What the driver refuses. What it draws is tested on a real framebuffer: tests/vm.
#include "platform/framebuffer.hpp"

#include "tests/platform/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace zerkalo {
namespace {

TEST(Framebuffer, MissingDeviceIsNamed) {
    const ScratchFolder folder;
    const std::string path = folder / "fb0";
    Framebuffer framebuffer;
    const std::string text = framebuffer.open(path.c_str()).text;
    EXPECT_EQ(text, path + ": cannot open the framebuffer: No such file or directory");
    EXPECT_EQ(framebuffer.extent(), (Extent{0, 0}));
}

TEST(Framebuffer, AnotherKindOfDeviceIsRefused) {
    Framebuffer framebuffer;
    const std::string text = framebuffer.open("/dev/null").text;
    EXPECT_EQ(text.rfind("/dev/null: not a framebuffer: ", 0), 0u) << text;
    EXPECT_EQ(framebuffer.extent(), (Extent{0, 0}));
}

}  // namespace
}  // namespace zerkalo
