"""zerkalo compare: the figures against closed forms, exit code 4, and the map of the differences."""
import json
import math
import os
import unittest

from picture_files import read_png, write_pfm, write_png
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

class CompareMap(CommandLineTest):
    """--map OUT.png: the picture of the differences."""

    def setUp(self):
        super().setUp()
        self.a, self.b, self.map = self.path("a.png"), self.path("b.png"), self.path("map.png")

    def write_pair(self, a, b):
        write_png(self.a, a)
        write_png(self.b, b)

    def map_rows(self, *arguments):
        self.succeed("compare", self.a, self.b, "--map", self.map, *arguments)
        width, height, depth, rows = read_png((self.files / "map.png").read_bytes())
        self.assertEqual((width, height, depth), (len(rows[0]), len(rows), 8))
        return rows

    def test_every_step_has_the_colour_of_its_class_and_larger_is_brighter(self):
        self.write_pair([[(0, 0, 0)] * 256], [[(step, 0, 0) for step in range(256)]])
        row = self.map_rows()[0]
        classes = [(0, 0), (1, 1), (2, 2), (3, 4), (5, 8), (9, 16), (17, 32), (33, 64), (65, 128), (129, 255)]
        colours = []
        for first, last in classes:
            self.assertEqual(set(row[first:last + 1]), {row[first]}, (first, last))
            colours.append(row[first])
        self.assertEqual((colours[0], colours[-1]), ((0, 0, 0), (255, 255, 255)))
        brightness = [sum(w * linear(c) for w, c in zip((0.2126, 0.7152, 0.0722), colour)) for colour in colours]
        for dark, bright in zip(brightness, brightness[1:]):
            self.assertGreater(bright, 1.2 * dark, colours)
        self.assertGreater(brightness[1], 0.05, "one step is plain to see against black")

    def test_the_worst_channel_counts_in_either_sense_and_every_pixel_keeps_its_place(self):
        a = [[GREY, GREY, GREY], [GREY, GREY, GREY]]
        b = [[GREY, (99, 100, 102), GREY], [(100, 0, 101), GREY, (101, 101, 101)]]
        self.write_pair(a, b)
        rows = self.map_rows()
        self.write_pair([[(0, 0, 0)] * 3], [[(1, 0, 0), (2, 0, 0), (100, 0, 0)]])
        one, two, hundred = self.map_rows()[0]
        black = (0, 0, 0)
        self.assertEqual(rows, [[black, two, black], [hundred, black, one]])

    def test_nan_against_a_number_is_white_and_the_mask_hides_in_grey(self):
        write_pfm(self.a, [[(math.nan, 0, 0), (1, 1, 1), (math.nan, 0, 0)]])
        write_pfm(self.b, [[(0, 0, 0), (0, 0, 0), (math.nan, 0, 0)]])
        write_png(self.path("mask.png"), [[(9, 0, 0), (0, 0, 0), (0, 0, 9)]])
        rows = self.map_rows("--mask", self.path("mask.png"))
        self.assertEqual(rows, [[(255, 255, 255), (64, 64, 64), (0, 0, 0)]])

    def test_exit_code_4_of_the_tolerance_still_writes_the_map(self):
        self.write_pair([[GREY]], [[(100, 95, 100)]])
        expected = self.map_rows()
        os.remove(self.map)
        done = self.run_program("compare", self.a, self.b, "--tolerance", "4", "--map", self.map, "--json")
        self.assertEqual(done.returncode, 4)
        self.assertEqual(read_png((self.files / "map.png").read_bytes())[3], expected)
        report = json.loads(done.stdout)
        self.assertEqual((report["map"], report["max_srgb8"]), (self.map, 5))

    def test_the_text_and_the_help_explain_the_scale(self):
        self.write_pair([[GREY]], [[GREY]])
        scale = "black 0, blue 1, violet 2, magenta to 4"
        text = self.succeed("compare", self.a, self.b, "--map", self.map).decode()
        self.assertIn("map.png, steps of the worst channel: " + scale, text)
        self.assertNotIn("map", self.succeed("compare", self.a, self.b).decode())
        self.assertNotIn("map", self.json("compare", self.a, self.b))
        help_text = " ".join(self.succeed("compare", "--help").decode().split())
        self.assertIn(scale, help_text)
        self.assertIn("white to 255", help_text)

    def test_pictures_that_cannot_be_compared_leave_no_map(self):
        self.write_pair([[GREY, GREY]], [[GREY]])
        self.expect_failure(4, "compare", self.a, self.b, "--map", self.map, says=["a.png is 2x1", "b.png is 1x1"])
        self.expect_failure(1, "compare", self.a, self.path("c.png"), "--map", self.map, says=["c.png", "No such file"])
        write_png(self.path("mask.png"), [[(0, 0, 0), (0, 0, 0)]])
        self.expect_failure(2, "compare", self.a, self.a, "--mask", self.path("mask.png"), "--map", self.map,
                            says=["mask.png", "no pixel counts"])
        self.assertEqual(self.names(), ["a.png", "b.png", "mask.png", "scene.toml"])

    def test_a_map_that_cannot_be_written_is_exit_1_and_leaves_nothing(self):
        self.write_pair([[GREY] * 99] * 99, [[(100, 95, 100)] * 99] * 99)
        os.mkdir(self.path("d.png"))
        for path, reason in ((self.path("none/map.png"), "No such file or directory"), ("/proc/map.png", "cannot write"),
                             (self.path("d.png"), "directory")):
            self.expect_failure(1, "compare", self.a, self.b, "--map", path, says=[path, reason])
        self.expect_failure(1, "compare", self.a, self.b, "--map", self.map, file_limit=64,
                            says=["map.png", "File too large"])
        self.assertEqual(self.names(), ["a.png", "b.png", "d.png", "scene.toml"])

    def test_a_failed_map_leaves_the_older_one_as_it_was(self):
        self.write_pair([[GREY] * 99] * 99, [[(100, 95, 100)] * 99] * 99)
        (self.files / "map.png").write_bytes(b"older")
        self.expect_failure(1, "compare", self.a, self.b, "--map", self.map, file_limit=64)
        self.assertEqual((self.files / "map.png").read_bytes(), b"older")

    def test_a_map_never_replaces_a_picture_that_is_read(self):
        self.write_pair([[GREY]], [[GREY]])
        write_png(self.path("mask.png"), [[GREY]])
        os.symlink("b.png", self.path("link.png"))
        whole = (self.files / "a.png").read_bytes()
        for name in ("a.png", "b.png", "mask.png", "link.png", "./a.png"):
            self.expect_failure(2, "compare", self.a, self.b, "--mask", self.path("mask.png"), "--map", self.path(name),
                                says=["--map", "that is the picture", "name another file"])
        self.assertEqual((self.files / "a.png").read_bytes(), whole)

    def test_a_map_is_a_png_file(self):
        self.write_pair([[GREY]], [[GREY]])
        self.expect_failure(2, "compare", self.a, self.b, "--map", "-", says=["--map -", "name a file"])
        for name in ("map.pfm", "map", ""):
            self.expect_failure(2, "compare", self.a, self.b, "--map", name, says=["--map", "must end in .png"])
        self.assertEqual(self.names(), ["a.png", "b.png", "scene.toml"])


if __name__ == "__main__":
    unittest.main()
