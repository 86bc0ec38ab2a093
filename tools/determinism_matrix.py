"""The work behind determinism_matrix.sh: builds, runs, compares, prints. See there for its use."""
import argparse
import os
import re
import shlex
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STAGES = ("camera-ray", "hit", "normal", "radiance")
BEGIN, END = "<!-- matrix: begin -->", "<!-- matrix: end -->"


@dataclass(frozen=True)
class Build:
    """One way to compile the core. `breaks`: flags after the project's own, which are to change the pictures."""
    name: str
    compiler: str
    flags: str
    toolchain: str = ""
    emulator: str = ""
    breaks: str = ""

    def title(self):
        return f"{self.compiler} {self.flags} {self.breaks}".strip()


SANITIZERS = "-fsanitize=address,undefined -fno-sanitize-recover=all"
BUILDS = (
    *(Build(f"gcc_O{level}", "g++", f"-O{level}") for level in range(4)),
    *(Build(f"clang_O{level}", "clang++-14", f"-O{level}") for level in range(4)),
    # GCC's sanitizers take most of an hour for one kernel.
    Build("clang_sanitized", "clang++-14", f"-O1 {SANITIZERS}"),
    Build("aarch64_O1", "aarch64-linux-gnu-g++", "-O1", "aarch64.cmake", "qemu-aarch64"),
    Build("aarch64_O3", "aarch64-linux-gnu-g++", "-O3", "aarch64.cmake", "qemu-aarch64"),
    # The lane library has no form for a processor without vectors; the kernel is the scalar one.
    Build("armhf_O2", "arm-linux-gnueabihf-g++", "-O2 -mfpu=neon", "armhf.cmake", "qemu-arm"),
    Build("contracted", "clang++-14", "-O1 -mfma", breaks="-ffp-contract=fast"),
)


def run(command, **options):
    """Standard output of a command that must succeed."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{shlex.join(map(str, command))}: exit code {done.returncode}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def write_scenes(folder, jobs):
    """The shipped scenes as one binary file, by the loader of a build of this machine's own."""
    build = folder / "scenes"
    run(["cmake", "-S", ROOT / "tests/proofs/matrix", "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
         "-DCMAKE_CXX_FLAGS=-O0"])
    run(["cmake", "--build", build, "--target", "write_scenes", "--parallel", str(jobs)])
    scenes = folder / "scenes.bin"
    run([build / "write_scenes", scenes, *sorted((ROOT / "firmware/scenes").glob("*.toml"))])
    return scenes


def configure(build, folder):
    toolchain = [f"-DCMAKE_TOOLCHAIN_FILE={ROOT / 'tools' / build.toolchain}"] if build.toolchain else []
    run(["cmake", "-S", ROOT / "tests/proofs/pictures", "-B", folder, "-G", "Ninja", *toolchain,
         f"-DCMAKE_CXX_COMPILER={build.compiler}", "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS={build.flags} -DNDEBUG",
         f"-DZERKALO_BREAK={build.breaks}", f"-DZERKALO_FEW_KERNELS={'ON' if build.breaks else 'OFF'}"])


def results_of(build, given, scenes):
    """What the program of one build prints, parsed."""
    built = dict(entry.split("=", 1) for entry in given.built)
    folder = Path(built.get(build.name, given.folder / build.name))
    if build.name not in built:
        configure(build, folder)
    run(["cmake", "--build", folder, "--target", "matrix", "--parallel", str(given.jobs)])
    return parsed(run([*shlex.split(build.emulator), folder / "matrix", scenes], timeout=3600))


def parsed(text):
    """{(instruction set, schedule): {(scene, number type): {stage: hash}}} of one program's output."""
    table = {}
    for line in text.splitlines():
        isa, schedule, scene, number, stage, value = line.split()
        table.setdefault((isa, schedule), {}).setdefault((scene, number), {})[stage] = value
    return table


def first_difference(hashes, reference):
    """None, or (scene, number type, stage): the earliest stage in which any picture differs, and the first such picture."""
    for stage in STAGES:
        for picture in sorted(reference):
            theirs = hashes.get(picture, {})
            # A schedule is asked for the radiance alone.
            if stage in theirs and theirs[stage] != reference[picture][stage]:
                return (*picture, stage)
    lacking = sorted(picture for picture in reference if "radiance" not in hashes.get(picture, {}))
    return (*lacking[0], "missing") if lacking else None


def verdicts(results, reference):
    """{(build, isa, schedule): first difference or None}"""
    return {(build, *key): first_difference(hashes, reference)
            for build, table in results.items() for key, hashes in table.items()}


def hash_table(reference):
    numbers = sorted({number for _, number in reference})
    lines = ["| scene | " + " | ".join(numbers) + " |", "|---|" + "---|" * len(numbers)]
    for scene in sorted({scene for scene, _ in reference}):
        cells = [f"`{reference[scene, number]['radiance']}`" if (scene, number) in reference else "" for number in numbers]
        lines.append(f"| {scene} | " + " | ".join(cells) + " |")
    return lines


def configuration_table(found, builds):
    """One row a build; a cell lists what agrees, then what does not, by the first stage that differs."""
    lines = ["| build | instruction sets, tiles row by row, one thread | tile order:threads, widest instruction set |",
             "|---|---|---|"]
    for build in builds:
        cells = ({}, {})
        for (name, isa, schedule), difference in found.items():
            if name == build.name:
                in_turn = schedule == "rows:1"
                cells[not in_turn].setdefault(difference, []).append(isa if in_turn else schedule)
        lines.append(f"| `{build.title()}` | {cell_text(cells[0])} | {cell_text(cells[1])} |")
    return lines


def cell_text(names_by_difference):
    """`names_by_difference`: {None or (scene, number type, stage): names}"""
    parts = [", ".join(names_by_difference.get(None, []))]
    for difference, names in names_by_difference.items():
        if difference:
            scene, number, stage = difference
            parts.append(f"**differing: {', '.join(names)} ({stage} of {scene}, {number})**")
    return "; ".join(filter(None, parts))


def judged(found, builds):
    """The sentence under the tables, and whether all is as it should be."""
    broken = {build.name for build in builds if build.breaks}
    sound = {key: difference for key, difference in found.items() if key[0] not in broken}
    differing = sum(difference is not None for difference in sound.values())
    good = bool(sound) and differing == 0
    text = f"{len(sound)} configurations, {len(sound) - differing} with these hashes, {differing} with others."
    for name in sorted(broken):
        caught = any(difference for key, difference in found.items() if key[0] == name)
        good = good and caught
        text += f" The build that breaks the float contract is {'caught' if caught else 'NOT caught'}."
    return text, good


def report(results, builds):
    """(Markdown, good). The reference is the first configuration of the first build."""
    reference = next(iter(results[builds[0].name].values()))
    found = verdicts(results, reference)
    text, good = judged(found, builds)
    return "\n".join([*hash_table(reference), "", *configuration_table(found, builds), "", text]), good


def update(path, text):
    old = path.read_text(encoding="utf-8")
    if (old.count(BEGIN), old.count(END)) != (1, 1):
        sys.exit(f"{path} has not one line '{BEGIN}' and one '{END}'")
    new = re.sub(f"{BEGIN}.*{END}", lambda _: f"{BEGIN}\n{text}\n{END}", old, flags=re.DOTALL)
    path.write_text(new, encoding="utf-8")


def main(arguments):
    parser = argparse.ArgumentParser(prog="determinism_matrix.sh")
    names = [build.name for build in BUILDS]
    parser.add_argument("--builds", default=",".join(names))
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--folder", type=Path, default=ROOT / "build/matrix")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--built", action="append", default=[], metavar="NAME=FOLDER", help="configured already")
    parser.add_argument("--scenes", type=Path, help="written already")
    given = parser.parse_args(arguments)
    if given.list:
        print("\n".join(f"{build.name:16} {build.title()}" for build in BUILDS))
        return 0
    wanted = given.builds.split(",")
    unknown = sorted(set(wanted) - set(names))
    if unknown:
        parser.error(f"no such build: {', '.join(unknown)}; there are {', '.join(names)}")
    builds = [build for build in BUILDS if build.name in wanted]
    given.folder.mkdir(parents=True, exist_ok=True)
    scenes = given.scenes or write_scenes(given.folder, given.jobs)
    results = {}
    for build in builds:
        print(f"{build.name}: {build.title()}", file=sys.stderr, flush=True)
        results[build.name] = results_of(build, given, scenes)
    text, good = report(results, builds)
    if given.update:
        update(ROOT / "tests/README.md", text)
    else:
        print(text)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
