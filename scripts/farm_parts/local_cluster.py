"""A cluster of two nodes on this machine, for tests: munged, slurmctld and two slurmd, with keys,
sockets, ports, logs and state of their own in a temporary folder. Nothing of a Slurm that the
machine may have is touched. All of it ends with the program, and nothing else does."""

import ctypes
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time

from . import processes
from .errors import FAILED, NO_INPUT, FarmError

NODES = ("a", "b")
PROGRAMS = {"munged": "munge", "slurmctld": "slurmctld", "slurmd": "slurmd",
            "sinfo": "slurm-client", "sbatch": "slurm-client"}
STARTS_WITHIN, ENDS_WITHIN = 30, 10  # [s]
LONGEST_SOCKET = 100                 # letters of a socket's path, which Linux limits to 107
PR_SET_PDEATHSIG = 1

CONFIGURATION = """\
ClusterName=farm
SlurmctldHost={host}({address})
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool_%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd_%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd_%n.log
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=2,sched_min_interval=0,batch_sched_delay=0
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
JobRequeue=1
# A lost node is noticed within some 12 s.
SlurmctldTimeout=5
SlurmdTimeout=3
MessageTimeout=3
TCPTimeout=1
KillWait=2
{nodes}
PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def own_address():
    """The name of this machine and its address, at which Slurm's daemons listen: Debian gives names
    127.0.1.1. Raises FarmError."""
    name = socket.gethostname()
    try:
        return name.split(".")[0], socket.gethostbyname(name)
    except OSError as error:
        raise FarmError(f"{name}, the name of this machine, has no address; add the line \"127.0.1.1 {name}\" "
                        "to /etc/hosts") from error


def free_ports(address, number):
    """Ports of this machine that nobody listens at."""
    sockets = [socket.socket() for _ in range(number)]
    for each in sockets:
        each.bind((address, 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def find_programs():
    """Where Debian puts daemons, which is not in every user's PATH. Raises FarmError."""
    path = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    found = {name: shutil.which(name, path=path) for name in PROGRAMS}
    missing = sorted({PROGRAMS[name] for name in PROGRAMS if not found[name]})
    if missing:
        raise FarmError("a local cluster needs Slurm; on Debian: apt install "
                        "--no-install-recommends " + " ".join(missing), NO_INPUT)
    return found


def end_with_parent():
    """In a daemon before it starts: it is asked to end when this program has gone."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


class LocalCluster:
    """Started and ended by `with`. Its environment is for the commands that use it."""

    def __init__(self):
        self.programs = find_programs()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="hazumi-farm-"))
        self.conf = self.folder / "slurm.conf"
        # What a Slurm of this machine told its jobs is not for this one.
        own = {name: value for name, value in os.environ.items()
               if not name.startswith(("SLURM_", "SBATCH_"))}
        self.environment = {**own, "SLURM_CONF": str(self.conf),
                            "HAZUMI_LOCAL_CLUSTER": str(self.folder)}
        self.daemons = []

    def __enter__(self):
        try:
            processes.adopt_orphans()
            self.configure()
            self.start()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def configure(self):
        """Key, folders and slurm.conf."""
        munge = self.folder / "munge"
        if len(str(munge / "socket")) > LONGEST_SOCKET:
            raise FarmError(f"{munge}/socket: is too long for the name of a socket; set TMPDIR to "
                            "a folder with a shorter name")
        munge.mkdir(mode=0o700)
        (self.folder / "state").mkdir(mode=0o700)
        key = munge / "key"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(128))
        host, address = own_address()
        ports = free_ports(address, 1 + len(NODES))
        cpus = max((os.cpu_count() or 1) // len(NODES), 1)
        nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr={address} Port={port} "
                          f"CPUs={cpus} State=UNKNOWN" for name, port in zip(NODES, ports[1:]))
        user = pwd.getpwuid(os.getuid()).pw_name
        self.conf.write_text(CONFIGURATION.format(host=host, address=address, ports=ports, folder=self.folder,
                                                  user=user, nodes=nodes))

    def start(self):
        """All daemons, until both nodes are there. Raises FarmError."""
        munge = self.folder / "munge"
        self.launch("munged", "--force", "--foreground", f"--key-file={munge}/key",
                    f"--socket={munge}/socket", f"--pid-file={munge}/pid",
                    f"--log-file={munge}/log", f"--seed-file={munge}/seed")
        self.wait_for("munged", (munge / "socket").exists)
        self.launch("slurmctld", "-D")
        for name in NODES:
            self.launch("slurmd", "-D", "-N", name)
        self.wait_for("slurmctld", self.is_ready)

    def launch(self, name, *arguments):
        """A daemon in a session of its own, so that Ctrl+C is for this program to deal with."""
        with open(self.folder / f"{name}.out", "ab") as says:
            self.daemons.append(subprocess.Popen(
                [self.programs[name], *arguments], env=self.environment, cwd=self.folder,
                stdin=subprocess.DEVNULL, stdout=says, stderr=says, start_new_session=True,
                preexec_fn=end_with_parent))

    def wait_for(self, name, is_there):
        """Raises FarmError with a daemon's last words."""
        end = time.monotonic() + STARTS_WITHIN
        while not is_there():
            dead = [d for d in self.daemons if d.poll() is not None]
            if dead or time.monotonic() > end:
                name = pathlib.Path(dead[0].args[0]).name if dead else name
                raise FarmError(f"{name} does not start: {self.last_words(name)}", FAILED)
            time.sleep(0.1)

    def is_ready(self):
        done = subprocess.run([self.programs["sinfo"], "--noheader", "--Node", "-o", "%T"],
                              env=self.environment, capture_output=True, text=True, check=False)
        return done.stdout.split() == ["idle"] * len(NODES)

    def last_words(self, name):
        lines = (self.folder / f"{name}.out").read_text(errors="replace").strip().splitlines()
        return lines[-1] if lines else f"no word within {STARTS_WITHIN} s"

    def stop(self):
        """Ends the daemons and what runs on the nodes, and removes the folder."""
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(ENDS_WITHIN)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        processes.end_steps(str(self.conf))
        shutil.rmtree(self.folder, ignore_errors=True)

    def reap(self):
        """Lets go of steps that have ended."""
        processes.reap_orphans({daemon.pid for daemon in self.daemons})
