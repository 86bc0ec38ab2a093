"""Feeds bad source trees to the source rules: each must be rejected, by the right rule, at the right line."""
import tempfile
import unittest
from pathlib import Path

import source_rules

GOOD = {
    "core/status.hpp": "#pragma once\n#include <cstdint>\n",
    "core/numeric/lane.hpp": '#include "core/status.hpp"\n#include <xsimd/xsimd.hpp>\nusing xsimd::batch;\n',
    "core/geometry/vec.hpp": '// Unlike xsimd.\n#include "core/numeric/lane.hpp"\n',
    "core/image/image_view.hpp": "#include <cstddef>\n",
    "core/render/render.hpp": '#include "core/geometry/vec.hpp"\n#include "core/image/image_view.hpp"\n',
    "platform/png.hpp": '#include "core/image/image_view.hpp"\n#include <string>\n',
    "firmware/kiosk.cpp": '#include "core/render/render.hpp"\n#include "platform/png.hpp"\n',
    "tools/main.cpp": '/* #include "firmware/kiosk.cpp" */\n#include "core/render/render.hpp"\n#include <vector>\n',
    "tests/some_test.cpp": '#include "tools/main.cpp"\n#include "firmware/kiosk.cpp"\n',
}


class SourceRules(unittest.TestCase):
    def violations(self, rule, **changes):
        """What a rule says about the good tree with some files replaced; `a__b_hpp` stands for a/b.hpp."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for name, text in {**GOOD, **changes.pop("files", {})}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return source_rules.RULES[rule][1](root)[0]

    def rejects(self, rule, name, text, *fragments):
        found = self.violations(rule, files={name: text})
        self.assertEqual(len(found), 1, found)
        for fragment in (name, *fragments):
            self.assertIn(fragment, found[0])

    def test_a_good_tree_breaks_no_rule(self):
        for rule in source_rules.RULES:
            self.assertEqual(self.violations(rule), [], rule)

    def test_every_arrow_against_the_direction_is_rejected(self):
        against = (("core/numeric/a.hpp", "core/geometry/vec.hpp"), ("core/geometry/a.hpp", "core/render/render.hpp"),
                   ("core/image/a.hpp", "core/geometry/vec.hpp"), ("core/shapes/a.hpp", "core/image/image_view.hpp"), ("core/status.hpp", "core/geometry/vec.hpp"),
                   ("core/render/a.cpp", "platform/png.hpp"), ("core/render/b.cpp", "tools/main.cpp"),
                   ("platform/a.cpp", "core/render/render.hpp"), ("platform/b.cpp", "core/geometry/vec.hpp"),
                   ("platform/c.cpp", "tools/main.cpp"), ("tools/a.cpp", "firmware/kiosk.cpp"),
                   ("firmware/a.cpp", "tools/main.cpp"), ("tools/b.cpp", "tests/some_test.cpp"),
                   ("core/render/c.hpp", "tests/some_test.cpp"))
        for source, target in against:
            self.rejects("arrows", source, f'#pragma once\n#include "{target}"\n', ":2:", f"must not see {target}")

    def test_angle_brackets_do_not_hide_an_arrow(self):
        self.rejects("arrows", "tools/a.cpp", "#include <firmware/kiosk.cpp>\n", "must not see firmware/kiosk.cpp")

    def test_odd_includes_are_rejected(self):
        self.rejects("arrows", "core/geometry/a.hpp", '#include "vec.hpp"\n', "repository root")
        self.rejects("arrows", "core/geometry/a.hpp", '#include "core/geometry/gone.hpp"\n', "does not exist")
        self.rejects("arrows", "core/geometry/a.hpp", "#include HEADER\n", "macro")
        self.rejects("arrows", "core/strange/a.hpp", "\n", "no layer")

    def test_headers_that_bring_more_than_types_are_rejected(self):
        for header in ("vector", "string", "iostream", "cmath", "algorithm", "atomic", "math.h", "memory", "new"):
            self.rejects("headers", "core/render/a.hpp", f"\n # include <{header}>\n", ":2:", f"<{header}>")
        self.rejects("headers", "core/render/a.hpp", "#include <immintrin.h>\n", "<immintrin.h>")
        self.rejects("headers", "core/numeric/a.hpp", "#include <cpuid.h>\n", "<cpuid.h>")

    def test_a_second_user_of_the_lane_library_is_rejected(self):
        self.rejects("lanes", "core/geometry/a.hpp", "using B = xsimd::batch<float>;\n", "only one file")
        self.rejects("lanes", "core/render/a.hpp", "#include <xsimd/xsimd.hpp>\n", "only one file")
        self.rejects("lanes", "core/numeric/second.hpp", "using B = xsimd::batch<float>;\n", "more than one")

    def test_line_301_is_rejected(self):
        self.assertEqual(self.violations("length", files={"tools/a.cpp": "\n" * 300}), [])
        for name in ("tools/a.cpp", "tests/a.py", "tools/a.sh", "core/CMakeLists.txt", "tools/a.cmake"):
            self.rejects("length", name, "\n" * 301, "301 lines")

    def test_an_empty_tree_is_rejected(self):
        with tempfile.TemporaryDirectory() as folder:
            for rule in source_rules.RULES:
                self.assertEqual(source_rules.main([rule, folder]), 1)


if __name__ == "__main__":
    unittest.main()
