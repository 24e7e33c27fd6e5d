#!/usr/bin/env -S /usr/bin/python3
"""What --render draws: which frames, into which files, the same each time.
usage: render_test.py HAZUMI"""

import os
import unittest

from command_line import THROW, InFolder, main, run
from png_pixels import rows_of


class Render(InFolder):
    def test_one_frame_is_drawn_into_the_picture_that_is_named(self):
        picture = self.folder / "new" / "one.png"
        small = ["--size", "32x24", "--samples", "1"]
        done = run("--render", picture, "--frames", "3", *small, THROW)
        self.assertEqual((done.returncode, self.files()), (0, ["one.png"]), done.stderr)
        self.assertEqual(run("--render", self.folder / "all", "--frames", "3", *small, THROW).returncode, 0)
        self.assertEqual(picture.read_bytes(), (self.folder / "all" / "frame_0003.png").read_bytes())
        for frames in ([], ["--frames", "3..4"]):
            done = run("--render", self.folder / "two.png", *frames, *small, THROW)
            self.assertEqual(done.returncode, 2)
            self.assertIn("one picture is a .png with --frames N", done.stderr)

    def test_frames_partly_outside_are_clipped_with_a_warning(self):
        done = run("--render", self.folder / "a", "--size", "64x48", "--frames", "29..50", THROW)
        self.assertEqual(done.returncode, 0)
        self.assertIn("has frames 0..30; drawing 29..30", done.stderr)
        self.assertEqual(self.files(), ["frame_0029.png", "frame_0030.png"])

    def test_render_writes_the_frames_asked_for(self):
        small = ["--size", "64x48"]
        self.assertEqual(run("--render", self.folder / "a", *small, "--frames", "3..5",
                             THROW).returncode, 0)
        self.assertEqual(run("--render", self.folder / "b_##.png", *small, "--frames", "7",
                             THROW).returncode, 0)
        self.assertEqual(self.files(), ["b_07.png", "frame_0003.png", "frame_0004.png",
                                        "frame_0005.png"])

    def test_each_picture_shows_its_own_frame_whatever_the_range_and_without_a_display(self):
        """Of a range, alone, and again: the same bytes. Two frames: other ones."""
        bare = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
        pictures = {}
        for frames in ("3..5", "4..4", "5..7"):
            folder = self.folder / frames
            done = run("--render", folder, "--size", "64x48", "--frames", frames, THROW, env=bare)
            self.assertEqual(done.returncode, 0, done.stderr)
            for path in folder.iterdir():
                seen = pictures.setdefault(path.name, path.read_bytes())
                self.assertEqual(seen, path.read_bytes(), path)
        self.assertEqual(sorted(pictures), [f"frame_{i:04}.png" for i in range(3, 8)])
        self.assertEqual(len(set(pictures.values())), 5)

    def test_equal_input_gives_equal_pictures_with_any_number_of_threads(self):
        for threads in ("1", "16"):
            run("--render", self.folder / threads, "--size", "160x90", "--frames", "4..8",
                "--threads", threads, "--paths", "--marks", "--tint", "--ghosts", "10", THROW)
        for name in (f"frame_{i:04}.png" for i in range(4, 9)):
            self.assertEqual((self.folder / "1" / name).read_bytes(),
                             (self.folder / "16" / name).read_bytes())

    def test_the_body_is_its_skin_unless_the_capsules_are_asked_for(self):
        pictures = {}
        for body in ((), ("--body", "skin"), ("--body", "capsules"), ("--body", "both")):
            folder = self.folder / "-".join(("body", *body))
            run("--render", folder, "--size", "160x90", "--frames", "4", *body, THROW)
            # Files differ in the options that they note.
            pictures[body[-1:]] = tuple(rows_of(folder / "frame_0004.png"))
        self.assertEqual(pictures[()], pictures[("skin",)])
        self.assertEqual(len(set(pictures.values())), 3)


if __name__ == "__main__":
    main()
