"""zerkalo render --error and --time: pictures in passes."""
import itertools
import json
import pathlib
import signal
import subprocess
import time
import unittest

from picture_files import read_pfm
from program import CommandLineTest, PROGRAM

ESTIMATORS = "random", "jittered", "sobol", "r2", "fibonacci", "fibonacci+coverage"


class Refine(CommandLineTest):
    def report(self, *arguments):
        return json.loads(self.succeed("render", self.scene, "-o", self.path("a.pfm"), "--json", *arguments))

    def pixels(self):
        return read_pfm((self.files / "a.pfm").read_bytes())[2]

    def distance(self, other):
        squares = [(a - b) ** 2 for row, of_other in zip(self.pixels(), other)
                   for pixel, there in zip(row, of_other) for a, b in zip(pixel, there)]
        return (sum(squares) / len(squares)) ** 0.5

    def refused(self, *arguments):
        done = self.run_program("render", self.scene, "-o", self.path("a.pfm"), *arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse((self.files / "a.pfm").exists())
        return done.stderr.decode()

    @staticmethod
    def catches(process, number):
        status = pathlib.Path(f"/proc/{process}/status").read_text()
        caught = int(next(line for line in status.splitlines() if line.startswith("SigCgt")).split()[1], 16)
        return caught >> (number - 1) & 1

    def test_json_tells_what_was_asked_estimated_and_spent(self):
        report = self.report("--error", "0.003")
        self.assertEqual(report["asked"], {"error": 0.003})
        self.assertLessEqual(report["estimated_error"], 0.003)
        self.assertGreater(report["estimated_error"], 0)
        self.assertEqual((report["reached"], report["deterministic"]), (True, True))
        self.assertEqual(report["spent"]["lobe_rays"], report["rays"]["lobe"])
        self.assertGreaterEqual(report["spent"]["passes"], 1)
        self.assertGreaterEqual(report["spent"]["most_samples"], 4)

    def test_a_smaller_error_costs_more_rays_and_lies_nearer_to_the_limit(self):
        self.report("--samples", "8192")
        limit = self.pixels()
        last_rays, last_distance = 0, 1
        for error in "0.003", "0.001", "0.0002":
            report = self.report("--error", error)
            distance = self.distance(limit)
            self.assertGreater(report["rays"]["lobe"], last_rays, error)
            self.assertLess(distance, last_distance, error)
            self.assertLess(distance, 1.5 * float(error), error)
            last_rays, last_distance = report["rays"]["lobe"], distance

    def test_an_error_gives_the_same_bytes_with_any_threads_and_instruction_set(self):
        hashes = {self.report("--error", "0.002", *more)["hash"]
                  for more in ((), ("--threads", "1"), ("--threads", "7"), ("--isa", "scalar"))}
        self.assertEqual(len(hashes), 1, hashes)

    def test_every_estimator_and_kind_of_numbers_reaches_an_error_with_the_same_bytes_everywhere(self):
        self.report("--samples", "8192")
        limit = self.pixels()
        for number, estimator in itertools.product(("float", "fixed", "double"), ESTIMATORS):
            with self.subTest(number=number, estimator=estimator):
                asked = "--error", "0.002", "--number", number, "--estimator", estimator
                report = self.report(*asked)
                self.assertTrue(report["reached"])
                self.assertLessEqual(report["estimated_error"], 0.002)
                self.assertEqual((report["number"], report["estimator"]), (number, estimator))
                self.assertLess(self.distance(limit), 1.5 * 0.002)
                for more in ("--threads", "3"), ("--isa", "scalar"):
                    self.assertEqual(self.report(*asked, *more)["hash"], report["hash"], more)

    def test_an_error_is_reached_where_a_pixel_has_several_camera_rays(self):
        for more in ("--estimator", "sobol"), ("--number", "fixed"):
            one = self.report("--error", "0.002", *more)
            several = self.report("--error", "0.002", "--antialias", "4", *more)
            self.assertTrue(several["reached"])
            self.assertGreater(several["rays"]["primary"], one["rays"]["primary"])

    def test_pixels_at_edges_share_the_lobe_rays_of_their_tiles(self):
        for more in (), ("--estimator", "sobol"), ("--number", "fixed"):
            asked = ("--error", "0.004", "--antialias", "auto", *more)
            one, several = self.report("--error", "0.004", *more), self.report(*asked)
            self.assertEqual(several["estimated_error"], one["estimated_error"])
            self.assertEqual(several["spent"]["passes"], one["spent"]["passes"])
            self.assertGreater(several["edge_pixels"], 0)
            self.assertEqual(several["rays"]["primary"], one["rays"]["primary"] + 16 * several["edge_pixels"])
            # At least one lobe ray for each camera ray, and as many as the tile has had.
            most = max(16, one["spent"]["most_samples"] + 15) * several["edge_pixels"]
            self.assertLessEqual(several["rays"]["lobe"], one["rays"]["lobe"] + most)
            for other in ("--threads", "3"), ("--isa", "scalar"), ("--repeat", "2"):
                self.assertEqual(self.report(*asked, *other)["hash"], several["hash"], other)

    def test_edges_are_painted_within_the_time(self):
        report = self.report("--time", "300", "--antialias", "auto")
        self.assertGreater(report["edge_pixels"], 0)
        self.assertGreater(report["spent"]["passes"], 1)

    def test_a_survey_is_finished_however_short_the_time(self):
        for more in ("--estimator", "jittered"), ("--number", "fixed"):
            report = self.report("--time", "1e-9", *more)
            self.assertEqual((report["spent"]["passes"], report["spent"]["most_samples"]), (4, 8))
            self.assertGreater(report["estimated_error"], 0)
            self.assertLess(report["estimated_error"], 1)

    def test_a_rotation_gives_another_picture_of_the_same_error(self):
        one, other = self.report("--error", "0.002"), self.report("--error", "0.002", "--rotation", "2147483647")
        self.assertNotEqual(one["hash"], other["hash"])
        self.assertLessEqual(other["estimated_error"], 0.002)

    def test_a_time_is_said_not_to_be_deterministic(self):
        report = self.report("--time", "5000", "--threads", "2")
        self.assertEqual(report["asked"], {"time_ms": 5000})
        self.assertFalse(report["deterministic"])
        self.assertGreater(report["spent"]["passes"], 1)

    def test_any_time_gives_a_whole_picture(self):
        self.report("--samples", "4096")
        limit = self.pixels()
        report = self.report("--time", "1e-9")
        self.assertEqual(report["spent"]["passes"], 1)
        for row, of_limit in zip(self.pixels(), limit):
            for pixel, there in zip(row, of_limit):
                for a, b in zip(pixel, there):
                    self.assertLess(abs(a - b), 0.5)

    def test_a_signal_ends_a_long_time_with_a_whole_picture_and_its_error(self):
        for number in signal.SIGINT, signal.SIGTERM:
            process = subprocess.Popen([PROGRAM, "render", self.scene, "-o", self.path("a.pfm"), "--size", "640x480",
                                        "--time", "600000", "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.addCleanup(process.kill)
            while not self.catches(process.pid, number):
                time.sleep(0.05)
            process.send_signal(number)
            out, errors = process.communicate(timeout=120)
            self.assertEqual((process.returncode, errors), (0, b""))
            self.assertGreater(json.loads(out)["estimated_error"], 0)
            self.assertGreater(len({tuple(pixel) for row in self.pixels() for pixel in row}), 100)

    def test_an_error_out_of_reach_keeps_the_picture_and_says_so(self):
        done = self.run_program("render", self.scene, "-o", self.path("a.pfm"), "--size", "16x12", "--error", "1e-12",
                                "--json")
        self.assertEqual(done.returncode, 4)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn(b"--error 1e-12: not reached", done.stderr)
        self.assertIn(b"the picture is kept", done.stderr)
        report = json.loads(done.stdout)
        self.assertFalse(report["reached"])
        self.assertGreaterEqual(report["spent"]["most_samples"], 16384)
        self.assertEqual(len(self.pixels()), 12)

    def test_numbers_that_are_none_are_refused(self):
        for option in "--error", "--time":
            for value in "-1", "0", "-0.0", "nan", "inf", "-inf", "1e999", "x", "1x", "", "0,002":
                self.assertIn("is not a finite number above 0", self.refused(option, value), (option, value))

    def test_conflicts_are_named(self):
        self.assertIn("--error and --time", self.refused("--error", "0.1", "--time", "5"))
        self.assertIn("--samples", self.refused("--error", "0.1", "--samples", "16"))
        self.assertIn("--samples", self.refused("--time", "5", "--samples", "16"))
        self.assertIn("--repeat", self.refused("--time", "5", "--repeat", "3"))


if __name__ == "__main__":
    unittest.main()
