"""Variations of a project: a task computes a share of the cells (hazumi --sweep with --tasks and
--task), a last call makes the table and the sheet of them (engine/sweep/README.md)."""

import subprocess
import sys
import time

from . import drawing
from .errors import FarmError

# As engine/sweep/sweep_store.cpp has it: rows are kept in blocks of cells, a file each.
CELLS_IN_BLOCK, MOST_BLOCKS = 20, 1000


def call(command):
    """What hazumi prints. Raises FarmError with its words."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise FarmError(drawing.last_line(done.stderr),
                        done.returncode if done.returncode > 0 else 1)
    for line in done.stderr.splitlines():
        if not line.startswith("sweep "):
            print(line, file=sys.stderr)
    return done.stdout


def plan_of(hazumi, file):
    """What is to be computed; `file` is absolute. Raises FarmError, with whatever is wrong."""
    cells = int(call([hazumi, "--sweep", str(file), "--count"]))
    return {"kind": "sweep", "file": str(file), "cells": cells}


class SweepWork:
    """The work of a plan in a folder."""

    unit = "cells"

    def __init__(self, folder, plan):
        self.folder, self.work = folder, plan["work"]
        self.hazumi, self.tasks = plan["hazumi"], plan["tasks"]
        self.block = max(CELLS_IN_BLOCK, -(-self.total() // MOST_BLOCKS))

    def total(self):
        return self.work["cells"]

    def most_tasks(self):
        """A task has a block or more."""
        return -(-self.total() // self.block)

    def done_blocks(self):
        """The blocks that are there: hazumi gives a file its name when it is whole."""
        names = (path.stem for path in (self.folder.path / "rows").glob("*.csv"))
        return {int(name) // self.block for name in names if name.isdigit()}

    def missing(self):
        return sorted(set(range(self.most_tasks())) - self.done_blocks())

    def progress(self):
        """The tasks that have nothing left to do, and how many cells are computed."""
        done, blocks = self.done_blocks(), self.most_tasks()
        tasks = {k for k in range(self.tasks) if done.issuperset(range(k, blocks, self.tasks))}
        cells = sum(min(self.block, self.total() - b * self.block) for b in done if b < blocks)
        return tasks, cells

    def command(self, tasks, task):
        return [self.hazumi, "--sweep", self.work["file"], "--out", str(self.folder.path),
                "--tasks", str(tasks), "--task", str(task)]

    def commands(self, task):
        """hazumi itself computes only what is left of a task."""
        return [self.command(self.tasks, task)]

    def try_out(self):
        """Computes the first missing block, so that what is wrong is known before anything is
        sent. Raises FarmError."""
        for block in self.missing()[:1]:
            call(self.command(self.most_tasks(), block))

    def measure(self):
        """Computes a block, and tells how long the others will take [s]."""
        begin = time.monotonic()
        self.try_out()
        return (time.monotonic() - begin) * len(self.missing())

    def merge(self):
        """The table and the sheet; lines that say where they are."""
        return call([self.hazumi, "--sweep", self.work["file"], "--out",
                     str(self.folder.path)]).splitlines()
