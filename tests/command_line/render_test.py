"""zerkalo render: the picture and the report."""
import struct
import unittest

from picture_files import read_pfm, read_png
from program import CommandLineTest, SCENE


def fnv1a(data):
    """64-bit FNV-1a (draft-eastlake-fnv)."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value


class Render(CommandLineTest):
    def png(self, *arguments):
        self.succeed("render", self.scene, "-o", self.path("a.png"), *arguments)
        return read_png((self.files / "a.png").read_bytes())

    def pfm(self, *arguments):
        self.succeed("render", self.scene, "-o", self.path("a.pfm"), *arguments)
        return read_pfm((self.files / "a.pfm").read_bytes())

    def test_a_png_has_the_size_of_the_scene_and_8_bits(self):
        width, height, depth, rows = self.png()
        self.assertEqual((width, height, depth), (32, 24, 8))
        self.assertGreater(len({pixel for row in rows for pixel in row}), 10, "the picture is nearly empty")

    def test_size_overrides_the_scene(self):
        self.assertEqual(self.png("--size", "17x5")[:2], (17, 5))

    def test_depth_16_gives_a_png_of_16_bits_that_rounds_to_the_8_bit_one(self):
        depth, deep = self.png("--depth", "16")[2:]
        self.assertEqual(depth, 16)
        shallow = self.png()[3]
        for deep_row, row in zip(deep, shallow):
            for deep_pixel, pixel in zip(deep_row, row):
                for fine, coarse in zip(deep_pixel, pixel):
                    self.assertLessEqual(abs(fine / 257 - coarse), 0.51, (fine, coarse))

    def test_the_pfm_resolves_to_the_png(self):
        def code(linear):
            linear = min(max(linear, 0.0), 1.0)
            curve = 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
            return curve * 255
        linear, codes = self.pfm()[2], self.png()[3]
        for linear_row, row in zip(linear, codes):
            for linear_pixel, pixel in zip(linear_row, row):
                for value, stored in zip(linear_pixel, pixel):
                    self.assertLessEqual(abs(code(value) - stored), 0.51, (value, stored))

    def test_a_dash_puts_the_same_png_on_standard_output_and_the_summary_nowhere(self):
        done = self.run_program("render", self.scene, "-o", "-")
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        self.png()
        self.assertEqual(read_png(done.stdout), read_png((self.files / "a.png").read_bytes()))

    def test_json_has_the_promised_names(self):
        report = self.json("render", self.scene, "-o", self.path("a.png"), "--samples", "4", "--threads", "1")
        for name, kind in {"scene": str, "width": int, "height": int, "seconds": float, "isa": str, "lanes": int,
                           "number": str, "threads": int, "samples": int, "antialias": int, "depth_limit": int,
                           "estimator": str, "rays": dict, "features": list, "hash": str, "output": str}.items():
            self.assertIsInstance(report.get(name), kind, name)
        self.assertEqual(set(report["rays"]), {"primary", "reflected", "lobe", "refracted", "shadow"})
        self.assertNotIn("seconds_min", report)
        self.assertEqual([report[name] for name in ("scene", "output", "width", "height", "samples", "threads",
                                                    "antialias", "depth_limit", "number", "estimator")],
                         [self.scene, self.path("a.png"), 32, 24, 4, 1, 1, 6, "float", "fibonacci"])
        self.assertEqual(report["rays"]["primary"], 32 * 24)

    def test_the_hash_is_that_of_the_linear_picture(self):
        report = self.json("render", self.scene, "-o", self.path("a.pfm"))
        rows = read_pfm((self.files / "a.pfm").read_bytes())[2]
        linear = b"".join(struct.pack("<3f", *pixel) for row in rows for pixel in row)
        self.assertEqual(report["hash"], f"{fnv1a(linear):016x}")

    def test_repeat_reports_the_median_between_the_extremes(self):
        report = self.json("render", self.scene, "-o", self.path("a.png"), "--repeat", "5")
        self.assertEqual(report["repeat"], 5)
        self.assertLessEqual(report["seconds_min"], report["seconds"])
        self.assertLessEqual(report["seconds"], report["seconds_max"])
        self.assertEqual(report["rays"]["primary"], 32 * 24)

    def test_every_isa_and_thread_count_gives_the_same_hash(self):
        hashes = {}
        for isa in self.json("doctor")["isas"]:
            for threads in ("1", "2", "5"):
                if isa["available"]:
                    report = self.json("render", self.scene, "-o", self.path("a.png"), "--isa", isa["name"],
                                       "--threads", threads)
                    self.assertEqual((report["isa"], report["lanes"]), (isa["name"], isa["lanes"]))
                    hashes[isa["name"], threads] = report["hash"]
        self.assertGreaterEqual(len(hashes), 6)
        self.assertEqual(len(set(hashes.values())), 1, hashes)

    def test_double_gives_the_float_picture_by_one_lane_under_every_isa(self):
        floats = [value for row in self.pfm("--isa", "scalar")[2] for pixel in row for value in pixel]
        hashes = set()
        for isa in self.json("doctor")["isas"]:
            for threads in ("1", "3"):
                if isa["available"]:
                    report = self.json("render", self.scene, "-o", self.path("d.pfm"), "--number", "double",
                                       "--isa", isa["name"], "--threads", threads)
                    self.assertEqual((report["number"], report["lanes"], report["isa"]), ("double", 1, isa["name"]))
                    hashes.add(report["hash"])
        self.assertEqual(len(hashes), 1, hashes)
        rows = read_pfm((self.files / "d.pfm").read_bytes())[2]
        doubles = [value for row in rows for pixel in row for value in pixel]
        apart = sorted(abs(a - b) for a, b in zip(floats, doubles, strict=True))
        self.assertGreater(apart[-1], 0, "nothing of float's rounding is left in the picture")
        # One pixel in a thousand may see another surface.
        self.assertLess(apart[len(apart) * 999 // 1000 - 1], 1e-4)

    def test_the_isa_without_a_choice_is_the_one_that_doctor_names(self):
        report = self.json("render", self.scene, "-o", self.path("a.png"))
        self.assertEqual(report["isa"], self.json("doctor")["isa"])

    def test_quality_options_reach_the_renderer(self):
        plain = self.json("render", self.scene, "-o", self.path("a.png"))
        more = self.json("render", self.scene, "-o", self.path("a.png"), "--antialias", "4")
        self.assertEqual(more["rays"]["primary"], 4 * plain["rays"]["primary"])
        flat = self.json("render", self.scene, "-o", self.path("a.png"), "--depth-limit", "0")
        self.assertEqual(flat["rays"]["lobe"] + flat["rays"]["reflected"], 0)
        dense = self.json("render", self.scene, "-o", self.path("a.png"), "--samples", "64")
        self.assertGreater(dense["rays"]["lobe"], plain["rays"]["lobe"])
        self.assertGreater(plain["rays"]["lobe"], 0)

    def test_pixels_at_edges_alone_get_more_camera_rays(self):
        plain = self.json("render", self.scene, "-o", self.path("a.png"))
        auto = self.json("render", self.scene, "-o", self.path("a.png"), "--antialias", "auto")
        self.assertNotIn("edge_pixels", plain)
        self.assertEqual((auto["antialias"], auto["edge_antialias"]), (1, 16))
        self.assertGreater(auto["edge_pixels"], 0)
        self.assertEqual(auto["rays"]["primary"], plain["rays"]["primary"] + 16 * auto["edge_pixels"])
        self.assertLess(auto["edge_pixels"], plain["rays"]["primary"] // 2)
        self.assertIn("antialias", auto["features"])
        for more in ("--threads", "3"), ("--isa", "scalar"), ("--repeat", "3"):
            again = self.json("render", self.scene, "-o", self.path("a.png"), "--antialias", "auto", *more)
            self.assertEqual((again["hash"], again["rays"]), (auto["hash"], auto["rays"]), more)

    def test_an_exact_plan_sends_the_lobe_rays_that_culling_spares(self):
        scene = self.file("phong.toml", SCENE.replace("lobe_exponent", "lobe = \"phong\"\nlobe_exponent"))
        plain = self.json("render", scene, "-o", self.path("a.png"))
        exact = self.json("render", scene, "-o", self.path("a.png"), "--exact-plan")
        self.assertEqual((plain["exact_plan"], exact["exact_plan"]), (False, True))
        self.assertGreater(exact["rays"]["lobe"], plain["rays"]["lobe"])

    def test_features_name_what_the_scene_uses(self):
        sharp = self.file("sharp.toml", SCENE.replace("lobe_exponent = 200.0", ""))
        glossy = self.json("render", self.scene, "-o", self.path("a.png"))["features"]
        self.assertIn("sphere", glossy)
        self.assertNotEqual(glossy, self.json("render", sharp, "-o", self.path("a.png"))["features"])

    def test_the_summary_is_one_line_with_the_output_and_the_speed(self):
        text = self.succeed("render", self.scene, "-o", self.path("a.png")).decode()
        self.assertRegex(text, r"\A\S*a\.png: 32x24 in [0-9.]+ ms, [0-9.]+ Mray/s "
                               r"\([a-z0-9.]+, \d+ lanes?, \d+ threads?\)\n\Z")

    def test_names_that_are_not_utf8_still_give_json(self):
        report = self.json("render", self.scene, "-o", self.path("a").encode() + b"\xff\"\\\n.png")
        self.assertEqual(report["output"], self.path("a") + "\ufffd\"\\\n.png")


if __name__ == "__main__":
    unittest.main()
