"""A wrong command line gives one clear line and exit code 2."""
import unittest

from program import CommandLineTest, SCENE


class Usage(CommandLineTest):
    def refuse(self, *arguments, says):
        self.expect_failure(2, *arguments, says=says)

    def refuse_render(self, *arguments, says):
        self.refuse("render", self.scene, "-o", self.path("a.png"), *arguments, says=says)
        self.assertEqual(self.names(), ["scene.toml"])

    def test_help_is_on_standard_output_everywhere(self):
        self.assertIn(b"Exit codes: 0 ok, 1", self.succeed("--help"))
        for command in ("render", "compare", "show", "doctor", "strip", "bench"):
            self.assertIn(command.encode(), self.succeed("--help"))
            text = self.succeed(command, "--help")
            self.assertTrue(text.splitlines()[1].startswith(f"Usage: zerkalo {command}".encode()), text)
            self.assertEqual(text, self.succeed(command, "-h"))

    def test_version_is_one_line(self):
        self.assertRegex(self.succeed("--version"), rb"\Azerkalo \d+\.\d+\.\d+\n\Z")

    def test_no_command_is_refused(self):
        self.refuse(says=["no command given", "zerkalo --help"])

    def test_an_unknown_command_is_refused_with_the_nearest_one(self):
        self.refuse("rendr", self.scene, says=["unknown command 'rendr'", "did you mean \"render\"?"])
        self.refuse("qqqqqq", says=["unknown command 'qqqqqq'; see"])

    def test_an_unknown_option_is_refused_with_the_nearest_one(self):
        self.refuse_render("--sampels", "4", says=["unknown option '--sampels'", "did you mean \"--samples\"?"])
        self.refuse_render("--sise=4x4", says=["unknown option '--sise'", "did you mean \"--size\"?"])
        self.refuse("render", self.scene, "--outptu", "a.png", says=["'--outptu'", "did you mean \"--output\"?"])
        self.refuse("compare", "a", "b", "--tolerence", "1", says=["did you mean \"--tolerance\"?"])

    def test_an_estimator_that_the_lobe_does_not_have_is_refused(self):
        self.refuse_render("--estimator", "monte-carlo", says=["--estimator", "is not one of", "random", "fibonacci"])
        rough = self.file("scene.toml", SCENE + 'lobe = "ggx"\n')
        self.refuse("render", rough, "-o", self.path("a.png"), "--estimator", "fibonacci+coverage",
                    says=["estimator", "must not be fibonacci+coverage where a mirror's lobe is ggx"])
        self.assertEqual(self.names(), ["scene.toml"])

    def test_a_surplus_argument_is_refused(self):
        self.refuse_render("second.toml", says=["unexpected argument 'second.toml'"])

    def test_missing_arguments_are_named(self):
        self.refuse("render", "-o", "a.png", says=["SCENE is required"])
        self.refuse("render", self.scene, says=["--output is required"])
        self.refuse("compare", "a.png", says=["B is required"])
        self.refuse_render("--samples", says=["--samples: takes exactly one value"])
        self.refuse_render("--size=", says=["--size: takes exactly one value"])
        self.refuse_render("--size", "1x1", "--size", "2x2", says=["--size: takes exactly one value"])

    def test_a_wrong_size_says_what_would_be_right(self):
        for size in ("0x0", "0x10", "-4x4", "64", "64x", "x64", "64x48x3", "64X48", "1e2x5", "nanxnan", " 4x4", "4x4 ",
                     "65537x1", "20000x20000", "99999999999999999999x1"):
            self.refuse_render(f"--size={size}", says=[f"'{size}' is not WIDTHxHEIGHT", "640x480"])

    def test_a_wrong_number_says_its_range(self):
        for option, low, high in (("--samples", 1, 1048576), ("--antialias", 1, 4096), ("--depth-limit", 0, 255),
                                  ("--threads", 1, 1024), ("--repeat", 1, 1000000)):
            for value in (str(low - 1), str(high + 1), "nan", "inf", "1.5", "1,5", "0x10", "four", "+4",
                          "99999999999999999999"):
                self.refuse_render(f"{option}={value}", says=[
                    option, f"'{value}' is not a whole number from {low} to {high}"])

    def test_camera_rays_are_a_number_or_auto(self):
        for value in ("Auto", "auto:16", "automatic", "0", "-1"):
            self.refuse_render(f"--antialias={value}",
                               says=[f"'{value}' is not a whole number from 1 to 4096, or auto"])

    def test_a_wrong_choice_lists_what_is_allowed(self):
        self.refuse_render("--isa", "avx3", says=["'avx3'", "scalar, sse2, sse4.2, avx2, avx512, neon"])
        self.refuse_render("--number", "half", says=["'half'", "float, fixed, double"])
        self.refuse_render("--estimator", "halton", says=["'halton'", "fibonacci"])
        self.refuse_render("--depth", "12", says=["'12'", "8, 16"])
        self.refuse("show", self.scene, "--display", "window", says=["'window'", "fb, fb:/dev/fbN, terminal, png:FILE"])

    def test_the_values_that_exist_are_accepted(self):
        self.succeed("render", self.scene, "-o", self.path("a.png"), "--number", "fixed")
        self.succeed("render", self.scene, "-o", self.path("a.png"), "--number", "double")
        self.succeed("render", self.scene, "-o", self.path("a.png"), "--number", "float", "--estimator", "fibonacci",
                     "--depth", "8", "--isa", "scalar")

    def test_an_output_without_a_known_extension_is_refused(self):
        for name in ("a.jpg", "a", "png", ".png", "a.png.gz"):
            self.refuse("render", self.scene, "-o", name, says=[f"-o {name}: ", ".png or .pfm"])

    def test_a_pfm_has_no_depth(self):
        self.refuse("render", self.scene, "-o", self.path("a.pfm"), "--depth", "16", says=["--depth 16", "PFM"])

    def test_json_and_a_picture_do_not_share_standard_output(self):
        self.refuse("render", self.scene, "-o", "-", "--json", says=["--json and '-o -'"])

    def test_a_picture_is_not_poured_into_a_terminal(self):
        session = self.terminal("render", self.scene, "-o", "-")
        self.assertEqual(session.exit_code(), 2)
        self.assertIn(b"standard output is a terminal", session.output)

    def test_a_wrong_command_line_is_noticed_before_the_scene(self):
        scene = self.file("bad.toml", SCENE + "nonsense")
        self.expect_failure(2, "render", scene, "-o", "a.jpg")


if __name__ == "__main__":
    unittest.main()
