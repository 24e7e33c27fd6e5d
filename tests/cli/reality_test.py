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

    # Errors for which the method and its weights were chosen [cm]: body keyed alike, as captured.
    FILLED = {("baseball pitch", 10): (1.292, 1.195), ("baseball pitch", 20): (2.975, 2.834),
              ("baseball pitch", 40): (18.90, 17.63), ("basketball shot", 10): (0.354, 0.323),
              ("basketball shot", 20): (1.546, 1.360), ("basketball shot", 40): (5.129, 3.316),
              ("walk 02_01", 10): (0.1655, 0.1252), ("walk 02_01", 20): (0.4263, 0.3129),
              ("walk 02_01", 40): (1.637, 1.465), ("walk 07_01", 10): (0.2122, 0.1646),
              ("walk 07_01", 20): (0.6045, 0.4048), ("walk 07_01", 40): (2.392, 1.898)}

    def test_keys_of_fills_are_within_3_percent_of_the_errors_of_their_method(self):
        try:
            from reality import fills, springs
        except ImportError as missing:
            self.skipTest(f"{missing}; on Debian: apt install python3-numpy")
        for name, file, stretch, _, _, _ in springs.CLIPS:
            [path] = self.data_files(".", file + ".bvh")
            clip = springs.load(HAZUMI, path.parents[1], self.folder, file)
            for gap in fills.GAPS:
                for body, expected in zip(fills.BODIES, self.FILLED[name, gap]):
                    row = fills.judge(HAZUMI, self.folder, clip, stretch, gap, body)
                    self.assertLess(row["fill"].cm, 1.03 * expected, (name, gap, body))


if __name__ == "__main__":
    main()
