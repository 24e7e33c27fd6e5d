"""What the tests of the command line share. Each is called with the path of hazumi."""

import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import data_folder  # noqa: E402
from skips import main  # noqa: E402,F401

THROW = ROOT / "assets" / "examples" / "throw.kfa"
JUMP = ROOT / "assets" / "examples" / "jump.kfa"
HAZUMI = os.path.abspath(sys.argv.pop(1))


# Prefix of a command that makes root obey file permissions.
AS_ANY_USER = ["setpriv", "--bounding-set=-dac_override,-dac_read_search"] if os.geteuid() == 0 else []


def run(*arguments, before=(), program=HAZUMI, **more):
    command = [*before, program, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, **more)


def start(*arguments, inherited=signal.SIG_DFL, program=HAZUMI, **more):
    """Starts without the signals that the test's own parent may ignore, or with them ignored."""
    return subprocess.Popen([program, *map(str, arguments)], text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            preexec_fn=lambda: signal.signal(signal.SIGINT, inherited), **more)


def wait_until_it_handles(process, number):
    """Until a program has come so far that a signal no longer ends it at once."""
    status = pathlib.Path(f"/proc/{process.pid}/status")
    for _ in range(6000):
        caught = re.search(r"^SigCgt:\s*([0-9a-f]+)", status.read_text(), re.M)
        if int(caught[1], 16) >> (number - 1) & 1:
            return
        time.sleep(0.01)
    raise AssertionError(f"it does not handle signal {number}")


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hazumi-cli-"))

    def tearDown(self):
        subprocess.run(["chmod", "-R", "u+w", self.folder], check=True)
        subprocess.run(["rm", "-rf", self.folder], check=True)

    def program_with_reader(self, commands=None):
        """A copy of hazumi beside a reader that does these shell commands, or beside none."""
        folder = pathlib.Path(tempfile.mkdtemp(prefix="hazumi-copy-"))
        self.addCleanup(shutil.rmtree, folder)
        shutil.copy(HAZUMI, folder / "hazumi")
        if commands is not None:
            (folder / "hazumi-reader").write_text(f"#!/bin/sh\n{commands}\n")
            (folder / "hazumi-reader").chmod(0o755)
        return folder / "hazumi"

    def project(self):
        """The throw, to be changed and written anywhere."""
        project = json.loads(THROW.read_text())
        project["figure"] = {"file": str(ROOT / "assets" / "figures" / "human.json")}
        return project

    def data_files(self, folder, pattern):
        """Of the data beside the repository. Without them it fails where HAZUMI_DATA is set, and
        is skipped elsewhere."""
        found = sorted(data_folder.path(folder).glob(pattern))
        if not found:
            missing = f"no data: {data_folder.path(folder) / pattern}"
            self.fail(missing) if data_folder.is_promised() else self.skipTest(missing)
        return found

    @contextlib.contextmanager
    def small_disk(self, size):
        """A folder on a disk of its own, "64k" large, as long as it is used. Skipped where none can
        be mounted."""
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", disk],
                                 capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("not here: no right to mount a small disk")
        try:
            yield disk
        finally:
            subprocess.run(["umount", disk], check=True)

    def files(self):
        return sorted(p.name for p in self.folder.rglob("*") if p.is_file())

    def peak(self, *arguments):
        """What a task says and ends with, and the most memory that it took [MB]."""
        child = start(*arguments)
        out, complaint = child.stdout.read(), child.stderr.read()
        child.stdout.close()
        child.stderr.close()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        # A sanitizer takes several times what the program does.
        is_sanitized = os.environ.get("HAZUMI_SANITIZE", "") != ""
        return child.returncode, out, complaint, 0 if is_sanitized else usage.ru_maxrss / 1024
