"""Feeds differing programs to the comparison of pictures: each must be rejected."""
import stat
import tempfile
import unittest
from pathlib import Path

import same_pictures

STORED = "sharp 00ff\nglossy 1234\n"
GOOD = "sharp sse2 00ff\nsharp avx2 00ff\nglossy sse2 1234\nglossy avx2 1234\n"


class SamePictures(unittest.TestCase):
    def run_on(self, *outputs, stored=None, few=(), code=0, update=False):
        """The exit code for programs that print the given texts; `self.stored`: the stored file afterwards."""
        with tempfile.TemporaryDirectory() as folder:
            arguments = []
            for i, text in enumerate([*few, *outputs]):
                program = Path(folder) / f"program{i}"
                program.write_text(f"#!/bin/sh\nprintf '%s' '{text}'\nexit {code}\n")
                program.chmod(program.stat().st_mode | stat.S_IXUSR)
                arguments += [*(["--few"] if i < len(few) else []), str(program)]
            hashes = Path(folder) / "hashes.txt"
            if stored is not None:
                hashes.write_text(stored)
            if stored is not None or update:
                arguments += ["--stored", str(hashes), *(["--update"] if update else [])]
            result = same_pictures.main(arguments)
            self.stored = hashes.read_text() if hashes.is_file() else None
            return result

    def test_equal_pictures_are_accepted(self):
        self.assertEqual(self.run_on(GOOD, GOOD, GOOD), 0)

    def test_another_hash_in_one_program_is_rejected(self):
        self.assertEqual(self.run_on(GOOD, GOOD.replace("1234", "1235")), 1)
        self.assertEqual(self.run_on(GOOD, GOOD, GOOD.replace("avx2 00ff", "avx2 00fe")), 1)

    def test_another_hash_in_one_instruction_set_of_all_programs_is_rejected(self):
        odd = GOOD.replace("avx2 00ff", "avx2 00fe")
        self.assertEqual(self.run_on(odd, odd), 1)

    def test_a_missing_kernel_or_picture_is_rejected(self):
        self.assertEqual(self.run_on(GOOD, "sharp sse2 00ff\nglossy sse2 1234\n"), 1)
        self.assertEqual(self.run_on("sharp sse2 00ff\nsharp avx2 00ff\n", GOOD), 1)

    def test_the_stored_hashes_are_those_of_every_picture_and_of_no_other(self):
        self.assertEqual(self.run_on(GOOD, stored=STORED), 0)
        self.assertEqual(self.run_on(GOOD, GOOD, stored=STORED.replace("1234", "1235")), 1)
        self.assertEqual(self.run_on(GOOD, stored="sharp 00ff\n"), 1)
        self.assertEqual(self.run_on(GOOD, stored=STORED + "matte 5678\n"), 1)

    def test_the_stored_hashes_are_written_only_where_all_agree(self):
        self.assertEqual(self.run_on(GOOD, GOOD, stored="sharp 0000\n", update=True), 0)
        self.assertEqual(self.stored, STORED)
        self.assertEqual(self.run_on(GOOD, update=True), 0)
        self.assertEqual(self.stored, STORED)
        self.assertEqual(self.run_on(GOOD, GOOD.replace("1234", "1235"), stored="sharp 0000\n", update=True), 1)
        self.assertEqual(self.stored, "sharp 0000\n")

    def test_a_missing_stored_file_is_rejected(self):
        with self.assertRaises(SystemExit):
            same_pictures.main(["--stored", "/nowhere/hashes.txt", "true", "true"])

    def test_a_program_of_few_kernels_has_one_lane_the_same_hashes_and_every_picture(self):
        whole = GOOD.replace("sse2", "scalar")
        self.assertEqual(self.run_on(whole, few=["sharp scalar 00ff\nglossy scalar 1234\n"]), 0)
        self.assertEqual(self.run_on(whole, few=["sharp avx2 00ff\nglossy scalar 1234\n"]), 1)
        self.assertEqual(self.run_on(whole, few=["sharp scalar 00fe\nglossy scalar 1234\n"]), 1)
        self.assertEqual(self.run_on(whole, few=["sharp scalar 00ff\n"]), 1)

    def test_a_failing_silent_or_lone_program_is_rejected(self):
        for outputs, code in (((GOOD, GOOD), 1), (("", ""), 0), ((GOOD,), 0)):
            with self.assertRaises(SystemExit):
                self.run_on(*outputs, code=code)


if __name__ == "__main__":
    unittest.main()
