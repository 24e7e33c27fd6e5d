#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --sweep makes, however it is shared out or broken off, and what it refuses.
usage: sweep_test.py HAZUMI"""

import csv
import json
import os
import shutil
import subprocess
import time
import unittest

from command_line import THROW, InFolder, run, start
from png_pixels import rows_of

HAS_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")
CAMERA = ["--camera", "2.5,-3,1.4,0,0,0.9,35"]
SIZE = ["--size", "48x36"]


class InSweep(InFolder):
    def setUp(self):
        super().setUp()
        self.sweep_file = self.folder / "sweep.json"
        self.out = self.folder / "out"
        self.write_project(self.project())

    def write_project(self, project):
        (self.folder / "throw.kfa").write_text(json.dumps(project))

    def write(self, vary, **more):
        sweep = {"format": "hazumi-sweep", "version": 1, "project": "throw.kfa", "vary": vary, **more}
        self.sweep_file.write_text(json.dumps(sweep))

    def sweep(self, *more, out=None, code=0):
        done = run("--sweep", self.sweep_file, "--out", out or self.out, *more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self, out=None):
        with ((out or self.out) / "sweep.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def contents(self, out=None):
        """Every file of a sweep's folder."""
        out = out or self.out
        return {str(p.relative_to(out)): p.read_bytes() for p in sorted(out.rglob("*"))
                if p.is_file()}

    def left_behind(self):
        return [name for name in self.files() if name.endswith(".tmp")]


GRAVITY = {"field": "scene.gravity_m_s2", "values": [9.81, 3.7]}
RELEASE = {"field": "held_objects[ball].release_frame", "values": [10, 11, 12]}


class Table(InSweep):
    def baked(self, change):
        """The motion of the throw with a change."""
        project = self.project()
        change(project)
        path = self.folder / "one.kfa"
        path.write_text(json.dumps(project))
        done = run("--bake", "-", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_rows_are_those_of_single_bakes(self):
        self.write([RELEASE, {"field": "regions[0].friction.default", "from": 0.5, "to": 1, "count": 2}],
                   measure=[{"quantity": "angle_deg", "of": "r_elbow_flexion", "frame": 12},
                            {"quantity": "position_x_m", "of": "r_wrist", "frame": 14},
                            {"quantity": "com_highest_m"}, {"quantity": "clearance_least_m"},
                            {"quantity": "limit_hits"}, {"quantity": "kinetic_end_j"},
                            {"quantity": "error_estimate_deg"}, {"quantity": "warnings"}])
        done = self.sweep()
        self.assertEqual(done.stdout, f"{self.out}/sweep.csv: 6 cells\n{self.out}/sheet.png\n")
        rows = self.rows()
        self.assertEqual(len(rows), 6)
        for number, row in enumerate(rows):
            release, friction = (10, 11, 12)[number // 2], (0.5, 1)[number % 2]
            self.assertEqual([row["cell"], row["held_objects[ball].release_frame"],
                              row["regions[0].friction.default"], row["error"]],
                             [str(number), str(release), f"{friction:g}", ""])

            def change(project):
                project["held_objects"][0]["release_frame"] = release
                project["regions"][0]["friction"]["default"] = friction

            motion = self.baked(change)
            frames = motion["frames"]
            elbow = motion["joints"].index("r_elbow_flexion")
            wrist = motion["joint_groups"].index("r_wrist")
            hits = sum(e.get("count", 1) for e in motion["events"] if e["kind"] == "stop")
            wanted = {"com_highest_m": max(f["com"][2] for f in frames),
                      "position_x_m r_wrist F14": frames[14]["joint_positions_m"][wrist][0],
                      "clearance_least_m": min(f["clearance_m"] for f in frames),
                      "limit_hits": hits, "warnings": len(motion["warnings"])}
            for name, value in wanted.items():
                self.assertEqual(float(row[name]), value, name)
            near = {"angle_deg r_elbow_flexion F12": frames[12]["angles_deg"][elbow],
                    "error_estimate_deg": max(r["error_estimate_deg"] for r in motion["regions"]),
                    "kinetic_end_j": sum(r["energy_j"]["kinetic_end"] for r in motion["regions"])}
            for name, value in near.items():
                self.assertAlmostEqual(float(row[name]), value, delta=1e-12 * max(1, abs(value)),
                                       msg=name)

    def test_landings_lie_on_the_parabola_of_the_last_frames_in_the_air(self):
        """As far as the ball's positions in the motion say: it lands within the frames only where
        it is let go late and low."""
        self.write([{"field": "scene.gravity_m_s2", "values": [9.81, 30]},
                    {"field": "held_objects[ball].release_frame", "values": [9, 14]}],
                   measure=[{"quantity": q, "of": "ball"}
                            for q in ("landing_x_m", "landing_z_m", "landing_frame")])
        self.sweep()
        landed = 0
        for number, row in enumerate(self.rows()):
            def change(project):
                project["scene"]["gravity_m_s2"] = (9.81, 30)[number // 2]
                project["held_objects"][0]["release_frame"] = (9, 14)[number % 2]

            ball = [f["objects"][0]["position"] for f in self.baked(change)["frames"]]
            radius = self.project()["held_objects"][0]["sphere"]["radius_m"]
            under = next((f for f, p in enumerate(ball) if p[2] < radius), None)
            if under is None:
                self.assertEqual(row["landing_frame ball"], "")
                continue
            landed += 1
            frame = float(row["landing_frame ball"])
            self.assertTrue(under - 1 <= frame <= under)
            self.assertAlmostEqual(float(row["landing_z_m ball"]), radius, delta=2e-9)
            x0, x1 = ball[under - 1][0], ball[under][0]
            self.assertAlmostEqual(float(row["landing_x_m ball"]),
                                   x0 + (frame - under + 1) * (x1 - x0), delta=1e-9)
        self.assertGreater(landed, 0)

    def test_a_cell_that_fails_is_named_and_stops_no_other(self):
        self.write([{"field": "regions[0].last_frame", "values": [15, 2, 14]}],
                   measure=[{"quantity": "com_highest_m"}], picture={"frames": [5], "options": SIZE})
        done = self.sweep()
        self.assertIn("hazumi: warning: 1 of 3 cells failed; cell 1: ", done.stderr)
        self.assertIn("must be before last_frame 2", done.stderr)
        rows = self.rows()
        self.assertEqual([bool(r["com_highest_m"]) for r in rows], [True, False, True])
        self.assertEqual([bool(r["error"]) for r in rows], [False, True, False])
        self.assertEqual(sorted(p.name for p in (self.out / "pictures").iterdir()),
                         ["000000.png", "000002.png"])

    def test_the_number_of_cells_is_said_without_a_folder(self):
        self.write([GRAVITY, RELEASE])
        done = run("--sweep", self.sweep_file, "--count")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "6\n", ""))
        self.assertEqual(self.files(), ["sweep.json", "throw.kfa"])

    def test_fields_and_quantities_are_listed(self):
        fields = dict(line.split(" = ", 1) for line in run("--fields", THROW).stdout.splitlines())
        self.assertEqual(fields["scene.gravity_m_s2"], "9.81")
        self.assertEqual(fields["solver.method"], '"exact"')
        self.assertIn("held_objects[ball].release_frame", fields)
        names = [line.split()[0] for line in run("--quantities").stdout.splitlines()]
        self.assertIn("landing_x_m", names)
        self.assertEqual(len(names), len(set(names)))


class InParts(InSweep):
    """Fifty cells, three blocks, with pictures."""

    def setUp(self):
        super().setUp()
        self.write([{"field": "regions[0].friction.default", "from": 0.1, "to": 1, "count": 10},
                    {"field": "scene.gravity_m_s2", "from": 1, "to": 9, "count": 5}],
                   measure=[{"quantity": "com_highest_m"}, {"quantity": "rate_largest_deg_s"}],
                   picture={"frames": [8, 12], "options": [*SIZE, *CAMERA]})

    def test_tasks_and_a_last_call_make_the_same_bytes_as_one_call(self):
        whole = self.folder / "whole"
        self.sweep(out=whole)
        for task in (2, 0, 1):
            done = self.sweep("--tasks", "3", "--task", str(task))
            self.assertEqual(done.stdout, "")
            self.assertFalse((self.out / "sweep.csv").exists())
        self.sweep()
        self.assertEqual(self.contents(), self.contents(whole))
        self.assertEqual(len(self.contents()), 1 + 3 + 50 + 2)

    def test_a_second_call_computes_nothing_and_changes_nothing(self):
        self.sweep()
        before = self.contents()
        times = {p: p.stat().st_mtime_ns for p in (self.out / "rows").iterdir()}
        self.sweep()
        self.assertEqual(self.contents(), before)
        self.assertEqual({p: p.stat().st_mtime_ns for p in (self.out / "rows").iterdir()}, times)

    def test_killed_and_continued_it_is_the_same_bytes(self):
        whole = self.folder / "whole"
        began = time.monotonic()
        self.sweep(out=whole)
        taken = time.monotonic() - began
        killed = 0
        for share in (0.1, 0.25, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9):
            process = start("--sweep", self.sweep_file, "--out", self.out)
            time.sleep(share * taken)
            killed += process.poll() is None
            process.kill()
            process.communicate()
            for name, data in self.contents().items():
                if not name.endswith(".tmp"):
                    self.assertEqual(data, (whole / name).read_bytes(), name)
        self.assertGreater(killed, 0)
        self.sweep()
        self.assertEqual(self.contents(), self.contents(whole))

    def test_an_interrupt_ends_it_with_whole_files_alone(self):
        process = start("--sweep", self.sweep_file, "--out", self.out)
        while not (self.out / "pictures" / "000000.png").exists() and process.poll() is None:
            time.sleep(0.01)
        process.terminate()
        _, complaint = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, complaint)
        self.assertTrue(complaint.endswith("hazumi: interrupted\n"), complaint)
        self.assertEqual(self.left_behind(), [])


class Pictures(InSweep):
    def test_a_strip_is_the_frames_of_render_beside_each_other(self):
        frames = [3, 10, 11]
        options = [*SIZE, *CAMERA, "--paths"]
        self.write([GRAVITY], picture={"frames": frames, "options": options})
        self.sweep()
        project = self.project()
        for cell, gravity in enumerate((9.81, 3.7)):
            project["scene"]["gravity_m_s2"] = gravity
            one = self.folder / "one.kfa"
            one.write_text(json.dumps(project))
            rendered = self.folder / f"rendered_{cell}"
            done = run("--render", rendered, *options, one)
            self.assertEqual(done.returncode, 0, done.stderr)
            parts = [rows_of(rendered / f"frame_{frame:04d}.png") for frame in frames]
            strip = rows_of(self.out / "pictures" / f"{cell:06d}.png")
            self.assertEqual(strip, [b"".join(rows) for rows in zip(*parts)])
        self.assertNotEqual((self.out / "pictures" / "000000.png").read_bytes(),
                            (self.out / "pictures" / "000001.png").read_bytes())

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_video_has_every_frame(self):
        self.write([GRAVITY], picture={"video": True, "options": [*SIZE, *CAMERA]})
        self.sweep()
        for cell in range(2):
            probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                    "stream=width,height,nb_read_frames,r_frame_rate", "-of", "json",
                                    self.out / "pictures" / f"{cell:06d}.mp4"],
                                   capture_output=True, text=True, check=True)
            self.assertEqual(json.loads(probe.stdout)["streams"],
                             [{"width": 48, "height": 36, "r_frame_rate": "30/1",
                               "nb_read_frames": "31"}])
        self.assertEqual(self.left_behind(), [])

    def test_what_changes_the_motion_or_is_no_picture_is_refused(self):
        refusals = {
            ("--fps", "60"): "picture.options: --fps changes the motion, not the picture",
            ("--method", "paper"): "picture.options: --method changes the motion, not the picture",
            ("--tolerance", "1"): "picture.options: --tolerance changes the motion, not the picture",
            ("--step", "0.01"): "picture.options: --step changes the motion, not the picture",
            ("--frames", "3..4"): "picture.options: --frames: say \"frames\" beside the options "
                                  "instead",
            ("--torques",): "picture.options: --torques belongs to",
            ("--bake", "x.json"): "picture.options: --render and --bake: one task at a time",
            ("--sise", "64x48"): "picture.options: unknown option --sise; did you mean --size?",
            ("--size", "64"): "picture.options: --size 64: ",
            ("other.kfa",): "picture.options: --render takes one FILE"}
        for options, message in refusals.items():
            self.write([GRAVITY], picture={"frames": [3], "options": list(options)})
            done = self.sweep(code=65)
            self.assertIn(f"{self.sweep_file}: {message}", done.stderr)
        for picture, message in (({"frames": [3, 31]}, "picture.frames[1]: the project has frames 0 "
                                                       "to 30"),
                                 ({"video": True, "options": ["--size", "49x36"]},
                                  "picture.options: --size: videos have even sizes")):
            self.write([GRAVITY], picture=picture)
            self.assertIn(f"{self.sweep_file}: {message}", self.sweep(code=65).stderr)
        self.assertEqual(self.files(), ["sweep.json", "throw.kfa"])


class Refusals(InSweep):
    def refused(self, code, message, *more):
        done = self.sweep(*more, code=code)
        self.assertEqual(done.stdout, "")
        self.assertIn(message, done.stderr)
        self.assertEqual(self.left_behind(), [])

    def test_bad_sweeps_say_what_is_wrong_and_leave_nothing(self):
        million = {"from": 0, "to": 1, "count": 1000000}
        name = self.sweep_file
        for vary, more, message in (
                ([{"field": "scene.gravity", "values": [1]}], {},
                 "vary[0].values[0]: scene.gravity = 1: there is no field \"gravity\" here"),
                ([{"field": "regions[legs].blend_frames", "values": [1]}], {},
                 "vary[0].values[0]: regions[legs].blend_frames = 1: there is no \"legs\" among "
                 "\"regions\""),
                ([{"field": "regions[0].friction.default", "values": [0.5, 1.5]}], {},
                 "vary[0].values[1]: regions[0].friction.default = 1.5: must lie between 0 and 1"),
                ([], {}, "vary: is empty: name a field and its values"),
                ([{"field": "name", "values": []}], {}, "vary[0]: has no values"),
                ([{"field": "scene.gravity_m_s2", **million},
                  {"field": "regions[0].friction.default", **million}], {},
                 "vary: 1000000000000 cells; 1000000 are the most"),
                ([GRAVITY], {"measure": [{"quantity": "landing_x", "of": "ball"}]},
                 "measure[0].quantity: there is no quantity \"landing_x\"; did you mean "
                 "\"landing_x_m\"?"),
                ([GRAVITY], {"measure": [{"quantity": "landing_x_m", "of": "bal"}]},
                 "measure[0].of: there is no held object \"bal\"; did you mean \"ball\"?")):
            self.write(vary, **more)
            self.refused(65, f"hazumi: {name}: {message}")
        self.assertEqual(self.files(), ["sweep.json", "throw.kfa"])

    def test_files_that_are_missing_or_no_sweep_are_named(self):
        self.write([GRAVITY], project="other.kfa")
        self.refused(66, f"{self.folder}/other.kfa: ")
        project = self.project()
        project["figure"] = {"file": "nobody.json"}
        self.write_project(project)
        self.write([GRAVITY])
        self.refused(66, "nobody.json")
        self.sweep_file.write_text("{")
        self.refused(65, f"{self.sweep_file}: ")
        self.sweep_file.write_text(THROW.read_text())
        self.refused(65, "not a Hazumi sweep: expected an object with \"format\": \"hazumi-sweep\"")
        self.sweep_file.unlink()
        self.refused(66, f"{self.sweep_file}: ")
        self.assertEqual(self.files(), ["throw.kfa"])

    def test_a_project_that_cannot_be_animated_is_said_before_anything_is_made(self):
        project = self.project()
        project["regions"][0]["last_frame"] = 2
        self.write_project(project)
        self.write([GRAVITY])
        self.refused(65, f"{self.folder}/throw.kfa: ")
        self.assertEqual(self.files(), ["sweep.json", "throw.kfa"])

    def test_a_folder_that_cannot_be_made_is_named(self):
        self.write([GRAVITY])
        self.out = self.sweep_file / "out"
        self.refused(73, f"hazumi: {self.out}")
        self.out = "/proc/hazumi"
        self.refused(73, "hazumi: /proc/hazumi")

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_folder_that_may_not_be_written_is_named(self):
        self.write([GRAVITY])
        self.out.mkdir()
        self.out.chmod(0o555)
        self.refused(73, f"hazumi: {self.out}")

    def test_a_folder_of_another_sweep_is_left_as_it_is(self):
        self.write([GRAVITY])
        self.sweep()
        before = self.contents()
        self.write([RELEASE])
        self.refused(65, f"{self.out}: holds another sweep: its plan.json differs")
        self.write([GRAVITY])
        project = self.project()
        project["name"] = "another throw"
        self.write_project(project)
        self.refused(65, f"{self.out}: holds another sweep: its plan.json differs")
        self.assertEqual(self.contents(), before)

    def test_a_full_disk_is_said_and_leaves_no_part_of_a_file(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk],
                                 capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("no file system can be mounted here")
        try:
            self.out = disk / "out"
            self.write([GRAVITY, RELEASE], picture={"frames": [1, 2, 3],
                                                    "options": ["--size", "320x240"]})
            self.refused(73, "No space left on device")
            self.assertFalse((self.out / "sweep.csv").exists())
        finally:
            subprocess.run(["umount", disk], check=True)

    def test_calls_that_make_no_sense_are_usage_errors(self):
        self.write([GRAVITY])
        for more, message in ((["--out", self.out, "--tasks", "3"],
                               "--tasks and --task go together"),
                              (["--out", self.out, "--tasks", "3", "--task", "3"],
                               "--task 3: of 3 tasks the last one is 2"),
                              ([], "--sweep wants --out FOLDER"),
                              (["--out", self.out, THROW], "--sweep takes no FILE"),
                              (["--out", self.out, "--fps", "60"], "--fps belongs to")):
            done = run("--sweep", self.sweep_file, *more)
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)
        self.assertEqual(self.files(), ["sweep.json", "throw.kfa"])


if __name__ == "__main__":
    unittest.main()
