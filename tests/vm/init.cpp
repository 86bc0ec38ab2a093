// The first process of the test machine: sets up /dev, /proc and /sys, loads the display's modules in the order of
// /modules.list, runs the program on /dev/fb0, and reports to the serial line what happened.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <linux/fb.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr char kMarker[] = "ZERKALO-VM";

// Says why and stops; the script that waits for markers reads it.
[[noreturn]] void fail(const char* what, const char* where) {
    std::printf("%s FAIL %s %s: %s\n", kMarker, what, where, std::strerror(errno));
    std::fflush(stdout);
    for (;;) ::pause();
}

void mount_at(const char* type, const char* where) {
    ::mkdir(where, 0755);
    if (::mount(type, where, type, 0, nullptr) != 0 && errno != EBUSY) fail("mount", where);
}

void use_serial_line() {
    const int line = ::open("/dev/ttyS0", O_RDWR | O_NOCTTY);
    if (line < 0) return;  // no way left to say so: the script's time runs out
    for (int file = 0; file < 3; ++file) ::dup2(line, file);
}

void load_modules() {
    std::FILE* list = std::fopen("/modules.list", "r");
    if (list == nullptr) fail("open", "/modules.list");
    char path[256];
    while (std::fgets(path, sizeof path, list) != nullptr) {
        path[std::strcspn(path, "\n")] = '\0';
        const int file = ::open(path, O_RDONLY | O_CLOEXEC);
        if (file < 0) fail("open", path);
        if (::syscall(SYS_finit_module, file, "", 0) != 0 && errno != EEXIST) fail("finit_module", path);
        ::close(file);
    }
    std::fclose(list);
}

void report_screen() {
    constexpr int kTries = 1000;
    constexpr useconds_t kPause = 10000;
    int file = -1;
    for (int i = 0; i < kTries && (file = ::open("/dev/fb0", O_RDWR | O_CLOEXEC)) < 0; ++i) ::usleep(kPause);
    fb_var_screeninfo var{};
    if (file < 0 || ::ioctl(file, FBIOGET_VSCREENINFO, &var) != 0) fail("open", "/dev/fb0");
    ::close(file);
    std::printf("%s SCREEN %ux%u-%u\n", kMarker, var.xres, var.yres, var.bits_per_pixel);
    std::fflush(stdout);
}

int run_program() {
    const pid_t child = ::fork();
    if (child < 0) fail("fork", "/zerkalo");
    if (child == 0) {
        ::execl("/zerkalo", "zerkalo", "show", "/scene.toml", "--display", "fb", "--once", static_cast<char*>(nullptr));
        std::perror("/zerkalo");
        ::_exit(127);
    }
    int status = 0;
    if (::waitpid(child, &status, 0) != child) fail("waitpid", "/zerkalo");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

int main() {
    if (::getpid() != 1) {
        std::fputs("this program sets up a machine: it runs as its first process only\n", stderr);
        return 2;
    }
    mount_at("devtmpfs", "/dev");
    mount_at("proc", "/proc");
    mount_at("sysfs", "/sys");
    use_serial_line();
    load_modules();
    report_screen();
    std::printf("%s EXIT %d\n", kMarker, run_program());
    std::fflush(stdout);
    for (;;) ::pause();
}
