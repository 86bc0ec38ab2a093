// Prepares the picture "everything" in fixed point, writes the plan's bytes to the file that is named, and renders it:
// what the program without a float unit has to print.
#include "core/render/render.hpp"
#include "tests/proofs/integers/rendering.hpp"
#include "tests/proofs/pictures/scenes.hpp"

#include <cstdio>

int main(int count, char** words) {
    using namespace zerkalo;
    static FixedPlan plan{};
    const Status status =
        prepare(pictures::kScenes[static_cast<int>(pictures::Picture::everything)], integers::settings(), plan);
    if (count != 2 || !status.ok()) {
        std::fprintf(stderr, "usage: bake PLAN; %s\n", status.ok() ? "the plan fits" : status.reason);
        return 2;
    }
    std::FILE* file = std::fopen(words[1], "wb");
    if (!file) return 1;
    const bool written = std::fwrite(&plan, sizeof plan, 1, file) == 1;
    if (std::fclose(file) != 0 || !written) return 1;
    char line[64];
    integers::describe(integers::hash_of_picture(plan, kernel_for(plan, Isa::scalar)), line);
    std::fputs(line, stdout);
    return 0;
}
