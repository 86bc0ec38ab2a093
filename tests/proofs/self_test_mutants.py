"""Feeds bad lists of mutants to their reader: each must be rejected, and the good one must change the right text."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "mutants"))
import mutant_list  # noqa: E402

SOURCE = "a = b + c;\nd = b + c;\n    e = f * g;\n    h = e;\n"
GOOD = "# a list\n\nmutant minus: a sign\nin core/a.hpp\n- a = b + c;\n+ a = b - c;\n"


class MutantList(unittest.TestCase):
    def mutated(self, text):
        """The mutated core/a.hpp of a list's first mutant."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "core").mkdir()
            (root / "core/a.hpp").write_text(SOURCE)
            (root / "list.txt").write_text(text)
            return mutant_list.mutated_files(root, mutant_list.read([root / "list.txt"])[0])["core/a.hpp"]

    def rejected(self, text, message):
        with self.assertRaisesRegex(mutant_list.BadList, message):
            self.mutated(text)

    def test_a_good_mutant_changes_its_text_alone(self):
        self.assertEqual(self.mutated(GOOD), SOURCE.replace("a = b + c", "a = b - c"))

    def test_several_lines_and_several_places(self):
        lines = "mutant two: x\nin core/a.hpp\n- e = f * g;\n-     h = e;\n+ h = f;\nin core/a.hpp\n- d = b\n+ d = c\n"
        self.assertEqual(self.mutated(lines), "a = b + c;\nd = c + c;\n    h = f;\n")

    def test_no_new_text_takes_the_old_away(self):
        self.assertEqual(self.mutated("mutant gone: x\nin core/a.hpp\n- a = b + c;\n"), SOURCE[len("a = b + c;"):])

    def test_text_that_is_not_there(self):
        self.rejected(GOOD.replace("- a = b", "- a = x"), "minus: the text occurs 0 times")

    def test_text_that_is_there_twice(self):
        self.rejected(GOOD.replace("- a = b + c", "- b + c"), "minus: the text occurs 2 times")

    def test_text_replaced_by_itself(self):
        self.rejected(GOOD.replace("b - c", "b + c"), "replaces a text by itself")

    def test_a_file_that_is_not_there(self):
        self.rejected(GOOD.replace("a.hpp", "b.hpp"), "minus: there is no core/b.hpp")

    def test_a_mutant_that_replaces_nothing(self):
        self.rejected("mutant idle: x\nin core/a.hpp\n+ y\n", "idle: nothing to replace")

    def test_a_name_used_twice(self):
        self.rejected(GOOD + GOOD, "a name of its own")

    def test_a_line_of_no_kind(self):
        self.rejected(GOOD + "* a = b\n", "neither mutant, in, - nor")


if __name__ == "__main__":
    unittest.main()
