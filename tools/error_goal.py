#!/usr/bin/env python3
"""What `render --error E` costs beside the smallest fixed --samples that reaches E, scene by scene, as Markdown.

Usage: tools/error_goal.py [--program FILE] [--error E] [--size WxH] [--estimator NAME] [--number NAME]
       [--placements N] [--repeat N] [SCENE...]

The reference is the mean of eight pictures of 1021 samples with different rotations, by fibonacci in float. Rays are
exact and the same everywhere; times are the least of --repeat renderings on one thread, in turn, so that a busy machine
slows both. Of several placements of the lobe rays errors are the root of the mean square, `largest` is that of the
worst one, rays are the sum, and so are the times of the first four.
Default: every shipped scene with an unpolished mirror, error 0.002, 320x240, one placement, 11 repetitions.
"""
import argparse
import array
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

APART = 31  # from rotation to rotation: more than a picture takes
TIMED = 4  # placements


def floats_of(path):
    """The values of a PFM file of three channels."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"PF":
            raise ValueError(f"{path}: not a PFM of three channels")
        file.readline()
        little = float(file.readline()) < 0
        values = array.array("f", file.read())
    if little != (sys.byteorder == "little"):
        values.byteswap()
    return values


class Scene:
    def __init__(self, program, path, size, folder):
        self.command = [program, "render", str(path), "--size", size, "--threads", "1", "--json"]
        self.picture = str(pathlib.Path(folder) / "picture.pfm")

    def render(self, *arguments):
        command = [*self.command, "-o", self.picture, *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, check=True)
        return json.loads(done.stdout)

    def set_reference(self):
        pictures = []
        for rotation in range(1001, 1009):
            self.render("--samples", 1021, "--rotation", rotation)
            pictures.append(floats_of(self.picture))
        self.reference = [sum(values) / len(pictures) for values in zip(*pictures)]

    def distance(self):
        squares = sum((a - b) ** 2 for a, b in zip(floats_of(self.picture), self.reference))
        return (squares / len(self.reference)) ** 0.5


class Placements:
    """Pictures of one kind by several placements of the lobe rays: error, estimate, and rays of all together."""

    def __init__(self, scene, count, arguments):
        reports, errors = [], []
        for k in range(count):
            reports.append(scene.render(*arguments, "--rotation", APART * k))
            errors.append(scene.distance())
        self.error = (sum(error ** 2 for error in errors) / count) ** 0.5
        self.largest = max(errors)
        self.estimated = (sum(report.get("estimated_error", 0) ** 2 for report in reports) / count) ** 0.5
        self.rays = sum(sum(report["rays"].values()) for report in reports)
        self.lobe_rays = sum(report["rays"]["lobe"] for report in reports)


def row(scene, name, options):
    scene.set_reference()
    kind = "--estimator", options.estimator, "--number", options.number
    samples, fixed = 0, None
    while fixed is None or fixed.error > options.error:
        samples += 1 + samples // 24
        fixed = Placements(scene, options.placements, (*kind, "--samples", samples))
    asked = Placements(scene, options.placements, (*kind, "--error", options.error))
    fixed_time = asked_time = 0
    for k in range(min(options.placements, TIMED)):
        times = {"--samples": [], "--error": []}
        for _ in range(options.repeat):
            for option, value in ("--samples", samples), ("--error", options.error):
                report = scene.render(*kind, option, value, "--rotation", APART * k)
                times[option].append(report["seconds"])
        fixed_time += min(times["--samples"])
        asked_time += min(times["--error"])
    return (f"| {name} | {samples} | {asked.rays / fixed.rays:.2f} | {asked.lobe_rays / fixed.lobe_rays:.2f} "
            f"| {asked_time / fixed_time:.2f} | {asked.estimated:.5f} | {asked.error:.5f} | {asked.largest:.5f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/tools/zerkalo"))
    parser.add_argument("--error", type=float, default=0.002)
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--estimator", default="fibonacci")
    parser.add_argument("--number", default="float")
    parser.add_argument("--placements", type=int, default=1)
    parser.add_argument("--repeat", type=int, default=11)
    parser.add_argument("scenes", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    scenes = options.scenes or sorted((ROOT / "firmware/scenes").glob("*.toml"))
    print("| scene | fixed samples | rays | lobe rays | time | estimated | true | largest |\n|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory(prefix="zerkalo-goal-") as folder:
        for path in scenes:
            scene = Scene(options.program, path, options.size, folder)
            if "glossy" in scene.render("--samples", 1)["features"]:
                print(row(scene, path.stem, options), flush=True)


if __name__ == "__main__":
    main()
