"""The program without a float unit must print what the one that baked its plan prints.

Usage: same_line.py [--emulator COMMAND] BAKE INTEGERS
"""
import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile

LINE = re.compile(r"everything fixed [0-9a-f]{16}\n")


def output_of(command):
    done = subprocess.run(command, capture_output=True, text=True, timeout=240)
    if done.returncode != 0 or not LINE.fullmatch(done.stdout):
        raise SystemExit(f"{' '.join(command)}: exit code {done.returncode}, printed: {done.stdout}{done.stderr}")
    return done.stdout


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--emulator", default="")
    parser.add_argument("bake")
    parser.add_argument("integers")
    given = parser.parse_args(arguments)
    emulator = shlex.split(given.emulator)
    with tempfile.TemporaryDirectory() as folder:
        expected = output_of([*emulator, given.bake, os.path.join(folder, "plan.bin")])
    printed = output_of([*emulator, given.integers])
    print(f"with a float unit:    {expected}without a float unit: {printed}", end="")
    return 0 if printed == expected else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
