#!/usr/bin/env python3
"""Boots a stock kernel with `zerkalo show` on /dev/fb0 and compares the screen with the picture byte for byte.

The expected picture is rendered on this machine by the same static program, at the size that the guest reports, so
that a different processor (the emulated one) must give the same bytes too.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
import typing

import initramfs
import kernel
import machine
import pictures


class Display(typing.NamedTuple):
    """A graphics card, the kernel's driver for it, its mode, and what the card makes of the picture's codes."""

    driver: str
    card: list
    mode: str
    shown: typing.Callable


DISPLAYS = {
    "XRGB8888": Display("bochs", ["-vga", "std"], "", lambda picture: picture),
    "RGB888": Display("cirrus", ["-vga", "cirrus"], "video=800x480-24", lambda picture: picture),
    "RGB565": Display("cirrus", ["-vga", "cirrus"], "video=800x480-16", pictures.on_rgb565),
}

BOOT_SECONDS = 120
SHOW_SECONDS = 120
# The driver copies what was drawn to the card a little later: ask again for so long before the screen counts as wrong.
DUMP_SECONDS = 5
DUMP_PAUSE = 0.05


class TestFailure(Exception):
    pass


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="static zerkalo")
    parser.add_argument("--init", required=True, help="static init of the guest")
    parser.add_argument("--scene", required=True)
    parser.add_argument("--display", default="XRGB8888", choices=sorted(DISPLAYS), help="pixel format of the screen")
    parser.add_argument("--cache", required=True, help="folder that keeps the kernel between runs")
    parser.add_argument("--output", required=True, help="folder for the expected picture and the screen dump")
    return parser.parse_args()


def require_static(program):
    """A program that needs a loader would fail in the guest with a message that hides the reason."""
    with open(program, "rb") as file:
        if b"/ld-linux" in file.read(4096):
            raise TestFailure(f"{program} is not statically linked")


def render(program, scene, size, path):
    result = subprocess.run(
        [program, "render", scene, "--size", size, "-o", path], capture_output=True, text=True, check=False
    )
    if result.returncode != 0:
        raise TestFailure(f"zerkalo render ended with {result.returncode}: {result.stderr.strip()}")
    with open(path, "rb") as file:
        return pictures.read_png(file.read())


def compare_screen(guest, expected, path):
    """Retries while the screen differs; keeps the last dump for looking at."""
    deadline = time.monotonic() + DUMP_SECONDS
    retries = 0
    while True:
        dump = guest.screen_dump()
        wrong = pictures.difference(pictures.read_ppm(dump), expected)
        if wrong is None or time.monotonic() > deadline:
            break
        retries += 1
        time.sleep(DUMP_PAUSE)
    with open(path, "wb") as file:
        file.write(dump)
    if wrong is not None:
        raise TestFailure(f"{wrong}; see {path}")
    return retries


def run(arguments):
    os.makedirs(arguments.output, exist_ok=True)
    for program in (arguments.program, arguments.init):
        require_static(program)
    display = DISPLAYS[arguments.display]
    vmlinux, modules = kernel.prepare(arguments.cache, sorted({known.driver for known in DISPLAYS.values()}))
    with tempfile.TemporaryDirectory(prefix="zerkalo-vm-") as folder:
        root = os.path.join(folder, "root.cpio")
        with open(root, "wb") as file:
            file.write(initramfs.build(arguments.init, arguments.program, arguments.scene, modules[display.driver]))
        start = time.monotonic()
        with machine.Machine(folder, vmlinux, root, display.card, display.mode) as guest:
            screen = guest.wait_for("ZERKALO-VM SCREEN", BOOT_SECONDS)
            size = screen.split("-")[0]
            expected = render(arguments.program, arguments.scene, size, os.path.join(arguments.output, "expected.png"))
            status = guest.wait_for("ZERKALO-VM EXIT", SHOW_SECONDS)
            if status != "0":
                raise TestFailure("\n".join([f"zerkalo show ended with {status}"] + guest.transcript[-10:]))
            retries = compare_screen(guest, display.shown(expected), os.path.join(arguments.output, "screen.ppm"))
        seconds = time.monotonic() - start
    return f"screen {screen} equals the rendered picture ({seconds:.1f} s, {retries} retries)"


def main():
    try:
        print(run(parse_arguments()))
        return 0
    except (TestFailure, kernel.KernelError, machine.MachineError, pictures.PictureError, OSError) as error:
        print(f"framebuffer_vm: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
