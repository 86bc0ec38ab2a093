"""Feeds bad call graphs, compiled on the spot, to the stack rules: each must be rejected by name.

Usage: self_test_stack.py SCRATCH --compiler CXX [--machine-code]
"""
import argparse
import sys
import unittest
from pathlib import Path

import stack_rules
from call_graph import CallGraph
from fake_build import fake_build

FRAME = "__attribute__((noinline)) int NAME(int n) {{ volatile char room[{size}]; room[n] = 1; return room[0]{call}; }}\n"


def function_of(name, size, call=""):
    """A function that holds `size` bytes on the stack while it calls."""
    return FRAME.replace("NAME", name).format(size=size, call=call and f" + {call} + room[1]")


class StackRules(unittest.TestCase):
    given = None

    def graph(self, sources):
        flags = ["-fstack-usage"] if self.given.machine_code else ["-fstack-usage", "-fcallgraph-info=su"]
        build = fake_build(self.given.scratch / "stack", self.given.compiler, sources, flags)
        return CallGraph(build)

    def rejects(self, rule, sources, *fragments, limit=24576, entries=None):
        found, _ = stack_rules.RULES[rule][1](self.graph(sources), limit, entries)
        self.assertTrue(found)
        for fragment in fragments:
            self.assertIn(fragment, found[0])

    def accepts(self, rule, sources, limit=24576, entries=None):
        self.assertEqual(stack_rules.RULES[rule][1](self.graph(sources), limit, entries)[0], [])

    def test_a_flat_program_breaks_no_rule(self):
        flat = {"zerkalo_core/a.cpp": function_of("leaf", 100) + function_of("top", 100, "leaf(n)")}
        self.accepts("recursion", flat)
        self.accepts("depth", flat)

    def test_direct_and_mutual_recursion_are_rejected(self):
        self.rejects("recursion", {"zerkalo_core/a.cpp": "int own(int); " + function_of("own", 10, "own(n - 1)")}, "own(int)")
        across = {"zerkalo_core/a.cpp": "int pong(int); " + function_of("ping", 10, "pong(n)"),
                  "zerkalo_core/b.cpp": "int ping(int); " + function_of("pong", 10, "ping(n)")}
        self.rejects("recursion", across, "ping(int)", "pong(int)")
        self.rejects("depth", across, "no bound exists")

    def test_namesakes_that_are_local_to_their_units_are_not_confused(self):
        text = "static {}\nint {}_top(int n) {{ return same(n) * 2; }}"
        small, large = function_of("same", 1000), function_of("same", 5000)
        graph = self.graph({"zerkalo_kernel_a/kernel.cpp": text.format(small, "a"),
                            "zerkalo_kernel_b/kernel.cpp": text.format(large, "b")})
        # GCC names the result's type too.
        deepest = {path[0].name.split()[-1]: size for size, path in stack_rules.deepest_paths(graph).values()}
        self.assertLess(deepest["a_top(int)"], 2000)
        self.assertGreater(deepest["b_top(int)"], 5000)

    def test_calls_through_pointers_are_rejected(self):
        self.rejects("recursion", {"zerkalo_core/a.cpp": "int f(int (*p)(int), int n) { return p(n) + 1; }"},
                     "through a pointer", "_Z1fPFiiEi, " if self.given.machine_code else "a.cpp:1")

    def test_a_jump_through_a_pointer_is_a_call_and_that_of_a_switch_is_none(self):
        self.rejects("recursion", {"zerkalo_core/a.cpp": "int f(int (*p)(int), int n) { return p(n); }"},
                     "through a pointer")
        cases = " ".join(f"case {n}: return {n * n + 3} / (m + {n});" for n in range(12))
        self.accepts("recursion", {"zerkalo_core/a.cpp": f"int f(int n, int m) {{ switch (n) {{ {cases} }} return 0; }}"})

    def test_the_sum_along_the_deepest_path_is_bounded(self):
        chain = {"zerkalo_core/a.cpp": function_of("low", 4000) + function_of("middle", 4000, "low(n)")
                 + function_of("high", 4000, "middle(n)")}
        self.accepts("depth", chain, limit=12800)
        self.rejects("depth", chain, "high(int)", "middle(int)", "low(int)", limit=12000)

    def test_kernels_and_others_are_bounded_apart(self):
        both = {"zerkalo_core/a.cpp": function_of("set_up", 9000), "zerkalo_kernel_a/kernel.cpp": function_of("tile", 4000)}
        self.accepts("depth", both, limit=5000, entries="kernels")
        self.rejects("depth", both, "set_up(int)", limit=5000, entries="others")
        self.rejects("depth", both, "tile(int)", limit=3000, entries="kernels")
        self.rejects("depth", {"zerkalo_core/a.cpp": function_of("set_up", 9000)}, "no entry point", entries="kernels")

    def test_a_call_of_memcpy_is_counted(self):
        copy = {"zerkalo_core/a.cpp": "void f(char* a, char* b, long n) { __builtin_memcpy(a, b, n); a[n] = 0; }"}
        self.rejects("depth", copy, "f(char*, char*, long", limit=stack_rules.OUTSIDE_STACK)

    def test_stacks_of_unknown_size_are_rejected(self):
        text = "void f(int n) { char* p = (char*)__builtin_alloca(n); asm volatile(\"\" :: \"r\"(p) : \"memory\"); }"
        self.rejects("depth", {"zerkalo_core/a.cpp": text}, "unknown size", "f(int)")

    def test_a_build_without_call_graph_is_rejected(self):
        build = fake_build(self.given.scratch / "stack", self.given.compiler, {"zerkalo_core/a.cpp": "int a() { return 1; }"})
        with self.assertRaises(SystemExit):
            CallGraph(build)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scratch", type=Path)
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--machine-code", action="store_true", help="the compiler writes no call graph")
    StackRules.given = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
