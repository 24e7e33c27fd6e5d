#!/usr/bin/env -S /usr/bin/python3
"""Projects and characters that a stranger made to do harm: each case is refused with a reason, or
does nothing that was not asked for. The files that are opened are traced (strace): none lies in the
folder of secrets. A control opens one, so that the trace would show it.
usage: attack_test.py HAZUMI"""

import base64
import json
import os
import pathlib
import re
import struct
import subprocess

from command_line import InFolder, ROOT, main, run

def can_trace():
    """Not beside a sanitizer, which traces itself, nor where the system forbids it."""
    return os.environ.get("HAZUMI_SANITIZE", "") == "" and subprocess.run(["strace", "-qq", "-o", "/dev/null", "true"], capture_output=True, check=False).returncode == 0


IS_TRACED = can_trace()
SECRET = "qX7-a-secret-line"
VARIED = [{"field": "regions[arms].friction.default", "values": [0.6, 0.8]}]
MEASURED = [{"quantity": "limit_hits"}]
SMALL = ("--size", "64x64", "--samples", "1")


def make(path, *arguments):
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", *arguments, path], check=True)
    return path


class Attack(InFolder):
    def setUp(self):
        super().setUp()
        self.home, self.secrets = self.folder / "home", self.folder / "secrets"
        self.home.mkdir()
        self.secrets.mkdir()
        self.wav = make(self.secrets / "secret.wav", "-f", "lavfi", "-i", "sine=duration=0.5")
        self.png = make(self.secrets / "secret.png", "-f", "lavfi", "-i", "color=red:s=64x64",
                        "-frames:v", "1")
        self.text = self.secrets / "secret.txt"
        self.text.write_text(f"{SECRET}\n" * 20)

    def save(self, **fields):
        project = self.project()
        project.update(fields)
        path = self.home / "a.kfa"
        path.write_text(json.dumps(project))
        return path

    def traced(self, *arguments, **more):
        """Runs hazumi. Returns the run, and the files of the folder of secrets that were opened."""
        if not IS_TRACED:
            return run(*arguments, cwd=self.home, **more), set()
        trace = self.folder / "trace"
        ran = run(*arguments, cwd=self.home, **more,
                  before=("strace", "-f", "-qq", "-y", "-e", "trace=open,openat,openat2,creat",
                          "-o", str(trace)))
        opened = re.findall(r"= \d+<([^>]*)>", trace.read_text(errors="replace"))
        return ran, {path for path in opened if path.startswith(str(self.secrets))}

    def refuse(self, said, *arguments, code=None, **more):
        """A run that fails with these words, opens no secret, and tells none."""
        ran, opened = self.traced(*arguments, **more)
        self.assertNotEqual(ran.returncode, 0, ran.stderr)
        self.assertGreater(ran.returncode, 0, ran.stderr)  # not by a signal
        self.assertIn(said, ran.stderr)
        self.assertNotIn(SECRET, ran.stdout + ran.stderr)
        self.assertEqual(opened, set())
        return ran

    def video(self, project, *more):
        return ("--export", self.home / "out.mp4", *SMALL, "--frames", "0..2", *more, project)

    def picture(self, project, *more):
        return ("--render", self.home / "out", *SMALL, "--frames", "0", *more, project)


class Paths(Attack):
    """Sounds and references that lie elsewhere."""

    def test_control_what_is_allowed_is_opened_and_traced(self):
        if not IS_TRACED:
            self.skipTest("not here: no right to trace, or a sanitizer")
        project = self.save(audio={"file": str(self.wav)})
        ran, opened = self.traced(*self.video(project, "--open-outside"))
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(opened, {str(self.wav)})

    def test_what_lies_in_the_folder_is_opened_unasked(self):
        (self.home / "sounds").mkdir()
        (self.home / "sounds/a.wav").write_bytes(self.wav.read_bytes())
        (self.home / "b.png").write_bytes(self.png.read_bytes())
        project = self.save(audio={"file": "sounds/a.wav"},
                            reference={"file": "b.png", "rendered": True})
        ran, opened = self.traced(*self.video(project))
        self.assertEqual((ran.returncode, opened), (0, set()), ran.stderr)

    def test_sound(self):
        os.symlink(self.wav, self.home / "link.wav")
        os.symlink(self.secrets, self.home / "linked")
        os.symlink("link.wav", self.home / "link_of_link.wav")
        for name in (str(self.wav), "../secrets/secret.wav", "link.wav", "link_of_link.wav",
                     "linked/secret.wav", "./x/../../secrets/secret.wav"):
            with self.subTest(name):
                (self.home / "x").mkdir(exist_ok=True)
                self.refuse("lies outside of the project's folder",
                            *self.video(self.save(audio={"file": name})))

    def test_reference(self):
        os.symlink(self.png, self.home / "link.png")
        for name in (str(self.png), "../secrets/secret.png", "link.png"):
            with self.subTest(name):
                project = self.save(reference={"file": name, "rendered": True})
                self.refuse("lies outside of the project's folder", *self.picture(project))
                self.refuse("lies outside of the project's folder", *self.video(project))

    def test_a_sweep_cannot_allow_it(self):
        self.save(reference={"file": str(self.png), "rendered": True})
        sweep = self.home / "sweep.json"
        plan = {"format": "hazumi-sweep", "version": 1, "project": "a.kfa",
                "vary": VARIED, "measure": MEASURED,
                "picture": {"frames": [0], "options": ["--open-outside", "--size", "64x64"]}}
        sweep.write_text(json.dumps(plan))
        self.refuse("lies outside of the project's folder", "--sweep", sweep, "--out",
                    self.home / "swept")

    def test_a_picture_cannot_allow_it(self):
        project = self.save()
        self.assertEqual(run(*self.picture(project)).returncode, 0)
        picture = next((self.home / "out").glob("*.png"))
        data = picture.read_bytes()
        options = re.search(rb"\[[^\]]*\]", data[data.index(b"Options"):])[0]
        words = json.loads(options)
        self.assertNotIn("--open-outside", words)
        project = self.save(reference={"file": str(self.png), "rendered": True})
        self.refuse("lies outside of the project's folder", "--verify", project, self.home / "out")


class Media(Attack):
    """Files in the folder that are not what their names say."""

    def sound(self, text, name="a.wav"):
        (self.home / name).write_text(text)
        return self.save(audio={"file": name})

    def reference(self, text, name="a.png"):
        (self.home / name).write_text(text)
        return self.save(reference={"file": name, "rendered": True})

    def test_playlists_name_other_files(self):
        for text in (f"#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\nfile://{self.wav}\n#EXT-X-ENDLIST\n",
                     f"ffconcat version 1.0\nfile '{self.wav}'\n",
                     "ffconcat version 1.0\nfile '../secrets/secret.wav'\n",
                     f"[playlist]\nFile1={self.wav}\nNumberOfEntries=1\n",
                     '<?xml version="1.0"?><MPD xmlns="urn:mpeg:dash:schema:mpd:2011" '
                     'profiles="urn:mpeg:dash:profile:isoff-live:2011" type="static" '
                     'mediaPresentationDuration="PT1S"><Period><AdaptationSet mimeType="audio/mp4">'
                     f'<Representation id="0" bandwidth="1"><BaseURL>file://{self.wav}</BaseURL>'
                     '</Representation></AdaptationSet></Period></MPD>'):
            for name in ("a.wav", "a.m3u8" if "EXTM3U" in text else "a.mpd"):
                with self.subTest(text=text[:20], name=name):
                    self.refuse("ffmpeg finds no sound in it", *self.video(self.sound(text, name)))

    def test_text_is_no_picture(self):
        for name in ("a.png", "a.ans", "a.txt", "a.mp4"):
            with self.subTest(name):
                self.refuse("ffmpeg finds no picture in it",
                            *self.picture(self.reference("\x1b[31mtext\n" * 50, name)))

    def test_a_drawing_names_another(self):
        drawing = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
                   f'width="64" height="64"><image xlink:href="file://{self.png}" width="64" height="64"/></svg>')
        for name in ("a.svg", "a.png"):
            with self.subTest(name):
                self.refuse("ffmpeg finds no picture in it", *self.picture(self.reference(drawing, name)))

    def test_a_name_is_no_pattern(self):
        os.symlink(self.png, self.home / "a1.png")
        os.symlink(self.png, self.home / "a2.png")
        for name in ("a%d.png", "a*.png", "a[12].png"):
            with self.subTest(name):
                self.refuse("ffmpeg finds no picture in it", *self.picture(self.reference("", name)))

    def test_pipes_and_devices(self):
        os.mkfifo(self.home / "pipe.wav")
        for name in ("pipe.wav", "/dev/zero", "/dev/stdin", "/proc/self/environ", "."):
            with self.subTest(name):
                self.refuse("", *self.video(self.save(audio={"file": name}), "--open-outside"))


class Figures(Attack):
    """Figure, pose and sweep files may lie elsewhere: what is none is not quoted."""

    def test_a_figure_that_is_none(self):
        os.mkfifo(self.home / "pipe")
        for name in (str(self.text), "/etc/passwd", "pipe", "/dev/zero", "/dev/stdin", ".", str(self.wav)):
            with self.subTest(name):
                project = self.save(figure={"file": name})
                ran = run("--check", project, cwd=self.home, input="")
                self.assertGreater(ran.returncode, 0)
                self.assertNotIn(SECRET, ran.stdout + ran.stderr)
                self.assertNotIn("root:", ran.stdout + ran.stderr)

    def test_files_with_one_line_of_json(self):
        for text in (f'"{SECRET}"', f'{{"{SECRET}": 1}}', f'{{"format": "{SECRET}"}}', SECRET,
                     f'{{"format": "hazumi-figure", "version": "{SECRET}"}}'):
            self.text.write_text(text)
            with self.subTest(text):
                for arguments in (("--check", self.save(figure={"file": str(self.text)})),
                                  ("--check", self.text), ("--run", self.text),
                                  ("--sweep", self.text, "--out", self.home / "swept")):
                    ran = run(*arguments, cwd=self.home)
                    self.assertGreater(ran.returncode, 0)
                    if "hazumi-figure" not in text:
                        self.assertNotIn(SECRET, ran.stdout + ran.stderr)


class Characters(Attack):
    """Files of other programs that name others."""

    def triangle(self, **more):
        data = struct.pack("<9f3Hxx10f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0)
        document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"name": "a", "mesh": 0, "children": [1]}, {"name": "b", "translation": [0, 1, 0]}],
            "buffers": [{"uri": "data:;base64," + base64.b64encode(data).decode(), "byteLength": len(data)}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6},
                            {"buffer": 0, "byteOffset": 44, "byteLength": 8},
                            {"buffer": 0, "byteOffset": 52, "byteLength": 32}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
                          {"bufferView": 2, "componentType": 5126, "count": 2, "type": "SCALAR"},
                          {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC4"}],
            "animations": [{"samplers": [{"input": 2, "output": 3}],
                            "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "textures": [{"source": 0}], "images": [{"uri": "c.png"}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}]}
        document.update(more)
        path = self.home / "a.gltf"
        path.write_text(json.dumps(document))
        return path

    def names(self):
        os.symlink(self.text, self.home / "link")
        return (str(self.text), "../secrets/secret.txt", "link", f"file://{self.text}",
                "%2e%2e/secrets/secret.txt", "..\\secrets\\secret.txt", "x/../../secrets/secret.txt")

    def test_buffers(self):
        for name in self.names():
            with self.subTest(name):
                path = self.triangle(buffers=[{"uri": name, "byteLength": 84}])
                self.refuse("", "--import", path, "--save", self.home / "out.kfa")

    def test_pictures(self):
        for name in self.names():
            with self.subTest(name):
                path = self.triangle(images=[{"uri": name}])
                ran, opened = self.traced("--import", path, "--save", self.home / "out.kfa")
                self.assertEqual((ran.returncode, opened), (0, set()), ran.stderr)
                self.assertIn("warning", ran.stderr)
                self.assertNotIn(SECRET, (self.home / "out.kfa").read_text())

    def test_entities(self):
        path = self.home / "a.dae"
        path.write_text(f'<?xml version="1.0"?><!DOCTYPE a [<!ENTITY s SYSTEM "file://{self.text}">]>'
                        '<COLLADA version="1.4.1"><asset><up_axis>&s;</up_axis></asset></COLLADA>')
        self.refuse("", "--import", path, "--save", self.home / "out.kfa")

    def test_a_planted_reader_is_not_run(self):
        planted = self.home / "hazumi-reader"
        planted.write_text(f"#!/bin/sh\ntouch {self.folder}/ran\n")
        planted.chmod(0o755)
        (self.home / "libexec/hazumi").mkdir(parents=True)
        (self.home / "libexec/hazumi/hazumi-reader").write_bytes(planted.read_bytes())
        (self.home / "libexec/hazumi/hazumi-reader").chmod(0o755)
        path = self.triangle(images=[])
        environment = {**os.environ, "PATH": f".:{self.home}:{os.environ['PATH']}",
                       "HAZUMI_READER": str(planted)}
        run("--import", path, "--save", self.home / "out.kfa", cwd=self.home, env=environment)
        self.assertFalse((self.folder / "ran").exists())


class Writing(Attack):
    """Nothing is written over what is read."""

    def setUp(self):
        super().setUp()
        figure = self.home / "figure.json"
        figure.write_bytes((ROOT / "assets/figures/human.json").read_bytes())
        (self.home / "a.wav").write_bytes(self.wav.read_bytes())
        (self.home / "b.png").write_bytes(self.png.read_bytes())
        self.kfa = self.save(figure={"file": "figure.json"}, audio={"file": "a.wav"},
                             reference={"file": "b.png"})
        self.inputs = [self.kfa, figure, self.home / "a.wav", self.home / "b.png"]
        self.before = {path: path.read_bytes() for path in self.inputs}

    def unchanged(self):
        self.assertEqual({path: path.read_bytes() for path in self.inputs}, self.before)

    def links(self, suffix):
        for i, path in enumerate(self.inputs):
            link = self.home / f"link{i}{suffix}"
            if not link.exists():
                os.symlink(path, link)
            yield link

    def test_exports_and_bakes(self):
        for suffix in (".bvh", ".glb", ".gltf", ".csv", ".json", ".mp4"):
            for link in self.links(suffix):
                with self.subTest(link.name):
                    options = SMALL if suffix == ".mp4" else ()
                    self.refuse("nothing is written over it", "--export", link, *options, self.kfa)
                    self.unchanged()
        for link in self.links(".json"):
            self.refuse("nothing is written over it", "--bake", link, self.kfa)
        for path in self.inputs:
            ran = run("--bake", path, self.kfa)
            self.assertGreater(ran.returncode, 0)
        self.unchanged()

    def test_pictures(self):
        for link in self.links(".png"):
            self.refuse("nothing is written over it", "--render", link, *SMALL, "--frames", "0", self.kfa)
        (self.home / "out").mkdir()
        os.symlink(self.kfa, self.home / "out/frame_0000.png")
        os.symlink(self.kfa, self.home / "out/frame_0.png")
        self.refuse("nothing is written over it", *self.picture(self.kfa))
        self.unchanged()

    def script(self, *steps):
        path = self.home / "script.json"
        path.write_text(json.dumps(list(steps)))
        return path

    def test_scripts(self):
        figure = self.home / "figure.json"
        os.symlink(self.kfa, self.home / "capture.png")
        cases = [{"op": "file.save", "path": str(figure), "overwrite": True},
                 {"op": "file.save", "path": str(self.home / "a.wav"), "overwrite": True},
                 {"op": "file.save", "path": str(self.home / "script.json"), "overwrite": True},
                 {"op": "capture", "path": str(self.home / "capture.png")},
                 {"op": "capture", "path": str(self.home / "other.kfa")},
                 {"op": "capture", "path": str(self.kfa)}]
        cases += [{"op": "file.export", "path": str(link)} for link in self.links(".bvh")]
        for step in cases:
            with self.subTest(step):
                script = self.script(step)
                text = script.read_bytes()
                ran = run("--run", script, "--size", "200x200", self.kfa, cwd=self.home)
                self.assertGreater(ran.returncode, 0, ran.stderr)
                self.assertEqual(script.read_bytes(), text)
                self.assertFalse((self.home / "other.kfa").exists())
                self.unchanged()

    def test_control_a_project_is_saved_over_itself(self):
        ran = run("--run", self.script({"op": "time.preview", "first": 1, "last": 5}, {"op": "file.save"}), self.kfa)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertNotEqual(self.kfa.read_bytes(), self.before[self.kfa])

    def test_sweeps(self):
        sweep = self.home / "sweep.json"
        sweep.write_text(json.dumps({"format": "hazumi-sweep", "version": 1, "project": "a.kfa",
                                     "vary": VARIED, "measure": MEASURED}))
        for name, target in (("plan.json", sweep), ("sweep.csv", self.kfa), ("plan.json", self.kfa)):
            out = self.home / f"out_{name}_{target.name}"
            out.mkdir()
            os.symlink(target, out / name)
            text = sweep.read_bytes()
            ran = run("--sweep", sweep, "--out", out, cwd=self.home)
            with self.subTest(name):
                self.assertGreater(ran.returncode, 0, ran.stdout)
                self.assertEqual(sweep.read_bytes(), text)
                self.unchanged()


class Numbers(Attack):
    """Numbers and sizes beyond reason are refused at once."""

    def test_huge_numbers(self):
        for fields in ({"frames": {"first": 0, "last": 2000000000}}, {"frames": {"first": -2147483648, "last": 2147483647}},
                       {"fps": 1e300}, {"fps": 0}, {"audio": {"file": "a.wav", "gain_db": 1e9}},
                       {"frames": {"first": 0, "last": 1e999}}):
            with self.subTest(fields):
                self.refuse("", "--check", self.save(**fields))

    def test_deep_and_long_text(self):
        for name, text in (("deep", "[" * 1000000), ("deep objects", '{"a":' * 100000),
                           ("long", '{"format": "hazumi-animation", "x": "' + "y" * (170 << 20) + '"}')):
            path = self.home / "a.kfa"
            path.write_text(text)
            with self.subTest(name):
                self.refuse("", "--check", path)


if __name__ == "__main__":
    main()
