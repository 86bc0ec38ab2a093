// How many rays a law is asked with: a number from the environment in a long run, else that of a build's tests.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace zerkalo::test {

/// The value of the variable, or what the build says (tests/oracle/CMakeLists.txt).
inline std::uint64_t count_from(const char* variable) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : ZERKALO_ORACLE_RAYS;
}

}  // namespace zerkalo::test
