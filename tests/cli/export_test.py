#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --export writes, and what it leaves behind when it cannot. usage: export_test.py
HAZUMI"""

import base64
import json
import math
import os
import shutil
import signal
import struct
import subprocess
import unittest

from command_line import JUMP, THROW, InFolder, main, run, start

HAS_FFMPEG = shutil.which("ffmpeg") and shutil.which("ffprobe")


def read_glb(path):
    """The JSON and the buffer of a .glb."""
    data = path.read_bytes()
    magic, version, length, size, kind = struct.unpack("<4sIII4s", data[:20])
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    return json.loads(data[20:20 + size]), data[20 + size + 8:]


def frames_of_bvh(path):
    """Number of frames; checks that each frame is a row with a number for each channel."""
    lines = path.read_text().split("\n")
    channels = sum(int(line.split()[1]) for line in lines if line.strip().startswith("CHANNELS"))
    start = lines.index("MOTION")
    count = int(lines[start + 1].removeprefix("Frames: "))
    rows, end = lines[start + 3:-1], lines[-1]
    assert (len(rows), end) == (count, ""), (len(rows), count, end)
    assert all(len([float(number) for number in row.split()]) == channels for row in rows)
    return count


def frames_of_animation(gltf, buffer):
    """Number of frames of all channels; checks that every reference is within the buffer."""
    for view in gltf["bufferViews"]:
        assert view.get("byteOffset", 0) + view["byteLength"] <= len(buffer), view
    [animation] = gltf["animations"]
    counts = {gltf["accessors"][sampler["input"]]["count"] for sampler in animation["samplers"]}
    outputs = {gltf["accessors"][sampler["output"]]["count"] for sampler in animation["samplers"]}
    assert len(counts) == 1 and counts == outputs, (counts, outputs)
    return counts.pop()


def frames_of_glb(path):
    gltf, buffer = read_glb(path)
    assert len(buffer) == gltf["buffers"][0]["byteLength"]
    return frames_of_animation(gltf, buffer)


def frames_of_gltf(path):
    gltf = json.loads(path.read_text())
    buffer = base64.b64decode(gltf["buffers"][0]["uri"].split(",", 1)[1], validate=True)
    assert len(buffer) == gltf["buffers"][0]["byteLength"]
    return frames_of_animation(gltf, buffer)


def frames_of_csv(path):
    """Number of rows; checks that each row has a cell for each name."""
    head, *rows, end = path.read_text().split("\n")
    assert end == "" and rows, end
    assert all(row.count(",") == head.count(",") for row in rows)
    return len(rows)


def frames_of_json(path):
    return len(json.loads(path.read_text())["frames"])


class Export(InFolder):
    def export(self, name, *options, project=THROW):
        path = self.folder / name
        done = run("--export", path, *options, project)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        return path

    def test_every_format_has_all_frames_and_ends_where_it_should(self):
        """Exports 31 frames. The reader of each format rejects truncated files."""
        for suffix, num_frames in (("bvh", frames_of_bvh), ("gltf", frames_of_gltf),
                                   ("glb", frames_of_glb), ("csv", frames_of_csv),
                                   ("json", frames_of_json), ("GLB", frames_of_glb)):
            path = self.export(f"throw.{suffix}")
            self.assertEqual(num_frames(path), 31, suffix)
            whole = path.read_bytes()
            for part in (len(whole) // 2, len(whole) - 3):
                path.write_bytes(whole[:part])
                with self.assertRaises((ValueError, AssertionError, struct.error), msg=suffix):
                    num_frames(path)
        self.assertEqual(len(list(self.folder.iterdir())), 6)

    def test_tables_are_those_of_bake(self):
        for suffix in ("csv", "json"):
            baked = self.folder / f"baked.{suffix}"
            run("--bake", baked, THROW)
            self.assertEqual(self.export(f"a.{suffix}").read_text(), baked.read_text())

    def test_a_script_of_the_editor_writes_the_same(self):
        steps = [{"op": "file.export", "path": f"script.{s}"} for s in ("bvh", "glb", "csv", "json")]
        steps.append({"op": "file.export", "path": "part.bvh", "first": 3, "last": 9, "up": "z",
                      "unit": 1})
        (self.folder / "script").write_text(json.dumps(steps))
        done = run("--run", self.folder / "script", THROW, cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for suffix in ("bvh", "glb", "csv"):
            self.assertEqual(self.export(f"a.{suffix}").read_bytes(),
                             (self.folder / f"script.{suffix}").read_bytes(), suffix)
        # The editor keeps no account of energy, so that what JSON reports of regions is less.
        mine = json.loads(self.export("a.json").read_text())
        its = json.loads((self.folder / "script.json").read_text())
        for field in ("frames", "events", "joints"):
            self.assertEqual(its[field], mine[field], field)
        part = self.export("p.bvh", "--frames", "3..9", "--bvh-up", "z", "--bvh-unit", "m")
        self.assertEqual(part.read_bytes(), (self.folder / "part.bvh").read_bytes())

    def test_bvh_is_y_up_in_centimetres_unless_it_is_told_otherwise(self):
        """The root's first position in all four ways."""
        motion = json.loads(self.export("m.json").read_text())
        x, y, z = motion["frames"][0]["root"]["position"]
        for options, wanted in (((), (100 * y, 100 * z, 100 * x)),
                                (("--bvh-unit", "m"), (y, z, x)),
                                (("--bvh-up", "z"), (100 * x, 100 * y, 100 * z)),
                                (("--bvh-up", "z", "--bvh-unit", "m"), (x, y, z))):
            lines = self.export("m.bvh", *options).read_text().splitlines()
            first = lines[lines.index("MOTION") + 3].split()
            for number, value in zip(first, wanted):
                self.assertAlmostEqual(float(number), value, delta=1e-6)

    def test_bvh_has_the_frames_that_are_asked_for(self):
        lines = self.export("m.bvh", "--frames", "3..7", "--fps", "60").read_text().splitlines()
        self.assertIn("Frames: 5", lines)
        time = next(line for line in lines if line.startswith("Frame Time: "))
        self.assertAlmostEqual(float(time.split()[2]), 1.0 / 60.0, places=12)

    def test_gltf_says_what_was_dynamic(self):
        gltf, _ = read_glb(self.export("throw.glb"))
        extras = gltf["animations"][0]["extras"]["hazumi"]
        project = json.loads(THROW.read_text())
        self.assertEqual([r["name"] for r in extras["regions"]],
                         [r["name"] for r in project["regions"]])
        region = extras["regions"][0]
        self.assertEqual(len(region["joints"]), len(region["friction"]))
        self.assertAlmostEqual(region["start_s"], region["first_frame"] / 30.0)
        gltf, _ = read_glb(self.export("jump.glb", project=JUMP))
        extras = gltf["animations"][0]["extras"]["hazumi"]
        self.assertIn("gravity", [p["kind"] for p in extras["placements"]])
        self.assertEqual({"take_off", "landing"} & {e["kind"] for e in extras["events"]},
                         {"take_off", "landing"})

    def test_gltf_holds_the_ball_that_bvh_leaves_out(self):
        gltf, _ = read_glb(self.export("throw.glb"))
        held = json.loads(THROW.read_text())["held_objects"][0]["name"]
        node = next(i for i, n in enumerate(gltf["nodes"]) if n["name"] == held)
        self.assertIn("mesh", gltf["nodes"][node])
        paths = {c["target"]["path"] for c in gltf["animations"][0]["channels"]
                 if c["target"]["node"] == node}
        self.assertIn("translation", paths)
        done = run("--export", self.folder / "throw.bvh", THROW)
        self.assertEqual(done.returncode, 0)
        self.assertIn(f'warning: "{held}" is not written', done.stderr)

    def test_gltf_stands_on_y_with_its_meshes_bound_to_the_bones(self):
        gltf, buffer = read_glb(self.export("jump.glb", project=JUMP))
        self.assertTrue(all("skin" in n for n in gltf["nodes"] if "mesh" in n))
        low, high = math.inf, -math.inf
        for mesh in gltf["meshes"]:
            accessor = gltf["accessors"][mesh["primitives"][0]["attributes"]["POSITION"]]
            low, high = min(low, accessor["min"][1]), max(high, accessor["max"][1])
        self.assertAlmostEqual(high - low, 1.7, delta=0.1)
        self.assertEqual(len(buffer), gltf["buffers"][0]["byteLength"])

    def test_a_place_that_is_not_there_is_named_and_nothing_is_computed(self):
        for name in ("no/such.glb", "no/such.mp4"):
            done = run("--export", self.folder / name, THROW)
            self.assertEqual((done.returncode, done.stdout), (73, ""))
            self.assertIn(f"there is no folder {self.folder / 'no'}; make it", done.stderr)
        (self.folder / "x.glb").mkdir()
        done = run("--export", self.folder / "x.glb", THROW)
        self.assertEqual(done.returncode, 73)
        self.assertIn("is a folder", done.stderr)

    def test_an_error_leaves_the_old_file(self):
        old = self.folder / "old.glb"
        old.write_text("old")
        done = run("--export", old, self.folder / "missing.kfa")
        self.assertEqual(done.returncode, 66)
        self.assertEqual(old.read_text(), "old")
        self.assertEqual(len(list(self.folder.iterdir())), 1)

    def test_a_video_without_ffmpeg_says_what_to_install(self):
        done = run("--export", self.folder / "v.mp4", "--size", "64x48", THROW,
                   env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt install ffmpeg", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_video_has_its_size_and_every_frame(self):
        path = self.folder / "throw.mp4"
        done = run("--export", path, "--size", "97x64", THROW)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--size 97x64: videos have even sizes; drawing 98x64", done.stderr)
        self.assertIn("export 31/31 frame 30", done.stderr)
        asked = "stream=codec_name,width,height,nb_read_frames,r_frame_rate"
        probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", asked,
                                "-of", "json", path], capture_output=True, text=True, check=True)
        self.assertEqual(json.loads(probe.stdout)["streams"],
                         [{"codec_name": "h264", "width": 98, "height": 64,
                           "r_frame_rate": "30/1", "nb_read_frames": "31"}])
        data = path.read_bytes()
        self.assertLess(data.index(b"moov"), data.index(b"mdat"))  # plays before it is all there
        self.assertEqual(len(list(self.folder.iterdir())), 1)

    def with_sound(self, **audio):
        """throw.kfa at 30 fps with a sound beside it: half a second of silence, then a tone for
        0.3 s."""
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-f", "lavfi", "-i",
                        "sine=frequency=1000:sample_rate=48000:duration=0.3,adelay=24000S",
                        self.folder / "tone.wav"], check=True)
        document = self.project()
        document["audio"] = {"file": "tone.wav", **audio}
        project = self.folder / "with_sound.kfa"
        project.write_text(json.dumps(document))
        return project

    def samples_of(self, path):
        """The sound of a video, 48000 numbers a second."""
        done = subprocess.run(["ffmpeg", "-loglevel", "error", "-i", path, "-map", "0:a:0", "-f",
                               "s16le", "-ac", "1", "-ar", "48000", "pipe:1"],
                              capture_output=True, check=True)
        return struct.unpack(f"<{len(done.stdout) // 2}h", done.stdout)

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_video_has_the_sound_of_its_frames(self):
        """Of frames 6 to 25 of 30 a second, by a sound that begins on frame 3; and the same at
        60 frames a second."""
        project = self.with_sound(start_frame=3, gain_db=-6)
        loudest = []
        for fps, frames in (("30", "6..25"), ("60", "12..51")):
            path = self.export(f"v{fps}.mp4", "--size", "64x48", "--fps", fps, "--frames", frames,
                               project=project)
            probe = subprocess.run(["ffprobe", "-v", "error", "-show_entries",
                                    "stream=codec_type,codec_name,start_time,duration", "-of",
                                    "json", path], capture_output=True, text=True, check=True)
            picture, sound = json.loads(probe.stdout)["streams"]
            self.assertEqual((picture["codec_type"], sound["codec_name"]), ("video", "aac"))
            self.assertEqual(float(sound["start_time"]), float(picture["start_time"]))
            self.assertAlmostEqual(float(picture["duration"]), 20 / 30, delta=1e-3)
            self.assertAlmostEqual(float(sound["duration"]), 20 / 30, delta=1024 / 48000)
            samples = self.samples_of(path)
            loudest.append(max(map(abs, samples)))
            heard = [i for i, s in enumerate(samples) if abs(s) > 0.2 * loudest[-1]]
            # From 0.5 s of the file, whose beginning is 0.1 s before the first picture, to its end.
            self.assertAlmostEqual(heard[0] / 48000, 0.4, delta=0.005)
            self.assertGreater(heard[-1] / 48000, 20 / 30 - 0.005)
        path = self.export("loud.mp4", "--size", "64x48", project=self.with_sound())
        samples = self.samples_of(path)
        louder = max(map(abs, samples)) / loudest[0]
        self.assertAlmostEqual(20 * math.log10(louder), 6.0, delta=0.5)

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_sound_changes_no_picture_and_a_mute_one_no_video(self):
        plain = self.export("plain.mp4", "--size", "64x48")
        mute = self.export("mute.mp4", "--size", "64x48", project=self.with_sound(mute=True))
        self.assertEqual(plain.read_bytes(), mute.read_bytes())
        heard = self.export("heard.mp4", "--size", "64x48", project=self.with_sound())
        for name, video in (("plain", plain), ("heard", heard)):
            subprocess.run(["ffmpeg", "-loglevel", "error", "-i", video, "-map", "0:v:0", "-f",
                            "rawvideo", self.folder / name], check=True)
        self.assertEqual((self.folder / "plain").read_bytes(), (self.folder / "heard").read_bytes())

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_sound_that_cannot_be_read_is_said_and_the_project_still_opens(self):
        project = self.with_sound()
        sound = self.folder / "tone.wav"
        old = self.folder / "v.mp4"
        old.write_text("old")
        for spoil, said in ((lambda: sound.write_text("broken"), "ffmpeg finds no sound in it"),
                            (sound.unlink, "cannot be read: No such file or directory")):
            spoil()
            done = run("--export", old, "--size", "64x48", project)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"{sound}: {said}", done.stderr)
            self.assertEqual(old.read_text(), "old")
            self.assertEqual(run("--check", project).returncode, 0)

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg or ffprobe is not installed")
    def test_a_reference_is_in_pictures_if_it_is_asked_for(self):
        subprocess.run(["ffmpeg", "-loglevel", "error", "-f", "lavfi", "-i",
                        "color=red:s=64x48:d=0.04", self.folder / "red.png"], check=True)
        pictures = {}
        for name, more in (("none", None), ("guide", {"opacity": 1}),
                           ("seen", {"opacity": 1, "rendered": True})):
            document = self.project()
            if more:
                document["reference"] = {"file": "red.png", **more}
            project = self.folder / f"{name}.kfa"
            project.write_text(json.dumps(document))
            done = run("--render", self.folder / name, "--size", "64x48", "--frames", "3..3",
                       project)
            self.assertEqual(done.returncode, 0, done.stderr)
            raw = subprocess.run(["ffmpeg", "-loglevel", "error", "-i",
                                  self.folder / name / "frame_0003.png", "-f", "rawvideo",
                                  "-pix_fmt", "rgb24", "pipe:1"], capture_output=True, check=True)
            pictures[name] = raw.stdout
        self.assertEqual(pictures["none"], pictures["guide"])
        red, green, blue = pictures["seen"][:3]
        self.assertGreater(red, 200)
        self.assertLess(max(green, blue), 60)
        (self.folder / "red.png").unlink()
        done = run("--render", self.folder / "again", self.folder / "seen.kfa")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("red.png: cannot be read: No such file or directory", done.stderr)

    @unittest.skipUnless(HAS_FFMPEG, "ffmpeg is not installed")
    def test_an_interrupted_video_leaves_the_old_one(self):
        path = self.folder / "v.mp4"
        path.write_text("old")
        process = start("--export", path, "--fps", "600", "--size", "320x240", THROW)
        for _ in range(3):
            process.stderr.readline()
        process.send_signal(signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertTrue(complaint.endswith("hazumi: interrupted\n"), complaint)
        self.assertEqual(path.read_text(), "old")
        self.assertEqual(len(list(self.folder.iterdir())), 1)

    def test_what_ffmpeg_says_is_passed_on(self):
        fake = self.folder / "ffmpeg"
        fake.write_text("#!/bin/sh\necho 'the encoder is on holiday' >&2\nexit 1\n")
        fake.chmod(0o755)
        done = run("--export", self.folder / "v.mp4", "--size", "64x48", THROW,
                   env={**os.environ, "PATH": f"{self.folder}:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("v.mp4: ffmpeg: the encoder is on holiday", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["ffmpeg"])

    def test_gltf_has_ten_thousand_frames_a_second(self):
        self.assertEqual(frames_of_glb(self.export("big.glb", "--fps", "10000")), 10001)


if __name__ == "__main__":
    main()
