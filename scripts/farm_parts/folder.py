"""The folder of a farm's work, which all nodes share.

farm.json   the plan: what is to be done, in how many tasks, and the number of its job
logs/       task_K.log: what task K said; task_K.json: how it ended
The rest is the work's own: frames/, video.mp4, sheet.png; or the files of a sweep."""

import errno
import hashlib
import json
import os
import pathlib

from .errors import BAD_DATA, CANNOT_WRITE, NO_INPUT, USAGE, FarmError


def write_whole(path, text):
    """All or nothing: a temporary file takes the name when it is whole."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise cannot_write(path, error) from error


def cannot_write(path, error):
    """The FarmError for an OSError."""
    remedy = {errno.ENOSPC: "make room on its disk, then run the same command again",
              errno.EACCES: "choose a folder that you may write",
              errno.EROFS: "choose a folder on a disk that can be written"}
    more = remedy.get(error.errno, "choose another folder with --out")
    return FarmError(f"{path}: cannot be written: {error.strerror}; {more}", CANNOT_WRITE)


def digest(path):
    """SHA-256 of a file. Raises OSError."""
    with open(path, "rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def files_named_in(path):
    """The files that a project or a sweep names, and those that they name: absolute paths."""
    found, waiting = [], [path]
    while waiting:
        here = waiting.pop()
        try:
            document = json.loads(here.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            continue  # no JSON: it names nothing
        for name in names_in(document if isinstance(document, dict) else {}):
            there = pathlib.Path(os.path.abspath(here.parent / name))
            if there.is_file() and there not in found and there != path:
                found.append(there)
                waiting.append(there)
    return found


def names_in(value):
    """What stands behind "file" or "project" anywhere in a JSON document."""
    pairs = value.items() if isinstance(value, dict) else enumerate(value)
    for key, child in pairs:
        if isinstance(child, str) and key in ("file", "project"):
            yield child
        elif isinstance(child, (dict, list)):
            yield from names_in(child)


class Folder:
    """Where the plan, the logs and the results are."""

    def __init__(self, path):
        self.path = pathlib.Path(os.path.abspath(path))
        if "\\" in str(self.path) or not str(self.path).isprintable():
            raise FarmError(f"{self.path}: Slurm cannot write logs into a folder with a backslash "
                            "or a control character in its name; choose another", USAGE)
        self.logs = self.path / "logs"
        self.plan_file = self.path / "farm.json"

    def make(self):
        """Makes it where it is not there. Raises FarmError."""
        try:
            self.logs.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise cannot_write(self.path, error) from error

    def has_plan(self):
        return self.plan_file.exists()

    def load(self):
        """The plan. Raises FarmError."""
        try:
            plan = json.loads(self.plan_file.read_text(encoding="utf-8"))
        except OSError as error:
            raise FarmError(f"{self.plan_file}: cannot be read: {error.strerror}; a farm's folder "
                            "lies on a disk that all nodes share", NO_INPUT) from error
        except ValueError as error:
            raise self.no_plan(error) from error
        if not isinstance(plan, dict) or not {"work", "tasks", "job"} <= plan.keys():
            raise self.no_plan("it lacks work, tasks or job")
        return plan

    def no_plan(self, why):
        return FarmError(f"{self.plan_file}: is no plan of a farm: {why}; remove it and run "
                         "scripts/farm render or sweep again", BAD_DATA)

    def save(self, plan):
        write_whole(self.plan_file, json.dumps(plan, indent=1) + "\n")

    def log_of(self, task):
        return self.logs / f"task_{task}.log"

    def report_file(self, task):
        return self.logs / f"task_{task}.json"

    def report(self, task):
        """How a task ended: {"exit", "node", "seconds", "message"}; None: it has not."""
        try:
            return json.loads(self.report_file(task).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
