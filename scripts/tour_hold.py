"""How the tour goes on by hand, in a window as tour_window.py has it."""

import shutil

from tour_story import END, FALL, GRIP, GRIP_AT, HELD, LIES, RAIL, STRENGTH
from tour_window import (LAST_FRAME_FIELD, RULER, SECTIONS, VIEW, BoxTour, Tour, frame_x,
                         story_by_hand)

CLOSE_BESIDE_FILE = (944, 255)  # the same, of a project that was opened
LEFT_ARM_ROW = (60, 745)  # its name, in the dope sheet of the throw
MUSCLE_EDGE = (600, 731)  # the upper edge of its bar when it is full
TOUCHES = (1137, 769)  # the tick, while there is no muscle
ADD_SPRING, JOINTS, BY_STRENGTH = (1220, 644), (1060, 455), (1071, 767)
ON_RAIL = (515, 213)
EFFORT = (870, 43)  # among the overlays
TORQUE = (14, 764)  # on the lower left of the graph
FRAME_FIELD = (663, 490)
GRAVITY_FROM_HERE = (1201, 371)
ADD_REGION, REGION_NAME, REGION_LAST = (1135, 351), (1188, 372), (1188, 414)


class HoldTour(BoxTour):
    """From the throw: the left arm gets muscle, and its hand takes hold of a rail."""

    def steps(self):
        return [("17-muscle", self.muscle), ("18-strength", self.strength), ("19-rail", self.rail),
                ("20-hold", self.hold), ("21-effort", self.effort), ("22-torque", self.torque)]

    def muscle(self):
        """The arm by its row, and a spring by its button. Its hand is to get at the rail."""
        user = self.user
        user.click(*CLOSE_BESIDE_FILE)
        user.click(frame_x(GRIP), RULER)
        user.click(*LEFT_ARM_ROW)
        user.click(*SECTIONS["region"])
        user.click(*TOUCHES)
        user.did("region.set", contacts=False)
        user.click(*ADD_SPRING)
        user.did("drive.add", kind="spring")

    def strength(self):
        """All of it first, and then the edge of its bar is dragged down. The list of joints makes
        room for the button."""
        user = self.user
        user.click(*JOINTS)
        user.looked("room")
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


class FallTour(Tour):
    """From there: the ground and gravity have the whole figure."""

    def steps(self):
        return [("23-gravity", self.gravity), ("24-let-go", self.let_go), ("25-lies", self.lies)]

    def gravity(self):
        """Time to fall in, and what places the figure in it."""
        user = self.user
        user.click(*CLOSE_BESIDE_FILE)
        user.click(*LAST_FRAME_FIELD, times=2)
        user.replace(str(LIES))
        user.did("time.range", last=LIES)
        user.click(*FRAME_FIELD, times=2)
        user.replace(str(END))
        user.click(*SECTIONS["scene"])
        user.click(*GRAVITY_FROM_HERE)
        user.did("placement.set", kind="gravity", first=END, last=LIES)

    def let_go(self):
        """All of it, the root too, by the button. That it touches the scene is ticked already."""
        user = self.user
        user.move(*VIEW)
        user.keys("a")
        user.click(*SECTIONS["region"])
        user.click(*ADD_REGION)
        user.did("region.add", contacts=True)
        user.looked("added")
        user.click(*REGION_NAME)
        user.replace(FALL)
        user.did("region.set", name=FALL)
        user.click(*REGION_LAST, times=2)
        user.replace(str(LIES))
        user.did("region.set", last=LIES)

    def lies(self):
        user = self.user
        user.move(*VIEW)
        user.keys("alt+a")
        user.click(*FRAME_FIELD, times=2)
        user.replace(str(LIES))
        user.looked("ground")
        self.save_as(self.project)


def fall_by_hand(hazumi, out, told, held):
    """`held`: the project of the hold, which it begins with."""
    begun = out / "begun.kfa"
    shutil.copy(held, begun)
    story_by_hand(hazumi, out, told, FallTour, [begun])
