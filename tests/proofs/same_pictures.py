"""Several programs must print the same pictures: one line "<picture> <isa> <hash>" each, equal hashes for one picture.

Usage: same_pictures.py [--stored FILE [--update]] [--few PROGRAM] [--emulator COMMAND] PROGRAM...
A stored file has lines "<picture> <hash>", which builds for other processors are compared with too; --update writes it
anew once all programs agree. A program of few kernels may lack some, but not one lane; all others must have the same.
"""
import argparse
import shlex
import subprocess
import sys
from pathlib import Path

from verdict import verdict


def pictures_of(command):
    """{(picture, isa): hash} as a program prints it; it must exit with 0 and print something."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=240)
    if done.returncode != 0 or not done.stdout:
        raise SystemExit(f"{' '.join(command)}: exit code {done.returncode}, printed: {done.stdout}{done.stderr}")
    lines = [line.split() for line in done.stdout.splitlines()]
    return {(picture, isa): value for picture, isa, value in lines}


def stored_hashes(path):
    """{picture: hash}"""
    if not path.is_file():
        raise SystemExit(f"{path} is missing; same_pictures.py --stored {path} --update PROGRAM... writes it")
    return dict(line.split() for line in path.read_text(encoding="utf-8").splitlines())


def differences(printed, stored=None, few=()):
    """`printed`: {program: {(picture, isa): hash}}; `stored`: {picture: hash}, or None. Violations: a second hash of a
    picture, a kernel or picture missing, a picture that is not stored.
    """
    found, first = [], {picture: (value, "the stored file") for picture, value in (stored or {}).items()}
    for program, table in printed.items():
        for (picture, isa), value in table.items():
            known, where = first.setdefault(picture, (value, f"{isa} of {program}"))
            if value != known:
                found.append(f"{picture}: {isa} of {program} gives {value}, {where} gives {known}")
    if stored is not None:
        found += [f"{picture}: is not stored" for picture in sorted(set(first) - set(stored))]
    everything = {key for table in printed.values() for key in table}
    for program, table in printed.items():
        if program in few:
            found += [f"{picture}: {program} lacks scalar" for picture in sorted({picture for picture, _ in table})
                      if (picture, "scalar") not in table]
        else:
            found += [f"{picture}: {program} lacks {isa}" for picture, isa in sorted(everything - set(table))]
        found += [f"{picture}: {program} lacks it" for picture in sorted(set(first) - {picture for picture, _ in table})]
    return found


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--stored", type=Path)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--few", action="append", default=[])
    parser.add_argument("--emulator", default="")
    parser.add_argument("programs", nargs="*")
    given = parser.parse_args(arguments)
    programs = [*given.programs, *given.few]
    if len(programs) + (given.stored is not None) < 2 or (given.update and not given.stored):
        raise SystemExit(__doc__)
    printed = {program: pictures_of([*shlex.split(given.emulator), program]) for program in programs}
    stored = stored_hashes(given.stored) if given.stored and not given.update else None
    found = differences(printed, stored, given.few)
    if given.update and not found:
        hashes = {picture: value for table in printed.values() for (picture, _), value in table.items()}
        given.stored.write_text("".join(f"{picture} {value}\n" for picture, value in hashes.items()), encoding="utf-8")
    isas = sorted({isa for table in printed.values() for _, isa in table})
    beside = " and the stored hashes" if given.stored else ""
    return verdict("every build renders the same pictures", found,
                   f"{len(programs)} programs{beside}, {sum(map(len, printed.values()))} pictures, {', '.join(isas)}")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
