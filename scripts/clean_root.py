"""A clean Debian in a folder, made by debootstrap: what a new machine would have."""

import contextlib
import pathlib
import re
import socket
import subprocess
import sys

TREE = pathlib.Path(__file__).resolve().parents[1]
ROOT = TREE / "build" / "clean_root"
NAME = pathlib.Path(sys.argv[0]).name


def say(text):
    print(f"{NAME}:", text, flush=True)


def demand(fact, claim):
    if not fact:
        sys.exit(f"{NAME}: FAILED: {claim}")
    say(f"ok: {claim}")


def run(*command, **more):
    return subprocess.run(list(map(str, command)), check=True, **more)


def as_root(command):
    """In the clean root."""
    run("chroot", ROOT, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL=C.UTF-8",
        "DEBIAN_FRONTEND=noninteractive", "sh", "-ec", command, stdout=subprocess.DEVNULL)


def apt(command):
    as_root(f"apt-get -q -y -o Dpkg::Use-Pty=0 {command}")


def mirror():
    """The release of this machine and where apt has it from."""
    release = re.search(r"^VERSION_CODENAME=(\w+)", pathlib.Path("/etc/os-release").read_text(), re.M)[1]
    lines = run("apt-get", "indextargets", "--format", "$(SITE) $(RELEASE)", "Created-By: Packages",
                capture_output=True, text=True).stdout.splitlines()
    sites = [line.split()[0] for line in lines if line.split()[1] == release]
    demand(sites, f"apt knows a mirror of {release}")
    return release, sites[0]


@contextlib.contextmanager
def clean_root():
    """A minimal Debian that knows its own name, with the file systems of the kernel, which are
    unmounted in the end. It stays there to be looked at."""
    if ROOT.exists():
        run("rm", "-rf", "--one-file-system", ROOT)
    ROOT.parent.mkdir(exist_ok=True)
    say("debootstrap")
    release, site = mirror()
    run("debootstrap", "--variant=minbase", release, ROOT, site, stdout=subprocess.DEVNULL)
    (ROOT / "etc" / "hosts").write_text(f"127.0.0.1 localhost\n127.0.1.1 {socket.gethostname()}\n")
    mounted = []
    try:
        for options in (("-t", "proc", "proc", "proc"), ("--rbind", "--make-rslave", "/sys", "sys"),
                        ("-t", "devpts", "-o", "newinstance,ptmxmode=0666", "devpts", "dev/pts")):
            place = ROOT / options[-1]
            place.mkdir(exist_ok=True)
            run("mount", *options[:-1], place)
            mounted.append(place)
        run("ln", "-sf", "pts/ptmx", ROOT / "dev" / "ptmx")
        apt("update")
        yield
    finally:
        for place in reversed(mounted):
            run("umount", "-R", place)
