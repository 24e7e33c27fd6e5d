"""A clean Debian in a folder, made by debootstrap: what a new machine would have."""

import contextlib
import pathlib
import re
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
    """A minimal Debian with /proc, which is unmounted in the end. It stays there to be looked at."""
    if ROOT.exists():
        run("rm", "-rf", "--one-file-system", ROOT)
    ROOT.parent.mkdir(exist_ok=True)
    say("debootstrap")
    release, site = mirror()
    run("debootstrap", "--variant=minbase", release, ROOT, site, stdout=subprocess.DEVNULL)
    run("mount", "-t", "proc", "proc", ROOT / "proc")
    try:
        apt("update")
        yield
    finally:
        run("umount", ROOT / "proc")
