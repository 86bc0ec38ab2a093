"""The progress line: on a terminal, for work over half a second, and nowhere else."""
import unittest

from program import CommandLineTest


class Progress(CommandLineTest):
    LONG = ("--size", "320x240", "--samples", "4096", "--antialias", "4", "--threads", "1")

    def long_repeat(self):
        """Repetitions of the long picture that take about a second and a half here."""
        once = self.json("render", self.scene, "-o", self.path("a.png"), *self.LONG)["seconds"]
        return str(max(1, round(1.5 / once)))

    def test_long_work_on_a_terminal_shows_percent_and_rays_per_second(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), *self.LONG, "--repeat",
                                  self.long_repeat())
        self.assertEqual(session.exit_code(), 0)
        self.assertRegex(session.output, rb"\r *\d+ %  \d+\.\d s  \d+\.\d Mray/s")

    def test_the_line_is_erased_before_the_result(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), *self.LONG, "--repeat",
                                  self.long_repeat())
        self.assertEqual(session.exit_code(), 0)
        last = session.output.rstrip(b"\r\n").split(b"\r")
        self.assertRegex(last[-1], rb"\A\S*a\.png: 320x240 in ")
        self.assertRegex(last[-2], rb"\A +\Z")

    def test_short_work_shows_no_progress(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), "--threads", "1")
        self.assertEqual(session.exit_code(), 0)
        self.assertNotIn(b"%", session.output)

    def test_long_work_without_a_terminal_is_silent(self):
        done = self.run_program("render", self.scene, "-o", self.path("a.png"), *self.LONG, "--repeat",
                                self.long_repeat())
        self.assertEqual((done.returncode, done.stderr), (0, b""))

    def test_a_dumb_terminal_gets_no_progress(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), *self.LONG, "--repeat",
                                  self.long_repeat(), environment={"TERM": "dumb"})
        self.assertEqual(session.exit_code(), 0)
        self.assertNotIn(b"%", session.output)


class Color(CommandLineTest):
    def error(self, **environment):
        session = self.terminal("render", environment=environment)
        self.assertEqual(session.exit_code(), 2)
        return session.output

    def test_an_error_on_a_terminal_is_red(self):
        self.assertIn(b"\x1b[1;31merror:\x1b[0m", self.error(NO_COLOR=""))

    def test_no_color_is_honoured(self):
        self.assertNotIn(b"\x1b", self.error(NO_COLOR="1"))
        self.assertNotIn(b"\x1b", self.error(TERM="dumb"))

    def test_no_color_leaves_the_progress_without_escape_codes(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), *Progress.LONG, "--repeat",
                                  Progress.long_repeat(self), environment={"NO_COLOR": "1"})
        self.assertEqual(session.exit_code(), 0)
        self.assertIn(b"%", session.output)
        self.assertNotIn(b"\x1b", session.output)

    LONG = Progress.LONG


if __name__ == "__main__":
    unittest.main()
