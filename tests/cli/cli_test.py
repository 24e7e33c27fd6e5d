#!/usr/bin/env -S /usr/bin/python3
"""What the command line promises: exit codes, streams, whole files. usage: cli_test.py HAZUMI"""

import csv
import json
import os
import re
import stat
import subprocess
import time
import unittest

from command_line import HAZUMI, JUMP, THROW, InFolder, run
from png_pixels import rows_of


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
                (["--bake", "-", "--json", THROW], "--json belongs to --check, --info and --flight"),
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
                (["--json", THROW], "--json belongs to --check, --info and --flight, not to the editor"),
                (["--export", "x.fbx", THROW],
                 "the name must end in .bvh, .gltf, .glb, .csv, .json or .mp4"),
                (["--export", "x.glb", "--bvh-up", "z", THROW],
                 "--bvh-up belongs to --export to .bvh, not to --export to x.glb"),
                (["--info"], "no FILE"),
                (["--info", THROW, JUMP], "only --check takes several")):
            done = run(*wrong, cwd=self.folder)
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn(message, done.stderr.splitlines()[0])

    def test_one_frame_is_drawn_into_the_picture_that_is_named(self):
        picture = self.folder / "new" / "one.png"
        small = ["--size", "32x24", "--samples", "1"]
        done = run("--render", picture, "--frames", "3", *small, THROW)
        self.assertEqual((done.returncode, self.files()), (0, ["one.png"]), done.stderr)
        self.assertEqual(run("--render", self.folder / "all", "--frames", "3", *small, THROW).returncode, 0)
        self.assertEqual(picture.read_bytes(), (self.folder / "all" / "frame_0003.png").read_bytes())
        for frames in ([], ["--frames", "3..4"]):
            done = run("--render", self.folder / "two.png", *frames, *small, THROW)
            self.assertEqual(done.returncode, 2)
            self.assertIn("one picture is a .png with --frames N", done.stderr)

    def test_the_script_of_the_help_runs(self):
        lines = run("--help").stdout.splitlines()
        begin = next(i for i, line in enumerate(lines) if line.lstrip().startswith("[{"))
        end = next(i for i in range(begin, len(lines)) if lines[i].endswith("}]"))
        script = self.folder / "script.json"
        script.write_text(" ".join(line.strip() for line in lines[begin:end + 1]))
        done = run("--run", script, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.files(), ["my.kfa", "script.json"])
        # Nobody gave it a name, so it is called as its file is.
        self.assertEqual(run("--info", self.folder / "my.kfa").stdout.splitlines()[0], "my")
        info = json.loads(run("--info", "--json", self.folder / "my.kfa").stdout)
        self.assertEqual(info["name"], "my")
        self.assertEqual(json.loads((self.folder / "my.kfa").read_text())["name"], "Untitled")

    def test_help_fits_a_terminal_and_names_every_option(self):
        lines = run("--help").stdout.splitlines()
        self.assertLessEqual(max(map(len, lines)), 80)
        for option in ("render", "bake", "export", "bvh-up", "bvh-unit",
                       "check", "info", "flight", "run", "operators", "frames", "size", "samples",
                       "camera", "threads", "body", "ghosts", "paths", "marks", "tint", "frame-number",
                       "no-shadow", "method", "tolerance", "step", "fps", "timings", "torques", "effort", "json", "trace"):
            self.assertTrue(any(line.startswith(f"  --{option}") for line in lines), option)

    def test_method_and_step_go_before_what_the_file_says(self):
        project = self.project()
        project["solver"] = {"method": "exact", "tolerance_deg": 0.5, "version": 1}
        for region in project["regions"]:
            region.update(method="exact", step_s=0.5)
        exact = self.folder / "exact.kfa"
        exact.write_text(json.dumps(project))
        done = run("--info", "--json", "--method", "paper", "--step", "0.01", exact)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        info = json.loads(done.stdout)
        self.assertEqual(info["solver"], {"method": "paper", "step_s": 0.01, "version": 1})
        self.assertEqual({(r["method"], r["step_s"]) for r in info["regions"]}, {("paper", 0.01)})

    def test_a_number_that_no_method_heeds_is_warned_about(self):
        step, tolerance = ["--step", "0.02"], ["--tolerance", "0.1"]
        for method, vain, other, heeded in (("paper", tolerance, "--step", step),
                                            ("exact", step, "--tolerance", tolerance)):
            done = run("--check", "--method", method, *vain, THROW)
            self.assertEqual((done.returncode, done.stdout), (0, f"{THROW}: ok\n"))
            self.assertIn(f"{vain[0]}: warning: has no effect: everything is solved by method "
                          f"{method}; use {other}", done.stderr)
            self.assertNotIn("no effect",
                             run("--check", "--method", method, *heeded, THROW).stderr)

    def test_the_root_in_a_region_needs_method_exact(self):
        project = self.project()
        project["regions"][0]["joints"].append("pelvis")
        swung = self.folder / "swung.kfa"
        swung.write_text(json.dumps(project))
        done = run("--check", "--method", "paper", swung)
        self.assertEqual(done.returncode, 65)
        self.assertIn('regions[0].joints[2]: "pelvis" is the root, which method "paper"',
                      done.stderr)

    def test_frames_partly_outside_are_clipped_with_a_warning(self):
        done = run("--render", self.folder / "a", "--size", "64x48", "--frames", "29..50", THROW)
        self.assertEqual(done.returncode, 0)
        self.assertIn("has frames 0..30; drawing 29..30", done.stderr)
        self.assertEqual(self.files(), ["frame_0029.png", "frame_0030.png"])

    def test_more_than_a_million_output_frames_are_refused(self):
        project = self.project()
        project["frames"]["last"] = 5000
        long = self.folder / "long.kfa"
        long.write_text(json.dumps(project))
        done = run("--bake", "-", "--fps", "10000", long)
        self.assertEqual((done.returncode, done.stdout), (65, ""))
        self.assertIn("output frames", done.stderr)

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

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full here")
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

    def test_bake_writes_json_or_csv_by_suffix(self):
        self.assertEqual(run("--bake", self.folder / "m.json", THROW).returncode, 0)
        self.assertEqual(run("--bake", self.folder / "m.csv", THROW).returncode, 0)
        motion = json.loads((self.folder / "m.json").read_text())
        rows = (self.folder / "m.csv").read_text().splitlines()
        self.assertEqual(len(motion["frames"]), 31)
        self.assertEqual(len(rows), 32)
        self.assertEqual(len(rows[0].split(",")), len(rows[1].split(",")))
        self.assertEqual(run("--bake", "-", THROW).stdout, (self.folder / "m.json").read_text())
        self.assertTrue(stat.S_IMODE((self.folder / "m.json").stat().st_mode) & 0o400)

    def test_torques_are_the_same_in_json_and_csv(self):
        for name in ("m.json", "m.csv"):
            done = run("--bake", self.folder / name, "--torques", THROW)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        motion = json.loads((self.folder / "m.json").read_text())
        rows = list(csv.DictReader((self.folder / "m.csv").read_text().splitlines()))
        self.assertEqual(len(rows), len(motion["frames"]))
        for row, frame in zip(rows, motion["frames"]):
            torques = [float(row[f"{joint}_n_m"]) for joint in motion["joints"]]
            self.assertEqual(torques, frame["torques_n_m"])
            self.assertEqual(float(row["unsupported_z_n"]), frame["unsupported"]["force_n"][2])
        self.assertNotIn("torques_n_m", run("--bake", "-", THROW).stdout)

    def test_effort_is_the_same_in_json_and_csv_and_the_largest_is_told(self):
        for name in ("m.json", "m.csv"):
            done = run("--bake", self.folder / name, "--effort", JUMP)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        motion = json.loads((self.folder / "m.json").read_text())
        self.assertEqual(motion["effort"], {"filtered_hz": None, "friction": 0.8})
        rows = list(csv.DictReader((self.folder / "m.csv").read_text().splitlines()))
        largest = 0.0
        for row, frame in zip(rows, motion["frames"]):
            effort = frame["effort"]
            for i, joint in enumerate(motion["joints"]):
                self.assertEqual(float(row[f"{joint}_effort_n_m"]), effort["torques_n_m"][i])
                share = row[f"{joint}_effort"]
                self.assertEqual(float(share) if share else None, effort["share"][i])
                largest = max(largest, abs(effort["torques_n_m"][i]))
            self.assertEqual(float(row["from_nowhere_z_n"]), effort["from_nowhere"]["force_n"][2])
        self.assertTrue(any(contact["pin"] for contact in motion["frames"][2]["effort"]["contacts"]))
        info = run("--info", "--effort", JUMP).stdout
        told = re.search(r"effort +largest torque: \S+ (-?\d+) N m at F\d+, \d+ % of its strength", info)
        self.assertAlmostEqual(abs(float(told.group(1))), largest, delta=1.0)
        self.assertNotIn("effort", run("--info", JUMP).stdout)
        self.assertNotIn("effort", run("--bake", "-", JUMP).stdout)

    def test_seams_are_told_where_regions_begin_and_end(self):
        project = self.project()
        motion = json.loads(run("--bake", "-", THROW).stdout)
        borders = {(seam["frame"], seam["of"], seam["begins"]) for seam in motion["seams"]}
        self.assertIn((5, "region", True), borders)
        self.assertIn((15, "region", False), borders)
        roots = [seam for seam in motion["seams"] if seam["joint"] is None]
        self.assertTrue(all("velocity_m_s" in seam for seam in roots))
        name = "r_elbow_flexion"
        keys = project["joints"][name]["keys"]
        at_border = next(key for key in keys if key["frame"] == project["regions"][0]["first_frame"])
        at_border["rate_in_deg_s"] = at_border.get("rate_deg_s", 0.0) - 100.0
        at_border.setdefault("rate_deg_s", 0.0)
        file = self.folder / "seam.kfa"
        file.write_text(json.dumps(project))
        info = json.loads(run("--info", "--json", file).stdout)
        seam = next(seam for seam in info["seams"]
                    if seam["joint"] == name and seam["frame"] == at_border["frame"])
        self.assertAlmostEqual(seam["rate_deg_s"], 100.0, places=9)
        self.assertIn("states a rate", seam["mend"])
        line = next(line for line in run("--info", file).stdout.splitlines()
                    if line.startswith("seam"))
        self.assertIn(f"F{at_border['frame']} {name}", line)
        self.assertIn("rate by 100 deg/s", line)

    def test_a_script_edits_a_project(self):
        script = self.folder / "script.json"
        out = self.folder / "out.kfa"
        script.write_text(json.dumps([
            {"op": "key.set", "curve": "r_knee", "frame": 5, "value": 40},
            {"op": "file.save", "path": str(out)}]))
        done = run("--run", script)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        keys = json.loads(out.read_text())["joints"]["r_knee"]["keys"]
        self.assertEqual(keys, [{"frame": 5, "angle_deg": 40}])
        script.write_text('[{"op": "key.delete", "curve": "r_knee", "frame": 5}]')
        done = run("--run", script, out)
        self.assertEqual(done.returncode, 0)
        self.assertIn("changed but not saved", done.stderr)
        script.write_text('[{"op": "key.delete", "curve": "r_knee", "frame": 6}]')
        done = run("--run", script, out)
        self.assertEqual(done.returncode, 65)
        self.assertIn("[0]: key.delete.frame: \"r_knee\" has no key on frame 6", done.stderr)

    def test_a_script_draws_the_editor_without_a_display(self):
        picture = self.folder / "editor.png"
        steps = [{"op": "view.theme", "dark": False}, {"op": "capture", "path": str(picture)}]
        script = self.folder / "script.json"
        script.write_text(json.dumps(steps))
        done = run("--run", script, "--size", "320x200", THROW)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        header = picture.read_bytes()[:24]
        self.assertEqual((header[:4], header[16:24]),
                         (b"\x89PNG", (320).to_bytes(4, "big") + (200).to_bytes(4, "big")))
        script.write_text(json.dumps([{"op": "capture", "path": str(self.folder / "no" / "e.png")}]))
        self.assertEqual(run("--run", script, THROW).returncode, 73)

    def test_tools_of_the_mouse_need_no_window(self):
        script = self.folder / "script.json"
        for tool in ("sheet.box", "sheet.preview", "sheet.mark_region", "sheet.move", "sheet.scale",
                     "sheet.duplicate", "tool.move", "tool.rotate"):
            script.write_text(json.dumps(
                [{"op": "keys.select_all"}, {"op": "select.joints", "joints": ["r_knee"]},
                 {"op": tool}, {"op": "app.search"}, {"op": tool}, {"op": "sheet.box"}]))
            self.assertEqual(run("--run", script, THROW).returncode, 0, tool)

    def test_the_window_says_where_there_is_no_display(self):
        bare = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = run(THROW, env=bare)
        self.assertEqual(done.returncode, 1)
        self.assertIn("there is no display", done.stderr)
        self.assertIn("--run", done.stderr)

    def test_the_operators_are_listed_with_their_parameters(self):
        lines = run("--operators").stdout.splitlines()
        self.assertIn("region.split: Makes two regions of one.", lines)
        self.assertIn("    region: a text, names a region: the region's name", lines)

    def test_another_frame_rate_is_the_same_motion(self):
        at_30 = json.loads(run("--bake", "-", JUMP).stdout)
        at_60 = json.loads(run("--bake", "-", "--fps", "60", JUMP).stdout)
        self.assertEqual(len(at_60["frames"]), 61)
        for i, frame in enumerate(at_30["frames"]):
            self.assertEqual(frame["angles_deg"], at_60["frames"][2 * i]["angles_deg"])
            self.assertEqual(frame["root"], at_60["frames"][2 * i]["root"])

    def test_render_writes_the_frames_asked_for(self):
        small = ["--size", "64x48"]
        self.assertEqual(run("--render", self.folder / "a", *small, "--frames", "3..5",
                             THROW).returncode, 0)
        self.assertEqual(run("--render", self.folder / "b_##.png", *small, "--frames", "7",
                             THROW).returncode, 0)
        self.assertEqual(self.files(), ["b_07.png", "frame_0003.png", "frame_0004.png",
                                        "frame_0005.png"])

    def test_each_picture_shows_its_own_frame_whatever_the_range_and_without_a_display(self):
        """Of a range, alone, and again: the same bytes. Two frames: other ones."""
        bare = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        pictures = {}
        for frames in ("3..5", "4..4", "5..7"):
            folder = self.folder / frames
            done = run("--render", folder, "--size", "64x48", "--frames", frames, THROW, env=bare)
            self.assertEqual(done.returncode, 0, done.stderr)
            for path in folder.iterdir():
                seen = pictures.setdefault(path.name, path.read_bytes())
                self.assertEqual(seen, path.read_bytes(), path)
        self.assertEqual(sorted(pictures), [f"frame_{i:04}.png" for i in range(3, 8)])
        self.assertEqual(len(set(pictures.values())), 5)

    def test_equal_input_gives_equal_pictures_with_any_number_of_threads(self):
        for threads in ("1", "16"):
            run("--render", self.folder / threads, "--size", "160x90", "--frames", "4..8",
                "--threads", threads, "--paths", "--marks", "--tint", "--ghosts", "10", THROW)
        for name in (f"frame_{i:04}.png" for i in range(4, 9)):
            self.assertEqual((self.folder / "1" / name).read_bytes(),
                             (self.folder / "16" / name).read_bytes())

    def test_the_body_is_its_skin_unless_the_capsules_are_asked_for(self):
        pictures = {}
        for body in ((), ("--body", "skin"), ("--body", "capsules"), ("--body", "both")):
            folder = self.folder / "-".join(("body", *body))
            run("--render", folder, "--size", "160x90", "--frames", "4", *body, THROW)
            # Files differ in the options that they note.
            pictures[body[-1:]] = tuple(rows_of(folder / "frame_0004.png"))
        self.assertEqual(pictures[()], pictures[("skin",)])
        self.assertEqual(len(set(pictures.values())), 3)

    def test_flight_finds_the_jump_at_the_frames_that_its_bake_states(self):
        done = run("--flight", "--json", "--fps", "120", JUMP)
        self.assertEqual(done.returncode, 0)
        report = json.loads(done.stdout)
        (flight,) = report["flights"]
        info = json.loads(run("--info", "--json", "--fps", "120", JUMP).stdout)
        at = {event["kind"]: 120.0 * event["time_s"] for event in info["events"]}
        for name in ("take_off", "apex", "landing"):
            self.assertLess(abs(flight[name] - at[name]), 2.0, name)
        self.assertLess(abs(flight["gravity_m_s2"] / 9.81 - 1.0), 0.01)
        self.assertEqual(report["time"]["verdict"], "true")

    def test_flight_says_in_words_where_and_that_time_is_right(self):
        done = run("--flight", "--fps", "120", JUMP)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"(?m)^flight     F\d+\.\d to F\d+\.\d, apex F\d+\.\d$")
        self.assertIn("the clip plays at its natural speed", done.stdout)
        self.assertIn("flight     none", run("--flight", THROW).stdout)

    def test_a_script_saves_nothing_that_check_refuses(self):
        project = self.project()
        project.update(regions=[], placements=[], holds=[])
        start_of_it = self.folder / "start.kfa"
        start_of_it.write_text(json.dumps(project))
        out = self.folder / "out.kfa"
        script = self.folder / "script.json"
        save = {"op": "file.save", "path": str(out)}
        away = {"op": "key.set", "curve": "root.z", "frame": 30, "value": 9}
        for steps, refused in (
                ([{"op": "hold.add", "joint": "r_toe", "first": 0, "last": 30}, away], True),
                ([away], False)):
            script.write_text(json.dumps([*steps, save]))
            done = run("--run", script, start_of_it)
            if not refused:
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(run("--check", out).returncode, 0)
                continue
            self.assertEqual(done.returncode, 65, done.stderr)
            self.assertIn("out of reach", done.stderr)
            self.assertIn("so it is not saved", done.stderr)
            self.assertFalse(out.exists())

    def test_every_broken_json_is_bad_data_with_a_place(self):
        for path in self.data_files("json", "*.json"):
            start = time.monotonic()
            done = run("--check", path)
            self.assertLess(time.monotonic() - start, 10.0, path.name)
            self.assertEqual((done.returncode, done.stdout), (65, ""), path.name)
            self.assertTrue(done.stderr.startswith(f"hazumi: {path}: "), done.stderr)
            if path.name.startswith("n_"):
                self.assertRegex(done.stderr, r"line \d+, column \d+", path.name)


if __name__ == "__main__":
    unittest.main()
