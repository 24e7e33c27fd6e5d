"""Pictures of a motion: a task draws a share of the frames; together they are a video and a
sheet."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import time
from fractions import Fraction

from . import drawing, video
from .errors import FarmError

CONTACT_SHEET = pathlib.Path(__file__).resolve().parents[1] / "contact_sheet"
MOST_ON_SHEET = 100   # frames, every second of which is on it: larger ones are hard to read
TRIED = 10            # frames that are drawn to tell how long one takes


def plan_of(hazumi, file, options, with_video):
    """What is to be drawn; `file` is absolute. Raises FarmError."""
    if with_video:
        drawing.check_even(options)
    first, last, rate = drawing.frames_of(hazumi, file, options)
    return {"kind": "render", "file": str(file), "options": drawing.without(options, "--frames"),
            "frames": [first, last], "rate": str(rate), "video": with_video}


class RenderWork:
    """The work of a plan in a folder."""

    unit = "frames"

    def __init__(self, folder, plan):
        self.folder, self.work = folder, plan["work"]
        self.hazumi, self.tasks = plan["hazumi"], plan["tasks"]
        self.first, self.last = self.work["frames"]
        self.frames = folder.path / "frames"

    def total(self):
        return self.last - self.first + 1

    def path_of(self, frame):
        """As hazumi names it."""
        return self.frames / f"frame_{'-' if frame < 0 else ''}{abs(frame):04d}.png"

    def drawn(self):
        """The frames that are there: hazumi gives a picture its name when it is whole."""
        names = (re.fullmatch(r"frame_(-?\d+)\.png", path.name) for path in self.frames.glob("*"))
        return {int(name[1]) for name in names if name}

    def share(self, task):
        """The frames of a task."""
        def edge(k):
            return self.first + self.total() * k // self.tasks
        return range(edge(task), edge(task + 1))

    def progress(self):
        """The tasks that have nothing left to do, and how many frames are drawn."""
        drawn = self.drawn()
        done = {k for k in range(self.tasks) if drawn.issuperset(self.share(k))}
        return done, sum(frame in drawn for frame in range(self.first, self.last + 1))

    def commands(self, task):
        """What is left of a task: a command for each run of frames that are missing."""
        drawn, runs = self.drawn(), []
        for frame in self.share(task):
            if frame in drawn:
                continue
            if runs and runs[-1][1] == frame - 1:
                runs[-1][1] = frame
            else:
                runs.append([frame, frame])
        return [self.command(a, b) for a, b in runs]

    def command(self, first, last):
        return [self.hazumi, "--render", str(self.frames), "--frames", f"{first}..{last}",
                *self.work["options"], self.work["file"]]

    def most_tasks(self):
        """A task has a frame or more."""
        return self.total()

    def missing(self):
        drawn = self.drawn()
        return [f for f in range(self.first, self.last + 1) if f not in drawn]

    def try_out(self):
        """Draws the first missing frame, so that what is wrong is known before anything is sent.
        Raises FarmError."""
        for frame in self.missing()[:1]:
            self.draw(frame, frame)

    def measure(self):
        """Draws a few frames, and tells how long the others will take [s]: with less than is spent
        before the first one."""
        missing = self.missing()
        if len(missing) < TRIED:
            return 0.0
        begin = time.monotonic()
        self.draw(missing[0], missing[0])
        middle = time.monotonic()
        self.draw(missing[1], missing[TRIED - 1])
        both, one = time.monotonic() - middle, middle - begin
        return max(both - one, 0.0) / (TRIED - 2) * (len(missing) - TRIED)

    def draw(self, first, last):
        done = subprocess.run(self.command(first, last), capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            raise FarmError(drawing.last_line(done.stderr), done.returncode)

    def merge(self):
        """The video and the sheet of all frames; lines that say where they are."""
        pictures = [self.path_of(f) for f in range(self.first, self.last + 1)]
        lines = [f"frames     {self.frames}: {len(pictures)}"]
        with tempfile.TemporaryDirectory(prefix="hazumi-farm-") as scratch:
            if self.work["video"]:
                lines.append(self.merge_video(pictures, scratch))
            lines.append(self.merge_sheet(pictures, scratch))
        return lines

    def merge_video(self, pictures, scratch):
        path, file = self.folder.path / "video.mp4", pathlib.Path(self.work["file"])
        options = ["--frames", f"{self.first}..{self.last}", *self.work["options"]]
        sound = video.has_sound(file) and video.sound_of(
            self.hazumi, file, drawing.without(drawing.without(options, "--size"), "--samples"),
            scratch)
        video.write_video(pictures, Fraction(self.work["rate"]), sound, path)
        return f"video      {path}"

    def merge_sheet(self, pictures, scratch):
        """As scripts/contact_sheet makes it of a folder; of every Nth frame if they are many."""
        path, scratch = self.folder.path / "sheet.png", pathlib.Path(scratch)
        if not shutil.which("ffmpeg"):
            raise FarmError("the program ffmpeg, which makes sheets, is not installed; on Debian: "
                            "apt install ffmpeg; frames and video are kept")
        every = -(-len(pictures) // MOST_ON_SHEET)
        for i, picture in enumerate(pictures[::every]):
            (scratch / f"frame_{i:06d}.png").symlink_to(picture)
        done = subprocess.run([CONTACT_SHEET, scratch, scratch / "sheet.png"], capture_output=True,
                              text=True, check=False)
        if done.returncode != 0:
            raise FarmError(f"{path}: ffmpeg: {drawing.last_line(done.stderr)}")
        temporary = path.with_name(".sheet.png.tmp")
        shutil.copyfile(scratch / "sheet.png", temporary)
        temporary.replace(path)
        return f"sheet      {path}" + (f" (of every {every}th frame)" if every > 1 else "")
