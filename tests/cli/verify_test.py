#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --verify says of motions and pictures, and that the program makes the same ones
whatever the C library and the processor have. usage: verify_test.py HAZUMI"""

import json
import math
import os
import re
import shutil
import subprocess
import unittest

from command_line import HAZUMI, JUMP, THROW, InFolder, main, run
from png_pixels import change_pixel, without_text

# The C library takes its routines for processors without these.
WITHOUT_FMA = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4"}
ELEMENTARY = ("sin cos tan asin acos atan atan2 exp exp2 pow log log10 hypot fmod remainder "
              "sincos log2 cbrt").split()
SMALL = ["--size", "64x48"]


class Motions(InFolder):
    def setUp(self):
        super().setUp()
        self.made = self.folder / "made.json"

    def bake(self, *options, project=THROW):
        done = run("--bake", self.made, *options, project)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(self.made.read_text())

    def verify(self, code, project=THROW, made=None):
        done = run("--verify", project, made or self.made)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_what_was_made_is_the_same_again(self):
        for project in (THROW, JUMP):
            self.bake(project=project)
            done = self.verify(0, project)
            self.assertRegex(done.stdout, r"^the same: \d{4,} values of 31 frames\n$")
            self.assertEqual(done.stderr, "")

    def test_a_motion_of_an_older_build_without_seams_is_the_same(self):
        motion = self.bake()
        del motion["seams"]
        self.made.write_text(json.dumps(motion))
        self.assertIn("the same: ", self.verify(0).stdout)

    def test_options_are_taken_from_the_file(self):
        for options in (["--fps", "60"], ["--fps", "7"], ["--tolerance", "0.5"], ["--torques"],
                        ["--effort"], ["--timings"], ["--method", "paper", "--step", "0.01"],
                        ["--fps", "24", "--tolerance", "0.001", "--torques", "--timings"]):
            self.bake(*options)
            self.assertIn("the same: ", self.verify(0).stdout, options)

    def test_what_export_wrote_is_the_same_too(self):
        for options in ([], ["--frames", "3..9"], ["--frames", "25..99"],
                        ["--fps", "7", "--torques"], ["--effort", "--frames", "3..9"], ["--frames", "4..10", "--fps", "60"]):
            done = run("--export", self.made, *options, JUMP)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("the same: ", self.verify(0, JUMP).stdout, options)

    def test_one_changed_bit_is_named_by_frame_and_joint(self):
        motion = self.bake()
        elbow = motion["joints"].index("r_elbow_flexion")
        value = motion["frames"][7]["angles_deg"][elbow]
        other = math.nextafter(value, math.inf)
        motion["frames"][7]["angles_deg"][elbow] = other
        self.made.write_text(json.dumps(motion))
        said = self.verify(1).stdout
        number = r"-?[\d.]+(?:e-?\d+)?"
        self.assertRegex(said, rf"^differs: frame 7, angles_deg of r_elbow_flexion: {number} as "
                               rf"made, {number} again, by [\d.]+e-\d+; 1 of \d+ values differ, by "
                               rf"[\d.]+e-\d+ at most\n$")
        self.assertIn(f"{other!r} as made, {value!r} again", said)

    def test_every_kind_of_value_is_compared(self):
        def frame(motion, number):
            return motion["frames"][number]

        changes = {
            "frame 3, rates_deg_s of l_wrist_": lambda m: frame(m, 3)["rates_deg_s"].__setitem__(
                next(i for i, j in enumerate(m["joints"]) if j.startswith("l_wrist_")), 1e9),
            "frame 4, root, position[1]": lambda m: frame(m, 4)["root"]["position"].__setitem__(1, 7),
            "frame 5, com[2]": lambda m: frame(m, 5)["com"].__setitem__(2, 0),
            "frame 6, clearance_m": lambda m: frame(m, 6).update(clearance_m=None),
            "frame 0, objects[0], held: false as made, true again":
                lambda m: frame(m, 0)["objects"][0].update(held=False),
            "frame 9, pinned": lambda m: frame(m, 9).update(pinned="nobody"),
            "frame 2 com: missing as made, there again": lambda m: frame(m, 2).pop("com"),
            "frame 1, extra: there as made, missing again": lambda m: frame(m, 1).update(extra=1),
            "events: 0 items as made": lambda m: m.update(events=[]),
            "frames: 30 items as made, 31 items again": lambda m: m["frames"].pop(),
            "fps: 31 as made, 30 again": lambda m: m.update(fps=31),
            "regions[0], evaluations": lambda m: m["regions"][0].update(evaluations=1)}
        whole = self.bake()
        for place, change in changes.items():
            motion = json.loads(json.dumps(whole))
            change(motion)
            self.made.write_text(json.dumps(motion))
            said = self.verify(1).stdout
            self.assertTrue(said.startswith(f"differs: {place}"), said)

    def test_another_project_is_not_the_same(self):
        self.bake()
        self.assertTrue(self.verify(1, JUMP).stdout.startswith("differs: "))
        project = self.project()
        project["regions"][0]["friction"]["default"] = 0.8000001
        (self.folder / "other.kfa").write_text(json.dumps(project))
        self.assertRegex(self.verify(1, self.folder / "other.kfa").stdout,
                         r"^differs: frame \d+, \w+ of \w+: ")

    def test_another_program_is_remarked_on_and_decides_nothing(self):
        motion = self.bake()
        this = motion["made_by"]["program"]
        motion["made_by"]["program"] = "Hazumi 0.0 (abcdef)"
        self.made.write_text(json.dumps(motion))
        self.assertEqual(self.verify(0).stderr, f"hazumi: made by Hazumi 0.0 (abcdef); this is {this}\n")
        del motion["made_by"]
        self.made.write_text(json.dumps(motion))
        self.assertEqual(self.verify(0).stderr, f"hazumi: made by an older program; this is {this}\n")

    def test_options_that_this_program_has_not_are_said(self):
        motion = self.bake()
        motion["made_by"]["options"] = ["--speed", "2"]
        self.made.write_text(json.dumps(motion))
        self.assertEqual(self.verify(65).stderr,
                         f"hazumi: {self.made}: options: this program cannot make it again: unknown "
                         f"option --speed; did you mean --sweep?\n")

    def test_what_is_no_motion_is_refused(self):
        for text in ("", "{", "[]", "7", '{"format": "hazumi-project"}', THROW.read_text(),
                     '{"format": 3}'):
            self.made.write_text(text)
            self.assertEqual(self.verify(65).stderr,
                             f"hazumi: {self.made}: is no motion that --bake wrote as .json\n")
        missing = self.folder / "missing.json"
        self.assertIn(f"hazumi: {missing}: ", self.verify(66, made=missing).stderr)
        self.bake()
        self.assertIn("missing.kfa", self.verify(66, project=self.folder / "missing.kfa").stderr)

    def test_odd_motions_are_compared_all_the_same(self):
        """Whatever is in it, it is said where it differs."""
        for more in ({}, {"frames": []}, {"frames": [1, 2]}, {"frames": [{"frame": "one"}]},
                     {"frames": {"a": 1}}, {"joints": 7}, {"made_by": 3},
                     {"made_by": {"program": 1, "options": [1, None]}}):
            self.made.write_text(json.dumps({"format": "hazumi-motion", "version": 1, **more}))
            self.assertTrue(self.verify(1).stdout.startswith("differs: "), more)

    def test_it_wants_two_names(self):
        for files in ([], [THROW], [THROW, THROW, THROW]):
            done = run("--verify", *files)
            self.assertEqual(done.returncode, 2, files)
        self.assertIn("--verify takes FILE and MADE: two names", done.stderr)


class Pictures(InFolder):
    def render(self, *options, project=THROW, frames="3..6"):
        self.made = self.folder / "made"
        done = run("--render", self.made, *SMALL, "--frames", frames, *options, project)
        self.assertEqual(done.returncode, 0, done.stderr)

    def verify(self, code, project=THROW):
        done = run("--verify", project, self.made)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_what_was_drawn_is_the_same_again(self):
        for options in ([], ["--paths", "--ghosts", "5", "--camera", "left"],
                        ["--body", "capsules", "--samples", "1"], ["--fps", "60"]):
            self.render(*options)
            self.assertEqual(self.verify(0).stdout, "the same: 12288 pixels of 4 pictures\n")
            shutil.rmtree(self.made)

    def test_pictures_of_which_some_are_gone_are_compared(self):
        self.render()
        (self.made / "frame_0004.png").unlink()
        self.assertEqual(self.verify(0).stdout, "the same: 9216 pixels of 3 pictures\n")

    def test_a_changed_pixel_is_named(self):
        self.render()
        change_pixel(self.made / "frame_0005.png", 20, 30, 3)
        said = self.verify(1).stdout
        match = re.fullmatch(r"differs: frame 5, pixel \(20, 30\): (\d+) (\d+) (\d+) as made, "
                             r"(\d+) (\d+) (\d+) again; 1 of 12288 pixels of 4 pictures differ, by "
                             r"(\d+) of 255 at most\n", said)
        self.assertTrue(match, said)
        made, again = [int(x) for x in match.groups()[:3]], [int(x) for x in match.groups()[3:6]]
        self.assertEqual((made[0] - again[0]) % 256, 3)
        self.assertEqual(made[1:], again[1:])

    def test_another_project_is_not_the_same(self):
        self.render()
        project = self.project()
        project["scene"]["objects"][0]["color"] = "#9aa0a7"
        (self.folder / "other.kfa").write_text(json.dumps(project))
        self.assertTrue(self.verify(1, self.folder / "other.kfa").stdout.startswith("differs: frame 3"))

    def test_a_frame_that_the_project_has_not_is_named(self):
        self.render()
        project = self.project()
        project["frames"]["last"] = project["placements"][0]["last_frame"] = 15
        (self.folder / "short.kfa").write_text(json.dumps(project))
        self.render(frames="15..17")
        self.assertEqual(self.verify(65, self.folder / "short.kfa").stderr,
                         f"hazumi: {self.made}/frame_0016.png: shows frame 16, which "
                         f"{self.folder}/short.kfa does not have\n")

    def test_a_folder_without_pictures_is_said(self):
        self.made = self.folder / "made"
        self.made.mkdir()
        (self.made / "notes.txt").write_text("none")
        self.assertEqual(self.verify(66).stderr,
                         f"hazumi: {self.made}: holds no pictures (.png) to compare\n")

    def test_pictures_of_an_older_program_are_said_to_tell_nothing(self):
        for key in ("Options", "Frame"):
            self.render()
            without_text(self.made / "frame_0004.png", key)
            self.assertEqual(self.verify(65).stderr,
                             f"hazumi: {self.made}/frame_0004.png: does not say how it was drawn: "
                             f"this or a newer Hazumi's --render notes it in the file\n")

    def test_another_program_is_remarked_on_and_decides_nothing(self):
        self.render()
        for path in self.made.iterdir():
            without_text(path, "Maker")
        self.assertRegex(self.verify(0).stderr, r"^hazumi: made by an older program; this is Hazumi ")

    def test_two_kinds_in_one_folder_are_refused(self):
        self.render()
        run("--render", self.made, *SMALL, "--frames", "9", "--paths", THROW)
        self.assertIn("was drawn with other options than the rest", self.verify(65).stderr)

    def test_a_broken_picture_is_named(self):
        self.render()
        path = self.made / "frame_0004.png"
        data = path.read_bytes()
        path.write_bytes(data[:-100])
        self.assertIn(f"hazumi: {path}: ", self.verify(65).stderr)
        path.write_bytes(b"not a picture")
        self.assertIn(f"hazumi: {path}: does not say how it was drawn", self.verify(65).stderr)


class SameEverywhere(InFolder):
    def test_the_c_librarys_choice_of_routines_changes_no_byte(self):
        for project in (THROW, JUMP):
            for options in ([], ["--method", "paper"], ["--torques", "--fps", "120"]):
                plain = run("--bake", "-", *options, project)
                other = run("--bake", "-", *options, project, env=WITHOUT_FMA)
                self.assertEqual((plain.returncode, other.returncode), (0, 0), plain.stderr)
                self.assertEqual(plain.stdout, other.stdout)

    def test_it_changes_no_pixel(self):
        out = self.folder / "made"
        done = run("--render", out, "--size", "160x120", "--frames", "8..12", "--paths", THROW)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run("--verify", THROW, out, env=WITHOUT_FMA)
        self.assertEqual((done.returncode, done.stdout),
                         (0, "the same: 96000 pixels of 5 pictures\n"), done.stderr)

    def test_throws_and_aims_are_found_to_the_same_byte(self):
        def solved(name, **how):
            path = self.folder / name
            script = [
                {"op": "held.add_ball", "joint": "r_wrist"},
                {"op": "throw.add", "object": "ball", "x": 3.6, "y": 0.2, "style": "overarm"},
                {"op": "region.add", "name": "left", "first": 5, "last": 18, "joints": ["l_shoulder+"]},
                {"op": "goal.add", "kind": "point", "name": "touch", "frame": 18, "joint": "l_wrist",
                 "position_x": 0.3, "position_y": 0.3, "position_z": 1.3},
                {"op": "goal.aim", "goal": "touch"},
                {"op": "file.save", "path": str(path)}]
            steps = self.folder / "steps.json"
            steps.write_text(json.dumps(script))
            done = run("--run", steps, **how)
            self.assertEqual(done.returncode, 0, done.stderr)
            return path.read_bytes()

        plain = solved("plain.kfa")
        self.assertIn(b"solved_by", plain)
        self.assertEqual(plain, solved("again.kfa"))
        self.assertEqual(plain, solved("other.kfa", env=WITHOUT_FMA))
        if hasattr(os, "sched_setaffinity"):
            one = min(os.sched_getaffinity(0))
            self.assertEqual(plain, solved("one.kfa", preexec_fn=lambda: os.sched_setaffinity(0, {one})))

    def test_one_thread_and_many_make_the_same_motion(self):
        if not hasattr(os, "sched_setaffinity"):
            self.skipTest("not here: threads cannot be kept to one processor here")
        one = min(os.sched_getaffinity(0))
        for project in (THROW, JUMP):
            many = run("--bake", "-", project)
            single = run("--bake", "-", project, preexec_fn=lambda: os.sched_setaffinity(0, {one}))
            self.assertEqual(many.returncode, 0, many.stderr)
            self.assertEqual(many.stdout, single.stdout)

    @unittest.skipUnless(shutil.which("nm"), "nm is not installed")
    def test_elementary_functions_are_not_the_c_librarys(self):
        if os.environ.get("HAZUMI_SANITIZE"):
            self.skipTest("not here: sanitizers take the functions' places")
        listed = subprocess.run(["nm", "-D", "--undefined-only", HAZUMI], capture_output=True,
                                text=True, check=True).stdout
        imported = {line.split()[-1].split("@")[0] for line in listed.splitlines()}
        self.assertIn("malloc", imported)
        wanted = {name + suffix for name in ELEMENTARY for suffix in ("", "f")}
        self.assertEqual(imported & wanted, set())


if __name__ == "__main__":
    main()
