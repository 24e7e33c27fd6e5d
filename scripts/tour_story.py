"""What the tour tells: a throw, in three poses with a dynamics region between them, a jump onto a
box, a throw over one that is made whole; and from the first throw on what muscle and a hold make of
it: the left arm pulls towards its keys and takes hold of a rail. In the end the whole figure is let go
and falls on the ground."""

# Angles of the wind-up, of the throw and of the end [degrees], by frame. Within a pose the joints
# farther out come first: what they turn is not in the way of those that are turned after them.
POSES = {
    0: {"r_elbow_flexion": 60, "l_elbow_flexion": 20, "r_shoulder_abduction": 95,
        "l_shoulder_abduction": 70, "chest_rotation": -28, "waist_flexion": -8},
    12: {"r_elbow_flexion": 35, "l_elbow_flexion": 30, "r_shoulder_abduction": 80,
         "l_shoulder_abduction": 40, "chest_rotation": 28, "waist_flexion": 18},
    36: {"r_elbow_flexion": 20, "l_elbow_flexion": 20, "r_shoulder_abduction": 15,
         "l_shoulder_abduction": 15, "chest_rotation": 10, "waist_flexion": 5},
}
REGION = "arms"
FIRST, LAST = 12, 28  # frames in which the arms swing by themselves
WRIST_FRICTION = 0.4  # of the right one
END = 36  # the last frame
RELEASE = 18  # the frame in which the ball leaves the hand
NAME = "Tour"
BOX = {"name": "box", "x": 1.2, "y": 0, "z": 0.2, "size_x": 0.8, "size_y": 0.8, "size_z": 0.4}
SPOT = (1.21, 0.0)  # where the toes land, on the box [m]
WALL = {"name": "box", "x": 1.0, "y": 0.3, "z": 0.3, "size_x": 0.3, "size_y": 0.8, "size_z": 0.6}
TARGET = (1.8, 0.34, 0.0)  # where the ball comes down, behind it [m]
LEFT_ARM = ["l_shoulder", "l_elbow", "l_wrist"]
STRENGTH = 0.5  # of its spring
RAIL = {"name": "rail", "x": 0.22, "y": 0.42, "z": 0.98, "size_x": 0.05, "size_y": 0.7,
        "size_z": 0.05}
GRIP = 16  # the frame from which the left hand goes for the rail
GRIP_AT = (0.243, 0.335, 1.005)  # on top of it [m]
HELD = 24  # a frame in which it has it
LIES = 96  # the last frame of the fall, which begins on END
FALL = "fall"
