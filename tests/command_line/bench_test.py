"""zerkalo bench: every kernel has a figure for every instruction set of this CPU."""
import json
import unittest

from program import CommandLineTest

QUICK = ("--min-time", "0.001")
KERNELS = ["solid/pyramid", "solid/prism", "solid/sphere", "solid/cylinder", "solid/cone", "solid/mesh_8_triangles",
           "shadow/sphere", "mirror/sharp", "mirror/lobe_sample", "tile/samples:16", "frame/samples:16"]


class Bench(CommandLineTest):
    def test_every_kernel_has_nanoseconds_per_ray_for_every_instruction_set(self):
        isas = {isa["name"]: isa["lanes"] for isa in self.json("doctor")["isas"] if isa["available"]}
        report = json.loads(self.succeed("bench", self.scene, "--json", *QUICK))
        found = {entry["name"]: entry for entry in report["benchmarks"]}
        for kernel in KERNELS:
            for isa, lanes in isas.items():
                entry = found[f"{kernel}/{isa}"]
                self.assertNotIn("error_message", entry)
                self.assertGreater(entry["ns/ray"], 0, entry)
                self.assertGreater(entry["rays"], 0, entry)
                self.assertEqual(entry["lanes"], lanes)

    def test_fixed_point_has_a_frame_for_every_instruction_set_with_a_kernel_of_its_own(self):
        lanes = {"scalar": 1, "sse4.2": 4, "avx2": 8, "avx512": 16, "neon": 4}
        available = {isa["name"] for isa in self.json("doctor")["isas"] if isa["available"]}
        report = json.loads(self.succeed("bench", "--filter", "^frame/samples:16/fixed/", "--json", *QUICK))
        found = {entry["name"].rsplit("/", 1)[1]: entry["lanes"] for entry in report["benchmarks"]}
        self.assertEqual(found, {name: count for name, count in lanes.items() if name in available})

    def test_a_solid_costs_one_camera_ray_a_pixel_and_a_light_one_shadow_ray(self):
        report = json.loads(self.succeed("bench", "--filter", "^(solid|shadow)/", "--json", *QUICK))
        self.assertEqual({entry["rays"] for entry in report["benchmarks"]}, {128 * 128})

    def test_the_filter_chooses_by_name(self):
        report = json.loads(self.succeed("bench", "--filter", "cone/scalar$", "--json", *QUICK))
        self.assertEqual([entry["name"] for entry in report["benchmarks"]], ["solid/cone/scalar"])
        self.assertIn(b"solid/cone/scalar", self.succeed("bench", "--filter", "cone/scalar$", *QUICK))

    def test_a_filter_that_matches_nothing_or_is_none_is_refused(self):
        self.expect_failure(2, "bench", "--filter", "octopus", says=["no benchmark matches 'octopus'"])
        self.expect_failure(2, "bench", "--filter", "(", says=["'(' is not a regular expression"])


if __name__ == "__main__":
    unittest.main()
