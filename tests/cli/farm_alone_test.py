#!/usr/bin/env -S /usr/bin/python3
"""What scripts/farm does without a cluster. usage: farm_alone_test.py HAZUMI"""

import json
import os
import shutil
import subprocess
import unittest

from command_line import HAZUMI, ROOT, THROW, main, run
from farm_testing import FRICTION, FarmTest, farm, missing

from farm_parts import drawing


class WithoutACluster(FarmTest):
    def test_any_queue_that_runs_the_task_line_will_do(self):
        if not shutil.which("parallel"):
            self.skipTest("GNU parallel is not installed; on Debian: apt install parallel")
        planned = farm(*self.render("out", "--tasks", 3, "--plan"))
        self.assertEqual(planned.returncode, 0, planned.stderr)
        line = planned.stdout.split(" K ")[0]
        early = farm("merge", self.folder / "out")
        self.assertEqual(early.returncode, 1)
        self.assertRegex(early.stderr, "tasks 0-2 of 3 are not done")
        subprocess.run(f"parallel --jobs 2 {line} {{}} ::: 0 1 2", shell=True, check=True,
                       capture_output=True)
        merged = farm("merge", self.folder / "out")
        self.assertEqual(merged.returncode, 0, merged.stderr)
        self.assert_as_one_process_does("out")

    def test_a_task_draws_what_is_missing_and_only_that(self):
        farm(*self.render("out", "--tasks", 1, "--plan"))
        farm("task", self.folder / "out", 0)
        frames = self.folder / "out" / "frames"
        for number in (3, 4, 7):
            (frames / f"frame_{number:04d}.png").unlink()
        before = {p.name: p.stat().st_mtime_ns for p in frames.glob("*")}
        self.assertEqual(farm("task", self.folder / "out", 0).returncode, 0)
        after = {p.name: p.stat().st_mtime_ns for p in frames.glob("*")}
        self.assertEqual(len(after), 12)
        self.assertEqual({n: after[n] for n in before}, before)

    def test_a_node_that_lacks_something_says_what(self):
        project, figure = self.folder / "mine.kfa", self.folder / "figure.json"
        shutil.copy(ROOT / "assets" / "figures" / "human.json", figure)
        project.write_text(json.dumps({**self.project(), "figure": {"file": "figure.json"}}))
        program = self.program("true")
        farm(*self.render("out", "--tasks", 2, "--plan", hazumi=program, file=project))
        project.write_text(project.read_text() + "\n")
        self.assert_task(65, f"{project}: is not the file that the farm was started with")
        figure.unlink()
        project.unlink()
        self.assert_task(66, "No such file or directory; it must be at the same place on all nodes")
        program.unlink()
        self.assert_task(66, f"there is no program {program}")
        (self.folder / "out" / "farm.json").unlink()
        self.assert_task(66, "lies on a disk that all nodes share")

    def assert_task(self, code, words):
        done = farm("task", self.folder / "out", 1, env={**os.environ, "SLURMD_NODENAME": "n7"})
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn("farm: node n7: ", done.stderr)
        self.assertIn(words, done.stderr)

    def test_no_slurm_and_one_that_does_not_answer(self):
        if not shutil.which("sbatch"):
            self.skipTest("sbatch is not installed")
        broken = farm(*self.render("out", "--tasks", 2),
                      env={**os.environ, "SLURM_CONF": str(self.folder / "no.conf")})
        self.assertEqual(broken.returncode, 1)
        self.assertIn("Slurm does not answer", broken.stderr)
        self.assertIn("--local-cluster", broken.stderr)
        bare = self.folder / "bin"
        bare.mkdir()
        (bare / "python3").symlink_to("/usr/bin/python3")
        absent = farm(*self.render("out", "--tasks", 2), env={**os.environ, "PATH": str(bare)})
        self.assertEqual(absent.returncode, 1)
        self.assertIn("sbatch is not installed", absent.stderr)
        none = farm("--local-cluster", "true",
                    env={**os.environ, "PATH": str(bare)}) if missing() else None
        if none:
            self.assertIn("apt install", none.stderr)

    def test_bad_input_is_refused_before_anything_is_sent(self):
        for words, code, says in (
                (self.render("out", "--tasks", 0), 2, "--tasks 0: has to be 1 or more"),
                (self.render("out", file=self.folder / "no.kfa"), 66, "no.kfa"),
                (self.render("out", hazumi="/no/hazumi"), 66, "/no/hazumi: there is no such"),
                (self.render("out") + ["--frames", "40..50"], 2, "has frames 0..30"),
                (self.render("out") + ["--size", "65x48"], 2, "videos have even sizes"),
                (self.render("out") + ["--wobble"], 2, "wobble"),
                (["render", THROW, "--out", "/dev/null/x", "--hazumi", HAZUMI], 73,
                 "/dev/null/x: cannot be written"),
                (["rend"], 2, "see scripts/farm --help")):
            done = farm(*words)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_bad_sweeps_are_refused_before_anything_is_sent(self):
        for changes, code, says in (
                ({"vary": [{"field": "regions[legs].weight", "values": [1]}]}, 65,
                 'no "legs" among "regions"'),
                ({"vary": []}, 65, "vary: is empty"),
                ({"vary": [{"field": FRICTION, "values": []}]}, 65, "vary[0]: has no values"),
                ({"vary": [{"field": FRICTION, "values": [2]}]}, 65, "must lie between 0 and 1"),
                ({"vary": [{"field": FRICTION, "from": 0, "to": 1, "count": 1000000},
                           {"field": "regions[arms].friction.joints[r_wrist]", "from": 0, "to": 1,
                            "count": 1000000}]}, 65, "1000000000000 cells"),
                ({"project": "no.kfa"}, 66, "no.kfa: cannot be read")):
            done = farm(*self.sweep("out", **changes))
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertFalse((self.folder / "out").exists())

    def test_a_sweep_goes_by_any_queue_with_or_without_the_farm(self):
        farm(*self.sweep("out", "--tasks", 3, "--plan"))
        for task in (0, 2):
            self.assertEqual(farm("task", self.folder / "out", task).returncode, 0)
        early = farm("merge", self.folder / "out")
        self.assertRegex(early.stderr, "tasks 1 of 3 are not done")
        run("--sweep", self.folder / "sweep.json", "--out", self.folder / "out", "--tasks", 3,
            "--task", 1)
        merged = farm("merge", self.folder / "out")
        self.assertEqual(merged.returncode, 0, merged.stderr)
        run("--sweep", self.folder / "sweep.json", "--out", self.folder / "one")
        self.assertEqual((self.folder / "out" / "sweep.csv").read_bytes(),
                         (self.folder / "one" / "sweep.csv").read_bytes())

    def test_the_frames_are_those_that_hazumi_draws(self):
        for options in ([], ["--fps", "7"], ["--fps", "29.97"], ["--fps", "30000/1001"],
                        ["--fps", "59.94", "--frames", "5..9"], ["--frames", "28..99"],
                        ["--frames", "3"]):
            first, last, _ = drawing.frames_of(HAZUMI, THROW, options)
            folder = self.folder / "-".join(options).replace("/", "_")
            run("--render", folder, "--size", "16x16", *options, THROW)
            names = sorted(p.name for p in folder.glob("*"))
            self.assertEqual((names[0], names[-1], len(names)),
                             (f"frame_{first:04d}.png", f"frame_{last:04d}.png", last - first + 1))


if __name__ == "__main__":
    main()
