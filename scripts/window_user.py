"""Hands and eyes before a window of hazumi: a screen of its own (Xvfb), mouse and keys (xdotool).

Everything is waited for by what can be seen from outside: the window's title, files, and the
journal, in which hazumi writes down what was done within 2 s."""

import json
import os
import pathlib
import random
import shutil
import subprocess
import tempfile
import time

SIZE = (1280, 800)  # of the screen and the window [px]
PATIENCE = 20.0  # until something must have happened [s]


class Screen:
    """An X server without a monitor, on a display that was free."""

    def __init__(self):
        for program in ("Xvfb", "xdotool", "import"):
            if not shutil.which(program):
                raise SystemExit(f"{program} is missing: scripts/setup xvfb xdotool imagemagick")
        for number in random.sample(range(100, 1000), 10):
            if self.starts(f":{number}"):
                return
        raise SystemExit("Xvfb does not start")

    def starts(self, display):
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", display, "-displayfd", str(write), "-screen", "0", "%dx%dx24" % SIZE,
             "-nolisten", "tcp", "-noreset"], pass_fds=[write], stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as ready:  # says its number once it can be talked to
            self.display = ":" + ready.readline().strip()
        return self.display == display

    def close(self):
        self.process.terminate()
        self.process.wait()


class User:
    """Somebody before one window. `pictures`: the folder that looked() writes to."""

    def __init__(self, hazumi, pictures, files=()):
        self.screen = Screen()
        self.pictures = pathlib.Path(pictures)
        self.home = pathlib.Path(tempfile.mkdtemp(prefix="hazumi_user."))
        self.environment = dict(
            os.environ, DISPLAY=self.screen.display, HOME=str(self.home), LANG="C.UTF-8",
            XDG_STATE_HOME=str(self.home / "state"), XDG_CONFIG_HOME=str(self.home / "config"))
        for other in ("LC_ALL", "LC_MESSAGES", "LANGUAGE", "WAYLAND_DISPLAY"):
            self.environment.pop(other, None)
        self.log = open(self.home / "log", "w+", encoding="utf-8")
        self.hazumi = pathlib.Path(hazumi).resolve()
        self.process = self.window = None
        try:
            self.start(*files)
        except BaseException:
            self.close()
            raise

    def start(self, *files):
        """hazumi with these files; again, after it was left."""
        self.process = subprocess.Popen([self.hazumi, "--trace", *files], stdout=self.log,
                                        stderr=self.log, env=self.environment, cwd=self.home)
        self.window = self.wait("a window", self.find_window)
        self.wait("a picture", lambda: len(set(self.pixels())) > 16)

    def find_window(self):
        assert self.process.poll() is None, self.said()
        found = self.run("xdotool", "search", "--onlyvisible", "--name", "Hazumi", check=False)
        return found.split()[0] if found else None

    def said(self):
        self.log.flush()
        return (self.home / "log").read_text(encoding="utf-8")

    def leave(self):
        """Waits until hazumi has ended by itself; what it said."""
        status = self.process.wait(PATIENCE)
        assert status == 0, (status, self.said())
        return self.said()

    def close(self):
        if self.process and self.process.poll() is None:
            self.process.terminate()
            self.process.wait()
        self.screen.close()
        self.log.close()
        shutil.rmtree(self.home)

    # Hands.

    def run(self, *command, check=True):
        done = subprocess.run(command, env=self.environment, check=check, capture_output=True,
                              text=True)
        return done.stdout.strip()

    def xdotool(self, *words):
        self.run("xdotool", *map(str, words))

    def move(self, x, y):
        self.xdotool("mousemove", round(x), round(y))

    def click(self, x, y, times=1, button=1, holding=None):
        """At a point; `holding`: shift, ctrl or alt."""
        words = ["mousemove", round(x), round(y)]
        words += ["keydown", holding] if holding else []
        words += ["click", "--repeat", times, "--delay", 60, button]
        self.xdotool(*words, *(["keyup", holding] if holding else []))

    def drag(self, start, end, button=1, steps=4):
        words = ["mousemove", *map(round, start), "mousedown", button]
        for i in range(1, steps + 1):
            point = [round(a + (b - a) * i / steps) for a, b in zip(start, end)]
            words += ["mousemove", *point, "sleep", 0.02]
        self.xdotool(*words, "mouseup", button)

    def keys(self, *names):
        """By their names in X: r, ctrl+s, Return. The same key twice in a row needs two calls: when
        it comes again within 20 ms, it is taken for one that is held."""
        time.sleep(0.1)
        self.xdotool("key", "--delay", 30, *names)

    def type(self, text):
        self.xdotool("type", "--delay", 12, text)

    def replace(self, text):
        """The text of the field that has the keyboard."""
        self.keys("ctrl+a")
        self.type(text)
        self.keys("Return")

    # Eyes.

    def pixels(self):
        return subprocess.run(["import", "-window", "root", "rgb:-"], check=True,
                              env=self.environment, capture_output=True).stdout

    def looked(self, name):
        """A picture of the screen, as soon as two in a row are the same."""
        before = None
        for _ in range(20):
            now = self.pixels()
            if now == before:
                break
            before = now
            time.sleep(0.15)
        self.run("import", "-window", "root", str(self.pictures / f"{name}.png"))

    def wait(self, what, seen):
        """Until `seen` returns something true, which is returned."""
        end = time.monotonic() + PATIENCE
        while True:
            result = seen()
            if result:
                return result
            if time.monotonic() > end:
                self.looked("failed")
                raise SystemExit(f"tour: waited in vain for {what}; see failed.png")
            time.sleep(0.05)

    def title(self):
        return self.run("xdotool", "getwindowname", self.window)

    def journal(self):
        """What was done since the last save, as lines; empty when all is saved."""
        lines = []
        for file in (self.home / "state/hazumi/journals").glob("*.journal"):
            for line in file.read_text(encoding="utf-8").split("\n")[:-1]:
                lines.append(json.loads(line))
        return lines

    def deeds(self, operator):
        return [line for line in self.journal() if line.get("op") == operator]

    def did(self, operator, **parameters):
        """Waits until an operator was the last one of its name, with such parameters."""
        def seen():
            last = (self.deeds(operator) or [{}])[-1]
            return last.get("op") and all(last.get(k) == v for k, v in parameters.items())
        self.wait(f"{operator} {parameters}", seen)

    def state(self):
        """What is selected and the frame, as the journal knows them."""
        return ([line["state"] for line in self.journal() if "state" in line] or [{}])[-1]
