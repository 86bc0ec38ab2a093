"""zerkalo compare: the figures against closed forms, and exit code 4."""
import math
import os
import unittest

from picture_files import write_pfm, write_png
from program import CommandLineTest

GREY = (100, 100, 100)
NAMES = {"rmse_linear", "rmse_srgb8", "max_linear", "psnr", "differing_pixels", "pixels_off_by_more_than_1", "pixels"}


def linear(code, top=255):
    value = code / top
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


class Compare(CommandLineTest):
    def png(self, name, rows, depth=8):
        write_png(self.path(name), rows, depth)
        return self.path(name)

    def pfm(self, name, rows):
        write_pfm(self.path(name), rows)
        return self.path(name)

    def test_a_picture_equals_itself(self):
        a = self.png("a.png", [[GREY, (0, 255, 7)], [(1, 2, 3), GREY]])
        report = self.json("compare", a, a)
        self.assertEqual(report, {"rmse_linear": 0, "rmse_srgb8": 0, "max_linear": 0, "max_srgb8": 0, "psnr": None,
                                  "differing_pixels": 0, "pixels_off_by_more_than_1": 0, "pixels": 4})
        self.succeed("compare", a, a, "--tolerance", "0")

    def test_the_figures_are_the_closed_forms(self):
        a = self.png("a.png", [[GREY, GREY], [GREY, GREY]])
        b = self.png("b.png", [[GREY, (101, 100, 100)], [(100, 100, 110), GREY]])
        report = self.json("compare", a, b)
        self.assertLessEqual(NAMES, set(report))
        counts = ("pixels", "differing_pixels", "pixels_off_by_more_than_1", "max_srgb8")
        self.assertEqual([report[name] for name in counts], [4, 2, 1, 10])
        rmse = math.sqrt((1 + 100) / 12)
        self.assertAlmostEqual(report["rmse_srgb8"], rmse, places=9)
        self.assertAlmostEqual(report["psnr"], 20 * math.log10(255 / rmse), places=9)
        small, large = linear(101) - linear(100), linear(110) - linear(100)
        self.assertAlmostEqual(report["max_linear"], large, places=6)
        self.assertAlmostEqual(report["rmse_linear"], math.sqrt((small ** 2 + large ** 2) / 12), places=6)

    def test_the_order_of_the_pictures_does_not_matter(self):
        a, b = self.png("a.png", [[GREY, GREY]]), self.png("b.png", [[GREY, (90, 80, 70)]])
        self.assertEqual(self.json("compare", a, b), self.json("compare", b, a))

    def test_depths_and_formats_mix(self):
        codes = [[(0, 1, 2), (127, 128, 129)], [(253, 254, 255), GREY]]
        fine = [[tuple(257 * c for c in pixel) for pixel in row] for row in codes]
        light = [[tuple(linear(c) for c in pixel) for pixel in row] for row in codes]
        files = [self.png("8.png", codes), self.png("16.png", fine, 16), self.pfm("a.pfm", light)]
        for a in files:
            for b in files:
                report = self.json("compare", a, b)
                self.assertEqual((report["differing_pixels"], report["rmse_srgb8"]), (0, 0), (a, b))
                self.assertLess(report["max_linear"], 1e-6, (a, b))

    def test_sixteen_bit_codes_round_to_the_nearest_eight_bit_code(self):
        a = self.png("a.png", [[(100, 100, 100)]])
        for code, differing in ((100 * 257 + 128, 0), (100 * 257 + 129, 1), (100 * 257 - 128, 0), (100 * 257 - 129, 1)):
            b = self.png("b.png", [[(code, 25700, 25700)]], 16)
            self.assertEqual(self.json("compare", a, b)["differing_pixels"], differing, code)

    def test_light_beyond_one_counts_only_where_both_files_can_hold_it(self):
        bright, white = self.pfm("a.pfm", [[(3.0, 1.0, 1.0)]]), self.pfm("b.pfm", [[(1.0, 1.0, 1.0)]])
        self.assertEqual(self.json("compare", bright, white)["max_linear"], 2)
        self.assertEqual(self.json("compare", bright, self.png("c.png", [[(255, 255, 255)]]))["max_linear"], 0)

    def test_nan_equals_nan_and_nothing_else(self):
        nan, black = self.pfm("a.pfm", [[(math.nan, 0, 0)]]), self.pfm("b.pfm", [[(0, 0, 0)]])
        same = self.json("compare", nan, nan)
        self.assertEqual((same["differing_pixels"], same["max_linear"], same["rmse_linear"]), (0, 0, 0))
        report = self.json("compare", nan, black)
        self.assertEqual((report["differing_pixels"], report["max_srgb8"], report["max_linear"]), (1, 255, None))
        self.assertEqual(self.run_program("compare", nan, black, "--tolerance", "254").returncode, 4)

    def test_only_where_the_mask_is_not_black_counts(self):
        a = self.png("a.png", [[GREY, GREY, GREY]])
        b = self.png("b.png", [[GREY, (0, 0, 0), (100, 100, 103)]])
        mask = self.png("m.png", [[(255, 255, 255), (0, 0, 0), (0, 0, 1)]])
        report = self.json("compare", a, b, "--mask", mask, "--tolerance", "3")
        self.assertEqual((report["pixels"], report["differing_pixels"], report["max_srgb8"]), (2, 1, 3))

    def test_a_black_mask_or_one_of_another_size_is_refused(self):
        a = self.png("a.png", [[GREY]])
        black, wide = self.png("m.png", [[(0, 0, 0)]]), self.png("n.png", [[GREY, GREY]])
        self.expect_failure(2, "compare", a, a, "--mask", black, says=["m.png", "no pixel counts"])
        self.expect_failure(4, "compare", a, a, "--mask", wide, says=["n.png is 2x1"])

    def test_tolerance_is_the_largest_step_that_passes(self):
        a, b = self.png("a.png", [[GREY, GREY]]), self.png("b.png", [[GREY, (100, 95, 100)]])
        self.succeed("compare", a, b, "--tolerance", "5")
        self.succeed("compare", a, b)
        done = self.run_program("compare", a, b, "--tolerance", "4", "--json")
        self.assertEqual(done.returncode, 4)
        self.assertIn(b"up to 5 steps", done.stderr)
        self.assertIn(b'"max_srgb8": 5', done.stdout)
        for value in ("-1", "256", "0.5", "nan"):
            self.expect_failure(2, "compare", a, b, f"--tolerance={value}", says=["--tolerance", "from 0 to 255"])

    def test_different_sizes_are_exit_4_and_named(self):
        a, b = self.png("a.png", [[GREY, GREY]]), self.pfm("b.pfm", [[(0, 0, 0)]])
        self.expect_failure(4, "compare", a, b, says=["a.png is 2x1", "b.pfm is 1x1"])

    def test_a_picture_that_cannot_be_read_is_exit_1_and_named(self):
        a = self.png("a.png", [[GREY, GREY], [GREY, GREY]])
        self.expect_failure(1, "compare", a, self.path("none.png"), says=["none.png", "No such file"])
        self.expect_failure(1, "compare", self.file("text.png", "hello"), a, says=["text.png"])
        self.expect_failure(1, "compare", self.file("empty.png", ""), a, says=["empty.png"])
        whole = (self.files / "a.png").read_bytes()
        for length in (20, len(whole) // 2, len(whole) - 14):
            (self.files / "cut.png").write_bytes(whole[:length])
            self.expect_failure(1, "compare", a, self.path("cut.png"), says=["cut.png"])
        (self.files / "cut.pfm").write_bytes(b"PF\n2 2\n-1.0\n" + bytes(47))
        self.expect_failure(1, "compare", a, self.path("cut.pfm"), says=["cut.pfm"])
        os.mkdir(self.path("d.png"))
        self.expect_failure(1, "compare", a, self.path("d.png"), says=["d.png"])

    def test_the_text_says_the_same_as_the_json(self):
        a, b = self.png("a.png", [[GREY, GREY]]), self.png("b.png", [[GREY, (100, 95, 100)]])
        text = self.succeed("compare", a, b).decode()
        self.assertIn("largest 5, PSNR", text)
        self.assertIn("pixels: 2, differing 1, off by more than 1 step 1", text)


if __name__ == "__main__":
    unittest.main()
