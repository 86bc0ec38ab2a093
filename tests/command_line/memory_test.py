"""How much memory a render takes, and what happens when there is not enough."""
import unittest

from program import CommandLineTest


class Memory(CommandLineTest):
    def test_a_vga_frame_peaks_below_12_mb(self):
        report = self.json("render", self.scene, "-o", self.path("a.png"), "--size", "640x480")
        self.assertGreater(report["peak_bytes"], 640 * 480 * 12)
        self.assertLess(report["peak_bytes"], 12e6)

    def test_no_memory_is_exit_70_and_leaves_no_file(self):
        self.expect_failure(70, "render", self.scene, "-o", self.path("a.png"), "--size", "16384x16384",
                            memory_limit=1 << 30, says=["out of memory"])
        self.assertEqual(self.names(), ["scene.toml"])


if __name__ == "__main__":
    unittest.main()
