// zerkalo doctor: what this machine offers to the program, and why not what it does not.
#include "platform/framebuffer.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"

#include <cstdio>
#include <cstring>
#include <memory>
#include <sys/ioctl.h>
#include <unistd.h>

namespace zerkalo {
namespace {

constexpr int kMaxFramebuffers = 32;  // FB_MAX of the kernel

#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

struct FramebufferReport {
    std::string path, format, reason;  // reason: why it cannot be used, or empty
    Extent extent;
};

std::vector<FramebufferReport> look_at_framebuffers() {
    std::vector<FramebufferReport> reports;
    for (int i = 0; i < kMaxFramebuffers; ++i) {
        const std::string path = "/dev/fb" + std::to_string(i);
        if (access(path.c_str(), F_OK) != 0) continue;
        Framebuffer framebuffer;
        const IoStatus status = framebuffer.open(path.c_str(), ConsoleMode::untouched);
        if (status.ok()) {
            reports.push_back({path, name_of(framebuffer.format()), "", framebuffer.extent()});
        } else {
            reports.push_back({path, "", status.text, {}});
        }
    }
    return reports;
}

// "model name" of the first processor, as the kernel gives it; boards that give none are "unknown".
std::string processor_name() {
    std::string name = "unknown";
    std::FILE* file = std::fopen("/proc/cpuinfo", "r");
    if (!file) return name;
    char line[512];
    while (std::fgets(line, sizeof line, file)) {
        const char* colon = std::strchr(line, ':');
        if (std::strncmp(line, "model name", 10) != 0 || !colon) continue;
        name = colon + 1;
        name.erase(0, name.find_first_not_of(" \t"));
        name.erase(name.find_last_not_of(" \t\n") + 1);
        break;
    }
    std::fclose(file);
    return name;
}

// Columns and rows of the terminal on stdout; 0x0 when there is none.
Extent terminal_cells() {
    winsize size{};
    if (isatty(STDOUT_FILENO) != 1 || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return {};
    return {size.ws_col, size.ws_row};
}

std::string json_report() {
    std::vector<JsonObject> isas, framebuffers;
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        JsonObject entry;
        entry.text("name", name_of(isa)).integer("lanes", lanes_of(isa)).flag("available", available(isa));
        isas.push_back(entry.flag("chosen", isa == best_isa()));
    }
    for (const FramebufferReport& report : look_at_framebuffers()) {
        JsonObject entry;
        entry.text("path", report.path).flag("usable", report.reason.empty());
        if (report.reason.empty()) {
            entry.integer("width", report.extent.width).integer("height", report.extent.height);
            entry.text("format", report.format);
        } else {
            entry.text("reason", report.reason);
        }
        framebuffers.push_back(entry);
    }
    const Extent cells = terminal_cells();
    JsonObject terminal, report;
    terminal.flag("present", cells.width > 0).integer("columns", cells.width).integer("rows", cells.height);
    report.text("version", ZERKALO_VERSION).text("compiler", kCompiler).text("processor", processor_name());
    report.text("isa", name_of(best_isa())).integer("lanes", lanes_of(best_isa())).list("isas", isas);
    report.integer("threads", hardware_threads());
    report.integer("plan_bytes", sizeof(Plan)).integer("fixed_plan_bytes", sizeof(FixedPlan));
    report.integer("double_plan_bytes", sizeof(DoublePlan));
    report.integer("scene_bytes", sizeof(Scene));
    report.list("framebuffers", framebuffers).object("terminal", terminal);
    return report.str() + "\n";
}

std::string text_report() {
    std::string text = format("zerkalo %s, compiler %s\nprocessor: %s\ninstruction sets:\n", ZERKALO_VERSION, kCompiler,
                              processor_name().c_str());
    for (int i = 0; i < kIsaCount; ++i) {
        const Isa isa = static_cast<Isa>(i);
        const char* state = isa == best_isa() ? "available, chosen" : available(isa) ? "available" : "not here";
        const char* lanes = lanes_of(isa) == 1 ? "lane " : "lanes";
        text += format("  %-7s %2d %s  %s\n", name_of(isa), lanes_of(isa), lanes, state);
    }
    text += format("threads: %d\nmemory: %zu bytes a plan, %zu bytes a scene, 12 bytes a pixel\ndisplays:\n",
                   hardware_threads(), sizeof(Plan), sizeof(Scene));
    const auto framebuffers = look_at_framebuffers();
    for (const FramebufferReport& report : framebuffers) {
        text += report.reason.empty() ? format("  %s: %dx%d %s\n", report.path.c_str(), report.extent.width,
                                               report.extent.height, report.format.c_str())
                                      : format("  not usable: %s\n", report.reason.c_str());
    }
    if (framebuffers.empty()) text += "  no framebuffer (/dev/fb*)\n";
    const Extent cells = terminal_cells();
    text += cells.width > 0 ? format("  terminal: %d columns, %d rows\n", cells.width, cells.height)
                            : std::string("  no terminal on standard output\n");
    return text;
}

}  // namespace

void add_doctor_command(CLI::App& app, Action& action) {
    const auto json = std::make_shared<bool>(false);
    CLI::App* command = app.add_subcommand("doctor", "Tells what this machine offers: instruction sets, displays");
    add_json_option(*command, *json);
    command->callback([json, &action] {
        action = [json] {
            print_result(*json ? json_report() : text_report());
            return ExitCode::ok;
        };
    });
}

}  // namespace zerkalo
