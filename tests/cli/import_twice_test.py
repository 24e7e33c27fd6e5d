#!/usr/bin/env -S /usr/bin/python3
"""Compares two imports of one file: exit code, message and, byte for byte, project must be equal.
The allocator fills the memory of hazumi with different values in each; memory of the reader, which
opens the file, is mostly zero in both.
usage: import_twice_test.py HAZUMI

HAZUMI_CASES and HAZUMI_FIRST_CASE: number of changed files, and first seed."""

import os
import pathlib
import random

from command_line import InFolder, main, run

FIRST, CASES = int(os.environ.get("HAZUMI_FIRST_CASE", 1)), int(os.environ.get("HAZUMI_CASES", 12))
PATTERNS = ("characters/*.glb", "characters/*.gltf", "characters/*.fbx", "wild/*.fbx", "wild/*.dae")
BROKEN = ("reports/*.gltf", "reports/*.glb", "reports/*.fbx", "reports/*.dae", "faults/*.gltf")
SMALL = ("characters/assimp_simple_skin.gltf", "characters/khronos_rigged_simple.gltf")


class ImportTwice(InFolder):
    def import_once(self, path, fill):
        saved = self.folder / "saved.kfa"
        saved.unlink(missing_ok=True)
        done = run("--import", path, "--save", saved,
                   env={**os.environ, "MALLOC_PERTURB_": str(fill)})
        return done.returncode, done.stderr, saved.read_bytes() if saved.exists() else None

    def assert_same(self, path, what):
        one, other = self.import_once(path, 85), self.import_once(path, 170)
        self.assertEqual(one[:2], other[:2], what)
        self.assertTrue(one[2] == other[2], f"{what}: two imports differ")
        return one[0] == 0

    def test_shared_characters_give_the_same_bytes(self):
        for pattern in PATTERNS:
            for path in self.data_files(*pattern.split("/")):
                self.assertTrue(self.assert_same(path, path.name), path.name)

    def test_reported_files_give_the_same_bytes_or_the_same_complaint(self):
        for pattern in BROKEN:
            for path in self.data_files(*pattern.split("/")):
                self.assert_same(path, path.name)

    def test_changed_characters_give_the_same_bytes_or_the_same_complaint(self):
        """Changes a few bytes of a small character."""
        print(f"seeds {FIRST} to {FIRST + CASES - 1}: HAZUMI_FIRST_CASE={FIRST} HAZUMI_CASES={CASES} "
              "tries them again", flush=True)
        changed = self.folder / "changed.gltf"
        for seed in range(FIRST, FIRST + CASES):
            draw = random.Random(seed)
            [path] = self.data_files(*SMALL[seed % len(SMALL)].split("/"))
            data = bytearray(pathlib.Path(path).read_bytes())
            for _ in range(draw.randint(1, 4)):
                place = draw.randrange(len(data))
                while not chr(data[place]).isalnum():
                    place = draw.randrange(len(data))
                data[place] = ord(draw.choice("0123456789aAzZ"))
            changed.write_bytes(data)
            self.assert_same(changed, f"seed {seed}")


if __name__ == "__main__":
    main()
