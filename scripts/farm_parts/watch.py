"""From a plan to its result: sends the tasks, shows progress, sends again what a node took with it,
and merges when all is there."""

import collections
import math
import os
import pathlib
import shutil
import sys
import time

from . import slurm
from .errors import CANNOT_WRITE, FAILED, FarmError
from .work import work_of

COMMAND = pathlib.Path(__file__).resolve().parents[1] / "farm"
POLL = 0.5           # [s]; for many tasks longer
SENT_AGAIN = 3       # times, where a task ended without a word
SILENCES = 3         # times in a row that Slurm may leave unanswered
SHOWN = 5            # errors
LINGERS = 5.0        # a job with nothing left to do [s]


class Progress:
    """One line that is written again on a terminal; elsewhere a line whenever it says something
    new, every few seconds at most."""

    def __init__(self, pause=5.0):
        self.last, self.at, self.pause = "", 0.0, pause
        self.on_terminal = sys.stderr.isatty()

    def show(self, text, is_last=False):
        if self.on_terminal:
            width = shutil.get_terminal_size().columns - 1
            end = "\n" if is_last else ""
            print(f"\r{text[:width]:{width}}", end=end, file=sys.stderr, flush=True)
        elif text != self.last and (is_last or time.monotonic() - self.at >= self.pause):
            print(text, file=sys.stderr, flush=True)
            self.last, self.at = text, time.monotonic()


def line_of(work, queue):
    """Tasks and frames or cells that are done, nodes that work, and why the others wait."""
    done, parts = work.progress()
    running = sorted(node for _, state, node, _ in queue if state == "RUNNING")
    waiting = collections.Counter()
    for count, state, _, reason in queue:
        if state == "PENDING":
            waiting[reason] += count
    text = f"farm: {len(done)}/{work.tasks} tasks, {parts}/{work.total()} {work.unit}"
    if running:
        nodes = collections.Counter(running)
        names = ", ".join(n if c == 1 else f"{n} ({c})" for n, c in list(nodes.items())[:6])
        text += f"; {len(running)} run on {names}"
    for reason, count in waiting.items():
        text += f"; {count} wait ({reason})"
    return text


def send(folder, plan):
    """Submits what is not done as one array job, and notes its number in the plan."""
    work = work_of(folder, plan)
    done, _ = work.progress()
    tasks = [k for k in range(work.tasks) if k not in done]
    if not tasks:
        return
    for task in tasks:
        folder.report_file(task).unlink(missing_ok=True)
        folder.log_of(task).unlink(missing_ok=True)
    plan["job"], plan["merged"] = slurm.submit(COMMAND, folder, tasks), False
    folder.save(plan)
    print(f"farm: job {plan['job']}: {len(tasks)} tasks; progress: {COMMAND} watch {folder.path}; "
          f"to end it: {COMMAND} cancel {folder.path}", file=sys.stderr, flush=True)


def await_job(folder, plan):
    """Until all is done or the job is. Raises FarmError where Slurm is silent or holds the job."""
    work, progress, done_at = work_of(folder, plan), Progress(), math.inf
    while True:
        queue = patient_queue(folder, plan["job"])
        done, _ = work.progress()
        if len(done) == work.tasks:
            done_at = min(done_at, time.monotonic())
        is_over = not queue or time.monotonic() >= done_at + LINGERS
        progress.show(line_of(work, queue), is_over)
        if is_over:
            break
        refuse_held(folder, plan["job"], queue)
        time.sleep(POLL * min(max(work.tasks / 50, 1), 20))
    if queue:  # of a node that is lost with its work done, which would be started again
        slurm.cancel(plan["job"], folder)


def patient_queue(folder, job):
    """The job's queue, asked for again where Slurm is silent. Raises FarmError in the end."""
    for silences in range(SILENCES):
        try:
            return slurm.queue(job, folder)
        except FarmError:
            if silences == SILENCES - 1:
                raise
            time.sleep(POLL)
    return []


def refuse_held(folder, job, queue):
    """Nobody would ever start these."""
    for _, state, _, reason in queue:
        if state == "PENDING" and "held" in reason.lower():
            raise FarmError(f"job {job} is held ({reason}): scontrol release {job} lets it go on, "
                            f"{COMMAND} cancel {folder.path} ends it")


def problems(folder, plan):
    """Of the tasks that are not done: those with an error, as (code, line), and those that ended
    without a word."""
    work, errors, lost = work_of(folder, plan), [], []
    done, _ = work.progress()
    for task in range(work.tasks):
        report = folder.report(task)
        if task in done:
            continue
        if report and report["exit"]:
            errors.append((report["exit"], f"task {task} on node {report['node']}: "
                                           f"{report['message']}"))
        else:
            lost.append(task)
    return errors, lost


def free_bytes(folder):
    status = os.statvfs(folder.path)
    return status.f_bavail * status.f_frsize


def last_words(folder, job, task):
    """What is known of a task that left no report."""
    try:
        lines = folder.log_of(task).read_text(errors="replace").splitlines()
    except OSError:
        lines = []
    return f"task {task}: {lines[-1] if lines else 'no word'} ({slurm.ending(job, task)})"


def refuse(folder, errors):
    """Raises FarmError with the first errors, and the code of the first."""
    for _, line in errors[:SHOWN]:
        print(f"farm: {line}", file=sys.stderr)
    more = f" ({len(errors) - SHOWN} more are in the logs)" if len(errors) > SHOWN else ""
    raise FarmError(f"{len(errors)} tasks failed{more}; what is done is kept in {folder.path}, "
                    f"logs in {folder.logs}; the same command goes on once the cause is mended",
                    errors[0][0])


def finish_tasks(folder, plan):
    """Until every task is done; what was lost is sent again. Raises FarmError."""
    for _ in range(SENT_AGAIN + 1):
        await_job(folder, plan)
        errors, lost = problems(folder, plan)
        if errors:
            refuse(folder, errors)
        if not lost:
            return
        if slurm.is_cancelled(plan["job"]):
            raise FarmError(f"job {plan['job']} was cancelled with {len(lost)} tasks left; the "
                            "same command goes on with them")
        words = [last_words(folder, plan["job"], task) for task in lost]
        if free_bytes(folder) == 0:
            raise FarmError(f"{folder.path}: its disk is full; make room, then run the same "
                            f"command again: what is done is kept. {words[0]}", CANNOT_WRITE)
        print("\n".join(f"farm: {line}" for line in words[:SHOWN]), file=sys.stderr)
        print(f"farm: {len(lost)} tasks ended without a result; sent again", file=sys.stderr)
        send(folder, plan)
    refuse(folder, [(FAILED, line) for line in words])


def merge(folder, plan):
    """The results of all tasks, if they are there. Raises FarmError."""
    errors, lost = problems(folder, plan)
    if errors:
        refuse(folder, errors)
    if lost:
        raise FarmError(f"{folder.path}: tasks {slurm.ranges(lost)} of {plan['tasks']} are not "
                        f"done; {COMMAND} task {folder.path} K does task K")
    for line in work_of(folder, plan).merge():
        print(line, flush=True)
    plan["job"], plan["merged"] = None, True
    folder.save(plan)


def watch(folder, plan):
    """Goes on with what was sent, if something was, and merges."""
    if plan["job"] is not None:
        try:
            finish_tasks(folder, plan)
        except KeyboardInterrupt:
            tell_how_to_go_on(folder, plan)
            raise
    merge(folder, plan)


def tell_how_to_go_on(folder, plan):
    """On Ctrl+C."""
    if "HAZUMI_LOCAL_CLUSTER" in os.environ:
        print("\nfarm: interrupted, and the local cluster with it; the same command goes on with "
              "what is missing", file=sys.stderr)
        return
    print(f"\nfarm: job {plan['job']} goes on; progress and merge: {COMMAND} watch {folder.path}; "
          f"to end it: {COMMAND} cancel {folder.path}", file=sys.stderr)
