#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --import makes of files of other programs, and what it leaves behind when it cannot.
usage: import_test.py HAZUMI"""

import json
import os
import pathlib
import signal
import time
import unittest

from command_line import THROW, InFolder, run, start


class Import(InFolder):
    def walk(self, frames=5):
        """A clip: a trunk that leans forward, an arm that swings."""
        rows = "".join(f"0 {90 + i % 5} 0 0 {5 * (i % 5)} 0 {40 * (i % 2)} 0 0\n"
                       for i in range(frames))
        path = self.folder / "walk.bvh"
        path.write_text(
            "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
            "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "JOINT LeftArm\n{\nOFFSET 20 80 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "End Site\n{\nOFFSET 60 0 0\n}\n}\n"
            "JOINT LeftLeg\n{\nOFFSET 10 -90 0\nEnd Site\n{\nOFFSET 0 0 20\n}\n}\n}\n"
            f"MOTION\nFrames: {frames}\nFrame Time: 0.0333333\n{rows}")
        return path

    def test_import_makes_a_project_and_says_what_it_took_it_for(self):
        out = self.folder / "walk.kfa"
        done = run("--import", self.walk(), "--save", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for fact in ("2 joints below \"Hips\"", "y is up (guessed)", "1 unit is 0.01 m (guessed: "
                     "centimetres): 1.7 m tall", "5 frames at 30 a second", f"saved as {out}"):
            self.assertIn(fact, done.stdout)
        self.assertEqual(run("--check", out).returncode, 0)
        first = out.read_bytes()
        run("--import", self.walk(), "--save", out)
        self.assertEqual(out.read_bytes(), first)
        project = json.loads(first)
        self.assertEqual(project["frames"], {"first": 0, "last": 4})
        self.assertEqual([round(k["position_m"], 9) for k in project["root"]["z"]["keys"]],
                         [0.9, 0.91, 0.92, 0.93, 0.94])

    def test_import_obeys_its_options(self):
        out = self.folder / "walk.kfa"
        done = run("--import", self.walk(), "--save", out, "--height", "2", "--mass", "80",
                   "--reduce", "1", "--fps", "60", "--limits", "none", "--up", "y")
        self.assertEqual(done.returncode, 0, done.stderr)
        for fact in ("2 m tall", "80 kg", "y is up (as asked for)", "within 1 degree of",
                     "at 60 a second"):
            self.assertIn(fact, done.stdout)
        project = json.loads(out.read_text())
        self.assertEqual(project["fps"], {"num": 60, "den": 1})
        leaning = [c for c in project["root"].values() if len(c["keys"]) == 2]
        self.assertTrue(leaning)  # what goes evenly has two keys

    def test_import_without_a_place_to_save_or_with_a_wrong_one_is_wrong_usage(self):
        for wrong, message in (([], "--import wants --save OUT.kfa"),
                               (["--save", "out.bvh"], "the name must end in .kfa"),
                               (["--save", "o.kfa", THROW], "--import takes one file"),
                               (["--save", "o.kfa", "--reduce", "0"], "give degrees"),
                               (["--save", "o.kfa", "--up", "x"], "give y or z")):
            done = run("--import", self.walk(), *wrong, cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (2, ""), wrong)
            self.assertIn(message, done.stderr)

    def test_import_of_what_cannot_be_imported_saves_nothing(self):
        broken = self.folder / "broken.bvh"
        broken.write_text("HIERARCHY\nROOT Hips\n{\n")
        text = self.folder / "notes.fbx"
        text.write_text("Dear diary")
        for file, code in ((broken, 65), (text, 65), (self.folder / "none.bvh", 66)):
            done = run("--import", file, "--save", self.folder / "o.kfa")
            self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
            self.assertTrue(done.stderr.startswith(f"hazumi: {file}: "), done.stderr)
        done = run("--import", self.walk(), "--clip", "jump", "--save", self.folder / "o.kfa")
        self.assertEqual(done.returncode, 65)
        self.assertIn("there is no \"jump\"; there are \"walk\"", done.stderr)
        self.assertNotIn("o.kfa", self.files())

    def test_an_interrupted_import_ends_its_reader_and_leaves_nothing(self):
        """A reader that never answers says who it is."""
        reader, number = self.folder / "reader", self.folder / "number"
        reader.write_text(f"#!/bin/sh\necho $$ > {number}.new; mv {number}.new {number}\n"
                          "exec sleep 100\n")
        reader.chmod(0o755)
        walk = self.walk()
        for signal_number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            number.unlink(missing_ok=True)
            process = start("--import", walk, "--save", self.folder / "o.kfa",
                            env={**os.environ, "HAZUMI_READER": str(reader)})
            while not number.exists():
                time.sleep(0.01)
            process.send_signal(signal_number)
            out, complaint = process.communicate(timeout=10)
            self.assertEqual((process.returncode, out), (130, ""), complaint)
            self.assertFalse(pathlib.Path("/proc", number.read_text().strip()).exists())
            self.assertEqual(self.files(), ["number", "reader", "walk.bvh"])

    def test_an_import_interrupted_at_any_time_ends_soon_and_leaves_nothing(self):
        """Not only while the file is read."""
        walk = self.walk(frames=20000)
        out = self.folder / "o.kfa"
        began = time.monotonic()
        self.assertEqual(run("--import", walk, "--save", out).returncode, 0)
        whole = time.monotonic() - began
        for share in (0.2, 0.4, 0.6, 0.8):
            out.unlink(missing_ok=True)
            process = start("--import", walk, "--save", out)
            time.sleep(share * whole)
            process.send_signal(signal.SIGTERM)
            _, complaint = process.communicate(timeout=60)
            if process.returncode == 0:  # it was done before
                continue
            self.assertEqual(process.returncode, 130, complaint)
            self.assertEqual(self.files(), ["walk.bvh"])

    def test_twenty_thousand_frames_of_ninety_hinges_are_imported_and_read_back(self):
        """More than five million values."""
        joints, frames = 30, 20000
        chain = "".join(f"JOINT J{i}\n{{\nOFFSET 0 6 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
                        for i in range(joints))
        rows = [" ".join(str((7 * f + 3 * k) % 20) for k in range(3 * joints)) for f in range(20)]
        path, out = self.folder / "long.bvh", self.folder / "long.kfa"
        path.write_text("HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
                        "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                        + chain + "End Site\n{\nOFFSET 0 6 0\n}\n" + "}\n" * (joints + 1)
                        + f"MOTION\nFrames: {frames}\nFrame Time: 0.00833333\n"
                        + "".join(f"0 90 0 0 0 {f % 9} {rows[f % 20]}\n" for f in range(frames)))
        for task in (["--import", path, "--save", out], ["--check", out]):
            code, _, complaint, megabytes = self.peak(*task)
            self.assertEqual(code, 0, complaint)
            self.assertLess(megabytes, 1000, task)

    def test_import_says_what_cannot_be_saved(self):
        done = run("--import", self.walk(), "--save", self.folder / "missing" / "o.kfa")
        self.assertEqual((done.returncode, done.stdout), (73, ""), done.stderr)

    def test_a_bvh_file_is_rendered_and_baked_as_it_is(self):
        done = run("--render", self.folder / "p", "--size", "64x48", "--frames", "2..3", self.walk())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.files(), ["frame_0002.png", "frame_0003.png", "walk.bvh"])
        motion = json.loads(run("--bake", "-", self.walk()).stdout)
        self.assertEqual(len(motion["frames"]), 5)
        # The arm's joint: 20 to the left, 80 up of hips that lean back and forth about y = left.
        x, y, z = motion["frames"][0]["joint_positions_m"][0]
        self.assertAlmostEqual(x, 0.0, 9)
        self.assertAlmostEqual(y, 0.2, 9)
        self.assertAlmostEqual(z, 1.7, 9)


if __name__ == "__main__":
    unittest.main()
