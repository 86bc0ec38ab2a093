// The subcommands: each adds itself to the command line and, when it is the one, says what to run.
#pragma once

#include "tools/zerkalo/failure.hpp"

#include <CLI/CLI.hpp>
#include <functional>

namespace zerkalo {

/// What main runs once the whole command line is understood. Throws Failure.
using Action = std::function<ExitCode()>;

void add_render_command(CLI::App& app, Action& action);
void add_compare_command(CLI::App& app, Action& action);
void add_show_command(CLI::App& app, Action& action);
void add_doctor_command(CLI::App& app, Action& action);
void add_stability_command(CLI::App& app, Action& action);
void add_study_command(CLI::App& app, Action& action);
void add_strip_command(CLI::App& app, Action& action);
void add_bench_command(CLI::App& app, Action& action);

}  // namespace zerkalo
