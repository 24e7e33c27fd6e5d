"""Run inside Blender by scripts/interop: imports a glTF or BVH file that Hazumi exported and
compares the world position of every joint at every frame with Hazumi's own motion JSON.
usage: blender --background --python interop_blender.py -- FILE MOTION.json [PICTURE.png]"""

import builtins
import json
import os
import sys

import numpy

# Debian's Blender 3.4 is older than its numpy, whose old names its glTF importer still uses.
for _name, _type in (("bool", bool), ("int", int), ("float", float), ("object", object)):
    if _name not in numpy.__dict__:
        setattr(numpy, _name, _type)

import bpy  # noqa: E402
from mathutils import Vector  # noqa: E402

TOLERANCE_M = 1e-4


def import_bvh(path, metres, forward, up):
    """`metres`: of a unit; `forward`, `up`: the file's axes that are Blender's y and z."""
    import io_anim_bvh.import_bvh as importer
    # It opens files with mode "rU", which Python 3.11 no longer knows.
    importer.open = lambda name, mode="r", **more: builtins.open(name, mode.replace("U", ""), **more)
    bpy.ops.import_anim.bvh(filepath=path, global_scale=metres, axis_forward=forward, axis_up=up,
                            frame_start=1, update_scene_fps=False)


def import_file(path):
    """Returns the frame on which the motion begins."""
    if path.endswith(".bvh"):
        import_bvh(path, 0.01, "-Z", "Y")
        return 1
    bpy.ops.import_scene.gltf(filepath=path)
    return 0


def expected(position):
    """A point of Hazumi's (x forward, y left, z up) as Blender has it after its turn from y up to
    z up: facing -y."""
    x, y, z = position
    return Vector((y, -x, z))


def largest_error(armature, motion, start):
    """The largest distance of any joint at any frame [m], and where that is."""
    worst, where, frames = 0.0, None, motion["frames"]
    for frame in frames:
        bpy.context.scene.frame_set(start + frame["frame"] - frames[0]["frame"])
        for joint, position in zip(motion["joint_groups"], frame["joint_positions_m"]):
            bone = armature.pose.bones.get(joint)
            if bone is None:
                raise SystemExit(f"Blender has no bone {joint}")
            error = (armature.matrix_world @ bone.head - expected(position)).length
            if not error <= worst:
                worst, where = error, f"{joint} at frame {frame['frame']}"
    return worst, where


def largest_object_error(motion, start):
    """The same of the centres of held objects, which glTF alone has."""
    worst = 0.0
    for frame in motion["frames"]:
        bpy.context.scene.frame_set(start + frame["frame"] - motion["frames"][0]["frame"])
        for held in frame.get("objects", []):
            thing = bpy.data.objects.get(held["name"])
            if thing is None:
                raise SystemExit(f"Blender has no object {held['name']}")
            place = thing.matrix_world.translation
            worst = max(worst, (place - expected(held["position"])).length)
    return worst


def render(path, start, motion):
    """A picture of the middle frame, from the front left."""
    scene = bpy.context.scene
    middle = motion["frames"][len(motion["frames"]) // 2]
    scene.frame_set(start + middle["frame"] - motion["frames"][0]["frame"])
    target = expected(middle["root"]["position"])
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = target + Vector((2.2, -3.0, 0.5))
    camera.rotation_euler = (target - camera.location).to_track_quat("-Z", "Y").to_euler()
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy = 3.0
    sun.rotation_euler = (0.6, 0.3, 0.0)
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.6, 0.65, 0.7, 1.0)
    for thing in (camera, sun):
        scene.collection.objects.link(thing)
    scene.world, scene.camera = world, camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = 16, False
    scene.render.resolution_x = scene.render.resolution_y = 400
    scene.render.filepath = os.path.abspath(path)
    bpy.ops.render.render(write_still=True)


def main():
    path, reference, *picture = sys.argv[sys.argv.index("--") + 1:]
    with open(reference, encoding="utf-8") as file:
        motion = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = round(motion["fps"])
    bpy.context.scene.render.fps_base = round(motion["fps"]) / motion["fps"]
    start = import_file(path)
    armature = next(o for o in bpy.context.scene.objects if o.type == "ARMATURE")
    worst, where = largest_error(armature, motion, start)
    meshes = sum(o.type == "MESH" for o in bpy.context.scene.objects)
    print(f"blender    {path}: {len(motion['frames'])} frames, {len(armature.data.bones)} bones, "
          f"{meshes} meshes, off by {worst:.1e} m at most ({where})", flush=True)
    if not worst <= TOLERANCE_M:
        raise SystemExit(f"more than {TOLERANCE_M} m")
    if not path.endswith(".bvh"):
        worst = largest_object_error(motion, start)
        print(f"blender    {path}: held objects off by {worst:.1e} m at most", flush=True)
        if not worst <= TOLERANCE_M:
            raise SystemExit(f"more than {TOLERANCE_M} m")
    if picture:
        render(picture[0], start, motion)


if __name__ == "__main__":
    main()
