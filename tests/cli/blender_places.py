"""Run by Blender: where the bones of a glTF file's skeleton are. arguments: FILE CLIP COUNT FPS OUT.
OUT: JSON, the names and [frame][bone] places [m]."""

import json
import sys

import bpy
import numpy

if not hasattr(numpy, "bool"):
    numpy.bool = bool  # a name that Debian's Blender still uses and its numpy no longer has

path, clip, count, fps, out = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.fps = round(float(fps))
bpy.ops.import_scene.gltf(filepath=path)
rig = next(o for o in scene.objects if o.type == "ARMATURE")
for track in rig.animation_data.nla_tracks:
    track.mute = True
wanted = [a for a in bpy.data.actions if any(c.data_path.startswith("pose.bones") for c in a.fcurves)]
rig.animation_data.action = next((a for a in wanted if a.name.startswith(clip)), wanted[0])
places = []
for frame in range(int(count)):
    scene.frame_set(frame)
    places.append([list(rig.matrix_world @ bone.head) for bone in rig.pose.bones])
with open(out, "w", encoding="utf-8") as file:
    json.dump({"names": [bone.name for bone in rig.pose.bones], "places": places}, file)
