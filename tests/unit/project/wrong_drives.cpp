// Drives of regions that cannot be.

#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

Changes WithDrives(const std::string& drives, Changes more = {}) {
  more.emplace_back("/regions/0/drives", drives);
  return more;
}

std::string Spring(const std::string& joints, const std::string& frequency = "2") {
  return R"([{"joints": )" + joints + R"(, "kind": "spring", "frequency_hz": )" + frequency + "}]";
}

std::string SpringOverTime(const std::string& curve, const std::string& value, double rate = 0) {
  return R"([{"joints": ["r_elbow"], "kind": "spring", "frequency_hz": 2, ")" + curve +
         R"(": [{"frame": 5, "value": 1}, {"frame": 15, "value": )" + value +
         R"(, "rate_per_s": )" + std::to_string(rate) + "}]}]";
}

}  // namespace

std::vector<WrongProject> WrongDrives() {
  const std::string first = "regions[0].drives[0]";
  return {
      {Check::kDriveEmpty, Read(WithDrives(Spring("[]"))),
       first + ".joints: a drive needs at least one joint"},
      {Check::kRange, Read(WithDrives(Spring(R"(["r_elbow"])", "31"))),
       first + ".frequency_hz: must lie between 0 and 30 Hz, is 31 (how often a second it "
               "would swing, undamped; the higher, the stiffer)"},
      {Check::kMissingField, Read(WithDrives(R"([{"joints": ["r_elbow"], "kind": "spring"}])")),
       first + ": the field \"frequency_hz\" is missing; add it"},
      {Check::kKeyOrder, Read(WithDrives(R"([{"joints": ["r_elbow"], "kind": "torque",
                            "keys": [{"frame": 7, "torque_n_m": 1}, {"frame": 5, "torque_n_m": 2}]}])")),
       first + ".keys[1].frame: frame 5 comes after frame 7; write keys in order of frames"},
      {Check::kUnknownJoint, Read(WithDrives(Spring(R"(["r_elbo"])"))),
       first + ".joints[0]: no joint \"r_elbo\"; did you mean \"r_elbow\"?"},
      {Check::kDriveOnRoot, Read(WithDrives(Spring(R"(["pelvis"])"))),
       first + ".joints[0]: \"pelvis\" is the root: muscles act in joints, and the root has none; "
               "remove it, or put + behind its name for all joints of the region"},
      {Check::kDriveNotInRegion, Read(WithDrives(Spring(R"(["r_knee"])"))),
       first + ".joints[0]: \"r_knee\" is not in this region; add it to the region's joints or "
               "take it out of the drive"},
      {Check::kDrivenTwice, Read(WithDrives(R"([{"joints": ["r_elbow"], "kind": "keys"},
                              {"joints": ["r_wrist", "r_elbow"], "kind": "keys"}])")),
       "regions[0].drives[1].joints[1]: \"r_elbow\" has drives[0] already; a joint has one drive"},
      {Check::kDriveFrozen,
       Compile(
           WithDrives(Spring(R"(["r_elbow"])"),
                      {{"/regions/0/friction", R"({"default": 1, "joints": {"r_elbow": 0}})"}})),
       "regions[0].drives: \"r_elbow\" has friction 0, which keeps it still; raise its friction or "
       "take it out of the drive"},
      {Check::kDriveSplitsBall,
       Compile(WithDrives(Spring(R"(["l_shoulder_flexion"])"),
                          {{"/figure/joints/1/hinges/1/limits_deg", "[-10, 10]"}})),
       "regions[0].drives: \"l_shoulder_flexion\" is one of the three hinges of \"l_shoulder\", "
       "which share a spring; drive all three"},
      {Check::kDriveWithoutStrength,
       Compile(WithDrives(R"([{"joints": ["r_elbow"], "kind": "spring", "frequency_hz": 2,
                               "strength": 0.5}])")),
       "regions[0].drives: the figure does not say how strong \"r_elbow\" is; give the drive a "
       "max_torque_n_m in place of strength, or the figure's hinges a strength"},
      {Check::kRange, Read(WithDrives(SpringOverTime("frequency_keys", "31"))),
       first + ".frequency_keys[1].value: must lie between 0 and 30 Hz, is 31 (how often a second "
               "it would swing, undamped)"},
      {Check::kKeyTwice, Read(WithDrives(R"([{"joints": ["r_elbow"], "kind": "spring",
           "frequency_hz": 2, "strength_keys": [{"frame": 5, "value": 1}, {"frame": 5, "value": 2}]}])")),
       first + ".strength_keys[1].frame: a second key on frame 5; keep one of them"},
      {Check::kDriveCurveOutside, Read(WithDrives(SpringOverTime("frequency_keys", "29", -100))),
       first + ".frequency_keys: between its keys the curve reaches 31 at frame 13.8, and must "
               "stay from 0 to 30; give keys beside that a rate, or interpolation linear"},
      {Check::kDriveCurveOutside, Read(WithDrives(SpringOverTime("strength_keys", "0.1", 20))),
       first + ".strength_keys: between its keys the curve reaches -0.698 at frame 12.4, and must "
               "stay from 0 to 10; give keys beside that a rate, or interpolation linear"},
      {Check::kRegionsOverlap,
       Compile(
           WithDrives(R"([{"joints": ["r_wrist"], "kind": "keys"}])",
                      {{"/regions/1/joints", R"(["r_wrist"])"}, {"/regions/1/first_frame", "9"}})),
       "regions[1]: regions \"arm\" and \"leg\" both drive \"r_wrist_flexion\" in frames 9 to 15; "
       "end one where the other begins, or take it out of one"},
  };
}

}  // namespace hazumi::testing
