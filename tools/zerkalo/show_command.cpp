// zerkalo show: a scene on a display of this machine, rendered at the display's own extent.
#include "platform/framebuffer.hpp"
#include "platform/terminal.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/frame.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/picture_file.hpp"
#include "tools/zerkalo/scene_input.hpp"
#include "tools/zerkalo/stop_signals.hpp"

#include <unistd.h>

namespace zerkalo {
namespace {

struct ShowOptions {
    std::string scene;
    std::string display;  // empty: whatever this machine has
    Settings settings;
    std::optional<Isa> isa;
    int threads = 1;
    bool once = false;
};

constexpr const char* kFirstFramebuffer = "/dev/fb0";

// The file name after "fb:" or "png:"; empty when `display` is of another kind.
std::string name_after(const std::string& prefix, const std::string& display) {
    return display.compare(0, prefix.size(), prefix) == 0 ? display.substr(prefix.size()) : "";
}

void require_device(const IoStatus& status) {
    if (!status.ok()) throw Failure(ExitCode::no_device, status.text);
}

void require_io(const IoStatus& status) {
    if (!status.ok()) throw Failure(ExitCode::io_failed, status.text);
}

Extent picture_size(const Scene& scene, const Settings& settings) {
    if (settings.width > 0) return {settings.width, settings.height};
    return {scene.image.width, scene.image.height};
}

// A signal before the picture is there ends a live show like any other moment of it; a single picture has failed.
void stop_early(const ShowOptions& options) {
    if (options.once) throw Failure(ExitCode::io_failed, "interrupted before the picture was shown");
}

// Renders at `extent`, unless --size says otherwise. Returns early, with a part of the picture, once `stopped`.
Frame rendered(const Scene& scene, const ShowOptions& options, const Extent& extent, const std::atomic<bool>& stopped) {
    Settings settings = options.settings;
    if (settings.width == 0) {
        settings.width = extent.width;
        settings.height = extent.height;
    }
    Frame frame = prepare_frame(scene, settings, chosen_isa(options.isa), options.threads);
    render_until(frame, stopped);
    return frame;
}

void show_on_framebuffer(const Scene& scene, const ShowOptions& options, Framebuffer& framebuffer) {
    StopSignals signals;
    const Extent extent = framebuffer.extent();
    const Frame frame = rendered(scene, options, extent, signals.stopped());
    if (signals.stopped()) return stop_early(options);
    const LinearImage& image = frame.image;
    if (image.width < extent.width || image.height < extent.height) require_io(clear(framebuffer));
    const Point centred{(extent.width - image.width) / 2, (extent.height - image.height) / 2};
    require_io(present_linear(framebuffer, image, centred));
    // The size of a framebuffer stays: a resize is the business of terminals.
    while (!options.once && signals.wait() != StopSignals::Event::stop) continue;
}

// One picture as large as the terminal is now, below the cursor.
void draw_in_terminal(const Scene& scene, const ShowOptions& options, const std::atomic<bool>& stopped) {
    const Extent extent = fit(picture_size(scene, options.settings), terminal_bounds(STDOUT_FILENO));
    const Frame frame = rendered(scene, options, extent, stopped);
    if (stopped) return stop_early(options);
    std::vector<float> pixels(std::size_t{3} * static_cast<std::size_t>(extent.width) *
                              static_cast<std::size_t>(extent.height));
    const LinearImage shrunk{pixels.data(), extent.width, extent.height,
                             static_cast<std::ptrdiff_t>(3 * sizeof(float)) * extent.width};
    shrink(frame.image, shrunk);
    Terminal terminal(STDOUT_FILENO, extent);
    require_io(present_linear(terminal, shrunk));
}

void show_in_terminal(const Scene& scene, const ShowOptions& options) {
    constexpr const char* kHomeAndErase = "\x1b[H\x1b[2J";
    StopSignals signals;
    draw_in_terminal(scene, options, signals.stopped());
    while (!options.once && signals.wait() == StopSignals::Event::resized) {
        print_result(kHomeAndErase);
        draw_in_terminal(scene, options, signals.stopped());
    }
}

void show_in_png(const Scene& scene, const ShowOptions& options, const std::string& path) {
    WholeFile file;
    open_picture(file, path);
    const Frame frame = rendered(scene, options, picture_size(scene, options.settings), false);
    write_picture(file, frame.image, PictureKind::png8);
}

// Without --display: the framebuffer if it can be drawn on, else the terminal, else nothing suits.
void show_anywhere(const Scene& scene, const ShowOptions& options) {
    Framebuffer framebuffer;
    const IoStatus status = framebuffer.open(kFirstFramebuffer);
    if (status.ok()) return show_on_framebuffer(scene, options, framebuffer);
    if (isatty(STDOUT_FILENO) == 1) return show_in_terminal(scene, options);
    throw Failure(ExitCode::no_device, std::string("no display: standard output is not a terminal, and ") +
                                           status.text + "; '--display png:FILE' draws into a file");
}

ExitCode run_show(const ShowOptions& options) {
    (void)chosen_isa(options.isa);  // refused before the scene is read
    const SceneInput input = read_scene(options.scene);
    const Scene& scene = *input.scene;
    const std::string png = name_after("png:", options.display), device = name_after("fb:", options.display);
    if (options.display.empty()) {
        show_anywhere(scene, options);
    } else if (options.display == "terminal") {
        show_in_terminal(scene, options);
    } else if (!png.empty()) {
        show_in_png(scene, options, png);
    } else {
        Framebuffer framebuffer;
        require_device(framebuffer.open(device.empty() ? kFirstFramebuffer : device.c_str()));
        show_on_framebuffer(scene, options, framebuffer);
    }
    return ExitCode::ok;
}

std::string check_display(const std::string& display) {
    const bool known = display == "fb" || display == "terminal" || !name_after("fb:", display).empty() ||
                       !name_after("png:", display).empty();
    return known ? "" : "'" + display + "' is not one of fb, fb:/dev/fbN, terminal, png:FILE";
}

}  // namespace

void add_show_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<ShowOptions>();
    CLI::App* command = app.add_subcommand("show", "Shows a scene on a display until SIGINT (Ctrl-C) or SIGTERM");
    command->add_option("SCENE", options->scene, "Scene file (TOML)")->required();
    command
        ->add_option("--display", options->display,
                     "fb, fb:/dev/fbN, terminal or png:FILE; default: the framebuffer if it can be used, else the "
                     "terminal")
        ->check(check_display)
        ->type_name("WHERE");
    command->add_flag("--once", options->once, "Draw the picture and exit");
    add_size_option(*command, options->settings);
    add_quality_options(*command, options->settings);
    add_isa_option(*command, options->isa);
    add_threads_option(*command, options->threads);
    command->callback([options, &action] { action = [options] { return run_show(*options); }; });
}

}  // namespace zerkalo
