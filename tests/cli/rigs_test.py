#!/usr/bin/env -S /usr/bin/python3
"""Rigs as others build them (made_rigs.py): what each bone is in a body is found, feet
and hands that hang beside their limbs are put back on those, and what is animated goes back into the
file; turned and scaled rigs stand upright on the ground, facing forward. usage: rigs_test.py HAZUMI"""

import json
import pathlib
import unittest

import numpy as np

from command_line import data_folder, main
from foreign_reader import Gltf
from made_rigs import Rig, make_rigs
from put_back import PutsBack, fit_most

LIMBS = {f"{side} {role}" for side in ("left", "right")
         for role in ("upper_arm", "forearm", "thigh", "shin", "foot")}
ANKLES = {"foot.l", "foot.r", "hand.l", "hand.r"}


def roles_of(project):
    return {f"{j.get('side', 'middle')} {j.get('role', 'none')}" for j in project["figure"]["joints"]}


@unittest.skipUnless(data_folder.path("characters/kaykit_Knight.glb").exists(), "no data")
class Rigs(PutsBack):
    def imported(self, path, *options):
        project = self.folder / "imported.kfa"
        self.ok("--import", path, "--save", project, *options)
        return project, json.loads(project.read_text())

    def test_ten_rigs_have_all_roles_and_take_motion_back(self):
        rigs = make_rigs(data_folder.path(), self.folder)
        self.assertEqual(len(rigs), 10)
        for name, path in rigs.items():
            with self.subTest(name):
                _, project = self.imported(path)
                missing = LIMBS - roles_of(project)
                self.assertEqual(missing, set())
                if name != "no_clip":
                    self.put_back(path, ends=1 if name == "hands_apart" else 0)

    def test_ends_beside_their_limbs_are_where_the_file_has_them(self):
        rigs = make_rigs(data_folder.path(), self.folder)
        for name in ("feet_apart", "hands_apart"):
            project, _ = self.imported(rigs[name])
            places, joints, _, fps = self.baked(project)
            gltf = Gltf(rigs[name])
            there, names = gltf.places(gltf.animation("Walking_A"), [f / fps for f in range(len(places))])
            both = [(k, names.index(joint)) for k, joint in enumerate(joints) if joint in names]
            move = fit_most(there[:, [i for _, i in both]], places[:, [k for k, _ in both]])
            for k, i in both:
                if names[i] not in ANKLES:
                    continue
                off = np.linalg.norm(move(there[:, i]) - places[:, k], axis=1)
                whole = np.linalg.norm(move(there[:, names.index("upperleg.l")]) -
                                       places[:, joints.index("upperleg.l")], axis=1).max()
                # As far as the thigh is, which the clip moves in its hip.
                self.assertLess(off.max(), (whole if "foot" in names[i] else 0.0) + 1e-3, (name, names[i]))

    def test_twenty_turned_and_scaled_rigs_stand_upright_and_face_forward(self):
        shoulders = {"kaykit_Knight.glb": ("upperarm.l", "upperarm.r"), "boxman.glb": ("arm_upper.L", "arm_upper.R")}
        for source in ("characters/kaykit_Knight.glb", "own/boxman.glb"):
            tall = None
            for i in range(10):
                with self.subTest(source, i=i):
                    rig = Rig(data_folder.path(source), ())
                    angle, factor = 36.0 * i + 11.0, [1.0, 100.0, 0.01][i % 3]
                    if factor != 1.0:
                        rig.scale_inside(factor)
                    rig.put_above(rotation=[0.0, np.sin(np.radians(angle / 2)), 0.0, np.cos(np.radians(angle / 2))])
                    path = self.folder / f"rig_{i}.glb"
                    rig.write(path)
                    project, content = self.imported(path)
                    places, joints, _, _ = self.baked(project)
                    left, right = (places[0][joints.index(name)] for name in shoulders[path_name(source)])
                    across = left - right
                    self.assertGreater(across[1], 0.99 * np.linalg.norm(across), "left is at y")
                    height = places[0][:, 2].max() - places[0][:, 2].min()
                    tall = tall or height
                    self.assertAlmostEqual(height / tall, 1.0, delta=1e-3)
                    ground = next(o["plane"]["offset_m"] for o in content["scene"]["objects"] if "plane" in o)
                    self.assertLess(abs(places[0][:, 2].min() - ground), 0.2 * height)


def path_name(path):
    return pathlib.PurePath(path).name


if __name__ == "__main__":
    main()
