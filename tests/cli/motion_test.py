#!/usr/bin/env -S /usr/bin/python3
"""What --bake, --info and --flight say of a motion. usage: motion_test.py HAZUMI"""

import csv
import json
import re
import stat
import unittest

from command_line import JUMP, THROW, InFolder, main, run


class Motion(InFolder):
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

    def test_more_than_a_million_output_frames_are_refused(self):
        project = self.project()
        project["frames"]["last"] = 5000
        long = self.folder / "long.kfa"
        long.write_text(json.dumps(project))
        done = run("--bake", "-", "--fps", "10000", long)
        self.assertEqual((done.returncode, done.stdout), (65, ""))
        self.assertIn("output frames", done.stderr)

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
        contacts = motion["frames"][2]["effort"]["contacts"]
        self.assertTrue(contacts)
        for contact in contacts:
            self.assertFalse(contact["grip"])
            self.assertGreaterEqual(contact["force_n"][2], 0)
        info = run("--info", "--effort", JUMP).stdout
        told = re.search(r"effort +largest torque: \S+ (-?\d+) N m at F\d+, \d+ % of its strength", info)
        self.assertAlmostEqual(abs(float(told.group(1))), largest, delta=1.0)
        brief = [line for line in run("--info", JUMP).stdout.splitlines() if line.startswith("effort")]
        self.assertEqual(len(brief), 1)
        self.assertRegex(brief[0], r"effort +largest effort: \S+ \d+ % of its strength, \S+ N m at F\d+")
        self.assertIn(brief[0], info)
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

    def test_another_frame_rate_is_the_same_motion(self):
        at_30 = json.loads(run("--bake", "-", JUMP).stdout)
        at_60 = json.loads(run("--bake", "-", "--fps", "60", JUMP).stdout)
        self.assertEqual(len(at_60["frames"]), 61)
        for i, frame in enumerate(at_30["frames"]):
            self.assertEqual(frame["angles_deg"], at_60["frames"][2 * i]["angles_deg"])
            self.assertEqual(frame["root"], at_60["frames"][2 * i]["root"])

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


if __name__ == "__main__":
    main()
