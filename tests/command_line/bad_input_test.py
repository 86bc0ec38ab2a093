"""Bad numbers through the real program: for every number of the scene files in tests/bad_input/scenes, one at a time,
the picture is written, or exit code 3 with one diagnostic that names file, line, column and key, and no file."""
import pathlib
import re
import unittest

from program import CommandLineTest

SCENES = pathlib.Path(__file__).resolve().parent.parent / "bad_input" / "scenes"
WORD = re.compile(r'([a-z_]+) *=|"[^"]*"|[-+]?[0-9][0-9.e+-]*')
# Rules that bind two keys: the other one may be named.
OTHER = {"width": "curvature_radius", "height": "curvature_radius", "radius": "curvature_radius",
         "points": "curvature_radius", "vertices": "triangles", "reflection": "transmission"}


def numbers_of(text):
    """(begin, end, line from 1, key) of every number."""
    begin = 0
    for number, line in enumerate(text.splitlines(keepends=True), 1):
        key = None
        for word in WORD.finditer("" if line.startswith("#") else line):
            if word.group(1):
                key = word.group(1)
            elif not word.group().startswith('"'):
                yield begin + word.start(), begin + word.end(), number, key
        begin += len(line)


class BadNumbers(CommandLineTest):
    def expect_answer(self, text, literal):
        answers = {0: 0, 3: 0}
        for begin, end, line, key in numbers_of(text):
            scene = self.file("bad.toml", text[:begin] + literal + text[end:])
            done = self.run_program("render", scene, "-o", self.path("a.png"), "--size", "8x6", "--samples", "2",
                                    "--threads", "1", "--json")
            told, where = done.stderr.decode(), f"{line}: {key} = {literal}"
            self.assertIn(done.returncode, answers, f"{where}: {told}")
            answers[done.returncode] += 1
            if done.returncode == 0:
                self.assertEqual(self.names(), ["a.png", "bad.toml", "scene.toml"], where)
                (self.files / "a.png").unlink()
                continue
            self.assertEqual(self.names(), ["bad.toml", "scene.toml"], where)
            self.assertEqual(told.count("error:"), 1, f"{where}: {told}")
            place = re.match(re.escape(scene) + r":(\d+):(\d+): error: .*\n", told)
            self.assertTrue(place, f"{where}: {told}")
            if f'"{key}"' in place.group() or f'.{key}"' in place.group():
                self.assertEqual(int(place.group(1)), line, f"{where}: {told}")
            else:
                self.assertIn(f'"{OTHER.get(key, key)}"', place.group(), where)
        return answers

    def test_no_number_may_be_nan(self):
        for name in ("round.toml", "sharp.toml"):
            text = (SCENES / name).read_text(encoding="utf-8")
            self.assertEqual(self.expect_answer(text, "nan"), {0: 0, 3: len(list(numbers_of(text)))}, name)

    def test_huge_and_negative_numbers_are_named_or_rendered(self):
        for name in ("round.toml", "sharp.toml"):
            text = (SCENES / name).read_text(encoding="utf-8")
            for literal in ("1e30", "-1.0"):
                answers = self.expect_answer(text, literal)
                self.assertGreater(min(answers.values()), 5, (name, literal, answers))


if __name__ == "__main__":
    unittest.main()
