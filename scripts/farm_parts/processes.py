"""Which processes a local cluster's jobs consist of, as Linux knows them: orphans come to this
program, so that none of its descendants gets away."""

import ctypes
import os
import pathlib
import signal
import time

PR_SET_CHILD_SUBREAPER = 36
ROUNDS = 100  # of looking for what was started meanwhile


def adopt_orphans():
    """What a descendant leaves becomes a child of this process."""
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) != 0:
        raise OSError(ctypes.get_errno(), "prctl: orphans cannot be adopted")


def table():
    """Of every process: its parent, state and name."""
    found = {}
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            before, _, after = (path / "stat").read_text().rpartition(")")
        except OSError:
            continue  # it has gone
        state, parent = after.split()[:2]
        found[int(path.name)] = (int(parent), state, before.partition("(")[2])
    return found


def descendants(processes, roots):
    """All below some processes, those included."""
    found = set(roots)
    while True:
        more = {pid for pid, (parent, _, _) in processes.items() if parent in found} - found
        if not more:
            return found
        found |= more


def node_of(pid, conf):
    """The node on which it is part of a job of the cluster with this configuration; None."""
    try:
        words = pathlib.Path(f"/proc/{pid}/environ").read_bytes().decode(errors="replace")
    except OSError:
        return None
    values = dict(word.split("=", 1) for word in words.split("\0") if "=" in word)
    return values.get("SLURMD_NODENAME") if values.get("SLURM_CONF") == conf else None


def steps(conf):
    """The processes of jobs that are alive: slurmstepd, what is below, and what it left."""
    processes = table()
    own = descendants(processes, {os.getpid()}) - {os.getpid()}
    roots = {pid for pid in own if processes.get(pid, (0, "", ""))[2] == "slurmstepd"
             or node_of(pid, conf)}
    return {pid for pid in descendants(processes, roots) if processes[pid][1] != "Z"}


def end_steps(conf):
    """Ends them all, also what they start meanwhile."""
    for _ in range(ROUNDS):
        left = steps(conf)
        if not left:
            break
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        reap_orphans(())
        time.sleep(0.02)
    reap_orphans(())


def kill_node(cluster, node):
    """As if a node of the cluster in this folder had lost its power: its daemon and all that runs
    there."""
    slurmd = int((pathlib.Path(cluster) / f"slurmd_{node}.pid").read_text())
    for pid in {slurmd} | running_on(cluster, node):
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


def running_on(cluster, node):
    """The processes of a node's jobs, and the slurmstepd above them."""
    processes, conf = table(), f"{cluster}/slurm.conf"
    found = {pid for pid in processes if node_of(pid, conf) == node}
    parents = {processes[pid][0] for pid in found}
    return found | {pid for pid in parents if processes.get(pid, (0, "", ""))[2] == "slurmstepd"}


def reap_orphans(except_for):
    """Takes note of children that have ended and are not waited for by anyone else."""
    own = os.getpid()
    for pid, (parent, state, _) in table().items():
        if parent == own and state == "Z" and pid not in except_for:
            try:
                os.waitpid(pid, os.WNOHANG)
            except ChildProcessError:
                pass
