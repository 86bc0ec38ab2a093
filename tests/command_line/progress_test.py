"""The progress line: on a terminal, for work over half a second, and nowhere else."""
import re
import unittest

from program import CommandLineTest


class Progress(CommandLineTest):
    LONG = ("--size", "320x240", "--samples", "4096", "--antialias", "4", "--threads", "1")

    def long_work(self, run):
        """What run(repeat) prints of work of a second and a half or more, however fast this machine is just now."""
        repeat = 4
        while True:
            printed = run("render", self.scene, "-o", self.path("a.png"), *self.LONG, "--repeat", str(repeat))
            median = re.search(rb"320x240 in (\d+\.\d+) ms", printed)
            if 1e-3 * float(median[1]) * repeat > 1.5:
                return printed
            repeat *= 2

    def on_terminal(self, environment=None):
        def run(*arguments):
            session = self.terminal(*arguments, environment=environment or {})
            self.assertEqual(session.exit_code(), 0)
            return session.output
        return run

    def test_long_work_on_a_terminal_shows_percent_and_rays_per_second(self):
        self.assertRegex(self.long_work(self.on_terminal()), rb"\r *\d+ %  \d+\.\d s  \d+\.\d Mray/s")

    def test_the_line_is_erased_before_the_result(self):
        last = self.long_work(self.on_terminal()).rstrip(b"\r\n").split(b"\r")
        self.assertRegex(last[-1], rb"\A\S*a\.png: 320x240 in ")
        self.assertRegex(last[-2], rb"\A +\Z")

    def test_short_work_shows_no_progress(self):
        session = self.terminal("render", self.scene, "-o", self.path("a.png"), "--threads", "1")
        self.assertEqual(session.exit_code(), 0)
        self.assertNotIn(b"%", session.output)

    def test_long_work_without_a_terminal_is_silent(self):
        def run(*arguments):
            done = self.run_program(*arguments)
            self.assertEqual((done.returncode, done.stderr), (0, b""))
            return done.stdout
        self.long_work(run)

    def test_a_dumb_terminal_gets_no_progress(self):
        self.assertNotIn(b"%", self.long_work(self.on_terminal({"TERM": "dumb"})))

    def test_no_color_leaves_the_progress_without_escape_codes(self):
        shown = self.long_work(self.on_terminal({"NO_COLOR": "1"}))
        self.assertIn(b"%", shown)
        self.assertNotIn(b"\x1b", shown)


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


if __name__ == "__main__":
    unittest.main()
