"""zerkalo stability: the table of stiff cases as text, JSON and Markdown."""
import os
import unittest

from program import CommandLineTest

README = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "README.md")


class Stability(CommandLineTest):
    def test_json_has_every_case_with_both_errors_and_the_bound(self):
        report = self.json("stability")
        self.assertTrue(report["holds"])
        self.assertEqual([row["case"] for row in report["cases"]], [f"S{i:02}" for i in range(1, 71)])
        for row in report["cases"]:
            self.assertTrue(row["holds"], row)
            self.assertLessEqual(row["ours"], row["bound"], row)
            self.assertTrue(row["fixed_refuses"] if row["fixed"] is None else row["fixed"] <= row["fixed_bound"], row)
            # null: the textbook's formula gave no number at all.
            self.assertTrue(row["naive"] is None or row["naive"] > row["bound"], row)

    def test_one_case_can_be_asked_for_on_one_instruction_set(self):
        report = self.json("stability", "S32", "S01", "--isa", "scalar")
        self.assertEqual((report["isa"], [row["case"] for row in report["cases"]]), ("scalar", ["S01", "S32"]))

    def test_fixed_point_names_the_field_of_what_it_refuses(self):
        camera, sun, glass = self.json("stability", "S01", "S40", "S50")["cases"]
        self.assertEqual((camera["fixed"], camera["fixed_refuses"]), (0, ""))
        self.assertEqual((sun["fixed"], sun["fixed_refuses"]), (None, "position"))
        self.assertEqual(glass["fixed_refuses"], "refractive_index")
        self.assertGreater(glass["fixed"], 0)  # the other ball of the row is judged

    def test_text_has_a_line_a_case_and_the_sum(self):
        lines = self.succeed("stability", "S01", "S02").decode().splitlines()
        self.assertEqual([line[:3] for line in lines[2:4]], ["S01", "S02"])
        self.assertEqual(lines[-1], "2 of 2 laws hold")

    def test_the_table_of_the_readme_is_the_markdown_but_for_the_measured_figures(self):
        def texts(lines):
            return [line.split(" | ")[:4] for line in lines if line.startswith("| S")]

        with open(README, encoding="utf-8") as file:
            self.assertEqual(texts(file), texts(self.succeed("stability", "--markdown").decode().splitlines()))

    def test_a_case_that_is_none_is_refused_with_a_suggestion(self):
        self.expect_failure(2, "stability", "S71", says=["'S71' is not one of: S01"])
        self.expect_failure(2, "stability", "--json", "--markdown", says=["--markdown"])


if __name__ == "__main__":
    unittest.main()
