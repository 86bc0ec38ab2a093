"""Feeds differing hashes to the comparison of the determinism matrix: each must be found, with its first stage."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import determinism_matrix as matrix  # noqa: E402


def lines(isa, schedule="rows:1", scene="ball", changed=()):
    """What a program prints; the hash of a stage in `changed` is another one."""
    stages = matrix.STAGES if schedule == "rows:1" else ("radiance",)
    return "".join(f"{isa} {schedule} {scene} float {stage} {'bad' if stage in changed else stage}\n" for stage in stages)


GOOD = lines("scalar") + lines("scalar", scene="cone") + lines("avx2") + lines("avx2", scene="cone") + \
    lines("avx2", "shuffled:3") + lines("avx2", "shuffled:3", scene="cone")
ONE = matrix.Build("one", "g++", "-O1")
TWO = matrix.Build("two", "clang++", "-O3")
BROKEN = matrix.Build("broken", "clang++", "-O1", breaks="-ffp-contract=fast")


class Matrix(unittest.TestCase):
    def report(self, **outputs):
        builds = [build for build in (ONE, TWO, BROKEN) if build.name in outputs]
        return matrix.report({name: matrix.parsed(text) for name, text in outputs.items()}, builds)

    def test_equal_hashes_are_accepted_and_counted(self):
        text, good = self.report(one=GOOD, two=GOOD)
        self.assertTrue(good)
        self.assertIn("6 configurations, 6 with these hashes, 0 with others.", text)
        self.assertIn("| ball | `radiance` |", text)
        self.assertIn("| `clang++ -O3` | scalar, avx2 | shuffled:3 |", text)

    def test_the_first_stage_that_differs_is_named(self):
        for first in range(len(matrix.STAGES)):
            later = matrix.STAGES[first:]
            odd = GOOD.replace(lines("avx2", scene="cone"), lines("avx2", scene="cone", changed=later))
            text, good = self.report(one=GOOD, two=odd)
            self.assertFalse(good)
            self.assertIn(f"| scalar; **differing: avx2 ({matrix.STAGES[first]} of cone, float)** |", text)
            self.assertIn("5 with these hashes, 1 with others", text)

    def test_the_earliest_stage_of_all_pictures_is_named(self):
        odd = lines("scalar", changed=("radiance",)) + lines("scalar", scene="cone", changed=("hit", "radiance"))
        self.assertIn("hit of cone", self.report(one=GOOD, two=odd)[0])

    def test_a_schedule_that_differs_is_rejected(self):
        odd = GOOD.replace(lines("avx2", "shuffled:3"), lines("avx2", "shuffled:3", changed=("radiance",)))
        text, good = self.report(one=GOOD, two=odd)
        self.assertFalse(good)
        self.assertIn("**differing: shuffled:3 (radiance of ball, float)**", text)

    def test_a_picture_that_is_missing_is_rejected(self):
        text, good = self.report(one=GOOD, two=lines("scalar"))
        self.assertFalse(good)
        self.assertIn("missing of cone", text)

    def test_a_broken_build_must_differ(self):
        bad = lines("scalar", changed=matrix.STAGES) + lines("scalar", scene="cone")
        text, good = self.report(one=GOOD, broken=bad)
        self.assertTrue(good)
        self.assertIn("is caught", text)
        text, good = self.report(one=GOOD, broken=GOOD)
        self.assertFalse(good)
        self.assertIn("is NOT caught", text)

    def test_nothing_but_a_broken_build_proves_nothing(self):
        self.assertFalse(self.report(broken=GOOD)[1])


if __name__ == "__main__":
    unittest.main()
