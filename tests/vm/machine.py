"""An emulated PC: boots, is read over its serial line, and gives screen dumps over QMP."""

import json
import os
import queue
import shutil
import socket
import subprocess
import threading
import time

EMULATOR = "qemu-system-x86_64"
MEMORY_MB = 160
COMMAND_LINE = (
    "console=ttyS0 panic=-1 quiet lsm= cryptomgr.notests mitigations=off nokaslr audit=0 vt.global_cursor_default=0"
)


class MachineError(Exception):
    pass


class Machine:
    """Runs inside `with`. `folder` must have a short path: it holds the control socket."""

    def __init__(self, folder, vmlinux, initramfs, card, mode):
        if shutil.which(EMULATOR) is None:
            raise MachineError(f"{EMULATOR} is not installed: apt-get install --no-install-recommends qemu-system-x86")
        self.folder = folder
        self.socket_path = os.path.join(folder, "qmp")
        # Pure emulation: the same everywhere, also where this test itself runs in a virtual machine.
        self.arguments = [
            EMULATOR, "-accel", "tcg", "-m", str(MEMORY_MB), "-nodefaults", "-display", "none", "-no-reboot",
            "-serial", "stdio", "-qmp", f"unix:{self.socket_path},server=on,wait=off", *card,
            "-kernel", vmlinux, "-initrd", initramfs, "-append", f"{COMMAND_LINE} {mode}".strip(),
        ]  # fmt: skip
        self.lines = queue.Queue()
        self.transcript = []

    def __enter__(self):
        self.process = subprocess.Popen(
            self.arguments, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )
        self.reader = threading.Thread(target=self._read_serial, daemon=True)
        self.reader.start()
        self.control = None
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        self.reader.join()
        self.process.stdout.close()
        if self.control is not None:
            self.control.close()

    def _read_serial(self):
        for line in self.process.stdout:
            self.lines.put(line.decode(errors="replace").rstrip())
        self.lines.put(None)

    def wait_for(self, marker, seconds):
        """What follows `marker` on its line. The emulator ends with 0 even after a panic: only markers count."""
        deadline = time.monotonic() + seconds
        while True:
            try:
                line = self.lines.get(timeout=max(deadline - time.monotonic(), 0.001))
            except queue.Empty:
                raise self._error(f"no '{marker}' within {seconds} s") from None
            if line is None:
                raise self._error(f"the machine ended before '{marker}'")
            self.transcript.append(line)
            if "Kernel panic" in line or "ZERKALO-VM FAIL" in line:
                raise self._error(line)
            if marker in line:
                return line.split(marker, 1)[1].strip()

    def _error(self, reason):
        return MachineError("\n".join([reason, "the machine's last lines:"] + self.transcript[-20:]))

    def screen_dump(self):
        """The screen as the bytes of a PPM file."""
        path = os.path.join(self.folder, "dump.ppm")
        self._command("screendump", filename=path)
        with open(path, "rb") as file:
            return file.read()

    def _command(self, name, **arguments):
        if self.control is None:
            connection = socket.socket(socket.AF_UNIX)
            connection.settimeout(30)
            connection.connect(self.socket_path)
            self.control = connection.makefile("rw", encoding="utf-8")
            self.control.readline()  # the greeting
            self._command("qmp_capabilities")
        self.control.write(json.dumps({"execute": name, "arguments": arguments}) + "\n")
        self.control.flush()
        while True:
            answer = json.loads(self.control.readline())
            if "return" in answer:
                return
            if "error" in answer:
                raise self._error(f"{name}: {answer['error']}")
