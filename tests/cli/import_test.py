#!/usr/bin/env -S /usr/bin/python3
"""What hazumi --import makes of files of other programs, and what it leaves behind when it cannot.
usage: import_test.py HAZUMI"""

import base64
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import time
import zlib

from command_line import HAZUMI, THROW, InFolder, main, run, start


def png(size):
    """A white square."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    rows = b"".join(b"\0" + b"\xff" * 3 * size for _ in range(size))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def data_uri(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def gltf(clips, pictures):
    """A bone on another, that turn in each clip; a triangle for each picture."""
    data, views, accessors = b"", [], []

    def add(form, numbers, component, kind, **more):
        nonlocal data
        data += b"\0" * (-len(data) % 4)
        packed = struct.pack(f"<{len(numbers)}{form}", *numbers)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data += packed
        count = len(numbers) // {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[kind]
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": count,
                          "type": kind, **more})
        return len(accessors) - 1

    floats = 5126
    attributes = {
        "POSITION": add("f", [0, 0, 0, 0.3, 1, 0, 0, 1.7, 0], floats, "VEC3", min=[0, 0, 0],
                        max=[0.3, 1.7, 0]),
        "TEXCOORD_0": add("f", [0, 0, 1, 0, 0, 1], floats, "VEC2"),
        "JOINTS_0": add("B", [0, 1, 0, 0] * 3, 5121, "VEC4"),
        "WEIGHTS_0": add("f", [0.5, 0.5, 0, 0] * 3, floats, "VEC4")}
    times = add("f", [0, 1], floats, "SCALAR", min=[0], max=[1])
    turns = add("f", [0, 0, 0, 1, 0, 0, 0.6, 0.8], floats, "VEC4")
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"name": "hips", "translation": [0, 0.9, 0], "children": [1]},
                  {"name": "spine", "translation": [0, 0.3, 0]}, {"mesh": 0, "skin": 0}],
        "skins": [{"joints": [0, 1]}],
        "meshes": [{"primitives": [{"attributes": attributes, "material": i}
                                   for i in range(max(len(pictures), 1))]}],
        "animations": [{"name": name, "samplers": [{"input": times, "output": turns}],
                        "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}
                       for name in clips],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}}
                      for i in range(len(pictures))] or [{}],
        "textures": [{"source": i} for i in range(len(pictures))],
        "images": [{"name": f"picture{i}", "uri": data_uri(picture, "image/png")}
                   for i, picture in enumerate(pictures)],
        "bufferViews": views, "accessors": accessors,
        "buffers": [{"byteLength": len(data), "uri": data_uri(data)}]}
    return json.dumps({key: value for key, value in document.items() if value != []})


class Import(InFolder):
    def walk(self, frames=5):
        """A clip: a trunk that leans forward, an arm that swings."""
        rows = "".join(f"0 {90 + i % 5} 0 0 {5 * (i % 5)} 0 {40 * (i % 2)} 0 0\n"
                       for i in range(frames))
        path = self.folder / "walk.bvh"
        path.write_text(
            "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
            "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
            "JOINT LeftArm\n{\nOFFSET 20 80 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
            "End Site\n{\nOFFSET 60 0 0\n}\n}\n"
            "JOINT LeftLeg\n{\nOFFSET 10 -90 0\nEnd Site\n{\nOFFSET 0 0 20\n}\n}\n}\n"
            f"MOTION\nFrames: {frames}\nFrame Time: 0.0333333\n{rows}")
        return path

    def test_a_character_of_no_size_is_an_error_that_says_what_to_do(self):
        out, path = self.folder / "walk.kfa", self.walk()
        done = run("--import", path, "--unit", "1e-9", "--save", out)
        self.assertEqual(done.returncode, 65)
        self.assertIn("--height", done.stderr)
        self.assertFalse(out.exists())
        text = path.read_text()
        for place in ("20 80 0", "60 0 0", "10 -90 0", "0 0 20"):
            text = text.replace(f"OFFSET {place}", "OFFSET 0 0 0")
        path.write_text(text)
        done = run("--import", path, "--save", out)
        self.assertEqual(done.returncode, 65)
        self.assertIn("all its bones lie in one place", done.stderr)
        self.assertFalse(out.exists())

    def test_import_makes_a_project_and_says_what_it_took_it_for(self):
        out = self.folder / "walk.kfa"
        done = run("--import", self.walk(), "--save", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for fact in ("2 joints below \"Hips\"", "y is up (guessed)", "1 unit is 0.01 m (guessed: "
                     "centimetres): 1.7 m tall", "5 frames at 30 a second", f"saved as {out}"):
            self.assertIn(fact, done.stdout)
        self.assertEqual(run("--check", out).returncode, 0)
        first = out.read_bytes()
        run("--import", self.walk(), "--save", out)
        self.assertEqual(out.read_bytes(), first)
        project = json.loads(first)
        self.assertEqual(project["frames"], {"first": 0, "last": 4})
        self.assertEqual([round(k["position_m"], 9) for k in project["root"]["z"]["keys"]],
                         [0.9, 0.91, 0.92, 0.93, 0.94])

    def test_import_obeys_its_options(self):
        out = self.folder / "walk.kfa"
        done = run("--import", self.walk(), "--save", out, "--height", "2", "--mass", "80",
                   "--reduce", "1", "--fps", "60", "--limits", "none", "--up", "y")
        self.assertEqual(done.returncode, 0, done.stderr)
        for fact in ("2 m tall", "80 kg", "y is up (as asked for)", "within 1 degree of",
                     "at 60 a second"):
            self.assertIn(fact, done.stdout)
        project = json.loads(out.read_text())
        self.assertEqual(project["fps"], {"num": 60, "den": 1})
        leaning = [c for c in project["root"].values() if len(c["keys"]) == 2]
        self.assertTrue(leaning)  # what goes evenly has two keys

    def test_import_without_a_place_to_save_or_with_a_wrong_one_is_wrong_usage(self):
        for wrong, message in (([], "--import wants --save OUT.kfa"),
                               (["--save", "out.bvh"], "the name must end in .kfa"),
                               (["--save", "o.kfa", THROW], "--import takes one file"),
                               (["--save", "o.kfa", "--reduce", "0"], "give degrees"),
                               (["--save", "o.kfa", "--up", "x"], "give y or z")):
            done = run("--import", self.walk(), *wrong, cwd=self.folder)
            self.assertEqual((done.returncode, done.stdout), (2, ""), wrong)
            self.assertIn(message, done.stderr)

    def test_import_of_what_cannot_be_imported_saves_nothing(self):
        broken = self.folder / "broken.bvh"
        broken.write_text("HIERARCHY\nROOT Hips\n{\n")
        text = self.folder / "notes.fbx"
        text.write_text("Dear diary")
        for file, code in ((broken, 65), (text, 65), (self.folder / "none.bvh", 66)):
            done = run("--import", file, "--save", self.folder / "o.kfa")
            self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
            self.assertTrue(done.stderr.startswith(f"hazumi: {file}: "), done.stderr)
        done = run("--import", self.walk(), "--clip", "jump", "--save", self.folder / "o.kfa")
        self.assertEqual(done.returncode, 65)
        self.assertIn("there is no \"jump\"; there are \"walk\"", done.stderr)
        self.assertNotIn("o.kfa", self.files())

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_a_reader_that_crashes_swells_or_babbles_is_bad_data(self):
        for commands, message in (("kill -SEGV $$", "crashed on it (Segmentation fault)"),
                                  ("exit 3", "2048 MB of memory"), ("exit 1", "crashed on it (exit 1)"),
                                  ("echo hello >&3", "no usable answer")):
            done = run("--import", self.walk(), "--save", self.folder / "o.kfa",
                       program=self.program_with_reader(commands))
            self.assertEqual((done.returncode, done.stdout), (65, ""), done.stderr)
            self.assertIn(message, done.stderr)
            self.assertIn("walk.bvh: ", done.stderr)
            self.assertIn("export it again", done.stderr)
            self.assertNotIn("o.kfa", self.files())

    def test_a_reader_that_is_missing_or_cannot_run_is_no_bad_data(self):
        for commands, message in ((None, "the program hazumi-reader is missing"),
                                  ("exit 127", "install Hazumi again")):
            done = run("--check", self.walk(), program=self.program_with_reader(commands))
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertIn(message, done.stderr)
            self.assertNotIn("export it again", done.stderr)

    def test_a_reader_planted_in_a_folder_above_is_not_run(self):
        program = self.folder / "project/bin/hazumi"
        program.parent.mkdir(parents=True)
        shutil.copy(HAZUMI, program)
        for folder in (self.folder, self.folder / "project"):
            planted = folder / "hazumi-reader"
            planted.write_text(f"#!/bin/sh\ntouch {self.folder}/was_run\n")
            planted.chmod(0o755)
        done = run("--check", self.walk(), program=program,
                   env={**os.environ, "HAZUMI_READER": str(self.folder / "hazumi-reader")})
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("hazumi-reader is missing", done.stderr)
        self.assertNotIn("was_run", self.files())

    def test_of_many_clips_it_says_which_it_took_and_what_the_others_are(self):
        names = [f"clip{i}" for i in range(120)]
        file = self.write("many.gltf", gltf(names, []))
        out = self.folder / "o.kfa"
        for command in (["--import", file, "--save", out], ["--bake", "-", file]):
            done = run(*command)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("clip: warning: \"clip0\" is taken, the first of 120: \"clip0\", \"clip1\", ",
                          done.stderr)
            self.assertIn("\"clip99\" and 20 more; to take another, give its name (--clip NAME)",
                          done.stderr)
            self.assertNotIn("clip: ", run(*command, "--clip", "clip7").stderr)
        wrong = run("--bake", "-", file, "--clip", "jump")
        self.assertEqual(wrong.returncode, 65)
        self.assertIn("there is no \"jump\"; there are \"clip0\", ", wrong.stderr)
        self.assertIn("\"clip99\" and 20 more", wrong.stderr)
        self.assertNotIn("clip", run("--check", self.write("one.gltf", gltf(["turn"], []))).stderr)

    def render(self, file, **more):
        done = run("--render", self.folder / "p", "--size", "64x48", "--frames", "0..0", file, **more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done, (self.folder / "p" / "frame_0000.png").read_bytes()

    def test_a_texture_that_cannot_be_decoded_is_named_and_left_out(self):
        good, cut = png(8), png(8)[:60]
        sound = self.write("sound.gltf", gltf(["turn"], [good, good + b"\0"]))
        done, whole = self.render(sound)
        self.assertNotIn("warning", done.stderr)
        broken = self.write("broken.gltf", gltf(["turn"], [good, cut]))
        done, _ = self.render(broken)
        self.assertIn(f"{broken}: textures[1] ", done.stderr)
        self.assertIn("not a whole PNG", done.stderr)
        self.assertNotIn("textures[0]", done.stderr)
        # A project has its textures in it; who decodes them is missing, then crashes.
        out = self.folder / "sound.kfa"
        self.assertEqual(run("--import", sound, "--save", out).returncode, 0)
        self.assertEqual(self.render(out)[1], whole)
        done, _ = self.render(out, program=self.program_with_reader())
        self.assertEqual(done.stderr.count("textures: warning: cannot be read, because the program "
                                           "hazumi-reader is missing"), 1, done.stderr)
        done, _ = self.render(out, program=self.program_with_reader("kill -SEGV $$"))
        for texture in ("textures[0] ", "textures[1] "):
            self.assertIn(texture, done.stderr)
        self.assertIn("crashed on it (Segmentation fault)", done.stderr)

    def test_the_program_itself_decodes_no_pictures(self):
        program = pathlib.Path(HAZUMI).read_bytes()
        for symbol in (b"png_create_read_struct", b"jpeg_read_header", b"libjpeg"):
            self.assertNotIn(symbol, program)
        self.assertIn(b"png_create_write_struct", program)

    def test_an_interrupted_import_ends_its_reader_and_leaves_nothing(self):
        """A reader that never answers says who it is."""
        number = self.folder / "number"
        program = self.program_with_reader(f"echo $$ > {number}.new; mv {number}.new {number}\n"
                                           "exec sleep 100")
        walk = self.walk()
        for signal_number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            number.unlink(missing_ok=True)
            process = start("--import", walk, "--save", self.folder / "o.kfa",
                            program=program)
            while not number.exists():
                time.sleep(0.01)
            process.send_signal(signal_number)
            out, complaint = process.communicate(timeout=10)
            self.assertEqual((process.returncode, out), (130, ""), complaint)
            self.assertFalse(pathlib.Path("/proc", number.read_text().strip()).exists())
            self.assertEqual(self.files(), ["number", "walk.bvh"])

    def test_an_import_interrupted_at_any_time_ends_soon_and_leaves_nothing(self):
        """Not only while the file is read."""
        walk = self.walk(frames=20000)
        out = self.folder / "o.kfa"
        began = time.monotonic()
        self.assertEqual(run("--import", walk, "--save", out).returncode, 0)
        whole = time.monotonic() - began
        for share in (0.2, 0.4, 0.6, 0.8):
            out.unlink(missing_ok=True)
            process = start("--import", walk, "--save", out)
            time.sleep(share * whole)
            process.send_signal(signal.SIGTERM)
            _, complaint = process.communicate(timeout=60)
            if process.returncode == 0:  # it was done before
                continue
            self.assertEqual(process.returncode, 130, complaint)
            self.assertEqual(self.files(), ["walk.bvh"])

    def long_take(self, frames):
        """A BVH file of ninety hinges."""
        joints = 30
        chain = "".join(f"JOINT J{i}\n{{\nOFFSET 0 6 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
                        for i in range(joints))
        rows = [" ".join(str((7 * f + 3 * k) % 20) for k in range(3 * joints)) for f in range(20)]
        return self.write("long.bvh", "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n"
                          "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                          + chain + "End Site\n{\nOFFSET 0 6 0\n}\n" + "}\n" * (joints + 1)
                          + f"MOTION\nFrames: {frames}\nFrame Time: 0.00833333\n"
                          + "".join(f"0 90 0 0 0 {f % 9} {rows[f % 20]}\n" for f in range(frames)))

    def test_a_take_with_too_many_keys_is_refused_by_its_first_rows(self):
        """A fault in its last row is not reached."""
        path, out = self.long_take(40000), self.folder / "long.kfa"
        with open(path, "a", encoding="utf-8") as file:
            file.write("0 90 no number\n")
        for more, message in (([], "40000 frames (5.56 minutes) makes about 3.76 million keys"),
                              (["--fps", "100"], "million keys"), (["--fps", "60"], "line 40"),
                              (["--reduce", "5"], "line 40")):
            done = run("--import", path, "--save", out, *more)
            self.assertEqual(done.returncode, 65)
            self.assertIn(message, done.stderr)

    def test_twenty_thousand_frames_of_ninety_hinges_are_imported_and_read_back(self):
        """More than five million values."""
        path, out = self.long_take(20000), self.folder / "long.kfa"
        for task in (["--import", path, "--save", out], ["--check", out]):
            code, _, complaint, megabytes = self.peak(*task)
            self.assertEqual(code, 0, complaint)
            self.assertLess(megabytes, 1000, task)

    def test_import_says_what_cannot_be_saved(self):
        done = run("--import", self.walk(), "--save", self.folder / "missing" / "o.kfa")
        self.assertEqual((done.returncode, done.stdout), (73, ""), done.stderr)

    def test_a_bvh_file_is_rendered_and_baked_as_it_is(self):
        done = run("--render", self.folder / "p", "--size", "64x48", "--frames", "2..3", self.walk())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.files(), ["frame_0002.png", "frame_0003.png", "walk.bvh"])
        motion = json.loads(run("--bake", "-", self.walk()).stdout)
        self.assertEqual(len(motion["frames"]), 5)
        # The arm's joint: 20 to the left, 80 up of hips that lean back and forth about y = left.
        x, y, z = motion["frames"][0]["joint_positions_m"][0]
        self.assertAlmostEqual(x, 0.0, 9)
        self.assertAlmostEqual(y, 0.2, 9)
        self.assertAlmostEqual(z, 1.7, 9)


if __name__ == "__main__":
    main()
