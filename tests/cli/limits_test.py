#!/usr/bin/env -S /usr/bin/python3
"""What the command line does with what is too large, takes too long or is broken off.
usage: limits_test.py HAZUMI"""

import json
import signal
import time

from command_line import JUMP, THROW, InFolder, main, run, start, wait_until_it_handles


class Limits(InFolder):
    def long(self, frames, **more):
        """The throw, standing on for so many frames."""
        project = self.project()
        project["frames"]["last"] = frames - 1
        project.update(more)
        path = self.folder / "long.kfa"
        path.write_text(json.dumps(project))
        return path

    def test_a_million_frames_are_checked_in_little_memory(self):
        long = self.long(1000000)
        for task in ("--check", "--info"):
            code, _, complaint, megabytes = self.peak(task, long)
            self.assertEqual(code, 0, complaint)
            self.assertLess(megabytes, 150, task)

    def test_a_motion_too_large_is_refused_with_its_size(self):
        for frames, tasks in ((1000000, (["--bake", "-"], ["--flight"], ["--render", "o"],
                                         ["--export", "o.glb"], ["--export", "o.mp4"])),
                              (100000, (["--bake", "-", "--fps", "240"],
                                        ["--export", "o.json", "--fps", "240"]))):
            long = self.long(frames)
            for task in tasks:
                code, out, complaint, megabytes = self.peak(*task, long)
                self.assertEqual((code, out), (65, ""), complaint)
                self.assertRegex(complaint, r"frames: \d+ frames of 37 joints would need [\d.]+ GB of "
                                            r"memory; at most 1 GB")
                self.assertLess(megabytes, 100, task)

    def test_what_is_not_refused_for_its_size_takes_a_gigabyte_at_most(self):
        long = self.long(60000)
        for task in (["--bake", self.folder / "m.json"], ["--export", self.folder / "m.csv"],
                     ["--export", self.folder / "m.glb"], ["--export", self.folder / "m.bvh"],
                     ["--flight"]):
            code, _, complaint, megabytes = self.peak(*task, long)
            self.assertEqual(code, 0, complaint)
            self.assertLess(megabytes, 1000, task)

    def test_paths_take_no_more_memory_than_there_may_be(self):
        drawn = ["--render", self.folder / "p", "--size", "64x48", "--frames", "0", "--paths"]
        code, _, complaint, megabytes = self.peak(*drawn, self.long(170000))
        self.assertEqual(code, 0, complaint)
        self.assertIn("--paths: 1 points a frame instead of 4", complaint)
        self.assertLess(megabytes, 1000)

    def test_too_many_ghosts_and_pixels_are_refused_with_the_number(self):
        for more, message in ((["--ghosts", "1"], "--ghosts 1: 5000 ghosts in each picture; 1000 "
                                                  "are the most, give at least 5"),
                              (["--size", "16384x16384"], "--size 16384x16384: needs 14 GB of "
                                                          "memory; at most 2 GB")):
            done = run("--render", self.folder / "o", *more, self.long(5000))
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)
        self.assertEqual(self.files(), ["long.kfa"])

    def test_long_names_are_not_said_whole(self):
        name = "x" * 100000
        for change in ({"name": name}, {"joints": {name: {"keys": []}}}, {"markers": [{name: 1}]},
                       {"regions": [{**self.project()["regions"][0], "joints": [name]}]},
                       {"solver": {"method": name, "version": 1}}, {"figure": {"file": name}},
                       {"joints": {"r_knee": {"keys": [{"frame": 0, "angle_deg": 1, name: 2}] * 2}}},
                       {"held_objects": [{"name": name}]}):
            long = self.long(10, **change)
            for task in (["--check"], ["--check", "--json"], ["--info"]):
                done = run(*task, long)
                self.assertIn(done.returncode, (0, 65, 66))
                self.assertLess(len(done.stdout) + len(done.stderr), 5000, (task, list(change)))
        for arguments in (["--frames", name], ["--" + name], ["--bake", name]):
            self.assertLess(len(run(*arguments, THROW).stderr), 5000)

    def test_an_interrupted_render_exits_with_130_and_leaves_whole_pictures(self):
        out = self.folder / "frames"
        process = start("--render", out, "--size", "640x360", JUMP)
        process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        for name in self.files():
            data = (out / name).read_bytes()
            self.assertTrue(name.endswith(".png") and data.endswith(b"IEND\xaeB`\x82"), name)
        self.assertLess(len(self.files()), 31)

    def test_an_interrupted_bake_or_check_exits_with_130_and_leaves_nothing(self):
        for task in (["--bake", self.folder / "m.json"], ["--check"], ["--info"],
                     ["--render", self.folder / "pictures"]):
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                process = start(*task, "--method", "paper", "--step", "0.000002", THROW)
                wait_until_it_handles(process, number)
                time.sleep(0.3)
                process.send_signal(number)
                out, complaint = process.communicate(timeout=60)
                self.assertEqual((process.returncode, out), (130, ""), (task, number))
                self.assertEqual(complaint, "hazumi: interrupted\n")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_interrupt_ends_a_bake_that_nobody_reads(self):
        process = start("--bake", "-", "--fps", "3000", THROW)
        process.stdout.read(1)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=20), 130)
        process.stdout.close()
        process.stderr.close()

    def test_an_ignored_interrupt_stays_ignored(self):
        process = start("--render", self.folder, "--size", "64x48", "--frames", "3..6", THROW,
                        inherited=signal.SIG_IGN)
        process.stderr.readline()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual((process.returncode, len(self.files())), (0, 4))


if __name__ == "__main__":
    main()
