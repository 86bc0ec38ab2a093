"""The tables of figures.sh: measures one and prints it as Markdown.

figures.py TABLE PROGRAM WORK [--quick]    TABLE: instructions lanes process pixels solids kernels
WORK is a folder for files; it holds sharp.toml, the shipped scene with its mirror polished.
"""
import array
import json
import math
import re
import resource
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

import figures_scenes

TOOLS = Path(__file__).resolve().parent
GLOSSY = TOOLS.parent / "firmware/scenes/gold-mirror-5.toml"
SHARP = "sharp"
CASES, COST_CASES = (SHARP, 16, 64), (SHARP, 16)
INSTRUCTION_GOALS = {("avx2", SHARP): 20e6, ("avx2", 16): 45e6, ("avx2", 64): 120e6, ("sse4.2", 16): 110e6}
RATIO_GOALS = {4: 3.0, 8: 5.5, 16: 9.0}
PROCESS_CPU_MS, PROCESS_PEAK_MB = 60, 12


class Bench:
    """The program to measure and how long to measure it."""

    def __init__(self, program, work, quick):
        self.program, self.work, self.quick = program, Path(work), quick
        self.isas = [isa for isa in json.loads(self.run("doctor", "--json"))["isas"] if isa["available"]]
        self.names = [isa["name"] for isa in self.isas]

    def run(self, *arguments):
        return output_of([self.program, *arguments])

    def scene(self, case):
        return self.work / "sharp.toml" if case == SHARP else GLOSSY

    def frame_ms(self, scene, case, isas, seconds):
        """Processor time of one frame by instruction set, all measured in one run: what else runs is not counted."""
        kernel = kernel_of(case)
        report = json.loads(self.run("bench", scene, "--filter", f"^{kernel}/({'|'.join(isas)})$",
                                     "--min-time", str(seconds), "--json"))
        ms = {entry["name"]: entry["ns/ray"] * entry["rays"] / 1e6 for entry in report["benchmarks"]}
        return {isa: ms[f"{kernel}/{isa}"] for isa in isas}

    def main_isas(self):
        """AVX2 and the widest: the columns where all instruction sets would be too many."""
        widest = max(self.isas, key=lambda isa: isa["lanes"])["name"]
        return [name for name in dict.fromkeys(("avx2", widest)) if name in self.names]


def output_of(command):
    finished = subprocess.run(command, capture_output=True, text=True)
    if finished.returncode != 0:
        sys.exit(f"figures.py: this failed: {' '.join(map(str, command))}\n{finished.stderr}".rstrip())
    return finished.stdout


def kernel_of(case):
    """As zerkalo bench names it. A sharp mirror takes one ray whatever the samples."""
    return f"frame/samples:{1 if case == SHARP else case}"


def name_of(case):
    return SHARP if case == SHARP else f"{case} samples"


def print_table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |")


def verdict(value, goal):
    """For a goal that is a ceiling."""
    return "met" if value <= goal else f"missed by {100 * (value / goal - 1):.1f} %"


def exponent(xs, ys):
    """The slope of log y over log x by least squares: y grows as x to this power."""
    fit = statistics.linear_regression([math.log(x) for x in xs], [math.log(y) for y in ys])
    return f"{fit.slope:.2f}"


def instructions(bench):
    print("### Instructions per frame\n")
    if not shutil.which("valgrind"):
        print("Valgrind is not installed here, so that they were not counted.")
        return
    isas = [name for name in bench.names if name != "avx512"]
    cases = CASES
    if bench.quick:
        isas, cases = isas[-1:], (SHARP, 16)
    counts = {}
    for case in cases:
        samples = "1" if case == SHARP else str(case)
        report = output_of([TOOLS / "count_instructions.sh", "--program", bench.program, bench.scene(case),
                            ",".join(isas), samples])
        for line in report.splitlines()[3:]:
            isa, _, count = line.split()
            counts[isa, case] = int(count)
    version = output_of(["valgrind", "--version"]).strip().replace("-", " ").capitalize()
    print("640x480, one thread, rendering alone, exact (callgrind).", end="")
    print(f" {version} cannot run AVX-512: no count for it.\n" if "avx512" in bench.names else "\n")
    rows = []
    for case in cases:
        goals = [f"{isa} {goal / 1e6:.0f} M: {verdict(counts[isa, case], goal)}"
                 for (isa, of), goal in INSTRUCTION_GOALS.items() if of == case and isa in isas]
        rows.append([name_of(case), *(f"{counts[isa, case] / 1e6:.1f} M" for isa in isas), "; ".join(goals) or "-"])
    print_table(["", *isas, "goals: at most"], rows)
    print("\n    tools/count_instructions.sh sharp.toml", ",".join(isas), "1")
    print("    tools/count_instructions.sh firmware/scenes/gold-mirror-5.toml", ",".join(isas),
          ",".join(str(case) for case in cases if case != SHARP))


def lanes_row(isa, width, ms):
    """Times of one instruction set; if it has a goal also the ratios, and which of them miss it."""
    cells, missed, goal = [], [], RATIO_GOALS.get(width)
    for case in CASES:
        cell = f"{statistics.median(ms[isa, case]):.2f} ms"
        if goal:
            ratios = [one / wide for one, wide in zip(ms["scalar", case], ms[isa, case])]
            middle = statistics.median(ratios)
            cell += f": {middle:.2f} ({min(ratios):.2f} to {max(ratios):.2f})"
            if middle < goal:
                missed.append(name_of(case))
        cells.append(cell)
    outcome = "-"
    if goal:
        outcome = f"{goal:g}: " + (f"missed at {', '.join(missed)}" if missed else "met")
    return [f"{isa}, {width}", *cells, outcome]


def lanes(bench):
    print("### Lanes against one lane\n")
    rounds, seconds = (3, 0.01) if bench.quick else (9, 0.05)
    ms = {(name, case): [] for name in bench.names for case in CASES}
    for case in CASES:
        for _ in range(rounds):
            for name, frame in bench.frame_ms(bench.scene(case), case, bench.names, seconds).items():
                ms[name, case].append(frame)
    print("640x480, one thread, rendering alone: ms of processor time, and how many times less than `scalar`. The\n"
          f"instruction sets take turns; of {rounds} rounds the median, of the ratios also the least and greatest.\n")
    rows = [lanes_row(isa["name"], isa["lanes"], ms) for isa in bench.isas]
    print_table(["lanes", *map(name_of, CASES), "goal: at least"], rows)
    print(f"\n    zerkalo bench sharp.toml --filter ^frame/samples:1/ --min-time {seconds}")
    print("    zerkalo bench firmware/scenes/gold-mirror-5.toml --filter '^frame/samples:(16|64)/' "
          f"--min-time {seconds}")


def children_cpu_ms():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1e3 * (usage.ru_utime + usage.ru_stime)


def process(bench):
    print("### The whole process: sharp frame to PNG on disk\n")
    runs = 5 if bench.quick else 20
    cpu, peak = {name: [] for name in bench.names}, dict.fromkeys(bench.names, 0)
    for _ in range(runs):
        for name in bench.names:
            before = children_cpu_ms()
            report = json.loads(bench.run("render", bench.scene(SHARP), "-o", bench.work / "picture.png", "--isa", name,
                                          "--threads", "1", "--json"))
            cpu[name].append(children_cpu_ms() - before)
            peak[name] = max(peak[name], report["peak_bytes"] / 1e6)
    print("640x480, 8 bits, one thread: processor time (user and system) from start to exit, median of\n"
          f"{runs} runs in turn; largest resident memory of them all.\n")
    rows = []
    for name in bench.names:
        ms = statistics.median(cpu[name])
        rows.append([name, f"{ms:.1f} ({min(cpu[name]):.1f} to {max(cpu[name]):.1f})", verdict(ms, PROCESS_CPU_MS),
                     f"{peak[name]:.1f}", verdict(peak[name], PROCESS_PEAK_MB)])
    print_table(["", "CPU ms", f"goal: at most {PROCESS_CPU_MS}", "peak MB", f"goal: at most {PROCESS_PEAK_MB}"], rows)
    print("\n    time zerkalo render sharp.toml -o mirror.png --threads 1 --isa avx2 --json")


def cost_columns(bench):
    return [(isa, case) for isa in bench.main_isas() for case in COST_CASES]


def print_cost(bench, first, rows, works, times):
    """One row a piece of work, then the power of the work with which each column grows."""
    columns = cost_columns(bench)
    lines = []
    for work, (start, pixel_count) in zip(works, rows):
        each = [times[work, column] for column in columns]
        lines.append([*start, *(f"{ms:.2f} ms, {1e6 * ms / pixel_count:.1f} ns" for ms in each)])
    lines.append(["grows as power", *[""] * (len(first) - 1),
                  *(exponent(works, [times[work, column] for work in works]) for column in columns)])
    print_table([*first, *(f"{isa}, {name_of(case)}" for isa, case in columns)], lines)


def resized(scene, width, height):
    text, found = re.subn(r"(?m)^width = 640\nheight = 480$", f"width = {width}\nheight = {height}", scene.read_text())
    if found != 1:
        sys.exit(f"figures.py: {scene} does not give its size, 640x480, in the expected way")
    return text


def pixels(bench):
    print("### Cost against pixels\n")
    sizes = [(320, 240), (640, 480), (1280, 960), (2560, 1920)][:3 if bench.quick else 4]
    seconds = 0.01 if bench.quick else 0.3
    works = [width * height for width, height in sizes]
    times = {}
    for (width, height), work in zip(sizes, works):
        for case in COST_CASES:
            scene = bench.work / "resized.toml"
            scene.write_text(resized(bench.scene(case), width, height))
            for isa, ms in bench.frame_ms(scene, case, bench.main_isas(), seconds).items():
                times[work, (isa, case)] = ms
    print("gold-mirror-5, one thread, rendering alone: ms of processor time a frame, ns a pixel.\n"
          "Expected: linear, power 1.\n")
    print_cost(bench, ["size"], [([f"{width}x{height}"], width * height) for width, height in sizes], works, times)
    print("\n    sed 's/^width = 640/width = 1280/; s/^height = 480/height = 960/' sharp.toml > resized.toml")
    print(f"    zerkalo bench resized.toml --filter ^frame/samples:1/ --min-time {seconds}")


def covered_percent(bench, count, first):
    scene, picture = bench.work / "silhouettes.toml", bench.work / "silhouettes.pfm"
    scene.write_text(figures_scenes.silhouettes(count, first))
    bench.run("render", scene, "-o", picture)
    values = array.array("f", picture.read_bytes().split(b"\n", 3)[3])
    return 100 * values.count(0.0) / len(values)


def solids(bench):
    print("### Cost against solids\n")
    counts, seconds = ([1, 5, 32], 0.005) if bench.quick else ([1, 5, 10, 20, 32], 0.05)
    kinds = range(len(figures_scenes.KINDS))
    times, rows = {}, []
    for count in counts:
        each = {column: [] for column in cost_columns(bench)}
        for first in kinds:
            for case in COST_CASES:
                scene = bench.work / "solids.toml"
                scene.write_text(figures_scenes.scene(count, first, sharp=case == SHARP))
                for isa, ms in bench.frame_ms(scene, case, bench.main_isas(), seconds).items():
                    each[isa, case].append(ms)
        for column, ms in each.items():
            times[count, column] = statistics.mean(ms)
        share = statistics.mean(covered_percent(bench, count, first) for first in kinds)
        rows.append(([count, f"{share:.1f} %"], 640 * 480))
    print("640x480, one thread, rendering alone: ms of processor time a frame, ns a pixel. Small solids of all\n"
          "kinds, spread before the gold mirror, that together cover nearly the same share of the picture; the mean\n"
          "over five scenes, in which every kind takes every place. Expected: clearly below linear, power below 1.\n")
    print_cost(bench, ["solids", "they cover"], rows, counts, times)
    print("\n    python3 tools/figures_scenes.py 32 > solids.toml")
    print(f"    zerkalo bench solids.toml --filter ^frame/samples:16/ --min-time {seconds}")


def kernels(bench):
    print("### Kernels\n")
    chosen, seconds = "^(solid|shadow|mirror)/", "0.02" if bench.quick else "0.2"
    report = json.loads(bench.run("bench", "--filter", chosen, "--min-time", seconds, "--json"))
    times = {entry["name"]: entry["ns/ray"] for entry in report["benchmarks"]}
    names = dict.fromkeys(name.rsplit("/", 1)[0] for name in times)
    print("Nanoseconds of processor time per ray; [bench](../README.md#bench) says which rays.\n")
    rows = [[name, *(f"{times[f'{name}/{isa}']:.2f}" for isa in bench.names)] for name in names]
    print_table(["", *bench.names], rows)
    print(f"\n    zerkalo bench --filter '{chosen}' --min-time {seconds}")


TABLES = {table.__name__: table for table in (instructions, lanes, process, pixels, solids, kernels)}

if __name__ == "__main__":
    if len(sys.argv) not in (4, 5) or sys.argv[1] not in TABLES or sys.argv[4:] not in ([], ["--quick"]):
        sys.exit(f"Usage: figures.py {'|'.join(TABLES)} PROGRAM WORK [--quick]")
    TABLES[sys.argv[1]](Bench(sys.argv[2], sys.argv[3], len(sys.argv) == 5))
