"""What the tour tells: a throw, in three poses with a dynamics region between them."""

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
NAME = "Tour"
