"""Run inside Blender by scripts/interop: reads a BVH clip and compares the position of every joint
at every frame with what Hazumi made of the same clip. Units and axes are Hazumi's choice: they are
found from the first frame, as one of the 24 turns by right angles and one factor, and must then
hold for all.
usage: blender --background --python interop_clip.py -- CLIP.bvh MOTION.json"""

import itertools
import json
import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import interop_blender as interop  # noqa: E402

bpy = interop.bpy


def positions(motion):
    """Of the armature's bones by frame, in the file's units and axes, and of Hazumi's joints [m]."""
    interop.import_bvh(sys.argv[sys.argv.index("--") + 1], 1.0, "Y", "Z")
    armature = next(o for o in bpy.context.scene.objects if o.type == "ARMATURE")
    names = [name for name in motion["joint_groups"] if name in armature.pose.bones]
    missing = sorted(set(motion["joint_groups"]) - set(names))
    if missing:
        raise SystemExit(f"Blender has no bones {missing}")
    theirs = []
    for i in range(len(motion["frames"])):
        bpy.context.scene.frame_set(1 + i)
        theirs.append([armature.pose.bones[name].head[:] for name in names])
    ours = [frame["joint_positions_m"] for frame in motion["frames"]]
    return numpy.array(theirs), numpy.array(ours)


def turns():
    """The 24 turns by right angles."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            turn = numpy.zeros((3, 3))
            turn[range(3), order] = signs
            if numpy.linalg.det(turn) > 0.0:
                yield turn


def errors(theirs, ours):
    """The distance of every joint at every frame [m], and the metres of a unit."""
    spread = [numpy.linalg.norm(p[0] - p[0].mean(axis=0)) for p in (theirs, ours)]
    unit = spread[1] / spread[0]
    turn = min(turns(), key=lambda turn: numpy.abs(unit * theirs[0] @ turn.T - ours[0]).max())
    return numpy.linalg.norm(unit * theirs @ turn.T - ours, axis=2), unit


def main():
    clip, reference = sys.argv[sys.argv.index("--") + 1:]
    with open(reference, encoding="utf-8") as file:
        motion = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    off, unit = errors(*positions(motion))
    frame, joint = numpy.unravel_index(off.argmax(), off.shape)
    print(f"blender    {os.path.basename(clip)}: {len(off)} frames, {off.shape[1]} joints, "
          f"1 unit is {unit:.6g} m, off by {off.max():.1e} m at most "
          f"({motion['joint_groups'][joint]} at frame {frame})", flush=True)
    if not off.max() <= interop.TOLERANCE_M:
        raise SystemExit(f"more than {interop.TOLERANCE_M} m")


main()
