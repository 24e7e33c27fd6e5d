#!/usr/bin/env -S /usr/bin/python3
"""What --run does without a window: edits, pictures of the editor, what it refuses to save.
usage: script_test.py HAZUMI"""

import json
import unittest

from command_line import THROW, InFolder, main, run


class Scripts(InFolder):
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

    def test_a_script_says_in_json_what_its_operators_made_and_measured(self):
        script = self.folder / "script.json"
        script.write_text(json.dumps([
            {"op": "held.add_ball", "joint": "r_wrist"},
            {"op": "key.set", "curve": "r_knee", "frame": 5, "value": 40},
            {"op": "throw.add", "object": "ball", "x": 2.0, "y": 0.3},
            {"op": "time.frame", "frame": 0}]))
        done = run("--run", script, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        ball, key, throw, go = map(json.loads, done.stdout.splitlines())
        self.assertEqual(ball, {"op": "held.add_ball", "made": ["held_objects[ball]"], "measured": {}})
        self.assertEqual((key["made"], key["measured"]), ([], {}))
        self.assertEqual(throw["made"], ["regions[throw]", "placements[0]", "goals[throw]"])
        measured = throw["measured"]
        self.assertLess(measured["release_frame"], measured["down_frame"])
        # What has to fly 2 m under gravity is no slower than sqrt(g x) from the ground up, and an
        # underarm throw is no faster than twice that.
        self.assertTrue(2.0 < measured["speed_m_s"] < 9.0, measured)
        self.assertEqual(go["made"], [])

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

    def test_the_operators_are_listed_with_their_parameters(self):
        lines = run("--operators").stdout.splitlines()
        self.assertIn("region.split: Makes two regions of one.", lines)
        self.assertIn("    region: a text, names a region: the region's name", lines)

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


if __name__ == "__main__":
    main()
