#!/usr/bin/env python3
"""Builds every mutant of the lists beside it and runs the laws against it: each must be killed by one.

    tools/mutants/run.py                        # all of them
    tools/mutants/run.py --only tube --only seed-2  # those whose name contains one of the words
    tools/mutants/run.py --check                # only that every mutant still applies; builds nothing
    tools/mutants/run.py --markdown table.md    # also writes the table of tools/mutants/README.md

Works on a copy of the project in the folder --work. Exit code: 0 all killed, 1 some survived, 2 the list is wrong or
the unchanged project does not build and pass.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import mutant_list

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The course work's own faults first.
LISTS = sorted(pathlib.Path(__file__).resolve().parent.glob("*.txt"), key=lambda path: (path.stem != "seed", path))

# Test programs that ask nothing of the core's formulas, or compare pictures without saying what is wrong with them.
OTHER_FOLDERS = {"platform", "reference", "scene_file", "command_line", "golden", "vm", "proofs", "consumer"}
# Folders whose laws are asked first: those of pictures, for their names, then those that are quick.
FIRST = ("laws", "core", "oracle", "stiff")
# Tests that compare whole pictures with those of the reference tracer.
COMPARISONS = "Oracle.*:*Reference*"
# A test that takes this long where the unchanged project takes seconds hangs.
TIME_LIMIT = 300

Verdict = collections.namedtuple("Verdict", "killed by seconds")


class Broken(Exception):
    """The unchanged project cannot be judged; the message says why."""


def copy_project(to):
    """The files that git knows or could know, so that nothing built is copied; only what differs is written."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout
    names = {name for name in listed.split("\0") if name and (ROOT / name).is_file()}
    for old in [p for p in to.rglob("*") if p.is_file() and str(p.relative_to(to)) not in names]:
        old.unlink()
    for name in names:
        source, target = ROOT / name, to / name
        if target.is_file() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
        shutil.copymode(source, target)


def contains_any(name, words):
    return not words or any(word in name for word in words)


def rank(folder_and_program):
    folder, program = folder_and_program
    return (FIRST.index(folder) if folder in FIRST else len(FIRST)), program


class Project:
    """A copy of the project, one lane wide and hardly optimised, with the laws that may see a wrong formula."""

    def __init__(self, work, jobs, words):
        self.tree, self.build, self.jobs = work / "tree", work / "build", jobs
        self.tree.mkdir(parents=True, exist_ok=True)
        copy_project(self.tree)
        configured = self.call(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                                "-DCMAKE_CXX_FLAGS=-O1", "-DZERKALO_SCALAR_ONLY=ON", "-DZERKALO_INSTALL=OFF"])
        if configured.returncode != 0:
            raise Broken(configured.stdout)
        targets = self.call(["ninja", "-C", self.build, "-t", "targets", "all"]).stdout
        programs = re.findall(r"^(tests/(\w+)/\w+): CXX_EXECUTABLE_LINKER", targets, re.MULTILINE)
        asked = [(folder, program) for program, folder in programs if folder not in OTHER_FOLDERS]
        self.programs = [program for _, program in sorted(asked, key=rank) if contains_any(program, words)]
        if not self.programs:
            raise Broken(f"no test program is called like {' or '.join(words)}")
        self.names = [program.rpartition("/")[2] for program in self.programs]

    @staticmethod
    def call(command, **options):
        return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, errors="replace", check=False, **options)

    def judge(self):
        """Builds and runs program after program until one fails; its first failed test is the verdict."""
        start = time.monotonic()
        for program in self.programs:
            built = self.call(["ninja", "-C", self.build, "-j", self.jobs, program])
            if built.returncode != 0:
                return Verdict(False, "does not compile:\n" + built.stdout[-3000:], time.monotonic() - start)
            law = self.first_failure(program)
            if law:
                return Verdict(True, law, time.monotonic() - start)
        return Verdict(False, "survived", time.monotonic() - start)

    def first_failure(self, program):
        """The name of the first law that fails; a law that says what is wrong before one that only compares."""
        return self.first_of(program, "-" + COMPARISONS) or self.first_of(program, COMPARISONS)

    def first_of(self, program, names):
        """As many shards of the program at a time as there may be jobs; of those that fail the first one's test."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            failures = pool.map(lambda shard: self.failure_of_shard(program, names, shard), range(self.jobs))
            return next(filter(None, list(failures)), "")

    def failure_of_shard(self, program, names, shard):
        shares = {"GTEST_TOTAL_SHARDS": str(self.jobs), "GTEST_SHARD_INDEX": str(shard)}
        try:
            ran = self.call([self.build / program, "--gtest_fail_fast", "--gtest_filter=" + names], timeout=TIME_LIMIT,
                            cwd=self.build / program.rpartition("/")[0], env={**os.environ, **shares})
        except subprocess.TimeoutExpired as late:
            return last_started(late.stdout or "") + " (does not end)"
        if ran.returncode == 0:
            return ""
        failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", ran.stdout, re.MULTILINE)
        return failed.group(1) if failed else last_started(ran.stdout) + " (ends the program)"


def positive(text):
    if not text.isdecimal() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text}: a whole number from 1 on is needed")
    return int(text)


def last_started(output):
    text = output.decode(errors="replace") if isinstance(output, bytes) else output
    started = re.findall(r"^\[ RUN      \] (\S+)", text, re.MULTILINE)
    return started[-1] if started else "no test"


def run_one(project, mutant):
    texts = mutant_list.mutated_files(project.tree, mutant)
    before = {path: (project.tree / path).read_bytes() for path in texts}
    try:
        for path, text in texts.items():
            (project.tree / path).write_text(text, encoding="utf-8")
        return project.judge()
    finally:
        for path, content in before.items():
            (project.tree / path).write_bytes(content)


def law_of(test):
    """A test's name without the width it ran at: All/Sphere.Law/scalar_1_lanes -> Sphere.Law."""
    return re.sub(r"^\w+/|/\w+(?= |$)", "", test)


def table(results):
    lines = ["| mutant | what is wrong | killed by |", "|---|---|---|"]
    for mutant, verdict in results:
        killer = f"`{law_of(verdict.by)}`" if verdict.killed else f"**{verdict.by.splitlines()[0]}**"
        lines.append(f"| {mutant.name} | {mutant.fault} | {killer} |")
    return "\n".join(lines) + "\n"


def run_all(mutants, options):
    project = Project(pathlib.Path(options.work).resolve(), options.jobs, options.ask)
    print(f"{len(mutants)} mutants against {', '.join(project.names)}", flush=True)
    unchanged = project.judge()
    if unchanged.by != "survived":
        raise Broken(f"the unchanged project: {unchanged.by}")
    print(f"unchanged: passes, {unchanged.seconds:.0f} s", flush=True)
    results = []
    for mutant in mutants:
        results.append((mutant, run_one(project, mutant)))
        verdict = results[-1][1]
        word = "killed by" if verdict.killed else "NOT KILLED:"
        print(f"{mutant.name}: {word} {law_of(verdict.by)}, {verdict.seconds:.0f} s", flush=True)
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", default=[], metavar="WORD", help="mutants with WORD in their name")
    parser.add_argument("--ask", action="append", default=[], metavar="WORD",
                        help="ask only the test programs with WORD in their name: quicker, but more survive")
    parser.add_argument("--check", action="store_true", help="only whether every mutant applies")
    parser.add_argument("--work", default=ROOT / "build" / "mutants", help="folder of the copy (build/mutants)")
    parser.add_argument("--jobs", type=positive, default=2, help="processes that compile or test (2)")
    parser.add_argument("--markdown", metavar="FILE", help="where to write the table")
    options = parser.parse_args()
    try:
        mutants = mutant_list.read(LISTS)
        mutant_list.check(ROOT, mutants)
        if options.check:
            print(f"{len(mutants)} mutants apply")
            return 0
        chosen = [mutant for mutant in mutants if contains_any(mutant.name, options.only)]
        results = run_all(chosen, options)
    except (mutant_list.BadList, Broken) as problem:
        print(problem, file=sys.stderr)
        return 2
    if options.markdown:
        pathlib.Path(options.markdown).write_text(table(results), encoding="utf-8")
    survivors = [mutant.name for mutant, verdict in results if not verdict.killed]
    print(f"{len(results) - len(survivors)} of {len(results)} killed")
    for name in survivors:
        print(f"not killed: {name}")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
