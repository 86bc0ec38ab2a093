// The pictures rendered by an ordinary program.
#include "tests/proofs/pictures/pictures.hpp"

#include <cstdio>

int main() {
    const bool same = zerkalo::pictures::render_all([](const char* line) { std::fputs(line, stdout); });
    return same ? 0 : 1;
}
