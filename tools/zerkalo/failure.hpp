// How the program ends: its exit codes, and the one exception that carries a message and a code up to main.
#pragma once

#include <stdexcept>
#include <string>

namespace zerkalo {

enum class ExitCode : int {
    ok = 0,
    io_failed = 1,        // a file could not be read or written
    usage = 2,            // the command line is wrong
    scene_invalid = 3,    // the scene file, or a file that it names, is wrong
    pictures_differ = 4,  // compare: beyond the tolerance; study: its references disagree; render: --error not reached
    no_device = 5,        // no such display here, or this CPU lacks the instruction set
    internal_error = 70,  // a fault of the program, or no memory
    interrupted = 130,    // study: by Ctrl-C or SIGTERM; what is finished is kept
};

/// Thrown by a command; main prints the message as one line and exits with the code.
/// An empty message says that everything was already printed.
class Failure : public std::runtime_error {
public:
    Failure(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

}  // namespace zerkalo
