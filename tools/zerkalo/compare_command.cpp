// zerkalo compare: how far two picture files are apart, and whether that is tolerable.
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/difference_map.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/picture_file.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace zerkalo {
namespace {

struct CompareOptions {
    std::string a, b, mask;
    std::optional<std::string> map;
    std::optional<int> tolerance;
    bool json = false;
};

void require_same_size(const Picture& a, const std::string& a_path, const Picture& b, const std::string& b_path) {
    if (a.width == b.width && a.height == b.height) return;
    throw Failure(ExitCode::pictures_differ, format("sizes differ: %s is %dx%d, %s is %dx%d", a_path.c_str(), a.width,
                                                    a.height, b_path.c_str(), b.width, b.height));
}

// One flag a pixel: true where the mask is not black.
std::vector<bool> flags_of(const Picture& mask) {
    std::vector<bool> flags(mask.codes.size() / 3);
    for (std::size_t i = 0; i < flags.size(); ++i) {
        flags[i] = mask.codes[3 * i] != 0 || mask.codes[3 * i + 1] != 0 || mask.codes[3 * i + 2] != 0;
    }
    return flags;
}

// The map is a PNG of its own; it replaces none of the pictures that are read.
void check_map_name(const CompareOptions& options) {
    const std::string& map = *options.map;
    if (map == "-") throw Failure(ExitCode::usage, "--map -: standard output holds the figures; name a file");
    if (std::filesystem::path(map).extension() != ".png") {
        throw Failure(ExitCode::usage, "--map " + map + ": the name must end in .png");
    }
    for (const std::string* input : {&options.a, &options.b, &options.mask}) {
        std::error_code missing;  // a file that does not exist is none of the pictures
        if (*input == map || std::filesystem::equivalent(*input, map, missing)) {
            throw Failure(ExitCode::usage, "--map " + map + ": that is the picture " + *input + "; name another file");
        }
    }
}

void write_map(const CompareOptions& options, const Picture& a, const Picture& b, const std::vector<bool>& mask) {
    WholeFile file;
    open_picture(file, *options.map);
    const std::vector<std::uint8_t> codes = difference_map(a, b, mask);
    write_codes(file, {codes.data(), a.width, a.height, std::ptrdiff_t{3} * a.width});
}

std::string json_report(const CompareOptions& options, const PictureDifference& difference) {
    JsonObject json;
    json.number("rmse_linear", difference.rmse_linear).number("rmse_srgb8", difference.rmse_srgb8);
    json.number("max_linear", difference.max_linear).integer("max_srgb8", difference.max_srgb8);
    json.number("psnr", difference.psnr).integer("differing_pixels", difference.differing_pixels);
    json.integer("pixels_off_by_more_than_1", difference.pixels_off_by_more_than_1);
    json.integer("pixels", difference.pixels);
    if (options.map) json.text("map", *options.map);
    return json.str() + "\n";
}

std::string text_report(const CompareOptions& options, const PictureDifference& difference) {
    const std::string map = options.map ? *options.map + ", steps of the worst channel: " + map_legend() + "\n" : "";
    const auto count = [](std::int64_t value) { return static_cast<long long>(value); };
    return format(
               "linear light: RMSE %.6g, largest %.6g\n8-bit sRGB: RMSE %.6g steps, largest %d, PSNR %.2f dB\n"
               "pixels: %lld, differing %lld, off by more than 1 step %lld\n",
               difference.rmse_linear, difference.max_linear, difference.rmse_srgb8, difference.max_srgb8,
               difference.psnr, count(difference.pixels), count(difference.differing_pixels),
               count(difference.pixels_off_by_more_than_1)) +
           map;
}

ExitCode run_compare(const CompareOptions& options) {
    if (options.map) check_map_name(options);
    const Picture a = read_picture(options.a), b = read_picture(options.b);
    require_same_size(a, options.a, b, options.b);
    std::vector<bool> mask;
    if (!options.mask.empty()) {
        const Picture picture = read_picture(options.mask);
        require_same_size(a, options.a, picture, options.mask);
        mask = flags_of(picture);
    }
    const PictureDifference difference = difference_of(a, b, mask);
    if (difference.pixels == 0) throw Failure(ExitCode::usage, options.mask + ": the mask is black, no pixel counts");
    if (options.map) write_map(options, a, b, mask);
    print_result(options.json ? json_report(options, difference) : text_report(options, difference));
    if (options.tolerance && difference.max_srgb8 > *options.tolerance) {
        throw Failure(ExitCode::pictures_differ, format("pictures differ by up to %d steps of 8-bit sRGB, more than %d",
                                                        difference.max_srgb8, *options.tolerance));
    }
    return ExitCode::ok;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "Measures how far two pictures (PNG, PFM) are apart");
    command->add_option("A", options->a, "A picture")->required();
    command->add_option("B", options->b, "Another of the same size")->required();
    command->add_option("--mask", options->mask, "Picture of the same size: only where it is not black counts")
        ->type_name("FILE");
    command
        ->add_option("--tolerance", options->tolerance,
                     "Exit with 4 if any channel of any pixel is off by more than so many steps of 8-bit sRGB")
        ->check(whole_number(0, 255))
        ->type_name("T");
    command
        ->add_option("--map", options->map,
                     "Writes the picture of the differences, a PNG. Colours, by the steps of 8-bit sRGB that a pixel's "
                     "worst channel is off by: " +
                         map_legend() + "; grey where the mask is black")
        ->type_name("OUT.png");
    add_json_option(*command, options->json);
    command->callback([options, &action] { action = [options] { return run_compare(*options); }; });
}

}  // namespace zerkalo
