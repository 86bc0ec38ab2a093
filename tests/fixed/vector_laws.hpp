// Each operation of fixed point in vector registers, against the same operation of one lane: a table for each
// instruction set.
#pragma once

#include <cstdint>

namespace zerkalo::test {

struct VectorLaw {
    const char* operation;
    /// Lanes, of `rounds` registers, whose answer is not that of one lane.
    int (*differing)(std::uint64_t seed, int rounds);
};
struct VectorLaws {
    const VectorLaw* laws;
    int count;
};

}  // namespace zerkalo::test
