// zerkalo: the command line program. Reads the command line, runs one command, turns every outcome into an exit code.
#include "tools/zerkalo/commands.hpp"
#include "tools/zerkalo/messages.hpp"
#include "tools/zerkalo/options.hpp"

#include <exception>
#include <new>

namespace zerkalo {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 reading or writing failed, 2 wrong command line, 3 invalid scene,\n"
    "4 pictures differ or --error not reached, 5 no suitable device or instruction set,\n"
    "70 internal error, 130 interrupted.\n"
    "Results go to standard output, messages to standard error.";

void add_commands(CLI::App& app, Action& action) {
    add_render_command(app, action);
    add_compare_command(app, action);
    add_show_command(app, action);
    add_doctor_command(app, action);
    add_stability_command(app, action);
    add_strip_command(app, action);
    add_study_command(app, action);
#ifdef ZERKALO_BENCH
    add_bench_command(app, action);
#endif
}

// "; did you mean ...?" among the commands of the program.
std::string command_suggestion(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return suggestion(word, {names.begin(), names.end()});
}

// "; did you mean ...?" among the options of one command.
std::string option_suggestion(const CLI::App& command, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    }
    return suggestion(word, {names.begin(), names.end()});
}

// One line: the argument that nothing wanted, if there is one (a mistyped option is the cause of "SCENE is required",
// not the other way round), else `otherwise`.
std::string usage_message(const CLI::App& app, const std::string& otherwise) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    const std::string help = "; see 'zerkalo " + (chosen.empty() ? "" : command.get_name() + " ") + "--help'";
    const std::vector<std::string> extras = app.remaining(true);
    for (const std::string& extra : extras) {
        if (extra.size() < 2 || extra[0] != '-') continue;
        const std::string option = extra.substr(0, extra.find('='));
        return "unknown option '" + option + "'" + option_suggestion(command, option) + help;
    }
    if (!extras.empty() && chosen.empty()) {
        return "unknown command '" + extras.front() + "'" + command_suggestion(app, extras.front()) + help;
    }
    if (!extras.empty()) return "unexpected argument '" + extras.front() + "'" + help;
    return otherwise + help;
}

ExitCode run(int argc, char** argv) {
    CLI::App app{"Draws solids in an unpolished coloured mirror, without a GPU."};
    app.name("zerkalo");
    app.set_version_flag("--version", "zerkalo " ZERKALO_VERSION);
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.footer(kExitCodes);
    app.require_subcommand(0, 1);
    Action action;
    add_commands(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& wish) {
        const bool version = dynamic_cast<const CLI::CallForVersion*>(&wish) != nullptr;
        print_result(version ? std::string(wish.what()) + "\n" : app.help());
        return ExitCode::ok;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string words = error.what();
        const std::string option = words.substr(0, words.find(':'));
        throw Failure(ExitCode::usage, usage_message(app, option + ": takes exactly one value"));
    } catch (const CLI::ParseError& error) {
        throw Failure(ExitCode::usage, usage_message(app, error.what()));
    }
    if (!action) throw Failure(ExitCode::usage, usage_message(app, "no command given"));
    return action();
}

ExitCode run_and_report(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const Failure& failure) {
        if (*failure.what() != '\0') print_error(failure.what());
        return failure.code();
    } catch (const std::bad_alloc&) {
        print_error("out of memory");
    } catch (const std::exception& error) {
        print_error(std::string("internal error: ") + error.what());
    }
    return ExitCode::internal_error;
}

}  // namespace
}  // namespace zerkalo

int main(int argc, char** argv) { return static_cast<int>(zerkalo::run_and_report(argc, argv)); }
