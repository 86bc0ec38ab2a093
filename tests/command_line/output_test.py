"""Output files appear whole or not at all; whatever goes wrong on the way, the exit code is 1 and no file is left."""
import os
import unittest

from program import CommandLineTest, SCENE


class Output(CommandLineTest):
    def test_a_missing_directory_fails_before_anything_is_rendered(self):
        # A million frames would outlast the time limit of a run.
        self.expect_failure(1, "render", self.scene, "-o", self.path("none/a.png"), "--size", "640x480",
                            "--repeat", "1000000", says=["none/a.png", "No such file or directory"])

    def test_an_unwritable_directory_is_refused(self):
        # Not by permissions, which do not bind root: nobody can create a file below /proc.
        self.expect_failure(1, "render", self.scene, "-o", "/proc/a.png", says=["/proc/a.png: cannot write"])

    def test_a_directory_is_no_output_file(self):
        os.mkdir(self.path("d.png"))
        self.expect_failure(1, "render", self.scene, "-o", self.path("d.png"), says=["d.png", "directory"])

    def test_a_full_disk_leaves_no_file(self):
        for name in ("a.png", "a.pfm"):
            self.expect_failure(1, "render", self.scene, "-o", self.path(name), "--size", "200x200", file_limit=1024,
                                says=[name, "File too large"])
            self.assertEqual(self.names(), ["scene.toml"])

    def test_a_full_disk_leaves_the_older_file_as_it_was(self):
        older = self.files / "a.png"
        older.write_bytes(b"older")
        self.expect_failure(1, "render", self.scene, "-o", str(older), "--size", "200x200", file_limit=1024)
        self.assertEqual(older.read_bytes(), b"older")
        self.assertEqual(self.names(), ["a.png", "scene.toml"])

    def test_standard_output_on_a_full_device_fails(self):
        for arguments in (("render", self.scene, "-o", "-"), ("doctor",), ("doctor", "--json"), ("--help",)):
            with open("/dev/full", "wb") as full:
                self.expect_failure(1, *arguments, stdout=full, says=["standard output", "No space left"])

    def test_an_invalid_scene_leaves_no_file(self):
        scene = self.file("bad.toml", SCENE.replace("radius = 0.6", "radius = -0.6"))
        done = self.run_program("render", scene, "-o", self.path("a.png"))
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"bad.toml:16:", done.stderr)
        self.assertEqual(self.names(), ["bad.toml", "scene.toml"])

    def test_a_scene_that_cannot_be_read_is_an_input_failure(self):
        done = self.run_program("render", self.path("none.toml"), "-o", self.path("a.png"))
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"none.toml", done.stderr)
        self.assertIn(b"No such file or directory", done.stderr)

    def test_a_device_is_written_through_and_not_replaced(self):
        os.mkfifo(self.path("pipe.png"))
        reader = os.open(self.path("pipe.png"), os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        self.succeed("render", self.scene, "-o", self.path("pipe.png"))
        self.assertEqual(os.read(reader, 8), b"\x89PNG\r\n\x1a\n")
        self.assertEqual(self.names(), ["pipe.png", "scene.toml"])


if __name__ == "__main__":
    unittest.main()
