#include "tools/scene_file/scene_file.hpp"

#include "core/scene/validate.hpp"
#include "tools/scene_file/file_bytes.hpp"
#include "tools/scene_file/nesting.hpp"
#include "tools/scene_file/read_scene.hpp"
#include "tools/scene_file/syntax_error.hpp"
#include "tools/scene_file/utf8.hpp"

#include <utility>

namespace zerkalo {
namespace {

using scene_file::Report;
using scene_file::SourceText;

constexpr int kUnreadable = 1;
constexpr int kWrong = 3;

LoadResult failure(Report& report) {
    LoadResult result;
    result.diagnostics = report.take(kMaxDiagnostics);
    result.more_errors = report.count() - static_cast<int>(result.diagnostics.size());
    result.exit_code = kWrong;
    return result;
}

LoadResult failure(const std::string& name, std::string message, int exit_code) {
    LoadResult result;
    result.diagnostics.push_back({scene_file::printable(name), {}, std::move(message), {}, {}, 0});
    result.exit_code = exit_code;
    return result;
}

LoadResult too_large(const std::string& name) {
    return failure(name, "a scene file has at most 1 MiB (" + std::to_string(kMaxSceneFileSize) + " bytes)", kWrong);
}

}  // namespace

LoadResult load_scene_text(std::string text, std::string name, const std::filesystem::path& directory) {
    if (text.size() > kMaxSceneFileSize) return too_large(name);
    const SourceText source(std::move(name), std::move(text));
    Report report(source);
    if (const std::size_t byte = scene_file::first_malformed(source.text()); byte != std::string_view::npos) {
        report.error(source.position_at(byte), "not UTF-8",
                     "save the file as UTF-8; Windows-1251 and UTF-16 are not read");
        return failure(report);
    }
    if (const auto byte = scene_file::first_too_deep(source.text())) {
        report.error(source.position_at(*byte),
                     "nested deeper than " + std::to_string(scene_file::kMaxNesting) + " levels");
        return failure(report);
    }
    const toml::parse_result parsed = toml::parse(source.text());
    if (!parsed) {
        scene_file::report_syntax_error(parsed.error(), report);
        return failure(report);
    }
    LoadResult result;
    result.scene = std::make_unique<Scene>();
    const auto tables = scene_file::read_scene(parsed.table(), directory, report, *result.scene, result.title);
    if (report.count() > 0) return failure(report);
    if (const Status status = validate(*result.scene); !status.ok()) {
        report.error(scene_file::locate(status, tables), scene_file::in_quotes(status.field) + " " + status.reason);
        return failure(report);
    }
    return result;
}

LoadResult load_scene(const std::filesystem::path& path) {
    scene_file::FileBytes file = scene_file::read_file(path, kMaxSceneFileSize);
    if (!file.fault.empty()) return failure(path.string(), "cannot read it: " + file.fault, kUnreadable);
    if (file.too_large) return too_large(path.string());
    return load_scene_text(std::move(file.bytes), path.string(), path.parent_path());
}

std::string to_text(const LoadResult& result) {
    std::string text;
    for (const Diagnostic& diagnostic : result.diagnostics) text += to_text(diagnostic);
    if (result.more_errors > 0) text += "and " + std::to_string(result.more_errors) + " more errors\n";
    return text;
}

}  // namespace zerkalo
