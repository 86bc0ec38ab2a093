"""zerkalo show and doctor: displays that are there, and exit code 5 for those that are not."""
import os
import re
import signal
import unittest

from picture_files import read_png
from program import CommandLineTest

PICTURE_LINE = re.compile(rb"(?:\x1b\[[34]8;2;\d+;\d+;\d+m|\xe2\x96\x80| )+\x1b\[0m\r?\n")


def lines_shown(output):
    return PICTURE_LINE.findall(output)


def cells_of(line):
    return len(re.sub(rb"\x1b\[[0-9;]*m", b"", line).replace(b"\xe2\x96\x80", b" ").rstrip(b"\r\n"))


class Doctor(CommandLineTest):
    def test_json_tells_instruction_sets_threads_displays_and_memory(self):
        report = self.json("doctor")
        names = ["scalar", "sse2", "sse4.2", "avx2", "avx512", "neon"]
        self.assertEqual([isa["name"] for isa in report["isas"]], names)
        chosen = [isa for isa in report["isas"] if isa["chosen"]]
        self.assertEqual([isa["name"] for isa in chosen], [report["isa"]])
        self.assertTrue(chosen[0]["available"])
        self.assertEqual(max(isa["lanes"] for isa in report["isas"] if isa["available"]), chosen[0]["lanes"])
        self.assertEqual(report["threads"], len(os.sched_getaffinity(0)))
        self.assertGreater(report["plan_bytes"], 1000)
        self.assertEqual(report["terminal"], {"present": False, "columns": 0, "rows": 0})
        present = [f"/dev/{name}" for name in os.listdir("/dev") if re.fullmatch(r"fb\d+", name)]
        self.assertEqual(sorted(device["path"] for device in report["framebuffers"]), sorted(present))

    def test_text_names_every_instruction_set_and_the_chosen_one(self):
        text = self.succeed("doctor").decode()
        for isa in self.json("doctor")["isas"]:
            state = "available, chosen" if isa["chosen"] else "available" if isa["available"] else "not here"
            self.assertRegex(text, rf"(?m)^  {re.escape(isa['name'])} +\d+ lanes? +{state}$")

    def test_a_terminal_is_found_with_its_size(self):
        session = self.terminal("doctor", columns=77, rows=21)
        self.assertEqual(session.exit_code(), 0)
        self.assertIn(b"terminal: 77 columns, 21 rows", session.output)


class Devices(CommandLineTest):
    def test_an_instruction_set_that_this_cpu_lacks_is_exit_5_and_names_what_it_has(self):
        isas = self.json("doctor")["isas"]
        missing = [isa["name"] for isa in isas if not isa["available"]]
        self.assertTrue(missing, "no CPU has both AVX and NEON")
        has = ", ".join(isa["name"] for isa in isas if isa["available"])
        for name in missing:
            for command in (("render", self.scene, "-o", self.path("a.png")), ("show", self.scene)):
                self.expect_failure(5, *command, "--isa", name, says=[f"cannot run '{name}'", f"it has {has}"])
        self.assertEqual(self.names(), ["scene.toml"])

    def test_a_framebuffer_that_is_missing_is_exit_5(self):
        self.expect_failure(5, "show", self.scene, "--display", "fb:/dev/fb77", "--once",
                            says=["/dev/fb77", "No such file"])

    def test_a_device_that_is_no_framebuffer_is_exit_5(self):
        self.expect_failure(5, "show", self.scene, "--display", "fb:/dev/zero", "--once",
                            says=["/dev/zero", "not a framebuffer"])

    def test_no_display_at_all_is_exit_5(self):
        if os.path.exists("/dev/fb0"):
            self.succeed("show", self.scene, "--once")
        else:
            self.expect_failure(5, "show", self.scene, "--once", says=["no display", "/dev/fb0", "not a terminal"])

    def test_a_display_file_is_the_rendered_picture(self):
        self.succeed("show", self.scene, "--display", "png:" + self.path("a.png"))
        self.succeed("render", self.scene, "-o", self.path("b.png"))
        first, second = ((self.files / name).read_bytes() for name in ("a.png", "b.png"))
        self.assertEqual(read_png(first), read_png(second))

    def test_a_display_file_that_cannot_be_written_is_exit_1(self):
        self.expect_failure(1, "show", self.scene, "--display", "png:" + self.path("none/a.png"), says=["none/a.png"])


class Show(CommandLineTest):
    def show(self, *arguments, **options):
        return self.terminal("show", self.scene, "--display", "terminal", *arguments, **options)

    def test_once_draws_one_picture_that_fits_the_terminal(self):
        session = self.show("--once", columns=20, rows=40)
        self.assertEqual(session.exit_code(), 0)
        shown = lines_shown(session.output)
        # 32x24 into 20 columns: 20x15 pixels, two a line.
        self.assertEqual([cells_of(line) for line in shown], [20] * 8)
        self.assertGreater(len(set(re.findall(rb"48;2;[0-9;]*m", session.output))), 10, "the picture is nearly empty")

    def test_a_larger_picture_is_scaled_down(self):
        session = self.show("--once", "--size", "160x40", columns=20, rows=40)
        self.assertEqual(session.exit_code(), 0)
        self.assertEqual([cells_of(line) for line in lines_shown(session.output)], [20] * 3)

    def test_it_stays_until_a_signal_and_then_ends_well(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            session = self.show()
            self.assertTrue(session.read_until(lambda output: len(lines_shown(output)) == 12), session.output)
            self.assertFalse(session.read_until(lambda output: False, seconds=0.3))
            self.assertEqual(os.waitpid(session.process, os.WNOHANG), (0, 0), "it did not stay")
            session.send(number)
            self.assertEqual(session.exit_code(), 0)

    def test_a_new_terminal_size_draws_the_picture_anew(self):
        session = self.show(columns=40, rows=13)
        self.assertTrue(session.read_until(lambda output: len(lines_shown(output)) == 12), session.output)
        session.resize(columns=8, rows=13)
        redrawn = session.read_until(lambda output: len(lines_shown(output)) == 15)
        self.assertTrue(redrawn, session.output)
        self.assertEqual([cells_of(line) for line in lines_shown(session.output)], [32] * 12 + [8] * 3)
        session.send()
        self.assertEqual(session.exit_code(), 0)


if __name__ == "__main__":
    unittest.main()
