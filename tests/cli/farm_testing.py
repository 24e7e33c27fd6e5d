"""What the tests of scripts/farm share. Each is called with the path of hazumi."""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

from command_line import HAZUMI, ROOT, THROW, InFolder, run

sys.path.insert(0, str(ROOT / "scripts"))
from farm_parts import processes  # noqa: E402
from farm_parts.errors import FarmError  # noqa: E402
from farm_parts.local_cluster import find_programs  # noqa: E402

FARM = ROOT / "scripts" / "farm"
SMALL = ["--size", "64x48", "--frames", "0..11"]
FRICTION = "regions[arms].friction.default"
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

    def sweep_file(self, **changes):
        """A sweep of 50 cells, three blocks of them."""
        path = self.folder / "sweep.json"
        path.write_text(json.dumps({
            "format": "hazumi-sweep", "version": 1, "project": str(THROW),
            "vary": [{"field": FRICTION, "from": 0.51, "to": 1, "count": 10},
                     {"field": "held_objects[ball].release_frame", "from": 8, "to": 12,
                      "count": 5}], **changes}))
        return path

    def sweep(self, out, *options, **changes):
        """The words of a command."""
        return ["sweep", self.sweep_file(**changes), "--out", self.folder / out, "--hazumi", HAZUMI,
                *options]

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
    """Tests with a cluster of two nodes, which is started once."""

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
