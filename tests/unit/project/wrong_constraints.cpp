// Constraints that cannot be, and those that nothing feels.

#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

const std::string kGrip = R"({"name": "grip", "kind": "point",
                              "a": {"joint": "r_wrist", "offset_m": [0, 0, -0.09]},
                              "b": {"object": "platform", "offset_m": [0, 0.2, 0]},
                              "first_frame": 5, "last_frame": 15, "arrive_frames": 5})";
const std::string kRope = R"({"name": "rope", "kind": "distance", "a": {"joint": "l_wrist"},
                              "b": {"offset_m": [0, 0, 2]}, "length_m": 0.3,
                              "first_frame": 5, "last_frame": 15})";

Changes WithConstraints(const std::string& constraints, const Changes& more = {}) {
  Changes changes = {{"/solver/method", "\"exact\""},
                     {"/regions/0/method", "\"exact\""},
                     {"/constraints", "[" + constraints + "]"}};
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

std::vector<WrongProject> WrongConstraintValues() {
  const std::string place = "constraints[0]";
  return {
      {Check::kNotPositive, Read(WithConstraints(kRope, {{"/constraints/0/length_m", "0"}})),
       place + ".length_m: must be greater than 0, is 0"},
      {Check::kMissingField, Read(WithConstraints(kRope, {{"/constraints/0/length_m", ""}})),
       place + ": the field \"length_m\" is missing; add it"},
      {Check::kNotPositive, Read(WithConstraints(kGrip, {{"/constraints/0/arrive_frames", "0"}})),
       place + ".arrive_frames: must be greater than 0, is 0"},
      {Check::kNotWhole, Read(WithConstraints(kGrip, {{"/constraints/0/arrive_frames", "2.5"}})),
       place + ".arrive_frames: expected a whole number, found 2.5"},
      {Check::kNotPositive,
       Read(WithConstraints(kGrip, {{"/constraints/0/break_force_n", "-900"}})),
       place + ".break_force_n: must be greater than 0, is -900"},
      {Check::kNotPositive,
       Read(WithConstraints(kGrip, {{"/constraints/0/break_impulse_n_s", "0"}})),
       place + ".break_impulse_n_s: must be greater than 0, is 0"},
      {Check::kUnknownChoice, Read(WithConstraints(kGrip, {{"/constraints/0/kind", "\"wild\""}})),
       place + ".kind: there is no constraint kind \"wild\"; did you mean \"weld\"?"},
      {Check::kWrongType, Read(WithConstraints(kGrip, {{"/constraints/0/a", "\"r_wrist\""}})),
       place + ".a: expected an object, found a string"},
      {Check::kWrongCount, Read(WithConstraints(kGrip, {{"/constraints/0/b/offset_m", "[1]"}})),
       place + ".b.offset_m: expected 3 values, found 1"},
      {Check::kEmptyName, Read(WithConstraints(kGrip, {{"/constraints/0/name", "\"\""}})),
       place + ".name: must not be empty"},
      {Check::kSpanEmpty, Read(WithConstraints(kGrip, {{"/constraints/0/last_frame", "5"}})),
       place + ": first_frame 5 must be before last_frame 5"},
      {Check::kNameTwice,
       Read(WithConstraints(kGrip + "," + kRope, {{"/constraints/1/name", "\"grip\""}})),
       "constraints[1].name: the name \"grip\" is already used by constraints[0]; choose another"},
  };
}

std::vector<WrongProject> WrongConstraintNames() {
  return {
      {Check::kUnknownJoint,
       Read(WithConstraints(kGrip, {{"/constraints/0/a/joint", "\"r_wrst\""}})),
       "constraints[0].a.joint: no joint \"r_wrst\"; did you mean \"r_wrist\"?"},
      {Check::kUnknownObject,
       Read(WithConstraints(kGrip, {{"/constraints/0/b/object", "\"brik\""}})),
       "constraints[0].b.object: no object \"brik\", neither in the scene nor held; did you mean "
       "\"brick\"?"},
      {Check::kUnknownObject,
       Read(WithConstraints(kGrip, {{"/scene/objects", "[]"}, {"/held_objects", "[]"}})),
       "constraints[0].b.object: no object \"platform\", neither in the scene nor held; there are "
       "none"},
      {Check::kAmbiguousObject,
       Read(WithConstraints(kGrip, {{"/held_objects/1/name", "\"platform\""}})),
       "constraints[0].b.object: the scene and what is held both have \"platform\"; give one of "
       "them another name"},
      {Check::kJointAndObject,
       Read(WithConstraints(kGrip, {{"/constraints/0/b/joint", "\"l_wrist\""}})),
       "constraints[0].b: is fixed to \"l_wrist\" and to \"platform\"; keep one of them"},
  };
}

std::vector<WrongProject> ConstraintContradictions() {
  const auto to = [](const std::string& object, const Changes& more = {}) {
    Changes changes = {{"/constraints/0/b/object", "\"" + object + "\""}};
    changes.insert(changes.end(), more.begin(), more.end());
    return Compile(WithConstraints(kGrip, changes));
  };
  return {
      {Check::kOutsideFrames,
       Compile(WithConstraints(kGrip, {{"/constraints/0/last_frame", "31"}})),
       "constraints[0]: frames 5 to 31 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kOutsideFrames,
       Compile(WithConstraints(kRope, {{"/constraints/0/first_frame", "-1"}})),
       "constraints[0]: frames -1 to 15 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kObjectChangesHands, to("ball"),
       "constraints[0].b: \"ball\" is not in one hand in all of the frames 5 to 15: \"r_wrist\" in "
       "frames 0 to 9; end the constraint where it is let go, or name a joint"},
      {Check::kObjectNotHeld, to("ball", {{"/constraints/0/first_frame", "9"}}),
       "constraints[0].b: nobody has \"ball\" in frames 9 to 15, and what flies or lies by itself "
       "cannot be constrained; let a joint have it all that time, or name an object of the scene"},
      {Check::kConstraintOnOneBody, to("ball", {{"/constraints/0/last_frame", "9"}}),
       "constraints[0]: both ends are fixed to \"r_wrist\", so that neither can move against the "
       "other; fix one to something else"},
      {Check::kConstraintOnOneBody,
       Compile(WithConstraints(kGrip, {{"/constraints/0/a", R"({"joint": "root"})"},
                                       {"/constraints/0/b", R"({"joint": "pelvis"})"}})),
       "constraints[0]: both ends are fixed to \"pelvis\", so that neither can move against the "
       "other; fix one to something else"},
      {Check::kConstraintInWorld, Compile(WithConstraints(kGrip, {{"/constraints/0/a", "{}"}})),
       "constraints[0]: both ends are fixed in the world, so that neither can move; fix one to a "
       "joint or to what a joint holds"},
      {Check::kConstraintInPaper,
       Compile({{"/constraints", "[" + kGrip + "]"}, {"/regions/1/mute", "true"}}),
       "constraints[0]: \"grip\" holds in frames 5 to 15, in which region \"arm\" has method "
       "\"paper\", which knows no constraints; choose method \"exact\" for it, or end one where "
       "the other begins"},
      {Check::kNumChecks, to("brick"), "no complaint"},
  };
}

std::vector<WrongProject> ConstraintWarnings() {
  return {
      {Check::kConstraintFeltByNone,
       Warn(WithConstraints(kGrip, {{"/constraints/0/a/joint", "\"l_knee\""}})),
       "constraints[0]: nothing feels \"grip\": no region moves \"l_knee\" in frames 5 to 15; add "
       "one, or remove the constraint"},
      {Check::kConstraintFeltByNone,
       Warn(WithConstraints(kGrip, {{"/constraints/0/a/joint", "\"l_knee\""},
                                    {"/constraints/0/b", R"({"joint": "waist"})"}})),
       "constraints[0]: nothing feels \"grip\": no region moves \"l_knee\" or \"waist\" in frames "
       "5 "
       "to 15; add one, or remove the constraint"},
      {Check::kConstraintOutlasts,
       Warn(WithConstraints(kGrip, {{"/constraints/0/last_frame", "25"}})),
       "constraints[0]: from frame 20 on nothing moves \"r_wrist\", so that \"grip\" has no effect "
       "up to its last frame 25; let a region move it as long, or end the constraint in frame 20"},
  };
}

}  // namespace

std::vector<WrongProject> WrongConstraints() {
  std::vector<WrongProject> all = WrongConstraintValues();
  for (const auto& list :
       {WrongConstraintNames(), ConstraintContradictions(), ConstraintWarnings()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace hazumi::testing
