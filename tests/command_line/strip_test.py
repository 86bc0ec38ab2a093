"""zerkalo strip: eleven degrees of polish side by side, even to the eye."""
import pathlib
import unittest

from picture_files import read_png
from program import CommandLineTest, SCENE

SCENES = pathlib.Path(__file__).resolve().parents[2] / "firmware" / "scenes"


class Strip(CommandLineTest):
    def strip(self, scene, *arguments):
        report = self.json("strip", scene, "-o", self.path("strip.png"), *arguments)
        return report["pictures"], read_png((self.files / "strip.png").read_bytes())

    def refuse(self, code, *arguments, says):
        self.expect_failure(code, "strip", *arguments, says=says)
        self.assertNotIn("strip.png", self.names())

    def test_each_part_is_the_picture_of_that_polish(self):
        pictures, (width, height, depth, rows) = self.strip(self.scene, "--samples", "5")
        self.assertEqual((width, height, depth), (11 * 32, 24, 8))
        self.assertEqual([picture["polish"] for picture in pictures], [k / 10 for k in range(11)])
        for k in (0, 3, 8, 10):
            mirror = f"polish = {k / 10}\nshininess = 200.0"
            scene = self.file(f"{k}.toml", SCENE.replace("lobe_exponent = 200.0", mirror))
            self.succeed("render", scene, "-o", self.path("one.png"), "--samples", "5")
            one = read_png((self.files / "one.png").read_bytes())[3]
            self.assertEqual([row[32 * k:32 * k + 32] for row in rows], one, k)

    def test_the_exponents_are_those_of_the_documented_map(self):
        pictures = self.strip(self.scene)[0]
        for picture in pictures[:10]:
            rough = 1 - picture["polish"]
            self.assertAlmostEqual(picture["exponent"], (rough ** -4 - 1) / 2, places=6 - (rough < 0.2) * 3)
        self.assertIsNone(pictures[10]["exponent"])  # infinity

    def test_the_map_is_even_to_the_eye(self):
        # From 0.3 on no tenth of the dial changes the picture more than four times as much as another one, before that,
        # in the haze, no less than a sixth of the most, and nowhere by more than 1.8 times its neighbour.
        for name in ("gold-mirror-5", "sphere", "prism"):
            pictures = self.strip(str(SCENES / f"{name}.toml"), "--size", "80x60", "--samples", "256")[0]
            steps = [picture["rmse_srgb8_from_last"] for picture in pictures[1:]]
            self.assertLessEqual(max(steps[3:]), 4 * min(steps[3:]), (name, steps))
            self.assertGreaterEqual(min(steps), max(steps) / 6, (name, steps))
            for one, next_one in zip(steps, steps[1:]):
                self.assertLessEqual(max(one, next_one), 1.8 * min(one, next_one), (name, steps))

    def test_the_text_is_a_table_of_eleven_lines(self):
        text = self.succeed("strip", self.scene, "-o", self.path("strip.png")).decode()
        self.assertEqual(len(text.splitlines()), 12, text)
        self.assertRegex(text.splitlines()[6], r"^ +0\.5 +7\.5 +\d+\.\d\d$")

    def test_what_cannot_be_a_strip_is_refused(self):
        bare = self.file("bare.toml", SCENE[:SCENE.index("[[mirror]]")])
        self.refuse(3, bare, "-o", self.path("strip.png"), says=["has no mirror"])
        self.refuse(2, self.scene, "-o", self.path("strip.pfm"), says=["must end in .png"])
        self.refuse(2, self.scene, "-o", "-", says=["standard output holds the figures"])
        self.refuse(2, self.scene, "-o", self.path("strip.png"), "--size", "6000x10", says=["at most 5957 each"])
        self.refuse(1, self.scene, "-o", self.path("no/strip.png"), says=["strip.png"])


if __name__ == "__main__":
    unittest.main()
