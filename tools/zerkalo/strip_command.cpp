// zerkalo strip: one scene with its mirrors at eleven degrees of polish, 0 to 1, side by side in one picture.
#include "core/image/resolve.hpp"
#include "core/scene/edit.hpp"
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/frame.hpp"
#include "tools/zerkalo/json.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"
#include "tools/zerkalo/picture_file.hpp"
#include "tools/zerkalo/progress.hpp"
#include "tools/zerkalo/scene_input.hpp"

#include <algorithm>

namespace zerkalo {
namespace {

constexpr int kPictures = 11;

struct StripOptions {
    std::string scene, output;
    Settings settings;
    std::optional<Isa> isa;
    int threads = 1;
    bool json = false;
};

double polish_of(int picture) { return picture / double(kPictures - 1); }

/// The scene with every mirror at that polish. What its highlight was stays: the strip shows the reflection alone.
std::unique_ptr<Scene> polished(const Scene& scene, double polish) {
    auto copy = std::make_unique<Scene>(scene);
    for (std::int32_t m = 0; m < copy->mirror_count; ++m) {
        Mirror& mirror = copy->mirrors[m];
        if (mirror.shininess == kShininessOfLobe && mirror.lobe_exponent < kInfinity) {
            mirror.shininess = mirror.lobe_exponent;
        } else if (mirror.shininess == kShininessOfLobe) {
            mirror.specular = 0;
        }
        mirror.lobe_exponent = exponent_of_polish(polish);
    }
    return copy;
}

/// The picture as 8-bit codes, for the steps between neighbours.
Picture picture_of(const LinearImage& image) {
    Picture picture{image.width, image.height, {}, {}, true};
    for (std::int32_t y = 0; y < image.height; ++y) {
        picture.linear.insert(picture.linear.end(), image.row(y), image.row(y) + std::ptrdiff_t{3} * image.width);
    }
    picture.codes.resize(picture.linear.size());
    resolve8(picture.linear.data(), picture.codes.data(), picture.codes.size());
    return picture;
}

/// What the strip tells: RMSE in steps of 8-bit sRGB from each picture to the next.
std::vector<double> steps_between(const std::vector<Picture>& pictures) {
    std::vector<double> steps;
    for (std::size_t k = 1; k < pictures.size(); ++k) {
        steps.push_back(difference_of(pictures[k - 1], pictures[k], {}).rmse_srgb8);
    }
    return steps;
}

std::string report(const StripOptions& options, const std::vector<double>& steps) {
    if (options.json) {
        std::vector<JsonObject> pictures;
        for (int k = 0; k < kPictures; ++k) {
            JsonObject picture;
            picture.number("polish", polish_of(k)).number("exponent", exponent_of_polish(polish_of(k)));
            if (k > 0) picture.number("rmse_srgb8_from_last", steps[static_cast<std::size_t>(k - 1)]);
            pictures.push_back(picture);
        }
        JsonObject json;
        json.text("scene", options.scene).list("pictures", pictures);
        return json.text("output", options.output).str() + "\n";
    }
    std::string text = "polish    exponent  RMSE from the one before, steps of 8-bit sRGB\n";
    for (int k = 0; k < kPictures; ++k) {
        text += format("   %.1f  %10.6g  ", polish_of(k), exponent_of_polish(polish_of(k)));
        text += k == 0 ? "\n" : format("%.2f\n", steps[static_cast<std::size_t>(k - 1)]);
    }
    return text;
}

/// The pictures' codes side by side.
std::vector<std::uint8_t> joined(const std::vector<Picture>& pictures) {
    std::vector<std::uint8_t> codes;
    for (std::int32_t y = 0; y < pictures[0].height; ++y) {
        for (const Picture& picture : pictures) {
            const auto row = picture.codes.begin() + std::ptrdiff_t{3} * picture.width * y;
            codes.insert(codes.end(), row, row + std::ptrdiff_t{3} * picture.width);
        }
    }
    return codes;
}

void check(const StripOptions& options, const Scene& scene) {
    if (options.output == "-") throw Failure(ExitCode::usage, "-o -: standard output holds the figures; name a file");
    if (picture_kind(options.output, 8) != PictureKind::png8) {
        throw Failure(ExitCode::usage, "-o " + options.output + ": the name must end in .png");
    }
    if (scene.mirror_count == 0) {
        throw Failure(ExitCode::scene_invalid, options.scene + ": has no mirror, so there is nothing to polish");
    }
    const std::int64_t width = options.settings.width > 0 ? options.settings.width : scene.image.width;
    if (width * kPictures > kMaxImageSide) {
        throw Failure(ExitCode::usage, format("--size: eleven pictures side by side are wider than %d pixels; "
                                              "at most %d each",
                                              kMaxImageSide, kMaxImageSide / kPictures));
    }
}

ExitCode run_strip(const StripOptions& options) {
    const Isa isa = chosen_isa(options.isa);
    const SceneInput input = read_scene(options.scene);
    check(options, *input.scene);
    WholeFile file;
    open_picture(file, options.output);
    std::vector<Picture> pictures;
    for (int k = 0; k < kPictures; ++k) {
        const auto scene = polished(*input.scene, polish_of(k));
        const Frame frame = prepare_frame(*scene, options.settings, isa, options.threads);
        render_frame(frame, 1, progress_wanted());
        pictures.push_back(picture_of(frame.image));
    }
    const std::vector<std::uint8_t> codes = joined(pictures);
    const std::int32_t width = kPictures * pictures[0].width;
    write_codes(file, {codes.data(), width, pictures[0].height, std::ptrdiff_t{3} * width});
    print_result(report(options, steps_between(pictures)));
    return ExitCode::ok;
}

}  // namespace

void add_strip_command(CLI::App& app, Action& action) {
    const auto options = std::make_shared<StripOptions>();
    CLI::App* command = app.add_subcommand("strip", "Renders a scene at polish 0, 0.1 ... 1, side by side");
    command->add_option("SCENE", options->scene, "Scene file (TOML); its mirrors' own polish does not matter")
        ->required();
    command->add_option("-o,--output", options->output, "NAME.png, eleven pictures wide")->required()->type_name("OUT");
    add_size_option(*command, options->settings);
    add_quality_options(*command, options->settings);
    add_isa_option(*command, options->isa);
    add_threads_option(*command, options->threads);
    add_json_option(*command, options->json);
    command->callback([options, &action] { action = [options] { return run_strip(*options); }; });
}

}  // namespace zerkalo
