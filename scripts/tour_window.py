"""The tour by hand: in a window, with mouse and keyboard. What is clicked is where it is at a
window of 1280x800 px, in English and at scale 1."""

import json
import signal
import sys
import time

from tour_story import (BOX, END, FIRST, LAST, NAME, POSES, REGION, RELEASE, SPOT, TARGET, WALL,
                        WRIST_FRICTION)
from window_user import User

VIEW = (300, 250)  # somewhere in the viewport, beside the figure
LAST_FRAME_FIELD = (825, 490)
SEARCH_JOINTS = (1110, 41)
FIRST_FOUND = (1100, 85)  # below the root, which is always shown
SECTIONS = {"pose": (988, 330), "region": (988, 390), "scene": (988, 420), "project": (988, 450)}
# Joints of the figure that stands and is seen from the front, and rows of the list of joints.
IN_VIEW = {"r_elbow": (450, 211), "l_elbow": (519, 211), "r_shoulder": (450, 165),
           "l_shoulder": (519, 165), "chest": (484, 190), "waist": (484, 224)}
IN_LIST = {"waist": (1040, 85), "chest": (1050, 105), "r_shoulder": (1070, 145),
           "r_elbow": (1075, 165), "l_shoulder": (1070, 205), "l_elbow": (1075, 225)}
# The colours of their rings: red is x.
AXES = {"flexion": "y", "abduction": "x", "rotation": "z"}
ROWS = {"right arm": 685, "left arm": 715}  # y of rows in the dope sheet [px]
RULER = 516
ON_BOX = (484, 366)  # what the middle of the box is seen at, from the front
BEHIND_BOX = (800, 420)  # on the floor, as the view is at first
CLOSE_FIRST_STEPS = (944, 305)


def frame_x(frame):
    """Where a frame is in the dope sheet when it shows all of them."""
    room = max(1.0, 0.04 * END)  # frames to the left and to the right
    left, width = 150, 819
    return left + width * (frame + room) / (END + 2 * room)


class Tour:
    def __init__(self, user, project):
        self.user = user
        self.project = project
        self.before = {}  # angles of the pose before, by hinge

    def saved(self):
        """The file after Ctrl+S."""
        user = self.user
        before = self.project.stat().st_mtime_ns
        user.keys("ctrl+s")
        user.wait("a saved project", lambda: self.project.stat().st_mtime_ns != before)
        user.wait("its title", lambda: user.title() == f"{self.project} - Hazumi")
        return json.loads(self.project.read_text(encoding="utf-8"))

    def empty(self):
        user = self.user
        user.wait("an empty project", lambda: user.title() == "Untitled - Hazumi")
        user.click(*LAST_FRAME_FIELD, times=2)
        user.replace(str(END))
        user.did("time.range", last=END)
        user.move(frame_x(10), ROWS["left arm"])
        user.keys("Home")
        user.move(*VIEW)
        user.keys("KP_1")

    def turn(self, hinge, by):
        """R, an axis twice, for it is the joint's own, degrees, Enter."""
        user = self.user
        joint, kind = hinge.rsplit("_", 1)
        user.click(*(IN_LIST if self.before else IN_VIEW)[joint])
        user.move(*VIEW)
        user.keys("r", AXES[kind])
        user.keys(AXES[kind], *[{"-": "minus"}.get(c, c) for c in str(by)], "Return")

    def pose(self, frame):
        user = self.user
        user.click(frame_x(frame), RULER)
        for hinge, angle in POSES[frame].items():
            self.turn(hinge, angle - self.before.get(hinge, 0))
        self.before = POSES[frame]
        user.keys("a", "i", "alt+a")
        if not self.project.exists():
            self.save_as(self.project)
        joints = self.saved()["joints"]
        for hinge, angle in POSES[frame].items():
            keys = {key["frame"]: key["angle_deg"] for key in joints[hinge]["keys"]}
            assert keys[frame] == angle, (hinge, keys)
        assert all(curve["keys"][-1]["frame"] == frame for curve in joints.values()), joints

    def save_as(self, file):
        user = self.user
        user.keys("ctrl+shift+s")
        user.looked("save-as")
        user.replace(str(file))
        user.wait(file, file.exists)

    def region(self):
        """D, and both arms are painted."""
        user = self.user
        start, end = (frame_x(FIRST), ROWS["right arm"]), (frame_x(LAST), ROWS["left arm"])
        user.move(*start)
        user.keys("d")
        user.drag(start, end)
        (region,) = self.saved()["regions"]
        assert region["name"] == REGION, region
        assert (region["first_frame"], region["last_frame"]) == (FIRST, LAST), region

    def choose(self, joint):
        """By its name."""
        user = self.user
        user.click(*SEARCH_JOINTS)
        user.keys("ctrl+a")
        user.type(joint)
        user.click(*FIRST_FOUND)

    def wrist(self):
        """A friction of its own, typed."""
        user = self.user
        self.choose("r_wrist")
        user.click(*SECTIONS["region"])
        own = (1190, 564)  # the button, and then the number
        user.click(*own)
        user.did("region.friction", joint="r_wrist")
        user.click(*own, times=2)
        user.looked("typing")
        user.replace(str(WRIST_FRICTION))
        (region,) = self.saved()["regions"]
        assert region["friction"]["joints"] == {"r_wrist": WRIST_FRICTION}, region

    def command(self, name):
        """By the search for commands, as it is proposed."""
        user = self.user
        user.keys("F3")
        user.type(name)
        user.keys("Return")

    def ball(self):
        """Into the hand that is selected; it leaves it on another frame."""
        user = self.user
        self.choose("r_wrist")
        self.command("Add ball")
        user.looked("add-ball")
        user.keys("Return")
        user.did("held.add_ball")
        user.click(frame_x(RELEASE), RULER)
        self.command("Let go")
        user.keys("Return")
        user.did("held.let_go")
        (ball,) = self.saved()["held_objects"]
        assert (ball["joint"], ball["release_frame"]) == ("r_wrist", RELEASE), ball

    def toe(self):
        user = self.user
        user.click(frame_x(0), RULER)
        self.choose("l_toe")
        user.click(*SECTIONS["scene"])
        user.click(1110, 368)  # Pin from here
        (span,) = self.saved()["placements"]
        assert span["joint"] == "l_toe", span
        assert (span["first_frame"], span["last_frame"]) == (0, END), span

    def play(self):
        """Other pictures while it plays, the same once it is stopped."""
        user = self.user
        user.move(*VIEW)
        user.keys("space")
        seen = {user.pixels()}
        user.wait("the figure to move", lambda: seen.add(user.pixels()) or len(seen) > 4)
        user.keys("space")

    def rename(self):
        user = self.user
        user.click(*SECTIONS["project"])
        user.click(1200, 330)
        user.replace(NAME)
        assert self.saved()["name"] == NAME

    def reopen(self):
        user = self.user
        user.keys("ctrl+n")
        user.wait("a new project", lambda: user.title() == "Untitled - Hazumi")
        user.keys("ctrl+o")
        user.looked("open")
        user.replace(self.project.name)
        user.wait("the project", lambda: user.title() == f"{self.project} - Hazumi")
        before = self.project.read_bytes()
        again = self.project.with_name("again.kfa")
        self.save_as(again)
        assert again.read_bytes() == before, "the project opened again is not the same"

    def render(self):
        """F12, small."""
        user = self.user
        user.keys("ctrl+F12")
        user.looked("render")
        pictures = self.project.with_name("render")
        user.click(575, 348, times=2)  # its width
        user.type("320\t180")
        user.keys("Return")
        user.wait("pictures", lambda: len(list(pictures.glob("*.png"))) == END + 1)
        user.looked("rendered")
        user.keys("Return")

    def leave(self):
        self.user.keys("ctrl+q")
        return self.user.leave()


class BoxTour(Tour):
    """From an empty project with a box."""

    def add_box(self, box):
        """Add box, its numbers typed."""
        user = self.user
        self.command("Add box")
        user.looked("add-box")
        user.keys("ctrl+a")
        user.type("\t".join(str(box[name]) for name in ("name", "x", "y", "z")))
        user.keys("Tab")
        user.type("\t".join(str(box[name]) for name in ("size_x", "size_y", "size_z")))
        user.looked("box-typed")
        user.keys("Return")
        user.did("object.add_box")

    def add(self, box):
        user = self.user
        user.wait("an empty project", lambda: user.title() == "Untitled - Hazumi")
        self.add_box(box)


class JumpTour(BoxTour):
    def steps(self):
        return [("13-box", self.box), ("14-jump", self.jump)]

    def box(self):
        self.add(BOX)

    def jump(self):
        """J, and the spot is pointed at."""
        user = self.user
        user.move(*VIEW)
        user.keys("KP_1")
        user.keys("j")
        user.click(*ON_BOX)
        user.did("jump.add")
        step = user.deeds("jump.add")[-1]
        assert (step["x"], step["y"]) == SPOT, step
        self.save_as(self.project)


class ThrowTour(BoxTour):
    def steps(self):
        return [("15-box", self.box), ("16-throw", self.throw)]

    def box(self):
        self.user.click(*CLOSE_FIRST_STEPS)
        self.add(WALL)

    def throw(self):
        """A ball in the hand, T, and the spot is pointed at."""
        user = self.user
        self.choose("r_wrist")
        self.command("Add ball")
        user.keys("Return")
        user.did("held.add_ball")
        user.move(*BEHIND_BOX)
        user.keys("t")
        user.looked("aimed")
        user.click(*BEHIND_BOX)
        user.did("throw.add")
        step = user.deeds("throw.add")[-1]
        assert (step["x"], step["y"], step["z"]) == TARGET, step
        self.save_as(self.project)


def tour_by_hand(hazumi, out, told):
    """`told`: the project that the tour without a window has saved."""
    out.mkdir(parents=True, exist_ok=True)
    for old in [*out.glob("*.png"), *out.glob("*.kfa"), *out.glob("render/*.png")]:
        old.unlink()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # and what was started ends, too
    user = User(hazumi, out)
    try:
        tour = Tour(user, out / "tour.kfa")
        steps = [("1-empty", tour.empty)]
        steps += [(f"{i}-pose-F{f}", lambda f=f: tour.pose(f)) for i, f in enumerate(POSES, 2)]
        steps += [("5-region", tour.region), ("6-wrist-friction", tour.wrist),
                  ("7-ball", tour.ball), ("8-pinned-toe", tour.toe), ("9-played", tour.play),
                  ("10-named", tour.rename), ("11-opened-again", tour.reopen),
                  ("12-rendered", tour.render)]
        for name, step in steps:
            begin = time.monotonic()
            try:
                step()
            except AssertionError:
                user.looked("failed")
                raise
            print(f"tour: {name} in {time.monotonic() - begin:.1f} s", flush=True)
            user.looked(name)
        said = tour.leave().strip()
    finally:
        user.close()
    check_same(tour.project, told)
    print(f"tour: by hand the same project; {said}; pictures in {out}")


def check_same(by_hand, told):
    ours, theirs = (json.loads(f.read_text(encoding="utf-8")) for f in (by_hand, told))
    assert ours == theirs, "by hand it became another project than by operators"


def jump_by_hand(hazumi, out, told):
    """`told`: the jump that the tour without a window has saved."""
    story_by_hand(hazumi, out, told, JumpTour)


def throw_by_hand(hazumi, out, told):
    story_by_hand(hazumi, out, told, ThrowTour)


def story_by_hand(hazumi, out, told, kind, files=()):
    user = User(hazumi, out, files)
    try:
        tour = kind(user, out / told.name)
        for picture, step in tour.steps():
            try:
                step()
            except AssertionError:
                user.looked("failed")
                raise
            user.looked(picture)
        tour.leave()
    finally:
        user.close()
    check_same(tour.project, told)
    print(f"tour: by hand the same {tour.project.stem}")
