#!/usr/bin/env -S /usr/bin/python3
"""Compares reports of the command line with analytic solutions. Fails if a report differs or
ignores a number of the file. usage: truth_test.py HAZUMI"""

import csv
import json
import math
import re
import unittest

from command_line import ROOT, InFolder, run

MOON, EARTH = 1.62, 9.81
# Rod on a pivot: mass [kg], distance of the centre of mass below the pivot [m], moment of inertia
# about the centre of mass and about the pivot [kg m^2].
MASS, LEVER, ABOUT_CENTRE = 2.0, 0.5, 0.18
INERTIA = ABOUT_CENTRE + MASS * LEVER * LEVER
FPS, LAST = 30, 30
SECONDS = LAST / FPS


def rod(limits=(-1000000, 1000000)):
    link = {"name": "rod", "from_m": [0, 0, 0], "to_m": [0, 0, -1], "radius_m": 0.02,
            "mass_kg": MASS, "com_m": [0, 0, -LEVER],
            "inertia_kg_m2": [ABOUT_CENTRE, ABOUT_CENTRE, 0.001, 0, 0, 0]}
    hinge = {"name": "pivot", "parent": "base", "offset_m": [0, 0, 0], "hinges": [{"axis": "y", "limits_deg": list(limits)}],
             "links": [link]}
    return {"format": "hazumi-figure", "version": 1, "name": "rod", "root": {"name": "base"},
            "joints": [hinge]}


def ball():
    link = {"name": "ball", "from_m": [0, 0, 0], "to_m": [0, 0, 0], "radius_m": 0.1,
            "mass_kg": MASS, "com_m": [0, 0, 0], "inertia_kg_m2": [0.01, 0.01, 0.01, 0, 0, 0]}
    tail = {"name": "tail", "from_m": [0, 0, 0], "to_m": [0, 0, 0.01], "radius_m": 0.01,
            "mass_kg": 1e-6, "com_m": [0, 0, 0], "inertia_kg_m2": [1e-9, 1e-9, 1e-9, 0, 0, 0]}
    return {"format": "hazumi-figure", "version": 1, "name": "ball",
            "root": {"name": "base", "links": [link]},
            "joints": [{"name": "tail", "parent": "base", "offset_m": [0, 0, 0],
                        "hinges": [{"axis": "y", "limits_deg": [-90, 90]}], "links": [tail]}]}


def human():
    return {"file": str(ROOT / "assets" / "figures" / "human.json")}


def scene(figure, gravity, objects=(), **more):
    return {"format": "hazumi-project", "version": 2, "fps": {"num": FPS, "den": 1},
            "frames": {"first": 0, "last": LAST},
            "solver": {"method": "exact", "version": 1, "tolerance_deg": 1e-7}, "figure": figure,
            "scene": {"gravity_m_s2": gravity, "objects": list(objects)}, **more}


def floor():
    return {"name": "floor", "plane": {"normal": [0, 0, 1], "offset_m": 0}}


def swing(friction=1.0):
    return [{"name": "swing", "first_frame": 0, "last_frame": LAST, "joints": ["pivot"],
             "friction": {"default": friction}}]


def keyed(angle, rate):
    return {"pivot": {"keys": [{"frame": 0, "angle_deg": angle, "rate_deg_s": rate}]}}


def root_at(z):
    return {"z": {"keys": [{"frame": 0, "position_m": z, "rate_m_s": 0}]}}


def falls():
    return [{"kind": "gravity", "first_frame": 0, "last_frame": LAST}]


class Truth(InFolder):
    def told(self, project, *options):
        """Output of a task on a project."""
        file = self.folder / "scene.kfa"
        file.write_text(json.dumps(project))
        done = run(*options, file)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def baked(self, project, *options):
        return json.loads(self.told(project, "--bake", "-", *options))

    def informed(self, project):
        """Output of --info as text and as JSON."""
        return (self.told(project, "--info", "--effort"),
                json.loads(self.told(project, "--info", "--json")))

    def assert_close(self, found, true, relative=1e-6):
        self.assertAlmostEqual(found, true, delta=relative * max(1.0, abs(true)))

    def joules(self, text, what):
        return float(re.search(rf"{what} (-?[\d.e+-]+) J", text)[1])


class Energy(Truth):
    def accounts(self, project):
        """Energy account of a project from three reports: a line of text, --info and --bake."""
        text, info = self.informed(project)
        line = re.search(r"energy: (.*)", text)[1]
        bake = self.baked(project)
        return line, info["regions"][0]["energy_j"], bake["regions"][0]["energy_j"]

    def test_friction_loses_the_energy_of_its_analytic_decay(self):
        factor, rate = 0.97, 3.0
        project = scene(rod(), 0, joints=keyed(0, math.degrees(rate)), regions=swing(factor))
        decay = -30 * math.log(factor)
        before = 0.5 * INERTIA * rate ** 2
        after = before * math.exp(-2 * decay * SECONDS)
        line, *accounts = self.accounts(project)
        for account in accounts:
            self.assert_close(account["kinetic_start"], before)
            self.assert_close(account["kinetic_end"], after)
            self.assert_close(account["friction"], after - before)
            self.assert_close(account["residual"], 0.0)
        self.assert_close(self.joules(line, "friction"), after - before, 1e-2)
        self.assert_close(float(re.search(r"kinetic (\S+) to", line)[1]), before, 1e-2)

    def test_a_limit_takes_all_energy_of_an_impact(self):
        rate = 2.0
        project = scene(rod((-1000, 60)), 0, joints=keyed(0, math.degrees(rate)), regions=swing())
        line, *accounts = self.accounts(project)
        for account in accounts:
            name = "limits" if "limits" in account else "stops"
            self.assert_close(account[name], -0.5 * INERTIA * rate ** 2)
            self.assert_close(account["friction"], 0.0)
        self.assert_close(self.joules(line, "limits"), -0.5 * INERTIA * rate ** 2, 1e-2)
        hit = [event for event in self.baked(project)["events"] if event["joint"] == "pivot"][0]
        self.assert_close(hit["time_s"], math.radians(60) / rate)
        self.assertEqual(hit["frame"], math.ceil(hit["time_s"] * FPS))

    def test_gravity_does_the_work_of_the_height(self):
        for gravity in (MOON, EARTH):
            project = scene(rod(), gravity, joints=keyed(80, 0), regions=swing())
            frame = self.baked(project)["frames"][-1]
            angle = math.radians(frame["angles_deg"][0])
            fallen = LEVER * (math.cos(angle) - math.cos(math.radians(80)))
            for account in self.accounts(project)[1:]:
                self.assert_close(account["potential_end"] - account["potential_start"],
                                  -MASS * gravity * fallen)
                self.assert_close(account["kinetic_end"], MASS * gravity * fallen)
            self.assert_close(0.5 * INERTIA * math.radians(frame["rates_deg_s"][0]) ** 2,
                              MASS * gravity * fallen)


    def test_keys_do_the_work_of_lifting(self):
        root = {"z": {"keys": [{"frame": 0, "position_m": 1, "rate_m_s": 0},
                               {"frame": LAST, "position_m": 2, "rate_m_s": 3}]}}
        project = scene(rod(), MOON, root=root, joints=keyed(0, 0), regions=swing())
        line, *accounts = self.accounts(project)
        work = MASS * (MOON * 1 + 0.5 * 3 ** 2)
        for account in accounts:
            self.assert_close(account["keyed"], work)
            self.assert_close(account["friction"], 0.0)
        self.assert_close(self.joules(line, "keys and placement"), work, 1e-2)


class Gravity(Truth):
    def test_a_pendulum_has_the_period_of_its_gravity(self):
        for gravity in (MOON, EARTH):
            project = scene(rod(), gravity, joints=keyed(0.01, 0), regions=swing())
            frame = self.baked(project)["frames"][-1]
            frequency = math.sqrt(MASS * gravity * LEVER / INERTIA)
            self.assertAlmostEqual(frame["angles_deg"][0], 0.01 * math.cos(frequency * SECONDS),
                                   delta=1e-7)

    def test_a_figure_falls_by_half_of_g_t_squared(self):
        for gravity in (MOON, EARTH):
            project = scene(ball(), gravity, root=root_at(20), placements=falls())
            for method in ("exact", "paper"):
                bake = self.baked(project, "--method", method)
                for frame in (bake["frames"][15], bake["frames"][-1]):
                    t = frame["frame"] / FPS
                    self.assert_close(frame["com"][2], 20 - gravity * t * t / 2,
                                      1e-6 if method == "exact" else 0.01)

    def test_a_fall_lands_at_the_analytic_time(self):
        for gravity in (MOON, EARTH):
            project = scene(ball(), gravity, [floor()], root=root_at(0.3), placements=falls())
            landing = [e for e in self.baked(project)["events"] if e["kind"] == "landing"][0]
            self.assert_close(landing["time_s"], math.sqrt(2 * 0.2 / gravity), 1e-5)
            self.assertEqual(landing["frame"], math.ceil(landing["time_s"] * FPS))

    def test_a_figure_that_is_let_go_falls_by_half_of_g_t_squared(self):
        for gravity in (MOON, EARTH):
            regions = [{"name": "all", "first_frame": 0, "last_frame": LAST,
                        "joints": ["base", "tail"], "contacts": {"scene": True}}]
            project = scene(ball(), gravity, root=root_at(20), placements=falls(), regions=regions)
            frame = self.baked(project)["frames"][-1]
            self.assert_close(frame["com"][2], 20 - gravity * SECONDS ** 2 / 2)

    def test_a_released_object_falls_by_half_of_g_t_squared(self):
        for gravity in (MOON, EARTH):
            thing = {"name": "thing", "sphere": {"radius_m": 0.05}, "mass_kg": 1, "joint": "pivot",
                     "offset_m": [0, 0, -1], "release_frame": 5}
            project = scene(rod(), gravity, root=root_at(50), joints=keyed(0, 0),
                            held_objects=[thing])
            place = self.baked(project)["frames"][-1]["objects"][0]["position"]
            t = (LAST - 5) / FPS
            self.assert_close(place[2], 49 - gravity * t * t / 2)

    def test_effort_carries_the_weight_under_each_gravity(self):
        for gravity in (MOON, EARTH):
            project = scene(human(), gravity, [floor()], root=root_at(0.9024))
            effort = self.baked(project, "--effort")["frames"][10]["effort"]
            weight = gravity * 70.0
            carried = sum(contact["force_n"][2] for contact in effort["contacts"])
            self.assert_close(carried, weight, 1e-3)
            self.assert_close(effort["from_nowhere"]["force_n"][2], 0)
            project["root"] = root_at(3)
            effort = self.baked(project, "--effort")["frames"][10]["effort"]
            self.assertEqual(effort["contacts"], [])
            self.assert_close(effort["from_nowhere"]["force_n"][2], weight, 1e-3)
            text, info = self.informed(project)
            problem = next(text for text in info["problems"] if "nothing carries" in text)
            self.assertRegex(problem, "^Frames 0 to 30, most at 0: nothing carries the figure, ")
            self.assert_close(float(re.search(r"figure, (\S+) N ", problem)[1]), weight, 1e-2)
            self.assertIn(f"problem    {problem}\n", text)

    def test_effort_holds_a_rod_against_its_gravity(self):
        for gravity in (MOON, EARTH):
            project = scene(rod(), gravity, joints=keyed(30, 0))
            frame = self.baked(project, "--effort", "--torques")["frames"][3]
            true = MASS * gravity * LEVER * math.sin(math.radians(30))
            self.assert_close(frame["torques_n_m"][0], true)
            self.assertEqual(frame["torques_n_m"], frame["effort"]["torques_n_m"])
            self.assertEqual(frame["unsupported"], frame["effort"]["from_nowhere"])
            text, _ = self.informed(project)
            told = float(re.search(r"largest torque: pivot (-?\S+) N m", text)[1])
            self.assert_close(told, true, 1e-2)


class Figures(Truth):
    def test_mass_and_centre_of_mass_are_those_of_the_figure(self):
        project = scene(rod(), EARTH, root=root_at(5), joints=keyed(-90, 0))
        text, info = self.informed(project)
        self.assertIn(f", {MASS:g} kg", text)
        self.assert_close(info["figure"]["mass_kg"], MASS)
        file = self.folder / "m.csv"
        self.told(project, "--bake", file)
        row = next(csv.DictReader(file.read_text().splitlines()))
        for com in (self.baked(project)["frames"][0]["com"],
                    [float(row[f"com_{axis}_m"]) for axis in "xyz"]):
            self.assert_close(com[0], LEVER)
            self.assert_close(com[1], 0)
            self.assert_close(com[2], 5)

    def test_clearance_is_the_height_of_the_lowest_point(self):
        for height in (0.5, 0.1, 0.04):
            frame = self.baked(scene(ball(), EARTH, [floor()], root=root_at(height)))["frames"][0]
            self.assert_close(frame["clearance_m"], height - 0.1)


class Forces(Truth):
    def test_contact_forces_of_a_lying_figure_are_its_weight(self):
        regions = [{"name": "all", "first_frame": 0, "last_frame": LAST,
                    "joints": ["base", "tail"], "contacts": {"scene": True}}]
        for gravity in (MOON, EARTH):
            project = scene(ball(), gravity, [floor()], root=root_at(0.1), placements=falls(),
                            regions=regions)
            contacts = self.baked(project)["frames"][20]["contacts"]
            self.assert_close(sum(contact["force_n"][2] for contact in contacts), MASS * gravity,
                              1e-3)

    def test_a_constraint_carries_the_hanging_weight(self):
        for gravity in (MOON, EARTH):
            tie = {"name": "tie", "kind": "point", "first_frame": 0, "last_frame": LAST,
                   "a": {"joint": "base", "offset_m": [0, 0, 0]},
                   "b": {"offset_m": [0, 0, 5]}}
            project = scene(ball(), gravity, root=root_at(5), placements=falls(),
                            regions=[{"name": "all", "first_frame": 0, "last_frame": LAST,
                                      "joints": ["base", "tail"]}], constraints=[tie])
            frame = self.baked(project)["frames"][10]
            self.assert_close(frame["constraint_forces_n"][0], MASS * gravity, 1e-5)

    def test_a_rod_in_the_wind_is_held_against_its_drag(self):
        for density in (1.2, 3.0):
            wind = {"name": "wind", "kind": "wind", "first_frame": 0, "last_frame": LAST,
                    "velocity_m_s": [6, 0, 0], "density_kg_m3": density}
            held = [self.baked(scene(rod(), 0, joints=keyed(0, 0), forces=[wind] * k),
                               "--effort")["frames"][3]["effort"]["from_nowhere"]["force_n"][0]
                    for k in (0, 1)]
            drag = held[0] - held[1]
            self.assert_close(abs(drag), 0.5 * density * 1.1 * 0.04 * 1.0 * 36)

    def test_a_drive_is_reported_as_the_torque_that_it_gives(self):
        """Chain of three joints: the first is keyed, the second driven by a curve, the third
        limp."""
        names, links = ["u", "v", "w"], []
        for i, name in enumerate(names):
            link = dict(rod()["joints"][0]["links"][0], name="l" + name)
            links.append({"name": name, "parent": "base" if i == 0 else names[i - 1],
                          "offset_m": [0, 0, 0 if i == 0 else -1],
                          "hinges": [{"axis": "y", "limits_deg": [-1e6, 1e6]}], "links": [link]})
        figure = dict(rod(), joints=links)
        keys = {"u": {"keys": [{"frame": 0, "angle_deg": 0, "rate_deg_s": 200},
                               {"frame": 20, "angle_deg": 60, "rate_deg_s": -100},
                               {"frame": LAST, "angle_deg": -40, "rate_deg_s": 0}]},
                "v": {"keys": [{"frame": 0, "angle_deg": 30, "rate_deg_s": 0}]},
                "w": {"keys": [{"frame": 0, "angle_deg": -20, "rate_deg_s": 0}]}}
        curve = [(0, 0.0), (15, 4.0), (30, -6.0)]
        drives = [{"joints": ["u"], "kind": "keys"},
                  {"joints": ["v"], "kind": "torque",
                   "keys": [{"frame": f, "torque_n_m": x, "interpolation": "linear"}
                            for f, x in curve]}]
        region = dict(swing()[0], joints=names, drives=drives)
        project = scene(figure, EARTH, joints=keys, regions=[region])
        for frame in self.baked(project, "--torques")["frames"][1:-1]:
            f = frame["frame"]
            true = f * 4 / 15 if f <= 15 else 4 - (f - 15) * 10 / 15
            self.assertAlmostEqual(frame["torques_n_m"][1], true, delta=1e-6)
            self.assertAlmostEqual(frame["torques_n_m"][2], 0.0, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
