"""What the tests of sweeps share."""

import csv
import json

from command_line import InFolder, run


class InSweep(InFolder):
    def setUp(self):
        super().setUp()
        self.sweep_file = self.folder / "sweep.json"
        self.out = self.folder / "out"
        self.write_project(self.project())

    def write_project(self, project):
        (self.folder / "throw.kfa").write_text(json.dumps(project))

    def write(self, vary, **more):
        sweep = {"format": "hazumi-sweep", "version": 1, "project": "throw.kfa", "vary": vary, **more}
        self.sweep_file.write_text(json.dumps(sweep))

    def sweep(self, *more, out=None, code=0, before=()):
        done = run("--sweep", self.sweep_file, "--out", out or self.out, *more, before=before)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self, out=None):
        with ((out or self.out) / "sweep.csv").open(newline="") as file:
            return list(csv.DictReader(file))

    def contents(self, out=None):
        """Every file of a sweep's folder."""
        out = out or self.out
        return {str(p.relative_to(out)): p.read_bytes() for p in sorted(out.rglob("*"))
                if p.is_file()}

    def left_behind(self):
        return [name for name in self.files() if name.endswith(".tmp")]


GRAVITY = {"field": "scene.gravity_m_s2", "values": [9.81, 3.7]}
RELEASE = {"field": "held_objects[ball].release_frame", "values": [10, 11, 12]}
