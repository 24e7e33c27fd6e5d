#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --import makes of files of other programs, and what it leaves behind when it cannot.
usage: import_test.py HAZUMI"""

import json
import unittest

from command_line import THROW, InFolder, run


class Import(InFolder):
    def walk(self):
        """A clip of five frames: a trunk that leans forward, an arm that swings."""
        rows = "".join(f"0 {90 + i} 0 0 {5 * i} 0 {40 * (i % 2)} 0 0\n" for i in range(5))
        path = self.folder / "walk.bvh"
        path.write_text(
            "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
            "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "JOINT LeftArm\n{\nOFFSET 20 80 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "End Site\n{\nOFFSET 60 0 0\n}\n}\n"
            "JOINT LeftLeg\n{\nOFFSET 10 -90 0\nEnd Site\n{\nOFFSET 0 0 20\n}\n}\n}\n"
            f"MOTION\nFrames: 5\nFrame Time: 0.0333333\n{rows}")
        return path

    def test_a_character_of_no_size_is_an_error_that_says_what_to_do(self):
        out, path = self.folder / "walk.kfa", self.walk()
        done = run("--import", path, "--unit", "1e-9", "--save", out)
        self.assertEqual(done.returncode, 65)
        self.assertIn("--height", done.stderr)
        self.assertFalse(out.exists())
        text = path.read_text()
        for place in ("20 80 0", "60 0 0", "10 -90 0", "0 0 20"):
            text = text.replace(f"OFFSET {place}", "OFFSET 0 0 0")
        path.write_text(text)
        done = run("--import", path, "--save", out)
        self.assertEqual(done.returncode, 65)
        self.assertIn("all its bones lie in one place", done.stderr)
        self.assertFalse(out.exists())

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
