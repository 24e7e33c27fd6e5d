#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --sweep refuses, and what it leaves behind then: nothing, or what was there.
usage: sweep_refusals_test.py HAZUMI"""

from command_line import AS_ANY_USER, THROW, main, run
from sweep_folder import GRAVITY, RELEASE, InSweep


class Refusals(InSweep):
    def refused(self, code, message, *more, before=()):
        done = self.sweep(*more, code=code, before=before)
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

    def test_a_folder_that_may_not_be_written_is_named(self):
        self.write([GRAVITY])
        self.out.mkdir()
        self.out.chmod(0o555)
        self.refused(73, f"hazumi: {self.out}", before=AS_ANY_USER)

    def test_a_folder_of_another_sweep_is_left_as_it_is(self):
        self.write([GRAVITY])
        self.sweep()
        before = self.contents()
        self.write([RELEASE])
        self.refused(65, f"{self.out}: holds another sweep: its plan.json differs in the sweep; name")
        self.write([GRAVITY])
        project = self.project()
        project["name"] = "another throw"
        self.write_project(project)
        self.refused(65, f"{self.out}: holds another sweep: its plan.json differs in the project; name")
        self.assertEqual(self.contents(), before)

    def test_a_full_disk_is_said_and_leaves_no_part_of_a_file(self):
        with self.small_disk("64k") as disk:
            self.out = disk / "out"
            self.write([GRAVITY, RELEASE], picture={"frames": [1, 2, 3],
                                                    "options": ["--size", "320x240"]})
            self.refused(73, "No space left on device")
            self.assertFalse((self.out / "sweep.csv").exists())

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
    main()
