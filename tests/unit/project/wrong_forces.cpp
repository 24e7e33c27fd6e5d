// Forces from outside that cannot be, and those that nothing feels.

#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

const std::string kBreeze = R"({"name": "breeze", "kind": "wind", "velocity_m_s": [2, 0, 0],
                                "first_frame": 5, "last_frame": 20})";
const std::string kGust = R"({"name": "gust", "kind": "wind", "velocity_m_s": [0, 9, 0],
                              "first_frame": 12, "last_frame": 18})";
const std::string kMagnet = R"({"name": "magnet", "kind": "attract", "joint": "r_wrist",
                                "to_m": [1, 0, 1.2], "force_n": 40, "radius_m": 0.5,
                                "first_frame": 5, "last_frame": 15})";
const std::string kBlow = R"({"name": "blow", "kind": "push", "joint": "r_elbow",
                              "impulse_n_s": [7, 0, 0], "frame": 12})";

Changes WithForces(const std::string& forces, const Changes& more = {}) {
  Changes changes = {{"/solver/method", "\"exact\""},
                     {"/regions/0/method", "\"exact\""},
                     {"/forces", "[" + forces + "]"}};
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

std::vector<WrongProject> WrongForceValues() {
  return {
      {Check::kNotPositive, Read(WithForces(kMagnet, {{"/forces/0/radius_m", "0"}})),
       "forces[0].radius_m: must be greater than 0, is 0"},
      {Check::kNegative, Read(WithForces(kMagnet, {{"/forces/0/force_n", "-1"}})),
       "forces[0].force_n: must not be negative, is -1"},
      {Check::kNegative, Read(WithForces(kBreeze, {{"/forces/0/density_kg_m3", "-1.2"}})),
       "forces[0].density_kg_m3: must not be negative, is -1.2"},
      {Check::kWrongType, Read(WithForces(kBreeze, {{"/forces/0/velocity_m_s/1", "\"fast\""}})),
       "forces[0].velocity_m_s[1]: expected a number, found a string"},
      {Check::kWrongCount, Read(WithForces(kBlow, {{"/forces/0/impulse_n_s", "[1, 2]"}})),
       "forces[0].impulse_n_s: expected 3 values, found 2"},
      {Check::kUnknownChoice, Read(WithForces(kBreeze, {{"/forces/0/kind", "\"winds\""}})),
       "forces[0].kind: there is no force kind \"winds\"; did you mean \"wind\"?"},
      {Check::kMissingField, Read(WithForces(kBlow, {{"/forces/0/frame", ""}})),
       "forces[0]: the field \"frame\" is missing; add it"},
      {Check::kEmptyName, Read(WithForces(kBlow, {{"/forces/0/joint", "\"\""}})),
       "forces[0].joint: must not be empty"},
      {Check::kSpanEmpty, Read(WithForces(kBreeze, {{"/forces/0/last_frame", "5"}})),
       "forces[0]: first_frame 5 must be before last_frame 5"},
      {Check::kNameTwice,
       Read(WithForces(kBreeze + "," + kBlow, {{"/forces/1/name", "\"breeze\""}})),
       "forces[1].name: the name \"breeze\" is already used by forces[0]; choose another"},
      {Check::kUnknownJoint, Read(WithForces(kMagnet, {{"/forces/0/joint", "\"r_wrst\""}})),
       "forces[0].joint: no joint \"r_wrst\"; did you mean \"r_wrist\"?"},
  };
}

std::vector<WrongProject> ForceContradictions() {
  return {
      {Check::kOutsideFrames, Compile(WithForces(kBreeze, {{"/forces/0/last_frame", "31"}})),
       "forces[0]: frames 5 to 31 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kReleaseOutside, Compile(WithForces(kBlow, {{"/forces/0/frame", "30"}})),
       "forces[0].frame: frame 30 is not within the project's frames 0 to 29"},
      {Check::kWindsOverlap, Compile(WithForces(kBreeze + "," + kGust)),
       "forces[1]: winds \"breeze\" and \"gust\" both blow in frames 12 to 18; end one where the "
       "other begins"},
      {Check::kForceInPaper,
       Compile({{"/forces", "[" + kBreeze + "]"}, {"/regions/1/mute", "true"}}),
       "forces[0]: \"breeze\" acts in frames 5 to 15, in which region \"arm\" has method "
       "\"paper\", "
       "which knows no forces from outside; choose method \"exact\" for it, or end one where the "
       "other begins"},
      {Check::kPushFeltByNone, Compile(WithForces(kBlow, {{"/forces/0/frame", "4"}})),
       "forces[0]: no region moves \"r_elbow\" in frame 4, so that nothing can give way to "
       "\"blow\"; begin a region there that has it or a joint between it and the root, or move the "
       "push to a frame inside one"},
      {Check::kPushFeltByNone, Compile(WithForces(kBlow, {{"/forces/0/joint", "\"pelvis\""}})),
       "forces[0]: no region moves \"pelvis\" in frame 12, so that nothing can give way to "
       "\"blow\"; begin a region there that has it or a joint between it and the root, or move the "
       "push to a frame inside one"},
      // In gravity everything may give way.
      {Check::kNumChecks,
       Compile(WithForces(kBlow, {{"/forces/0/frame", "16"}, {"/forces/0/joint", "\"pelvis\""}})),
       "no complaint"},
  };
}

// Of a figure's link.
std::vector<WrongProject> WrongSurfaces() {
  const auto with = [](const std::string& surface) {
    return Figure("/joints/3/links/0/surface", surface);
  };
  const std::string place = "joints[3].links[0].surface";
  return {
      {Check::kMissingField, with(R"({"normal": [1, 0, 0], "center_m": [0, 0, 0]})"),
       place + ": the field \"area_m2\" is missing; add it"},
      {Check::kNotPositive, with(R"({"area_m2": 0, "normal": [1, 0, 0], "center_m": [0, 0, 0]})"),
       place + ".area_m2: must be greater than 0, is 0"},
      {Check::kNotUnit, with(R"({"area_m2": 1, "normal": [2, 0, 0], "center_m": [0, 0, 0]})"),
       place + ".normal: must have length 1, has 2; write [1, 0, 0]"},
      {Check::kUnknownChoice,
       with(R"({"area_m2": 1, "normal": [1, 0, 0], "center_m": [0, 0, 0], "coefficients": "wng"})"),
       place + ".coefficients: there is no coefficients \"wng\"; did you mean \"wing\"?"},
      {Check::kNegative, with(R"({"area_m2": 1, "normal": [1, 0, 0], "center_m": [0, 0, 0],
                "coefficients": {"lift": [0], "drag": [1, -1]}})"),
       place + ".coefficients.drag[1]: must not be negative, is -1"},
      {Check::kEmptyName, with(R"({"area_m2": 1, "normal": [1, 0, 0], "center_m": [0, 0, 0],
                "coefficients": {"lift": [], "drag": [1]}})"),
       place + ".coefficients.lift: must not be empty"},
  };
}

std::vector<WrongProject> ForceWarnings() {
  return {
      {Check::kForceFeltByNone, Warn(WithForces(kMagnet, {{"/forces/0/joint", "\"l_knee\""}})),
       "forces[0]: nothing feels \"magnet\": no region moves \"l_knee\" in frames 5 to 15; add "
       "one, or remove the force"},
      {Check::kForceFeltByNone,
       Warn(WithForces(kBreeze, {{"/forces/0/first_frame", "0"}, {"/forces/0/last_frame", "5"}})),
       "forces[0]: nothing feels \"breeze\": no region moves anything in frames 0 to 5; add one, "
       "or remove the force"},
  };
}

}  // namespace

std::vector<WrongProject> WrongForces() {
  std::vector<WrongProject> all = WrongForceValues();
  for (const auto& list : {ForceContradictions(), WrongSurfaces(), ForceWarnings()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace hazumi::testing
