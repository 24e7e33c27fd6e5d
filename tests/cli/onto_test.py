#!/usr/bin/env -S /usr/bin/python3
"""Puts a changed arm back into the file it was imported from, and looks by an independent reader: the
changed bones are where the project has them, everything else says what it said, its buffers and numbers byte for byte. Prints a
line for each file. usage: onto_test.py HAZUMI"""

from command_line import THROW, data_folder, main, run
from put_back import PutsBack

# Files with a clip, below the data.
FILES = ["characters/kaykit_Knight.glb", "characters/khronos_cesium_man.gltf",
         "characters/khronos_rigged_simple.gltf", "characters/assimp_simple_skin.gltf", "own/boxman.glb",
         "own/husky.glb", "reports/g00_control.gltf", "reports/g01_rotation_normalized_short.gltf",
         "reports/g02_cubic_three_keys.gltf", "reports/g03_first_key_at_1p5s.gltf", "reports/g24_gltfpack_noq.glb",
         "reports/g25_no_skin_arm_and_leg_move.gltf", "reports/g11_parent_scaled_unevenly.gltf",
         "other/bvhtoolbox_walk01.bvh", "other/cmu_mb_02_01_walk.bvh", "wild/cmu_mb_02_03_run.bvh",
         "wild/cmu_mb_90_05_jump_kick.bvh"]


class Onto(PutsBack):
    def test_changed_arm_of_every_character(self):
        if not data_folder.path().is_dir():
            self.skipTest("no data")
        for name in FILES:
            with self.subTest(name):
                changed, held, off, again = self.put_back(data_folder.path() / name, ends="husky" in name)
                print(f"{name}: {changed[0]}: in the file {held} within {1e3 * off:.4f} mm, "
                      f"read again {1e3 * again:.4f} mm", flush=True)

    def test_own_export_without_data(self):
        exported = self.folder / "throw.glb"
        self.ok("--export", exported, THROW)
        self.put_back(exported)

    def test_unchanged_file_is_the_same_bytes(self):
        exported, project, again = (self.folder / name for name in ("throw.glb", "a.kfa", "again.glb"))
        self.ok("--export", exported, THROW)
        self.ok("--import", exported, "--save", project)
        self.assertEqual(self.ok("--export", again, "--onto", exported, project), "no bone has changed\n")
        self.assertEqual(again.read_bytes(), exported.read_bytes())

    def test_refusals_say_what_to_do(self):
        exported, project = self.folder / "throw.glb", self.folder / "a.kfa"
        self.ok("--export", exported, THROW)
        self.ok("--import", exported, "--save", project)
        bvh = self.folder / "throw.bvh"
        self.ok("--export", bvh, THROW)
        for out, onto, file, says in [("throw.glb", exported, project, "name another"),
                                      ("x.bvh", exported, project, "has to end in .glb"),
                                      ("x.glb", self.folder / "none.glb", project, "none.glb"),
                                      ("x.vrm", None, project, "wants --onto"),
                                      ("x.csv", exported, project, "--onto belongs to"),
                                      ("x.glb", exported, THROW, "was not imported from")]:
            with self.subTest(out=out, says=says):
                done = run("--export", self.folder / out, *(["--onto", onto] if onto else []), file)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(says, done.stderr)


if __name__ == "__main__":
    main()
