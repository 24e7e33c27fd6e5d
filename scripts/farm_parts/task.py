"""One task, on whatever node: checks that the node has what it takes, does what is left of the
task's share, and reports how it ended."""

import json
import os
import pathlib
import socket
import subprocess
import sys
import time

from . import drawing
from .errors import BAD_DATA, FAILED, NO_INPUT, USAGE, FarmError
from .folder import digest, write_whole
from .work import work_of


def node_name():
    return os.environ.get("SLURMD_NODENAME") or socket.gethostname()


def check_node(plan):
    """Raises FarmError where hazumi or a file is missing here, or another file than was planned."""
    if not os.access(plan["hazumi"], os.X_OK):
        raise FarmError(f"there is no program {plan['hazumi']}; it must be at the same place on "
                        "all nodes: install it, or give another with --hazumi", NO_INPUT)
    for path, wanted in plan["inputs"].items():
        try:
            found = digest(path)
        except OSError as error:
            raise FarmError(f"{path}: {error.strerror}; it must be at the same place on all nodes: "
                            "copy it there, or put it on a disk that they share",
                            NO_INPUT) from error
        if found != wanted:
            raise FarmError(f"{path}: is not the file that the farm was started with; copy that "
                            "one to this node, or choose another --out for the new one", BAD_DATA)


def say(text):
    """Into the task's log. Where its disk is full the exit code alone tells of it."""
    try:
        print(text, file=sys.stderr, flush=True)
    except OSError:
        pass


def run(command):
    """Runs hazumi; its progress is left out of the log. Raises FarmError with its last words."""
    last = ""
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as child:
        try:
            for line in child.stderr:
                if not line.startswith(("render ", "sweep ")):
                    say(line.rstrip("\n"))
                    last += line
        except BaseException:
            child.terminate()
            raise
    if child.returncode != 0:
        killed = f"ended by signal {-child.returncode}" if child.returncode < 0 else ""
        raise FarmError(killed or drawing.last_line(last),
                        FAILED if child.returncode < 0 else child.returncode)


def run_task(folder, task):
    """Does task K of the plan in a folder. Returns the exit code."""
    node, begin, message, code = node_name(), time.monotonic(), "", 0
    try:
        plan = folder.load()
        if not 0 <= task < plan["tasks"]:
            raise FarmError(f"task {task}: {folder.path} has tasks 0 to {plan['tasks'] - 1}", USAGE)
        folder.report_file(task).unlink(missing_ok=True)
        check_node(plan)
        for command in work_of(folder, plan).commands(task):
            run(command)
    except FarmError as error:
        message, code = str(error), error.code
        say(f"farm: node {node}: {message}")
    seconds = round(time.monotonic() - begin, 3)
    report = {"exit": code, "node": node, "seconds": seconds, "message": message,
              "restarts": int(os.environ.get("SLURM_RESTART_COUNT", 0))}
    try:
        write_whole(pathlib.Path(folder.report_file(task)), json.dumps(report) + "\n")
    except FarmError as error:
        say(f"farm: node {node}: {error}")
        code = code or error.code
    return code
