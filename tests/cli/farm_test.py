#!/usr/bin/env -S /usr/bin/python3
"""What scripts/farm does on a cluster of its own. usage: farm_test.py HAZUMI"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import unittest

from command_line import HAZUMI, ROOT, THROW, main, run
from farm_testing import (FARM, PATIENCE, FarmTest, OnACluster, farm, heed_interrupts, missing,
                          wait_until)

from farm_parts import processes, slurm
from farm_parts.errors import FarmError


class TwoNodes(OnACluster):
    def test_a_render_is_what_one_process_draws(self):
        done = farm(*self.render("out", "--tasks", 4))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4/4 tasks, 12/12 frames", done.stderr)
        self.assert_as_one_process_does("out")
        self.assertEqual([r["exit"] for r in self.reports("out")], [0] * 4)
        again = farm(*self.render("out", "--tasks", 4))
        self.assertEqual((again.returncode, again.stdout), (0, ""), again.stderr)
        self.assertIn("all is done", again.stderr)
        other = farm(*self.render("out"), "--ghosts", "5")
        self.assertEqual(other.returncode, 65)
        self.assertIn("has results of other work", other.stderr)

    def test_a_sweep_is_what_one_process_computes(self):
        done = farm(*self.sweep("out", "--tasks", 3, picture={
            "frames": [5], "options": ["--size", "32x24"]}))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("3/3 tasks, 50/50 cells", done.stderr)
        one, out = self.folder / "one", self.folder / "out"
        alone = run("--sweep", self.folder / "sweep.json", "--out", one)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        names = {str(p.relative_to(one)) for p in one.rglob("*") if p.is_file()}
        self.assertEqual(len(names), 3 + 3 + 50)  # plan, table, sheet, blocks, pictures
        for name in names:
            self.assertEqual((out / name).read_bytes(), (one / name).read_bytes(), name)
        again = farm(*self.sweep("out", picture={"frames": [5], "options": ["--size", "32x24"]}))
        self.assertIn("all is done", again.stderr)

    def test_cancelled_it_keeps_what_is_done_and_goes_on_later(self):
        child = self.start(self.render("out", "--tasks", 3, hazumi=self.program("sleep 60")))
        wait_until(lambda: self.job_processes("sleep"), "no task has started")
        cancelled = farm("cancel", self.folder / "out")
        self.assertEqual(cancelled.returncode, 0, cancelled.stderr)
        said = child.communicate(timeout=PATIENCE)[1]
        self.assertEqual(child.returncode, 1)
        self.assertRegex(said, "job .* was cancelled with 3 tasks left; the same command goes on")
        self.assertEqual(self.job_processes("sleep"), [])
        self.assertIn("no job is at it", farm("cancel", self.folder / "out").stderr)
        done = farm(*self.render("out"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_as_one_process_does("out")

    def test_interrupted_it_says_how_to_go_on(self):
        child = self.start(self.render("out", "--tasks", 2, hazumi=self.program("sleep 2")))
        wait_until(lambda: self.job_processes("sleep"), "no task has started")
        child.send_signal(signal.SIGINT)
        said = child.communicate(timeout=PATIENCE)[1]
        self.assertEqual(child.returncode, 130)
        self.assertIn("interrupted", said)
        watched = farm("watch", self.folder / "out")
        self.assertEqual(watched.returncode, 0, watched.stderr)
        self.assert_as_one_process_does("out")

    def test_a_task_that_was_killed_is_sent_again(self):
        """Not by Slurm, for which it only ended: the farm finds no report of it."""
        once = self.folder / "once"
        killer = self.program(f"if mkdir {once} 2>/dev/null; then kill -9 $PPID $$; fi")
        done = farm(*self.render("out", "--tasks", 3, hazumi=killer))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("1 tasks ended without a result; sent again", done.stderr)
        self.assert_as_one_process_does("out")

    def test_an_error_names_node_file_and_remedy_and_loses_nothing(self):
        project = self.folder / "mine.kfa"
        figure = self.folder / "figure.json"
        shutil.copy(ROOT / "assets" / "figures" / "human.json", figure)
        project.write_text(json.dumps({**self.project(), "figure": {"file": "figure.json"}}))
        program = self.program(f"rm -f {figure}")
        done = farm(*self.render("out", "--tasks", 2, hazumi=program, file=project))
        self.assertEqual(done.returncode, 66, done.stderr)
        self.assertRegex(done.stderr, r"task \d on node [ab]: .*figure.json.*No such file")
        self.assertRegex(done.stderr, "tasks failed; what is done is kept in .*, logs in .*/logs")
        self.assertTrue((self.folder / "out" / "frames" / "frame_0000.png").exists())

    def test_a_full_disk_is_named_and_loses_nothing(self):
        with self.small_disk("128k") as disk:
            done = farm("render", THROW, "--out", disk / "out", "--hazumi", HAZUMI, "--tasks", 2,
                        "--", "--size", "320x180")
            self.assertEqual(done.returncode, 73, done.stderr)
            self.assertRegex(done.stderr, "No space left|disk is full")
            self.assertIn("what is done is kept", done.stderr)
            kept = sorted((disk / "out" / "frames").glob("*.png"))
            self.assertGreater(len(kept), 0)
            subprocess.run(["mount", "-o", "remount,size=20m", disk], check=True)
            whole = farm("render", THROW, "--out", disk / "out", "--hazumi", HAZUMI, "--tasks", 2,
                         "--", "--size", "320x180")
            self.assertEqual(whole.returncode, 0, whole.stderr)

    def test_too_many_tasks_are_refused(self):
        with self.assertRaisesRegex(FarmError, "more than the cluster takes"):
            slurm.submit(FARM, FakeFolder(self.folder), range(0, 5000))

    def test_z_a_node_that_is_lost_takes_nothing_with_it(self):
        """Last, by its name: there is one node from then on."""
        child = self.start(self.render("out", "--tasks", 5, hazumi=self.program("sleep 1")))
        wait_until(lambda: processes.running_on(self.place, "b") & set(self.job_processes("sleep")),
                   "node b got no task")
        processes.kill_node(self.place, "b")
        out, said = child.communicate(timeout=PATIENCE)
        self.assertEqual(child.returncode, 0, said)
        self.assert_as_one_process_does("out")
        again = [r for r in self.reports("out") if r["restarts"]]
        self.assertEqual([(r["node"], r["exit"]) for r in again], [("a", 0)], said)


@unittest.skipIf(missing(), missing())
class ItsOwnCluster(FarmTest):
    def test_ctrl_c_ends_the_command_and_then_the_cluster(self):
        command = ("trap 'echo ended; kill $!; exit 7' INT; echo $HAZUMI_LOCAL_CLUSTER; "
                   "sleep 50 >/dev/null & wait")
        child = subprocess.Popen([FARM, "--local-cluster", "sh", "-c", command], text=True,
                                 stdout=subprocess.PIPE, start_new_session=True,
                                 preexec_fn=heed_interrupts)
        place = pathlib.Path(child.stdout.readline().strip())
        self.assertTrue((place / "slurm.conf").exists())
        daemons = {pid for pid in processes.descendants(processes.table(), {child.pid})
                   if processes.table()[pid][2] in ("munged", "slurmctld", "slurmd")}
        self.assertEqual(len(daemons), 4)
        os.killpg(child.pid, signal.SIGINT)
        self.assertEqual(child.communicate(timeout=PATIENCE)[0], "ended\n")
        self.assertEqual(child.returncode, 130)
        self.assertEqual(daemons & processes.table().keys(), set())
        self.assertFalse(place.exists())


class FakeFolder:
    """As much of a folder as sending needs."""

    def __init__(self, path):
        self.path = self.logs = path


if __name__ == "__main__":
    main()
