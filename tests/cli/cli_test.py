#!/usr/bin/env -S /usr/bin/python3
"""What the command line promises: exit codes, streams, whole files. usage: cli_test.py HAZUMI"""

import json
import os
import subprocess
import unittest

from command_line import HAZUMI, JUMP, ROOT, THROW, InFolder, main, run


class CommandLine(InFolder):
    def test_help_and_version_go_to_standard_output(self):
        for option in ("--help", "--version"):
            done = run(option)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("azumi", done.stdout)

    def test_wrong_usage_exits_with_2_and_prints_no_result(self):
        for wrong in ([THROW, JUMP], ["--bogus"], ["--render"], ["--check"], ["--bake", "x.json"],
                      ["--bake", "x.txt", THROW], ["--bake", "-", THROW, JUMP],
                      ["--render", "o", "--bake", "-", THROW],
                      ["--bake", "-", "--step", "0", THROW],
                      ["--bake", "-", "--fps", "zero", THROW],
                      ["--bake", "-", "--method", "magic", THROW],
                      ["--bake", "-", "--tolerance", "0", THROW],
                      ["--bake", "-", "--tolerance", "6", THROW],
                      ["--bake", "-", "--tolerance", "nan", THROW],
                      ["--render", "o", "--frames", "9..3", THROW],
                      ["--render", "o", "--frames", "0..99999999999", THROW],
                      ["--render", "o", "--frames", "3..", THROW],
                      ["--render", "o", "--frames", "40..50", THROW],
                      ["--render", "o", "--size", "0x9", THROW],
                      ["--render", "o", "--size", "64x48x", THROW],
                      ["--render", "o", "--samples", "2", THROW],
                      ["--render", "o", "--threads", "0", THROW],
                      ["--render", "o", "--camera", "1,2,3,4,5,6,nan", THROW],
                      ["--render", "o", "--camera", "1,2,3,4,5,6,30,8", THROW],
                      ["--render", "", THROW], ["--render", "o/pic.png", THROW],
                      ["--render", "o/pic.JPG", THROW], ["--check", "--json=no", THROW],
                      ["--bake", "-", "--step", "2", THROW], ["--bake", "-", "--step", "1x", THROW],
                      ["--bake", "-", "--fps", "0.05", THROW],
                      ["--bake", "-", "--fps", "20000", THROW],
                      ["--bake", "-", "--fps", "1/20", THROW],
                      ["--bake", "-", "--fps", "30/0", THROW],
                      ["--bake", "-", "--fps", "99999999999/1", THROW],
                      ["--bake", "-", "--fps", "30", "--fps", "60", THROW],
                      ["--export", "x.fbx", THROW], ["--export", "", THROW], ["--export", "x.glb"],
                      ["--export", "x.glb", "--bvh-unit", "m", THROW],
                      ["--export", "x.bvh", "--bvh-up", "x", THROW],
                      ["--export", "x.bvh", "--size", "64x48", THROW],
                      ["--export", "x.mp4", "--frames", "40..50", THROW],
                      ["--render", "o", "--body", "fur", THROW],
                      ["--render", "o", "--camera", "sideways", THROW]):
            done = run(*wrong, cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (2, ""), wrong)
            self.assertTrue(done.stderr.startswith("hazumi: "), (wrong, done.stderr))
            self.assertTrue(done.stderr.endswith("\nsee hazumi --help\n"), (wrong, done.stderr))
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_wrong_usage_says_what_to_do(self):
        for wrong, message in (
                (["--chekc", THROW], "unknown option --chekc; did you mean --check?"),
                (["--check", "--frmaes=3", THROW],
                 "unknown option --frmaes; did you mean --frames?"),
                (["--check", "-x", THROW], "unknown option -x"),
                (["--render", "out/pic.png", THROW], "put #### where the frame number goes"),
                (["--render", "o", "--frames", "40..50", THROW], "has frames 0..30"),
                (["--bake", "-", "--ghosts", "3", THROW], "--ghosts belongs to --render"),
                (["--bake", "-", "--json", THROW], "--json belongs to --check, --info, --flight and --run"),
                (["--render", "o", "--timings", THROW], "--timings belongs to --bake"),
                (["--export", "o.bvh", "--torques", THROW], "--torques belongs to --bake"),
                (["--check", "--method", "magic", THROW],
                 "--method magic: the methods are: exact, paper"),
                (["--check", "--tolerance", "9", THROW],
                 "--tolerance 9: give degrees from 1e-10 to 5"),
                (["--check", "--info", THROW], "--check and --info: one task at a time"),
                (["--check", "--json=no", THROW], "--json takes no value"),
                (["--bake", "-", THROW, "--fps"], "--fps wants a value"),
                (["--bake", "-", "--fps", "30", "--fps", "60", THROW], "--fps is given twice"),
                (["--json", THROW], "--json belongs to --check, --info, --flight and --run, not to the editor"),
                (["--export", "x.fbx", THROW],
                 "the name must end in .bvh, .gltf, .glb, .csv, .json or .mp4"),
                (["--export", "x.glb", "--bvh-up", "z", THROW],
                 "--bvh-up belongs to --export to .bvh, not to --export to x.glb"),
                (["--info"], "no FILE"),
                (["--info", THROW, JUMP], "only --check takes several")):
            done = run(*wrong, cwd=self.folder)
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn(message, done.stderr.splitlines()[0])

    def test_help_fits_a_terminal_and_names_every_option(self):
        lines = run("--help").stdout.splitlines()
        self.assertLessEqual(max(map(len, lines)), 80)
        for option in ("render", "bake", "export", "bvh-up", "bvh-unit",
                       "check", "info", "flight", "run", "operators", "frames", "size", "samples",
                       "camera", "threads", "body", "ghosts", "paths", "marks", "tint", "frame-number",
                       "no-shadow", "method", "tolerance", "step", "fps", "timings", "torques", "effort", "json", "trace"):
            self.assertTrue(any(line.startswith(f"  --{option}") for line in lines), option)

    def test_a_name_cannot_steer_the_terminal(self):
        project = self.project()
        project["name"] = "red \x1b[31m\x9b"
        red = self.folder / "red\x1b[31m.kfa"
        red.write_text(json.dumps(project))
        for done in (run("--info", red), run("--check", red),
                     run("--check", self.folder / "no\x1b.kfa")):
            self.assertNotRegex(done.stdout + done.stderr, "[\x00-\x09\x0b-\x1f\x7f-\x9f]")
            self.assertIn("\\x1b", done.stdout + done.stderr)
        run("--render", self.folder, "--size", "64x48", "--frames", "0", red)
        data = (self.folder / "frame_0000.png").read_bytes()
        self.assertIn(b"red [31m", data)

    def test_a_missing_file_exits_with_66_and_names_it(self):
        for task in (["--check"], ["--info"], ["--bake", "-"], ["--render", self.folder / "o"]):
            done = run(*task, "nowhere.kfa")
            self.assertEqual(done.returncode, 66, task)
            self.assertIn("nowhere.kfa", done.stderr)

    def test_bad_data_exits_with_65_and_names_the_place(self):
        project = self.project()
        project["regions"][0]["joints"].append("r_wirst")
        bad = self.folder / "bad.kfa"
        bad.write_text(json.dumps(project))
        done = run("--bake", "-", bad)
        self.assertEqual((done.returncode, done.stdout), (65, ""))
        self.assertIn('regions[0].joints[2]: no joint "r_wirst"; did you mean "r_wrist"?',
                      done.stderr)

    def test_check_and_info_report_the_same_problems(self):
        info = json.loads(run("--info", "--json", THROW).stdout)["problems"]
        self.assertIn("Frame 28: ball goes into floor.", info)
        self.assertEqual(json.loads(run("--check", "--json", THROW).stdout)["problems"], info)
        told = run("--check", THROW)
        self.assertEqual(told.stdout, f"{THROW}: ok\n")
        self.assertEqual(told.stderr,
                         "".join(f"hazumi: {THROW}: problem: {text}\n" for text in info))

    def test_strict_check_names_every_unknown_field(self):
        project = self.project()
        project["regions"][0]["frction"] = project["regions"][0]["friction"]
        project["solver"]["magic"] = 1
        project["x_note"] = "a remark"
        figure = json.loads((ROOT / "assets/figures/human.json").read_text())
        figure["joints"][0]["colour"] = "red"
        sweep = {"format": "hazumi-sweep", "version": 1, "project": "p.kfa", "sed": 2,
                 "vary": [{"field": "solver.tolerance_deg", "values": [0.01]}]}
        files = {"p.kfa": (project, ["regions[0].frction: unknown field; the nearest known one is "
                                     "\"friction\"", "solver.magic: unknown field"]),
                 "figure.json": (figure, ["joints[0].colour: unknown field"]),
                 "sweep.json": (sweep, ["sed: unknown field; the nearest known one is \"seed\""])}
        for name, (content, expected) in files.items():
            path = self.folder / name
            path.write_text(json.dumps(content))
            done = run("--check", "--strict", path)
            self.assertEqual((done.returncode, done.stdout), (65, ""), name)
            errors = [line for line in done.stderr.splitlines()
                      if "warning:" not in line and "problem:" not in line]
            self.assertEqual(len(errors), len(expected), done.stderr)
            for wanted in expected:
                self.assertIn(wanted, done.stderr)
        answer = json.loads(run("--check", "--strict", "--json", self.folder / "p.kfa").stdout)
        self.assertFalse(answer["ok"])
        self.assertEqual(len(answer["unknown"]), 2)
        self.assertEqual(run("--check", self.folder / "p.kfa").returncode, 0)
        self.assertEqual(run("--check", "--strict", THROW, JUMP,
                             ROOT / "assets/figures/human.json").returncode, 0)

    def test_check_answers_for_every_file(self):
        bad = self.folder / "bad.kfa"
        bad.write_text("{")
        done = run("--check", THROW, bad, JUMP)
        self.assertEqual(done.returncode, 65)
        self.assertEqual(done.stdout.count(": ok"), 2)
        lines = [json.loads(line) for line in run("--check", "--json", THROW, bad)
                 .stdout.splitlines()]
        self.assertEqual([line["ok"] for line in lines], [True, False])

    def test_output_that_cannot_be_written_exits_with_73_and_leaves_nothing(self):
        blocked = self.folder / "blocked"
        blocked.write_text("a file where a folder is wanted")
        for task in (["--bake", blocked / "x.json"], ["--render", blocked / "frames"]):
            self.assertEqual(run(*task, THROW).returncode, 73, task)
        self.assertEqual(self.files(), ["blocked"])

    @unittest.skipUnless(os.path.exists("/dev/full"), "not here: no /dev/full")
    def test_a_full_or_closed_standard_output_exits_with_73_whatever_the_task(self):
        for task in (["--bake", "-", THROW], ["--check", THROW], ["--check", "--json", THROW, JUMP],
                     ["--info", THROW], ["--info", "--json", THROW], ["--flight", JUMP],
                     ["--flight", "--json", JUMP], ["--operators"], ["--schema"], ["--help"], ["--version"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([HAZUMI, *map(str, task)], stdout=full, text=True,
                                      stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(done.returncode, 73, task)
            self.assertIn("standard output: could not be written", done.stderr)
            command = " ".join(f"'{word}'" for word in [HAZUMI, *map(str, task)])
            done = subprocess.run(["sh", "-c", f"{command} >&-"], timeout=60, text=True,
                                  stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 73, task)
            self.assertIn("standard output: could not be written", done.stderr)

    def test_an_error_goes_before_a_full_standard_output(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([HAZUMI, "--check", THROW, "nowhere.kfa"], stdout=full,
                                  stderr=subprocess.DEVNULL, timeout=60)
        self.assertEqual(done.returncode, 66)

    def test_the_window_says_where_there_is_no_display(self):
        bare = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = run(THROW, env=bare)
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no display", done.stderr)
        self.assertIn("--run", done.stderr)

    def test_every_broken_json_is_bad_data_with_a_place(self):
        for path in self.data_files("json", "*.json"):
            done = run("--check", path)
            self.assertEqual((done.returncode, done.stdout), (65, ""), path.name)
            self.assertTrue(done.stderr.startswith(f"hazumi: {path}: "), done.stderr)
            if path.name.startswith("n_"):
                self.assertRegex(done.stderr, r"line \d+, column \d+", path.name)


if __name__ == "__main__":
    main()
