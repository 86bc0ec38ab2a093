"""Feeds bad objects, compiled on the spot, to the symbol and instruction rules: each must be rejected by name.

Usage: self_test_objects.py SCRATCH --compiler CXX --nm NM --objdump OBJDUMP
"""
import argparse
import sys
import unittest
from pathlib import Path

import instruction_rules
import objects
import symbol_rules
from fake_build import fake_build
from verdict import output_of

KERNEL = "zerkalo_kernel_wide/kernel.cpp"
GOOD = {"zerkalo_core/a.cpp": "namespace z { int twice(int n) { return n + n; } const char* const kNames[] = {\"a\"};\n"
                              "const char* name(int i) { return kNames[i]; } }",
        KERNEL: "namespace z { int twice(int); float scale(float* v, int n) { return v[n] * v[1] + float(twice(n)); } }"}
FUSED = {"x86-64": ("vfmadd213ps %xmm0,%xmm1,%xmm2", "vfnmsub132sd %xmm0,%xmm1,%xmm2", "vfmaddsub231ps %ymm0,%ymm1,%ymm2"),
         "aarch64": ("fmadd s0,s1,s2,s3", "fmla v0.4s,v1.4s,v2.4s", "fmls v0.4s,v1.4s,v2.4s", "fnmsub d0,d1,d2,d3")}
ESTIMATES = {"x86-64": ("rcpps %xmm0,%xmm1", "vrsqrtps %ymm0,%ymm1", "rsqrtss %xmm0,%xmm1", "vrcp14ps %zmm0,%zmm1",
                        "vrsqrt14ps %zmm0,%zmm1"),
             "aarch64": ("frecpe v0.4s,v1.4s", "frsqrte v0.4s,v1.4s", "frecps v0.4s,v1.4s,v2.4s")}
OTHERS = {"x86-64": ("fldl (%rsp)", "fadds (%rsp)"), "aarch64": ("fmin v0.4s,v1.4s,v2.4s", "fmaxnm s0,s1,s2")}


class ObjectRules(unittest.TestCase):
    given = None

    def build(self, changes):
        return fake_build(self.given.scratch / "objects", self.given.compiler, {**GOOD, **changes})

    def symbol_violations(self, rule, changes):
        found = objects.core_objects(self.build(changes))
        return symbol_rules.RULES[rule][1](found, self.given.nm, self.given.objdump)

    def rejects(self, rule, text, *fragments):
        found = self.symbol_violations(rule, {"zerkalo_core/bad.cpp": text})
        self.assertEqual(len(found), 1, found)
        for fragment in fragments:
            self.assertIn(fragment, found[0])

    def test_good_objects_break_no_rule(self):
        build = self.build({})
        tools = ["--nm", self.given.nm, "--objdump", self.given.objdump]
        for rule in symbol_rules.RULES:
            self.assertEqual(symbol_rules.main([rule, str(build), *tools]), 0, rule)
        self.assertEqual(instruction_rules.main([str(build), *tools[2:]]), 0)

    def test_needs_from_outside_are_rejected_with_function_and_reason(self):
        self.rejects("needs", "extern \"C\" double sin(double); double wave(double x) { return sin(x) + 1; }",
                     "bad.cpp", "wave", " sin ", "libm")
        self.rejects("needs", "int* memory() { return new int[9]; }", "memory", "_Znam", "heap")
        self.rejects("needs", "extern \"C\" void* malloc(unsigned long); void* m(long n) { return malloc(n); }", "heap")
        self.rejects("needs", "__int128 slow(__int128 a, __int128 b) { return a / b; }", "slow", "__divti3", "run-time")
        self.rejects("needs", "extern int elsewhere; int get() { return elsewhere; }", "get", "elsewhere")
        found = self.symbol_violations("needs", {"zerkalo_core/bad.cpp":
                                       "int f(); int once() { static int v = f(); return v; } int f() { return 0 * once(); }"})
        self.assertTrue(any("__cxa_guard" in line for line in found), found)

    def test_the_four_memory_functions_are_allowed(self):
        text = "void copy(char* a, const char* b, unsigned long n) { __builtin_memcpy(a, b, n); __builtin_memset(a, 1, n); " \
               "__builtin_memmove(a, b, n); } int same(char* a, char* b, unsigned long n) { return __builtin_memcmp(a, b, n); }"
        self.assertEqual(self.symbol_violations("needs", {"zerkalo_core/good.cpp": text}), [])

    def test_state_is_rejected(self):
        self.rejects("state", "int counter; int next() { return ++counter; }", "counter", ".bss")
        self.rejects("state", "static int seed = 7; int next() { return seed++; }", "seed", ".data")
        self.rejects("state", "int next() { static int n = 3; return n++; }", "next()::n", ".data")
        found = self.symbol_violations("state", {"zerkalo_core/bad.cpp": "int f(); int value = f();"})
        self.assertTrue(any("before main" in line for line in found), found)
        found = self.symbol_violations("state", {"zerkalo_core/bad.cpp": "thread_local int n = 4; int f() { return n++; }"})
        self.assertTrue(any(".tdata" in line for line in found), found)

    def test_mergeable_functions_of_two_instruction_sets_are_rejected(self):
        shared = "template <class T> __attribute__((noinline)) T half(T x) { return x / 2; }\n" \
                 "float NAME(float x) { return half(x); }"
        kernels = {KERNEL: shared.replace("NAME", "wide"), "zerkalo_kernel_narrow/kernel.cpp": shared.replace("NAME", "narrow")}
        found = self.symbol_violations("merge", kernels)
        self.assertEqual(len(found), 1, found)
        for fragment in ("half", "kernel_wide", "kernel_narrow"):
            self.assertIn(fragment, found[0])
        with_core = {KERNEL: shared.replace("NAME", "wide"), "zerkalo_core/b.cpp": shared.replace("NAME", "plain")}
        self.assertEqual(len(self.symbol_violations("merge", with_core)), 1)
        apart = {name: f"inline namespace {name.split('/')[0]} {{ {text} }}" for name, text in kernels.items()}
        self.assertEqual(self.symbol_violations("merge", apart), [])

    def test_forbidden_instructions_are_rejected_in_any_object(self):
        build = self.build({})
        architecture = instruction_rules.architecture_of(self.given.objdump, objects.core_objects(build)[0].path)
        for what, listing in (("fused", FUSED), ("estimate", ESTIMATES), ("", OTHERS)):
            for instruction in listing[architecture]:
                for name in ("zerkalo_core/bad.cpp", KERNEL):
                    build = self.build({name: f'void bad() {{ asm("{instruction}"); }}'})
                    found, _ = instruction_rules.instruction_violations(objects.core_objects(build), self.given.objdump)
                    self.assertEqual(len(found), 1, f"{instruction}: {found}")
                    self.assertIn("bad()", found[0])
                    self.assertIn(what, found[0])

    def test_a_build_without_objects_or_kernels_is_rejected(self):
        with self.assertRaises(SystemExit):
            objects.core_objects(self.given.scratch / "nothing")
        build = fake_build(self.given.scratch / "objects", self.given.compiler, {"zerkalo_core/a.cpp": "int a() { return 1; }"})
        self.assertEqual(instruction_rules.main([str(build), "--objdump", self.given.objdump]), 1)
        tools = ["--nm", self.given.nm, "--objdump", self.given.objdump]
        self.assertEqual(symbol_rules.main(["merge", str(build), *tools]), 1)

    def test_a_stale_archive_is_rejected(self):
        build = self.build({})
        extra = build / "core" / "CMakeFiles" / "zerkalo_core.dir" / "stale.cpp"
        extra.write_text("int stale() { return 1; }")
        output_of(self.given.compiler, "-c", extra, "-o", f"{extra}.o")
        tools = ["--nm", self.given.nm, "--objdump", self.given.objdump]
        self.assertEqual(symbol_rules.main(["needs", str(build), *tools]), 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scratch", type=Path)
    for option, default in (("--compiler", "g++"), ("--nm", "nm"), ("--objdump", "objdump")):
        parser.add_argument(option, default=default)
    ObjectRules.given = parser.parse_args()
    unittest.main(argv=sys.argv[:1])
