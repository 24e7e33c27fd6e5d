#!/usr/bin/env -S /usr/bin/python3
"""What onto_test.py does, with Blender as the reader, for two characters. Blender is large: this is
run by hand, and skipped where Blender is not installed. usage: onto_in_blender_test.py HAZUMI"""

import json
import pathlib
import shutil
import subprocess

import numpy as np

from command_line import data_folder, main
from put_back import PutsBack

SCRIPT = pathlib.Path(__file__).with_name("blender_places.py")


class OntoInBlender(PutsBack):
    def file_places(self, path, clip, count, fps):
        out = self.folder / "places.json"
        done = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                               SCRIPT, "--", path, clip, str(count), str(fps), out],
                              capture_output=True, text=True, check=False, timeout=300)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        read = json.loads(out.read_text())
        return np.array(read["places"]), read["names"]

    def test_changed_arm_of_two_characters(self):
        if not data_folder.path().is_dir() or not shutil.which("blender"):
            self.skipTest("no data, or no Blender")
        for name in ("characters/kaykit_Knight.glb", "characters/khronos_cesium_man.gltf"):
            with self.subTest(name):
                changed, held, off, again = self.put_back(data_folder.path() / name)
                print(f"{name}: {changed[0]}: in Blender {held} within {1e3 * off:.4f} mm, "
                      f"read again {1e3 * again:.4f} mm", flush=True)


if __name__ == "__main__":
    main()
