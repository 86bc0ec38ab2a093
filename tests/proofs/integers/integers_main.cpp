// A plan compiled in, rendered by a program that has no instruction for floats: no C library either, see
// ../pictures/freestanding_main.cpp, which calls this.
#include "core/render/kernel.hpp"
#include "tests/proofs/integers/rendering.hpp"
#include "tests/proofs/pictures/pictures.hpp"

asm(".section .rodata\n.balign 64\n.globl baked_plan\nbaked_plan:\n.incbin \"" ZERKALO_PLAN "\"\n.previous\n");
extern "C" const zerkalo::FixedPlan baked_plan;

namespace zerkalo::pictures {

bool render_all(void (*write)(const char* line)) {
    char line[64];
    integers::describe(integers::hash_of_picture(baked_plan, kFixedKernel_scalar), line);
    write(line);
    return true;
}

}  // namespace zerkalo::pictures
