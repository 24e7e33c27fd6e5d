#!/usr/bin/env -S /usr/bin/python3
"""A member that is added to a struct of which caches, checkpoints, undo or the reach of edits make
something is not forgotten: the code that has to deal with it does not compile without it. Each
struct gets one more member, in a copy, and the compiler has to complain about that struct. That the
sources compile as they are is what the build shows.

usage: tests/members_test.py [COMPILER]"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMPILER = sys.argv.pop(1) if len(sys.argv) > 1 else "c++"
EIGEN = "/usr/include/eigen3"
ALL_ERRORS = "-ferror-limit=0" if "clang" in pathlib.Path(COMPILER).name else "-fmax-errors=0"
# By source file that is compiled: headers and their structs.
STRUCTS = {
    "engine/bake/island_solution.cpp": {
        "engine/spatial/rigid_inertia.h": ["RigidInertia"],
        "engine/region/driven_curve.h": ["DrivenCurve"],
        "engine/region/node_motion.h": ["DrivenMotion"],
        "engine/region/hinge_state.h": ["HingeState"],
        "engine/region/region_model.h": ["NodeHinge", "ModelNode", "NodeJoint", "RegionModel"],
        "engine/spatial/body_motion.h": ["PointMotion"],
        "engine/bake/island_request.h": ["IslandTask", "BeginIsland", "DriveIsland",
                                        "AdvanceIsland", "SolveIsland", "SampleIsland",
                                        "MeasureIsland", "AccelerateIsland"],
        "engine/bake/moving_base_cache.h": ["Carrier"],
        "engine/region/contact/contact_spec.h": ["ContactCapsule", "ContactObstacle", "ContactSpec"],
    },
    "engine/bake/baker.cpp": {
        "engine/bake/stretch.h": ["Checkpoint"],
        "engine/bake/pose/known_holds.h": ["HoldRequest"],
        "engine/placement/hold_solver.h": ["HoldTarget"],
    },
    "engine/bake/incremental_bake.cpp": {"engine/timeline/animation.h": ["Animation"]},
    "ui/edit/document/change.cpp": {"engine/project/project.h": ["Project"]},
}


# What forces are made of: each spec of a law.
for law in sorted((ROOT / "engine/region/forces").glob("*.h")):
    specs = re.findall(r"^struct (\w+Spec) \{", law.read_text(), re.M)
    if specs:
        STRUCTS["engine/bake/island_solution.cpp"][str(law.relative_to(ROOT))] = specs


def with_members(header, structs):
    """The header's text, each struct with one member more before its closing brace."""
    text = (ROOT / header).read_text()
    for struct in structs:
        text, count = re.subn(rf"(^struct {struct} \{{\n.*?)(^\}};)", r"\1  int one_more = 0;\n\2", text,
                              count=1, flags=re.M | re.S)
        assert count == 1, f"{header}: no struct {struct}"
    return text


def complaints(source, folder):
    return subprocess.run(
        [COMPILER, "-std=c++20", "-fsyntax-only", ALL_ERRORS, f"-I{folder}", f"-I{ROOT}",
         "-isystem", EIGEN, ROOT / source], capture_output=True, text=True, check=False).stderr


class Members(unittest.TestCase):
    def test_one_more_does_not_compile(self):
        for source, headers in STRUCTS.items():
            with tempfile.TemporaryDirectory() as folder:
                for header, structs in headers.items():
                    copy = pathlib.Path(folder) / header
                    copy.parent.mkdir(parents=True, exist_ok=True)
                    copy.write_text(with_members(header, structs))
                said = complaints(source, folder)
                for struct in (s for structs in headers.values() for s in structs):
                    with self.subTest(struct):
                        self.assertRegex(said, rf"‘[^’]*\b{struct}’ decomposes into|'[^']*\b{struct}' decomposes into")


unittest.main()
