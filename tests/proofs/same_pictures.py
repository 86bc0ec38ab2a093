"""Several programs must print the same pictures: one line "<picture> <isa> <hash>" each, equal hashes for one picture.

Usage: same_pictures.py [--native PROGRAM] [--few PROGRAM] [--emulator COMMAND] PROGRAM...
A native program may have other instruction sets than the emulated ones, one of few kernels may lack some, but not one
lane; all others must have the same.
"""
import argparse
import shlex
import subprocess
import sys

from verdict import verdict


def pictures_of(command):
    """{(picture, isa): hash} as a program prints it; it must exit with 0 and print something."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=240)
    if done.returncode != 0 or not done.stdout:
        raise SystemExit(f"{' '.join(command)}: exit code {done.returncode}, printed: {done.stdout}{done.stderr}")
    lines = [line.split() for line in done.stdout.splitlines()]
    return {(picture, isa): value for picture, isa, value in lines}


def differences(printed, natives=(), few=()):
    """`printed`: {program: {(picture, isa): hash}}. Violations: a second hash of a picture, a kernel or picture missing."""
    found, first = [], {}
    for program, table in printed.items():
        for (picture, isa), value in table.items():
            known, where = first.setdefault(picture, (value, f"{isa} of {program}"))
            if value != known:
                found.append(f"{picture}: {isa} of {program} gives {value}, {where} gives {known}")
    everything = {key for program, table in printed.items() if program not in natives for key in table}
    for program, table in printed.items():
        if program in few:
            found += [f"{picture}: {program} lacks scalar" for picture in sorted({picture for picture, _ in table})
                      if (picture, "scalar") not in table]
        elif program not in natives:
            found += [f"{picture}: {program} lacks {isa}" for picture, isa in sorted(everything - set(table))]
        lost = sorted({picture for picture, _ in everything} - {picture for picture, _ in table})
        found += [f"{picture}: {program} lacks it" for picture in lost]
    return found


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--native", action="append", default=[])
    parser.add_argument("--few", action="append", default=[])
    parser.add_argument("--emulator", default="")
    parser.add_argument("programs", nargs="*")
    given = parser.parse_args(arguments)
    commands = {program: [program] for program in given.native}
    given.programs += given.few
    commands.update({program: [*shlex.split(given.emulator), program] for program in given.programs})
    if len(commands) < 2:
        raise SystemExit(__doc__)
    printed = {program: pictures_of(command) for program, command in commands.items()}
    isas = sorted({isa for table in printed.values() for _, isa in table})
    return verdict("every build renders the same pictures", differences(printed, given.native, given.few),
                   f"{len(commands)} programs, {sum(map(len, printed.values()))} pictures, {', '.join(isas)}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
