#!/usr/bin/env -S /usr/bin/python3
"""What scripts/farm does on a cluster of its own, and without one. usage: farm_test.py HAZUMI"""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from command_line import HAZUMI, ROOT, THROW, InFolder, run

sys.path.insert(0, str(ROOT / "scripts"))
from farm_parts import drawing, processes, slurm  # noqa: E402
from farm_parts.errors import FarmError  # noqa: E402
from farm_parts.local_cluster import find_programs  # noqa: E402

FARM = ROOT / "scripts" / "farm"
SMALL = ["--size", "64x48", "--frames", "0..11"]
PATIENCE = 60  # [s]


def missing():
    """Why there is no cluster to test with, or None."""
    try:
        find_programs()
    except FarmError as error:
        return str(error)
    return None


def farm(*arguments, **more):
    return subprocess.run([FARM, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          **more)


def heed_interrupts():
    """In a child, whatever the test's own parent ignores."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def wait_until(is_so, what):
    end = time.monotonic() + PATIENCE
    while not is_so():
        if time.monotonic() > end:
            raise AssertionError(what)
        time.sleep(0.05)


class FarmTest(InFolder):
    """What the tests with and without a cluster share."""

    one_process = None  # frames, sheet and video of one, drawn once

    def program(self, line):
        """hazumi, which first does something where a node runs it."""
        path = self.folder / "hazumi"
        path.write_text(f'#!/bin/sh\n[ -z "$SLURM_JOB_ID" ] || {line}\nexec {HAZUMI} "$@"\n')
        path.chmod(0o755)
        return path

    def render(self, out, *options, hazumi=HAZUMI, file=THROW):
        """The words of a command."""
        return ["render", file, "--out", self.folder / out, "--hazumi", hazumi, *options, "--",
                *SMALL]

    def reports(self, out):
        return [json.loads(p.read_text()) for p in (self.folder / out / "logs").glob("*.json")]

    def contents(self, folder):
        """Frames, sheet and video, to the byte."""
        files = [*(folder / "frames").glob("*"), folder / "sheet.png", folder / "video.mp4"]
        return {path.name: path.read_bytes() for path in files}

    def draw_by_one_process(self):
        one = self.folder / "one"
        self.assertEqual(run("--render", one / "frames", *SMALL, THROW).returncode, 0)
        self.assertEqual(run("--export", one / "video.mp4", *SMALL, THROW).returncode, 0)
        subprocess.run([ROOT / "scripts" / "contact_sheet", one / "frames", one / "sheet.png"],
                       check=True, capture_output=True)
        FarmTest.one_process = self.contents(one)

    def assert_as_one_process_does(self, out):
        if not FarmTest.one_process:
            self.draw_by_one_process()
        self.assertEqual(len(FarmTest.one_process), 14)
        self.assertEqual(self.contents(self.folder / out), FarmTest.one_process)


@unittest.skipIf(missing(), missing())
class OnACluster(FarmTest):
    @classmethod
    def setUpClass(cls):
        cls.cluster = subprocess.Popen([FARM, "--local-cluster"], text=True, stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE)
        lines = [cls.cluster.stdout.readline() for _ in range(2)]
        values = dict(re.match(r"export (\w+)='(.*)'", line).groups() for line in lines)
        os.environ.update(values)
        cls.place = pathlib.Path(values["HAZUMI_LOCAL_CLUSTER"])

    @classmethod
    def tearDownClass(cls):
        """Ended by SIGTERM while a job runs, it leaves no process and no file."""
        subprocess.run(["sbatch", "--output=/dev/null"], input="#!/bin/sh\nsleep 500 & sleep 600\n",
                       text=True, check=True, capture_output=True)
        wait_until(lambda: cls.job_processes("sleep"), "no job has started")
        own = processes.descendants(processes.table(), {cls.cluster.pid})
        assert len(own) >= 8, own  # farm, munged, slurmctld, two slurmd, a step and its three
        cls.cluster.send_signal(signal.SIGTERM)
        said = cls.cluster.communicate(timeout=30)[1]
        left = own & processes.table().keys()
        assert (cls.cluster.returncode, left) == (128 + signal.SIGTERM, set()), (said, left)
        assert not cls.place.exists()
        del os.environ["SLURM_CONF"], os.environ["HAZUMI_LOCAL_CLUSTER"]

    @classmethod
    def job_processes(cls, name):
        table = processes.table()
        own = processes.descendants(table, {cls.cluster.pid})
        return [pid for pid in own if pid in table and table[pid][2] == name]

    def start(self, words):
        return subprocess.Popen([FARM, *map(str, words)], text=True, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, preexec_fn=heed_interrupts)

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
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "none", disk],
                                 capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("no right to mount a small disk")
        try:
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
        finally:
            subprocess.run(["umount", disk], check=True)

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
    unittest.main()
