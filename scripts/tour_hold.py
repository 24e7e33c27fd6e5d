"""How the tour goes on by hand, in a window as tour_window.py has it."""

import shutil

from tour_story import GRIP, GRIP_AT, HELD, RAIL, STRENGTH
from tour_window import RULER, SECTIONS, BoxTour, frame_x, story_by_hand

CLOSE_BESIDE_FILE = (944, 255)  # the same, of a project that was opened
LEFT_ARM_ROW = (60, 715)  # its name, in the dope sheet of the throw
MUSCLE_EDGE = (600, 701)  # the upper edge of its bar when it is full
ADD_SPRING, BY_STRENGTH = (1220, 644), (1071, 770)
ON_RAIL = (515, 213)
EFFORT = (870, 43)  # among the overlays
TORQUE = (14, 764)  # on the lower left of the graph


class HoldTour(BoxTour):
    """From the throw: the left arm gets muscle, and its hand takes hold of a rail."""

    def steps(self):
        return [("17-muscle", self.muscle), ("18-strength", self.strength), ("19-rail", self.rail),
                ("20-hold", self.hold), ("21-effort", self.effort), ("22-torque", self.torque)]

    def muscle(self):
        """The arm by its row, and a spring by its button."""
        user = self.user
        user.click(*CLOSE_BESIDE_FILE)
        user.click(frame_x(GRIP), RULER)
        user.click(*LEFT_ARM_ROW)
        user.click(*SECTIONS["region"])
        user.click(*ADD_SPRING)
        user.did("drive.add", kind="spring")

    def strength(self):
        """All of it first, and then the edge of its bar is dragged down."""
        user = self.user
        user.click(*BY_STRENGTH)
        user.did("drive.set", strength=1.0)
        x, y = MUSCLE_EDGE
        user.drag(MUSCLE_EDGE, (x, y + 100 * (1 - STRENGTH)))
        user.did("drive.set", strength=STRENGTH)

    def rail(self):
        self.add_box(RAIL)

    def hold(self):
        """The wrist, and then the rail is clicked."""
        user = self.user
        self.choose("l_wrist")
        self.command("Hold on to what is clicked")
        user.move(*ON_RAIL)
        user.looked("holding-on")
        user.click(*ON_RAIL)
        user.did("constraint.hold_on")
        step = user.deeds("constraint.hold_on")[-1]
        assert (step["x"], step["y"], step["z"]) == GRIP_AT, step

    def effort(self):
        user = self.user
        user.click(frame_x(HELD), RULER)
        user.click(*EFFORT)

    def torque(self):
        user = self.user
        self.choose("l_shoulder")
        user.move(*MUSCLE_EDGE)
        user.keys("ctrl+Tab")
        user.looked("graph")
        user.click(*TORQUE)
        user.move(frame_x(HELD), MUSCLE_EDGE[1])
        self.save_as(self.project)


def hold_by_hand(hazumi, out, told, throw):
    """`throw`: the project of the first throw, which it begins with."""
    begun = out / "begun.kfa"
    shutil.copy(throw, begun)
    story_by_hand(hazumi, out, told, HoldTour, [begun])
