// What a checked build of fixed point does where a digit is lost: see core/numeric/checked.hpp. Host programs alone have
// a standard error stream to say it on; no other build has this file.
#include "core/numeric/checked.hpp"

#include <cstdio>
#include <cstdlib>

namespace zerkalo {

void digits_lost(const char* operation) {
    std::fprintf(stderr, "fixed point: %s lost digits\n", operation);
    std::abort();
}

}  // namespace zerkalo
