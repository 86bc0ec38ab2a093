#include "tools/study/diagrams.hpp"

#include "tools/study/gnuplot_script.hpp"
#include "tools/study/journal.hpp"
#include "tools/zerkalo/failure.hpp"
#include "tools/zerkalo/messages.hpp"

#include <cerrno>
#include <cstring>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace zerkalo::study {
namespace {

// Runs gnuplot in `folder`; false when there is none.
bool run_gnuplot(const std::string& folder, const std::string& script) {
    std::string words[] = {"gnuplot", script};
    char* arguments[] = {words[0].data(), words[1].data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    pid_t process = 0;
    const int error = posix_spawnp(&process, words[0].c_str(), &actions, nullptr, arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error == ENOENT) return false;
    int status = 0;
    if (error == 0) {
        while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
    }
    if (error != 0 || status != 0) {
        throw Failure(ExitCode::io_failed,
                      folder + "/" + script + ": gnuplot failed" +
                          (error != 0 ? std::string(": ") + std::strerror(error) : "; its message is above"));
    }
    return true;
}

}  // namespace

bool draw_diagrams(const std::string& folder, const std::vector<Row>& rows) {
    const std::string diagrams = folder + "/diagrams";
    make_folder(diagrams);
    bool drawn = true;
    for (const std::string& scene : scenes_of(rows)) {
        const std::string script = gnuplot_script(scene, rows_of_scene(rows, scene));
        if (script.empty()) continue;
        write_text(diagrams + "/" + scene + ".gp", script);
        drawn = drawn && run_gnuplot(diagrams, scene + ".gp");
    }
    return drawn;
}

}  // namespace zerkalo::study
