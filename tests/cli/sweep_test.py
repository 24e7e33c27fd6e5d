#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --sweep makes, however it is shared out or broken off.
usage: sweep_test.py HAZUMI"""

import json
import shutil
import subprocess
import time
import unittest

from command_line import THROW, main, run, start
from png_pixels import rows_of
from sweep_folder import GRAVITY, RELEASE, InSweep

HAS_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")
CAMERA = ["--camera", "2.5,-3,1.4,0,0,0.9,35"]
SIZE = ["--size", "48x36"]


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


if __name__ == "__main__":
    main()
