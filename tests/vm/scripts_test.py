#!/usr/bin/env python3
"""The scripts around the test machine: each says no to what is wrong, and reads right what is right."""

import os
import struct
import tempfile
import unittest
import zlib
from unittest import mock

import framebuffer_vm
import initramfs
import kernel
import machine
import pictures

WIDTH, HEIGHT = 3, 5
CODES = bytes((37 * i + i * i) % 256 for i in range(3 * WIDTH * HEIGHT))


def png_chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def filtered_rows():
    """Row y of CODES by filter type y, straight from the definitions of the standard."""
    rows = b""
    for y in range(HEIGHT):
        row = CODES[3 * WIDTH * y : 3 * WIDTH * (y + 1)]
        above = CODES[3 * WIDTH * (y - 1) : 3 * WIDTH * y] if y else bytes(len(row))
        left = bytes(3) + row[:-3]
        corner = bytes(3) + above[:-3]
        guesses = [
            lambda a, b, c: 0,
            lambda a, b, c: a,
            lambda a, b, c: b,
            lambda a, b, c: (a + b) // 2,
            lambda a, b, c: min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2],
        ]
        rows += bytes([y]) + bytes((v - guesses[y](a, b, c)) & 255 for v, a, b, c in zip(row, left, above, corner))
    return rows


def png(depth=8):
    header = struct.pack(">IIBBBBB", WIDTH, HEIGHT, depth, 2, 0, 0, 0)
    data = zlib.compress(filtered_rows())
    parts = [(b"IHDR", header), (b"IDAT", data[:20]), (b"IDAT", data[20:]), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(png_chunk(*part) for part in parts)


class Pictures(unittest.TestCase):
    def test_every_png_filter_is_undone(self):
        self.assertEqual(pictures.read_png(png()), (WIDTH, HEIGHT, CODES))

    def test_sixteen_bit_png_is_refused(self):
        with self.assertRaises(pictures.PictureError):
            pictures.read_png(png(depth=16))

    def test_padded_dump_loses_its_padding(self):
        for padding in (b"", b"\xaa\xbb\xcc"):
            rows = b"".join(CODES[9 * y : 9 * y + 9] + padding for y in range(HEIGHT))
            self.assertEqual(pictures.read_ppm(b"P6\n3 5\n255\n" + rows), (WIDTH, HEIGHT, CODES))

    def test_short_dump_is_refused(self):
        for data in (b"P6\n3 5\n255\n" + CODES[:-1], b"P5\n3 5\n255\n" + CODES):
            with self.assertRaises(pictures.PictureError):
                pictures.read_ppm(data)

    def test_one_differing_byte_is_found(self):
        picture = (WIDTH, HEIGHT, CODES)
        self.assertIsNone(pictures.difference(picture, picture))
        for i in range(len(CODES)):
            changed = bytearray(CODES)
            changed[i] ^= 1
            message = pictures.difference((WIDTH, HEIGHT, bytes(changed)), picture)
            self.assertIn(f"1 of 15 pixels differ; the first at ({i // 3 % 3}, {i // 9})", message)
        self.assertIn("the screen is 5x3", pictures.difference((5, 3, CODES), picture))

    def test_sixteen_bits_keep_black_and_white_and_mean_what_the_code_means(self):
        for code in (0, 64, 128, 255):
            shown = pictures.on_rgb565((8, 8, bytes([code] * 192)))[2]
            self.assertAlmostEqual(sum(shown) / 192, code, delta=1.5)
            self.assertEqual(len(set(shown)) == 1, code in (0, 255))


class Kernel(unittest.TestCase):
    def test_dependencies_are_loaded_first_and_once(self):
        depends = {"bochs": ["drm", "ttm"], "ttm": ["drm"], "drm": [], "other": []}
        self.assertEqual(kernel.load_order("bochs", depends), ["drm", "ttm", "bochs"])
        with self.assertRaisesRegex(kernel.KernelError, "no module ttm"):
            kernel.load_order("bochs", {"bochs": ["ttm"]})

    def test_depends_are_read_from_modinfo(self):
        module = b"\x7fELF...\0license=GPL\0depends=drm-kms-helper,ttm\0name=bochs\0"
        self.assertEqual(kernel.depends_of(module), ["drm_kms_helper", "ttm"])
        self.assertEqual(kernel.depends_of(b"\0depends=\0"), [])

    def test_payload_of_a_bzimage_is_found(self):
        payload = zlib.compress(b"\x7fELF the kernel", wbits=31)
        image = bytearray(b"\xee" * 4096)
        image[0x1F1] = 3
        image[0x202:0x206] = b"HdrS"
        struct.pack_into("<II", image, 0x248, 100, len(payload))
        image[4 * 512 + 100 : 4 * 512 + 100 + len(payload)] = payload
        self.assertEqual(kernel.vmlinux_of(bytes(image)), b"\x7fELF the kernel")
        image[0x202] = 0
        with self.assertRaisesRegex(kernel.KernelError, "not a bzImage"):
            kernel.vmlinux_of(bytes(image))

    def test_kernel_that_cannot_be_had_is_a_clear_failure(self):
        with tempfile.TemporaryDirectory() as cache, mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            with self.assertRaisesRegex(kernel.KernelError, "no kernel to boot: apt-cache is not installed"):
                kernel.fetch(cache)

    def test_earlier_download_serves_without_a_network(self):
        with tempfile.TemporaryDirectory() as cache, mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            kept = os.path.join(cache, "linux-image-6.1.0-1-amd64_1_amd64.deb")
            with open(kept, "wb"):
                pass
            self.assertEqual(kernel.fetch(cache), kept)


class Initramfs(unittest.TestCase):
    def test_entries_are_newc(self):
        data = initramfs.archive({"bin/a": (b"hello", 0o755)})
        self.assertEqual(len(data) % 4, 0)
        found = []
        position = 0
        while position < len(data):
            self.assertEqual(data[position : position + 6], b"070701")
            fields = [int(data[position + 6 + 8 * i : position + 14 + 8 * i], 16) for i in range(13)]
            mode, size, name_size = fields[1], fields[6], fields[11]
            name = data[position + 110 : position + 110 + name_size - 1].decode()
            position += (110 + name_size + 3) // 4 * 4
            found.append((name, mode, data[position : position + size]))
            position += (size + 3) // 4 * 4
        self.assertEqual(found, [("bin", 0o40755, b""), ("bin/a", 0o100755, b"hello"), ("TRAILER!!!", 0, b"")])


class Machine(unittest.TestCase):
    def test_missing_emulator_is_a_clear_failure(self):
        with mock.patch.dict(os.environ, {"PATH": "/nowhere"}):
            with self.assertRaisesRegex(machine.MachineError, "qemu-system-x86_64 is not installed: apt-get install"):
                machine.Machine("/tmp", "vmlinux", "root", [], "")

    def spoken(self, text):
        """A machine whose emulator is a program that prints `text` and ends."""
        with mock.patch("shutil.which", return_value="yes"):
            guest = machine.Machine("/tmp", "vmlinux", "root", [], "")
        guest.arguments = ["printf", "%s", text]
        return guest

    def test_marker_is_found_among_other_lines(self):
        with self.spoken("noise\nZERKALO-VM SCREEN 8x8-32\nZERKALO-VM EXIT 0\n") as guest:
            self.assertEqual(guest.wait_for("ZERKALO-VM SCREEN", 10), "8x8-32")
            self.assertEqual(guest.wait_for("ZERKALO-VM EXIT", 10), "0")

    def test_panic_failure_and_early_end_are_errors_with_the_last_lines(self):
        for text, reason in (
            ("a\nKernel panic - not syncing\n", "Kernel panic"),
            ("a\nZERKALO-VM FAIL open /dev/fb0: No such file\n", "/dev/fb0"),
            ("a\nb\n", "the machine ended before 'X'"),
        ):
            with self.spoken(text) as guest, self.assertRaisesRegex(machine.MachineError, f"(?s){reason}.*\na") as _:
                guest.wait_for("X", 10)


class Test(unittest.TestCase):
    def test_dynamic_program_is_refused(self):
        with tempfile.NamedTemporaryFile() as program:
            program.write(b"\x7fELF" + b"\0" * 500 + b"/lib64/ld-linux-x86-64.so.2\0")
            program.flush()
            with self.assertRaisesRegex(framebuffer_vm.TestFailure, "not statically linked"):
                framebuffer_vm.require_static(program.name)


if __name__ == "__main__":
    unittest.main()
