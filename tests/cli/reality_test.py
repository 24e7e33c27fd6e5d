"""The arms of captured walks, let go between two keys, are nearer to the capture than the curves
between these keys are. The rest of what tests/reality measures is for scripts/compare_reality."""

import sys
import unittest

from command_line import HAZUMI, ROOT, InFolder, main

sys.path.insert(0, str(ROOT / "tests"))


class Walks(InFolder):
    def test_loose_arms_are_nearer_than_interpolation(self):
        try:
            from reality import cases, springs
        except ImportError as missing:
            self.skipTest(f"{missing}; on Debian: apt install python3-numpy")
        for file in (springs.WALK_2, springs.WALK_7):
            [path] = self.data_files(".", file + ".bvh")
            data = path.parents[1]
            walk = springs.loose_walk(HAZUMI, data, self.folder, file, [cases.FRICTION])
            scores = walk["scores"]
            self.assertLess(scores[str(cases.FRICTION)].cm,
                            springs.WIN * scores["interpolated"].cm, file)


if __name__ == "__main__":
    main()
