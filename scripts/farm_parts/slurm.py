"""The commands of Slurm, by what they print: neither accounting nor a database is needed."""

import os
import re
import shutil
import subprocess

from .errors import FarmError, USAGE

ANSWERS_WITHIN = 60  # [s]
# Of squeue: the queue has forgotten the job, as all of it has ended.
FORGOTTEN = "Invalid job id"
# Of any command: there is nobody who knows.
SILENT = "contact|connect|timed out|configuration|authentic|munge"


def call(*arguments, text=None):
    """What a command prints. Raises FarmError."""
    if not shutil.which(arguments[0]):
        raise FarmError(
            f"{arguments[0]} is not installed on this machine; on Debian: apt install "
            "slurm-client. Another queue runs the tasks as well: scripts/farm --help")
    conf = os.environ.get("SLURM_CONF")
    if conf and not os.path.exists(conf):  # for which Slurm would wait a minute
        raise no_answer(f"SLURM_CONF: there is no file {conf}")
    try:
        done = subprocess.run([*map(str, arguments)], input=text, capture_output=True, text=True,
                              timeout=ANSWERS_WITHIN, check=False,
                              env={**os.environ, "SLURM_BITSTR_LEN": "0"})  # lists in full
    except subprocess.TimeoutExpired as error:
        raise no_answer(f"{arguments[0]} had no answer in {ANSWERS_WITHIN} s") from error
    if done.returncode == 0:
        return done.stdout
    says = done.stderr.strip().splitlines() or [f"ended with {done.returncode}"]
    if any(re.search(SILENT, line) for line in says):
        raise no_answer(f"{arguments[0]}: {says[-1]}")
    raise FarmError(f"{arguments[0]}: {says[0]}")


def no_answer(what):
    return FarmError(f"Slurm does not answer ({what}); is this a machine of the cluster, and is "
                     "SLURM_CONF, if set, its file? scripts/farm --local-cluster starts one here")


def ranges(numbers):
    """Sorted numbers as sbatch takes them: 0-3,5."""
    found = []
    for number in numbers:
        if found and number == found[-1][1] + 1:
            found[-1][1] = number
        else:
            found.append([number, number])
    return ",".join(f"{a}-{b}" if a < b else f"{a}" for a, b in found)


def script(command, folder):
    """What a node runs for a task: COMMAND task FOLDER K. The node's own words where it cannot."""
    return f"""#!/bin/sh
[ -x {quote(command)} ] || {{
  echo "farm: node $SLURMD_NODENAME: there is no" {quote(command)}"; it must be at the same" \\
    "place on all nodes" >&2
  exit 66
}}
exec {quote(command)} task {quote(folder)} "$SLURM_ARRAY_TASK_ID"
"""


def quote(path):
    """For sh."""
    return "'" + str(path).replace("'", "'\\''") + "'"


def submit(command, folder, tasks):
    """Sends tasks as one array job, started again if a node is lost; its number."""
    log = str(folder.logs).replace("%", "%%") + "/task_%a.log"
    try:
        answer = call("sbatch", "--parsable", f"--array={ranges(tasks)}", "--requeue",
                      "--open-mode=append", f"--output={log}", "--chdir=/", "--ntasks=1",
                      "--job-name=hazumi-farm", f"--comment={folder.path}",
                      text=script(command, folder.path))
    except FarmError as error:
        if "array" in str(error):
            raise FarmError(f"{error}: {len(tasks)} tasks, the last {tasks[-1]}, are more than the "
                            "cluster takes (scontrol show config: MaxArraySize); give fewer with "
                            "--tasks", USAGE) from error
        raise
    return int(answer.split(";")[0])


def queue(job, folder):
    """What of a folder's job has not ended: (tasks, state, node, reason) of each line of squeue,
    tasks as a number of them. Empty: all has ended."""
    try:
        lines = call("squeue", "--noheader", "--jobs", job, "--format",
                     "%K|%T|%N|%r|%k").splitlines()
    except FarmError as error:
        if FORGOTTEN in str(error):
            return []
        raise
    found = []
    for line in lines:
        tasks, state, node, reason, comment = line.split("|", 4)
        if comment == str(folder.path):  # else another cluster's job of the same number
            found.append((count(tasks), state, node, reason))
    return found


def count(tasks):
    """How many tasks 0-3,5%2 are."""
    parts = [part.split("-") for part in tasks.split("%")[0].split(",")]
    return sum(int(ends[-1]) - int(ends[0]) + 1 for ends in parts)


def ending(job, task):
    """How a task ended, as Slurm keeps it for some minutes: its words, or that it has forgotten."""
    try:
        records = call("scontrol", "--oneliner", "show", "job", job).splitlines()
    except FarmError:
        records = []
    for record in records:
        fields = dict(re.findall(r"(\w+)=(\S*)", record))
        if fields.get("ArrayTaskId") == str(task):
            return (f"{fields.get('JobState')} on node {fields.get('NodeList')}, exit "
                    f"{fields.get('ExitCode')}, {fields.get('Reason')}")
    return "Slurm keeps nothing of it"


def is_cancelled(job):
    """Somebody cancelled tasks of it."""
    try:
        return "JobState=CANCELLED" in call("scontrol", "--oneliner", "show", "job", job)
    except FarmError:
        return False


def cancel(job, folder):
    """Ends all tasks of a folder's job. True: there was one."""
    if not queue(job, folder):
        return False
    call("scancel", job)
    return True
