"""zerkalo study: the rows of a plan however they come about, and one clear line when they cannot."""
import csv
import json
import os
import pathlib
import shutil
import signal
import stat
import subprocess
import unittest

from program import CommandLineTest, PROGRAM, SCENE

SMALL = {"--size": "24x18", "--samples": "1,4,16", "--estimators": "random,fibonacci", "--numbers": "float,fixed",
         "--errors": "0.02", "--rotations": "4", "--reference-samples": "1024", "--reference-tolerance": "0.05"}
MEASURED = ("isa", "lanes", "threads", "repetitions", "seconds", "seconds_low", "seconds_high")
FLOAT = ("--numbers", "float")


def small_with(*options):
    """The options of a small study, some of them replaced or added."""
    together = {**SMALL, **dict(zip(options[::2], options[1::2]))}
    return [word for pair in together.items() for word in pair]


class Study(CommandLineTest):
    def study(self, folder, *options):
        return ("study", self.scene, "-o", self.path(folder), *small_with(*options))

    def rows(self, folder):
        with open(self.files / folder / "study.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def exact(self, folder, name="study.csv"):
        """The deterministic columns, row by row, as they are written."""
        lines = (self.files / folder / name).read_text(encoding="utf-8").splitlines()
        begin = lines[0].split(",").index(MEASURED[0])
        return [line.split(",")[:begin] for line in lines]

    def shard(self, folder, which, *options):
        return self.succeed(*self.study(folder, "--shard", which, *options))

    def test_every_setting_has_a_row(self):
        self.succeed(*self.study("d"))
        rows = self.rows("d")
        asked = [(r["number"], r["estimator"], r["samples"]) for r in rows if float(r["asked_error"]) > 0]
        self.assertEqual(asked, [("float", "fibonacci", "0")])
        rows = [r for r in rows if float(r["asked_error"]) == 0]
        self.assertEqual([(r["number"], r["estimator"], r["samples"]) for r in rows],
                         [(n, e, s) for n in ("float", "fixed") for e in ("random", "fibonacci")
                          for s in ("1", "4", "16")])
        for row in rows:
            self.assertEqual((row["scene"], row["width"], row["height"]), ("scene", "24", "18"))
            self.assertEqual((row["lobe"], float(row["lobe_exponent"])), ("max_phong", 200))
            self.assertEqual(int(row["rays_primary"]), 24 * 18)
            self.assertGreaterEqual(int(row["repetitions"]), 6)
            self.assertLessEqual(float(row["seconds_low"]), float(row["seconds"]))
            self.assertLessEqual(float(row["seconds"]), float(row["seconds_high"]))
            self.assertLess(float(row["arithmetic_mirror"]), 1e-5)
            self.assertGreater(float(row["quantised8_mirror"]), float(row["quantised10_mirror"]))
            self.assertLessEqual(float(row["p999_mirror"]), float(row["max_mirror"]))

    def test_more_samples_mean_less_error(self):
        self.succeed(*self.study("d", *FLOAT))
        errors = [float(r["rmse_mean_mirror"]) for r in self.rows("d") if r["estimator"] == "fibonacci"]
        asked = [float(r["rmse_mean_picture"]) for r in self.rows("d") if float(r["asked_error"]) > 0]
        self.assertLess(asked[0], 0.02)
        self.assertLess(errors[1], errors[0] / 1.5)
        self.assertLess(errors[2], errors[1] / 1.5)

    def test_the_picture_of_a_row_is_that_of_render(self):
        self.succeed(*self.study("d", *FLOAT))
        rays = self.json("render", self.scene, "-o", self.path("a.pfm"), "--size", "24x18", "--samples", "4")["rays"]
        row = next(r for r in self.rows("d") if r["estimator"] == "fibonacci" and r["samples"] == "4")
        self.assertEqual({k: int(row["rays_" + k]) for k in rays}, rays)

    def test_json_and_csv_say_the_same(self):
        self.succeed(*self.study("d", *FLOAT))
        report = json.loads((self.files / "d" / "study.json").read_text(encoding="utf-8"))
        rows = self.rows("d")
        self.assertEqual(len(report["rows"]), len(rows))
        self.assertIn("size 24x18", report["plan"])
        for told, row in zip(report["rows"], rows):
            self.assertEqual(tuple(told["measured"]), MEASURED)
            together = {**told["exact"], **told["measured"], **told["slope"]}
            self.assertEqual(list(together), list(row))
            for name, value in together.items():
                if isinstance(value, str):
                    self.assertEqual(row[name], value)
                elif value is None:
                    self.assertIn(row[name], ("nan", "-nan", "inf"))
                else:
                    self.assertEqual(float(row[name]), value, name)

    def test_a_study_goes_on_where_it_was_stopped(self):
        self.succeed(*self.study("whole", *FLOAT))
        self.succeed(*self.study("stopped", *FLOAT))
        journal = self.files / "stopped" / "rows.csv"
        lines = journal.read_bytes().splitlines(keepends=True)
        for kept in (0, 1, 3, len(lines)):
            # As it is left when the machine loses power: some whole rows, and one cut off.
            journal.write_bytes(b"".join(lines[:kept]) + b"scene,max_phong,20")
            (self.files / "stopped" / "study.csv").unlink()
            self.succeed(*self.study("stopped", *FLOAT))
            self.assertEqual(self.exact("stopped"), self.exact("whole"), kept)
            self.assertEqual(journal.read_bytes().splitlines(keepends=True)[:kept], lines[:kept])

    def test_ctrl_c_keeps_finished_rows(self):
        slow = ("--size", "96x72", "--samples", "64,65,66,67,68,69,70,71", "--reference-samples", "1024")
        session = subprocess.Popen([PROGRAM, *self.study("d", *slow)], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        journal = self.files / "d" / "rows.csv"
        while session.poll() is None and not (journal.exists() and journal.read_bytes().count(b"\n") > 2):
            pass
        session.send_signal(signal.SIGINT)
        message = session.communicate()[1].decode()
        self.assertEqual(session.returncode, 130, message)
        self.assertRegex(message, r"\Azerkalo: error: interrupted; \d+ of 33 rows are in .*\n\Z")
        self.assertGreater(journal.read_bytes().count(b"\n"), 2)
        self.assertEqual(journal.read_bytes()[-1:], b"\n")

    def test_shards_join_to_the_single_run(self):
        self.succeed(*self.study("whole", *FLOAT))
        for k in (1, 2, 3, 4):
            self.shard(f"part{k}", f"{k}/4", *FLOAT)
        parts = [self.path(f"part{k}") for k in (3, 1, 4, 2)]
        self.succeed("study", "--join", *parts, "-o", self.path("joined"))
        self.assertEqual(self.exact("joined"), self.exact("whole"))
        self.assertEqual(self.exact("joined", "rows.csv"), self.exact("whole", "rows.csv"))
        measured = {r["samples"] + r["estimator"]: r["seconds"] for r in self.rows("joined")}
        with open(self.files / "part2" / "rows.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.assertEqual(measured[row["samples"] + row["estimator"]], row["seconds"])

    def test_shards_by_gnu_parallel(self):
        parallel = shutil.which("parallel")
        if parallel is None:
            self.fail("GNU parallel is not installed (Debian package parallel)")
        self.succeed(*self.study("whole", *FLOAT))
        command = [parallel, "--will-cite", PROGRAM, *self.study("part{}", *FLOAT, "--shard", "{}/3"), ":::", "1", "2",
                   "3"]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=False,
                              env={**os.environ, "HOME": str(self.files)})
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.succeed("study", "--join", *(self.path(f"part{k}") for k in (1, 2, 3)), "-o", self.path("joined"))
        self.assertEqual(self.exact("joined"), self.exact("whole"))

    def test_a_join_gets_its_crops_from_a_study_of_the_same_plan(self):
        for k in (1, 2):
            self.shard(f"part{k}", f"{k}/2", *FLOAT)
        self.succeed("study", "--join", self.path("part1"), self.path("part2"), "-o", self.path("d"))
        joined = (self.files / "d" / "study.csv").read_bytes()
        self.assertFalse((self.files / "d" / "crops").exists())
        self.succeed(*self.study("d", *FLOAT))
        self.assertEqual((self.files / "d" / "study.csv").read_bytes(), joined)
        self.assertTrue(list((self.files / "d" / "crops").glob("scene-*.png")))

    def test_without_gnuplot_one_line_says_so_and_the_data_are_written(self):
        done = self.run_program(*self.study("d", *FLOAT), environment={"PATH": self.path("empty")})
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr.decode(), r"\Azerkalo: note: gnuplot \(Debian package gnuplot-nox\) is missing: .*\n\Z")
        self.assertEqual([path.name for path in (self.files / "d" / "diagrams").iterdir()], ["scene.gp"])
        self.assertEqual(len(self.rows("d")), 2 * 3 + 1)
        self.assertIn("## Slopes", (self.files / "d" / "study.md").read_text(encoding="utf-8"))

    def test_threads_and_instruction_sets_change_no_exact_column(self):
        self.succeed(*self.study("a", *FLOAT))
        self.succeed(*self.study("b", *FLOAT, "--isa", "scalar", "--threads", "2"))
        self.assertEqual(self.exact("a"), self.exact("b"))
        self.assertEqual({(r["isa"], r["lanes"], r["threads"]) for r in self.rows("b")}, {("scalar", "1", "2")})

    def test_an_exponent_is_given_after_the_scenes_name(self):
        self.succeed("study", self.scene + "@1000", "-o", self.path("d"), *small_with(*FLOAT))
        self.assertEqual({(r["scene"], r["lobe_exponent"]) for r in self.rows("d")}, {("scene@1000", "1000")})


class StudyFailure(CommandLineTest):
    def refuse(self, code, *arguments, says):
        self.expect_failure(code, "study", *arguments, says=says)

    def small(self, folder, *options):
        return (self.scene, "-o", self.path(folder), *small_with(*FLOAT, *options))

    def test_a_wrong_command_line(self):
        self.refuse(2, "-o", self.path("d"), says=["scenes to study or --join"])
        self.refuse(2, self.scene, says=["--output is required"])
        self.refuse(2, *self.small("d", "--estimators", "halton"), says=["'halton'", "random, jittered, sobol"])
        self.refuse(2, *self.small("d", "--numbers", "half"), says=["'half'", "float, fixed"])
        self.refuse(2, *self.small("d", "--samples", "4,0"), says=["--samples", "from 1 to 1048576"])
        for shard in ("0/3", "4/3", "1", "1/", "/2", "a/b", "1/3x"):
            self.refuse(2, *self.small("d", "--shard", shard), says=[f"'{shard}' is not K/N"])
        self.refuse(2, self.scene + "@dull", "-o", self.path("d"), says=["'@'", "lobe exponent"])
        self.refuse(2, self.scene, self.scene, "-o", self.path("d"), says=["two scenes are called 'scene'"])
        self.assertEqual(self.names(), ["scene.toml"])

    def test_wrong_scenes(self):
        self.file("bad.toml", SCENE + "nonsense")
        done = self.run_program("study", self.path("bad.toml"), "-o", self.path("d"))
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"bad.toml:", done.stderr)
        done = self.run_program("study", self.path("none.toml"), "-o", self.path("d"))
        self.assertEqual(done.returncode, 1)
        sharp = self.file("sharp.toml", SCENE.replace("lobe_exponent = 200.0", ""))
        self.refuse(2, sharp, "-o", self.path("d"), says=["no unpolished mirror"])
        self.assertEqual(self.names(), ["bad.toml", "scene.toml", "sharp.toml"])

    def test_a_folder_that_cannot_be_written(self):
        self.file("d", "a file, no folder")
        self.refuse(1, *self.small("d"), says=[self.path("d")])
        self.assertEqual((self.files / "d").read_text(encoding="utf-8"), "a file, no folder")
        self.refuse(1, *self.small("d/below"), says=[self.path("d")])
        locked = self.files / "locked"
        locked.mkdir()
        locked.chmod(stat.S_IRUSR | stat.S_IXUSR)
        if not os.access(locked, os.W_OK):  # root may write everywhere
            self.refuse(1, *self.small("locked"), says=[str(locked), "Permission denied"])
        locked.chmod(stat.S_IRWXU)

    def test_another_plan_in_the_folder(self):
        self.succeed("study", *self.small("d"))
        rows = (self.files / "d" / "rows.csv").read_bytes()
        self.refuse(2, *self.small("d", "--size", "20x20"),
                    says=["another plan", "'size 24x18' there", "'size 20x20' here"])
        pathlib.Path(self.scene).write_text(SCENE.replace("radius = 0.6", "radius = 0.5"), encoding="utf-8")
        self.refuse(2, *self.small("d"), says=["another plan", "scene"])
        self.assertEqual((self.files / "d" / "rows.csv").read_bytes(), rows)

    def test_references_that_disagree(self):
        self.refuse(4, *self.small("d", "--reference-samples", "4", "--reference-tolerance", "0.0001"),
                    says=["scene: the two references are", "--reference-samples"])
        self.assertEqual((self.files / "d" / "rows.csv").read_bytes().count(b"\n"), 1)

    def test_joins_that_do_not_fit(self):
        for k in (1, 2):
            self.succeed("study", *self.small(f"part{k}", "--shard", f"{k}/2"))
        parts = [self.path("part1"), self.path("part2")]
        self.refuse(1, "--join", parts[0], "-o", self.path("d"), says=["3 of 7 rows are in none", "scene/float/"])
        self.succeed("study", *self.small("other", "--size", "20x20", "--shard", "2/2"))
        self.refuse(2, "--join", parts[0], self.path("other"), "-o", self.path("d"), says=["different plans", "size"])
        self.refuse(1, "--join", parts[0], self.path("nothing"), "-o", self.path("d"), says=[self.path("nothing")])
        shutil.copytree(parts[1], self.path("forged"))
        journal = self.files / "forged" / "rows.csv"
        lines = journal.read_text(encoding="utf-8").splitlines()
        cells = lines[1].split(",")
        cells[lines[0].split(",").index("rays_lobe")] = "7"
        journal.write_text("\n".join([lines[0], ",".join(cells), *lines[2:]]) + "\n", encoding="utf-8")
        self.refuse(4, "--join", *parts, self.path("forged"), "-o", self.path("d"), says=["different errors"])
        journal.write_text("\n".join([lines[0], lines[1][:40]]) + "\n", encoding="utf-8")
        self.refuse(1, "--join", *parts, self.path("forged"), "-o", self.path("d"),
                    says=["rows.csv:2: is not a whole row"])
        self.assertNotIn("d", self.names())


if __name__ == "__main__":
    unittest.main()
