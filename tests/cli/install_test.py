#!/usr/bin/env -S /usr/bin/python3
"""What is installed works where it lies, and knows nothing of where it was built. It is installed
once, by cmake, and then moved. usage: install_test.py HAZUMI CMAKE"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE = sys.argv.pop(2)
from command_line import HAZUMI, ROOT, main  # noqa: E402

BUILD = pathlib.Path(HAZUMI).parent
LINK = re.compile(r"\]\(([^)#:]+)\)")  # of a page, to a file
IS_SANITIZED = os.environ.get("HAZUMI_SANITIZE", "") != ""


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"no {program} here")


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="hazumi-installed-"))
        subprocess.run([CMAKE, "--install", BUILD, "--strip", "--prefix", cls.folder / "first"],
                       check=True, capture_output=True)
        cls.prefix = (cls.folder / "first").rename(cls.folder / "moved")
        cls.share = cls.prefix / "share"
        cls.throw = cls.share / "hazumi" / "examples" / "throw.kfa"

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def run_installed(self, *arguments):
        """From a folder that has nothing of it."""
        away = self.folder / "elsewhere"
        away.mkdir(exist_ok=True)
        done = subprocess.run([self.prefix / "bin" / "hazumi", *arguments], cwd=away,
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def files(self):
        return [path for path in sorted(self.prefix.rglob("*")) if path.is_file()]

    def test_everything_is_where_it_is_looked_for(self):
        names = {str(path.relative_to(self.prefix)) for path in self.files()}
        icons = {name for name in names if name.endswith("apps/hazumi.png")}
        pictures = {name for name in names if name.startswith("share/doc/hazumi/pictures/")}
        self.assertEqual(len(icons), 9 if shutil.which("rsvg-convert") else 0)
        self.assertEqual(
            {re.sub(r"\.gz$", "", name) for name in names - icons - pictures}, {
                "bin/hazumi", "libexec/hazumi/hazumi-reader",
                "share/applications/hazumi.desktop", "share/bash-completion/completions/hazumi",
                "share/doc/hazumi/copyright", "share/doc/hazumi/README.md",
                "share/doc/hazumi/examples/README.md", "share/doc/hazumi/sweeps.md", "share/fish/vendor_completions.d/hazumi.fish",
                *(f"share/hazumi/examples/{name}.kfa" for name in
                  ("bar", "bat", "blow", "curl", "jump", "reach", "stairs", "throw", "torque", "walk", "wings")),
                "share/hazumi/examples/throw_sweep.json",
                "share/hazumi/figures/README.md", "share/hazumi/figures/bird.json", "share/hazumi/figures/human.json",
                "share/hazumi/schema/figure.schema.json", "share/hazumi/schema/kfa.schema.json",
                "share/hazumi/schema/poses.schema.json",
                "share/hazumi/schema/sweep.schema.json",
                "share/icons/hicolor/scalable/apps/hazumi.svg", "share/man/man1/hazumi.1",
                "share/metainfo/org.example.hazumi.metainfo.xml", "share/mime/packages/hazumi.xml",
                "share/zsh/site-functions/_hazumi"})

    def test_an_example_opens_where_it_lies_and_is_drawn(self):
        self.assertRegex(self.run_installed("--version"), r"^hazumi \d")
        self.assertEqual(self.run_installed("--check", self.throw), f"{self.throw}: ok\n")
        self.run_installed("--render", self.folder / "out", "--frames", "9", "--size", "64x48",
                           self.throw)
        self.assertTrue((self.folder / "out" / "frame_0009.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_copy_of_an_example_is_drawn_elsewhere(self):
        copy = shutil.copy(self.throw, self.folder / "copy.kfa")
        self.run_installed("--render", self.folder / "copied", "--frames", "9", "--size", "64x48", copy)
        self.assertTrue((self.folder / "copied" / "frame_0009.png").exists())
        for name in ("throw", "jump"):
            own = self.share / "hazumi" / "examples" / f"{name}.kfa"
            of_tree = ROOT / "assets" / "examples" / f"{name}.kfa"
            self.assertEqual(self.run_installed("--bake", "-", own),
                             self.run_installed("--bake", "-", of_tree))

    def test_links_of_pages_lead_to_what_is_installed(self):
        pages = sorted((self.share / "doc" / "hazumi").rglob("*.md"))
        links = [(page, link) for page in pages for link in LINK.findall(page.read_text())]
        self.assertGreater(len(links), 10)
        for page, link in links:
            self.assertTrue((page.parent / link).is_file(), (page, link))
        shown = {(page.parent / link).resolve() for page, link in links if "pictures/" in link}
        pictures = set((self.share / "doc" / "hazumi" / "pictures").resolve().iterdir())
        self.assertEqual(pictures, shown)
        self.assertLess(sum(picture.stat().st_size for picture in pictures), 2e6)
        for page in pages:
            self.assertNotRegex(page.read_text(), r"scripts/|assets/|tests/|engine/", page)

    def test_the_reader_is_found(self):
        walk, own = self.folder / "walk.bvh", self.folder / "own.kfa"
        self.run_installed("--export", walk, self.throw)
        self.run_installed("--import", walk, "--save", own)
        self.assertEqual(json.loads(own.read_text())["format"], "hazumi-project")

    @unittest.skipIf(IS_SANITIZED, "not here: sanitizers keep the names of source files")
    def test_nothing_says_where_it_was_built(self):
        for path in self.files():
            # clang's assertions, of debug builds, name a function of a lambda by where that stands.
            data = path.read_bytes().replace(b"(lambda at " + os.fsencode(ROOT), b"")
            for place in (ROOT, BUILD, self.folder):
                self.assertNotIn(os.fsencode(place), data, path)

    @needs("readelf")
    def test_libraries_are_looked_for_where_the_system_says(self):
        for program in ("bin/hazumi", "libexec/hazumi/hazumi-reader"):
            shown = subprocess.run(["readelf", "-d", self.prefix / program], check=True, text=True,
                                   capture_output=True).stdout
            self.assertNotRegex(shown, "RPATH|RUNPATH")

    @needs("readelf")
    def test_programs_are_hardened(self):
        """Loaded at any address, their tables of addresses read-only; the reader with a guard of its
        stack."""
        for program in ("bin/hazumi", "libexec/hazumi/hazumi-reader"):
            shown = subprocess.run(["readelf", "-Whld", self.prefix / program], check=True, text=True,
                                   capture_output=True).stdout
            self.assertRegex(shown, r"Type: +DYN", program)
            self.assertIn("GNU_RELRO", shown, program)
            self.assertIn("BIND_NOW", shown, program)
        symbols = subprocess.run(["readelf", "-W", "--dyn-syms", self.prefix / "libexec/hazumi/hazumi-reader"],
                                 check=True, text=True, capture_output=True).stdout
        self.assertIn("__stack_chk_fail", symbols)

    def test_page_and_completions_are_those_of_the_program(self):
        for name, arguments in (("man/man1/hazumi.1", ["--man"]),
                                ("bash-completion/completions/hazumi", ["--completion", "bash"]),
                                ("zsh/site-functions/_hazumi", ["--completion", "zsh"]),
                                ("fish/vendor_completions.d/hazumi.fish",
                                 ["--completion", "fish"])):
            self.assertEqual((self.share / name).read_text(), self.run_installed(*arguments))

    def test_schemas_are_json(self):
        for schema in (self.share / "hazumi" / "schema").iterdir():
            self.assertIn("$schema", json.loads(schema.read_text()))

    @needs("desktop-file-validate")
    def test_the_menu_entry_is_one(self):
        done = subprocess.run(["desktop-file-validate", self.share / "applications/hazumi.desktop"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    @needs("appstreamcli")
    def test_the_description_is_one(self):
        done = subprocess.run(["appstreamcli", "validate", "--no-net",
                               self.share / "metainfo" / "org.example.hazumi.metainfo.xml"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)

    @needs("update-mime-database")
    def test_the_type_of_projects_is_taken(self):
        mime = shutil.copytree(self.share / "mime", self.folder / "mime")
        done = subprocess.run(["update-mime-database", mime], capture_output=True, text=True,
                              env={**os.environ, "XDG_DATA_DIRS": str(self.folder)})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("60:application/x-hazumi-project:*.kfa", (mime / "globs2").read_text())
        self.assertIn(b"hazumi-project", (mime / "magic").read_bytes())


if __name__ == "__main__":
    main()
