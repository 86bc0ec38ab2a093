// What ends a checked build: see checked.hpp. The only file of the core that speaks, and part of no other build.
#include "core/numeric/checked.hpp"

#include <cstdio>
#include <cstdlib>

namespace zerkalo {

void digits_lost(const char* operation) {
    std::fprintf(stderr, "fixed point: %s lost digits\n", operation);
    std::abort();
}

}  // namespace zerkalo
