"""Runs the real program on files in a directory of its own: what every test of the command line builds on."""
import fcntl
import json
import os
import pathlib
import pty
import resource
import select
import signal
import struct
import subprocess
import tempfile
import termios
import time
import unittest

PROGRAM = os.environ["ZERKALO"]

# A ball and its reflection in an unpolished mirror, 32x24.
SCENE = """
version = 1
background = [0.1, 0.2, 0.3]
[image]
width = 32
height = 24
[camera]
position = [1.0, 1.5, 5.0]
look_at = [0.0, 0.8, 0.0]
horizontal_fov_deg = 50.0
[[light]]
position = [-3.0, 4.0, 3.0]
[[solid]]
kind = "sphere"
position = [0.0, 0.6, 0.0]
radius = 0.6
[[mirror]]
position = [0.0, 1.0, -1.5]
normal = [0.0, 0.0, 1.0]
boundary = { shape = "rectangle", width = 4.0, height = 2.0 }
lobe_exponent = 200.0
"""


def set_size(terminal, columns, rows):
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))


class TerminalSession:
    """The program on a pseudo-terminal of its own: all of stdin, stdout and stderr."""

    def __init__(self, *arguments, environment=None, columns=40, rows=13):
        self.process, self.descriptor = pty.fork()
        if self.process == 0:
            # The size must be there before the program asks for it.
            set_size(0, columns, rows)
            os.execve(PROGRAM, [PROGRAM, *arguments], {**os.environ, "TERM": "xterm", **(environment or {})})
        self.output = b""

    def resize(self, columns, rows):
        set_size(self.descriptor, columns, rows)

    def read_until(self, enough, seconds=60):
        """Reads until enough(output) or the end; returns whether it was enough in time."""
        deadline = time.monotonic() + seconds
        while not enough(self.output):
            if not select.select([self.descriptor], [], [], max(0, deadline - time.monotonic()))[0]:
                return False
            try:
                piece = os.read(self.descriptor, 65536)
            except OSError:  # how Linux says that the other side is closed
                piece = b""
            if not piece:
                return enough(self.output)
            self.output += piece
        return True

    def send(self, number=signal.SIGINT):
        os.kill(self.process, number)

    def exit_code(self):
        self.read_until(lambda output: False)
        status = os.waitpid(self.process, 0)[1]
        self.process = None
        return os.waitstatus_to_exitcode(status)

    def end(self):
        """For a test that failed half-way: leaves no program behind."""
        if self.process is not None:
            os.kill(self.process, signal.SIGKILL)
            os.waitpid(self.process, 0)
        os.close(self.descriptor)


class CommandLineTest(unittest.TestCase):
    """Each test has an empty directory `self.files` with the scene `scene.toml` in it."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="zerkalo-test-")
        self.addCleanup(directory.cleanup)
        self.files = pathlib.Path(directory.name)
        self.scene = self.file("scene.toml", SCENE)

    def file(self, name, text):
        path = self.files / name
        path.write_text(text, encoding="utf-8")
        return str(path)

    def path(self, name):
        return str(self.files / name)

    def names(self):
        """Every file of the directory, hidden ones too."""
        return sorted(entry.name for entry in self.files.iterdir())

    def run_program(self, *arguments, environment=None, stdout=subprocess.PIPE, file_limit=None, memory_limit=None):
        def limit():
            if file_limit is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (file_limit, file_limit))
            if memory_limit is not None:
                resource.setrlimit(resource.RLIMIT_AS, (memory_limit, memory_limit))

        limited = file_limit is not None or memory_limit is not None
        return subprocess.run([PROGRAM, *arguments], stdin=subprocess.DEVNULL, stdout=stdout, stderr=subprocess.PIPE,
                              env={**os.environ, **(environment or {})}, preexec_fn=limit if limited else None,
                              timeout=120, check=False)

    def succeed(self, *arguments, **options):
        """Standard output of a run that must end with 0."""
        done = self.run_program(*arguments, **options)
        self.assertEqual(done.returncode, 0, f"{arguments}: {done.stderr.decode(errors='replace')}")
        return done.stdout

    def json(self, *arguments):
        """The one JSON object that the run prints."""
        return json.loads(self.succeed(*arguments, "--json"))

    def terminal(self, *arguments, **options):
        """The program on a terminal of its own."""
        session = TerminalSession(*arguments, **options)
        self.addCleanup(session.end)
        return session

    def expect_failure(self, code, *arguments, says=(), **options):
        """A run that must end with `code`, one line on stderr that holds all of `says`, and nothing on stdout."""
        done = self.run_program(*arguments, **options)
        message = done.stderr.decode(errors="replace")
        self.assertEqual(done.returncode, code, f"{arguments}: {message}")
        self.assertEqual(message.count("\n"), 1, f"{arguments}: not one line: {message}")
        self.assertTrue(message.startswith("zerkalo: error: "), message)
        for fragment in says:
            self.assertIn(fragment, message)
        self.assertFalse(done.stdout, f"{arguments}: {done.stdout!r}")
        return message
