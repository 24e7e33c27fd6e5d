#include "tests/unit/project/wrong_makers.h"
#include "tests/unit/project/wrong_projects.h"

namespace hazumi::testing {

namespace {

const std::string kHoldBoth = R"([{"joint": "r_wrist", "first_frame": 0, "last_frame": 5},
                                  {"joint": "l_wrist", "first_frame": 3, "last_frame": 5}])";
const std::string kHoldTwice = R"([{"joint": "r_elbow", "first_frame": 0, "last_frame": 5},
                                  {"joint": "r_wrist", "first_frame": 3, "last_frame": 5}])";
const std::string kHoldByBody =
    R"([{"joint": "r_wrist", "reach": "body", "first_frame": 0, "last_frame": 5},
        {"joint": "l_wrist", "first_frame": 3, "last_frame": 5}])";
const std::string kWaistRegion = R"([{"name": "trunk", "first_frame": 4, "last_frame": 9,
                                      "joints": ["waist"]}])";
const std::string kPinWrist = R"([{"kind": "pinned", "joint": "l_wrist", "first_frame": 0,
                                   "last_frame": 5}])";
const std::string kFall = R"([{"kind": "gravity", "first_frame": 0, "last_frame": 5}])";
const std::string kHoldWrist = R"([{"joint": "r_wrist", "reach": "body", "first_frame": 2,
                                   "last_frame": 8}])";
// Regions that swing the root.
const std::string kTumble = R"({"name": "tumble", "first_frame": 5, "last_frame": 10,
                                "joints": ["pelvis", "r_elbow"], "method": "exact"})";
const std::string kRoll = R"({"name": "roll", "first_frame": 8, "last_frame": 12,
                              "joints": ["root"], "method": "exact"})";

// A slip in the figure's own file.
std::string DoubtFigureFile() {
  const TemporaryFolder folder;
  const Json figure = Changed(SampleProject()["figure"], {{"/joints/0/link", "[]"}});
  WriteFile(folder / "doll.json", figure.dump());
  WriteFile(folder / "a.kfa",
            Changed(SampleProject(), {{"/figure", R"({"file": "doll.json"})"}}).dump());
  const Result<Project> project = LoadProject(folder / "a.kfa");
  if (!project.ok()) return Complaint(project);
  if (project.value().read.warnings.empty()) return "no complaint";
  const Warning& warning = project.value().read.warnings.front();
  return warning.place + ": " + warning.message;
}

std::vector<WrongProject> WrongValues() {
  return {
      {Check::kBadFrameRate, Read("/fps/num", "0"),
       "fps: must lie between 0.1 and 10000 frames a second, is 0/1"},
      {Check::kBadFrameRate, Read("/fps/den", "0"),
       "fps: must lie between 0.1 and 10000 frames a second, is 30/0"},
      {Check::kBadFrameRate, Read("/fps/num", "-30"),
       "fps: must lie between 0.1 and 10000 frames a second, is -30/1"},
      {Check::kFramesReversed, Read("/frames/last", "-1"),
       "frames: the last frame -1 is before the first, 0"},
      {Check::kFramesReversed, Read("/preview/last", "4"),
       "preview: the last frame 4 is before the first, 5"},
      {Check::kTooManyFrames, Read("/frames/last", "1000000"),
       "frames: 1000001 frames; a project has 1000000 at most"},
      {Check::kNewerSolver, Read("/solver/version", "3"),
       "solver.version: made for version 3 of the solver, this Hazumi has 2; please update it"},
      {Check::kRange, Read("/solver/step_s", "0"),
       "solver.step_s: must lie between 1e-06 and 1 s, is 0 (length of a step of method paper)"},
      {Check::kRange, Read("/regions/0/step_s", "1e-9"),
       "regions[0].step_s: must lie between 1e-06 and 1 s, is 1e-09 (length of a step of method "
       "paper)"},
      {Check::kRange, Read("/solver/tolerance_deg", "6"),
       "solver.tolerance_deg: must lie between 1e-10 and 5°, is 6 (greatest error of an angle, by "
       "method exact)"},
      {Check::kRange, Read("/regions/0/tolerance_deg", "0"),
       "regions[0].tolerance_deg: must lie between 1e-10 and 5°, is 0 (greatest error of an "
       "angle, by method exact)"},
      {Check::kNotFinite, Spoilt([](Project& p) { p.regions[1].tolerance_deg = std::nan(""); }),
       "regions[1].tolerance_deg: must be a finite number"},
      {Check::kNotFinite,
       Spoilt([](Project& p) { p.joints[0].value.keys[0].value = std::nan(""); }),
       "joints.r_knee.keys[0].angle_deg: must be a finite number"},
      {Check::kKeyOrder, Read("/joints/r_knee/keys/1/frame", "31"),
       "joints.r_knee.keys[2].frame: frame 30 comes after frame 31; write keys in order of frames"},
      {Check::kKeyTwice, Read("/joints/r_knee/keys/1/frame", "30"),
       "joints.r_knee.keys[2].frame: a second key on frame 30; keep one of them"},
      {Check::kKeyTwice, Read("/root/z/keys", R"([{"frame": 1, "position_m": 0},
                                                 {"frame": 1, "position_m": 2}])"),
       "root.z.keys[1].frame: a second key on frame 1; keep one of them"},
      {Check::kSpanEmpty, Read("/regions/0/last_frame", "5"),
       "regions[0]: first_frame 5 must be before last_frame 5"},
      {Check::kSpanEmpty, Read("/placements/0/first_frame", "30"),
       "placements[0]: first_frame 30 must be before last_frame 30"},
      {Check::kSpanEmpty, Read("/holds/0/last_frame", "-2"),
       "holds[0]: first_frame 0 must be before last_frame -2"},
      {Check::kRegionEmpty, Read("/regions/0/joints", "[]"),
       "regions[0].joints: a region needs at least one joint"},
      {Check::kSetEmpty, Read("/selection_sets/1/joints", "[]"),
       "selection_sets[1].joints: a selection set needs at least one joint"},
      {Check::kGoalEmpty, Read("/goals/0/joints", "[]"),
       "goals[0].joints: a goal of kind pose needs at least one joint"},
      {Check::kFillEmpty, Read("/fills/0/joints", "[]"),
       "fills[0].joints: a fill needs at least one joint"},
      {Check::kNegative, Read("/regions/0/blend_frames", "-1"),
       "regions[0].blend_frames: must not be negative, is -1"},
      {Check::kRange, Read("/regions/0/friction/default", "1.5"),
       "regions[0].friction.default: must lie between 0 and 1, is 1.5 (speed that is left after "
       "1/30 s: 0 frozen, 1 no friction)"},
      {Check::kRange, Read("/regions/0/friction/joints/r_wrist", "-0.1"),
       "regions[0].friction.joints.r_wrist: must lie between 0 and 1, is -0.1 (the same, of single "
       "joints and hinges: 0 frozen, 1 no friction)"},
      {Check::kNameTwice, Read("/regions/1/name", "\"arm\""),
       "regions[1].name: the name \"arm\" is already used by regions[0]; choose another"},
      {Check::kNameTwice, Read("/held_objects/1/name", "\"ball\""),
       "held_objects[1].name: the name \"ball\" is already used by held_objects[0]; choose "
       "another"},
      {Check::kNameTwice, Read("/selection_sets/1/name", "\"arm\""),
       "selection_sets[1].name: the name \"arm\" is already used by selection_sets[0]; choose "
       "another"},
      {Check::kRange, Read("/camera/vertical_fov_deg", "180"),
       "camera.vertical_fov_deg: must lie between 1 and 179°, is 180 (vertical field of view)"},
      {Check::kRange, Read("/audio/gain_db", "25"),
       "audio.gain_db: must lie between -60 and 24 dB, is 25 (how much louder it is than its "
       "file)"},
      {Check::kEmptyName, Read("/audio/file", "\"\""), "audio.file: must not be empty"},
      {Check::kRange, Read("/reference/opacity", "1.5"),
       "reference.opacity: must lie between 0 and 1, is 1.5 (0: not seen, 1: it hides what is "
       "behind it)"},
      {Check::kRange, Read("/joints/r_knee/keys/1/length_in", "0.95"),
       "joints.r_knee.keys[1].length_in: must lie between 0.05 and 0.9, is 0.95 (how far its "
       "tangent reaches back, a share of the time from the key before)"},
      {Check::kMissingField, Read("/audio/file", ""),
       "audio: the field \"file\" is missing; add it"},
      {Check::kReleaseByNobody, Read("/held_objects/0/joint", ""),
       "held_objects[0].release_frame: nobody has it at first who could let go; give it a joint or "
       "remove this"},
      {Check::kHoldersOverlap,
       Read("/held_objects/1/holders", R"([{"joint": "l_wrist", "first_frame": 8}])"),
       "held_objects[1].holders[0]: begins in frame 8, when \"l_wrist\" still has it; end that one "
       "before or in that frame"},
      {Check::kSpanEmpty,
       Read({{"/held_objects/1/release_frame", "4"},
             {"/held_objects/1/holders",
              R"([{"joint": "l_wrist", "first_frame": 8, "last_frame": 8}])"}}),
       "held_objects[1].holders[0]: first_frame 8 must be before last_frame 8"},
      {Check::kPositionIncomplete,
       Read("/held_objects/1/position", R"({"x": {"keys": [{"frame": 0, "position_m": 1}]}})"),
       "held_objects[1].position.y: has no keys, but others of x, y and z have; give keys to all "
       "three or to none"},
      {Check::kNoView, Read("/camera/target_m", "[0, -3, 1]"),
       "camera: eye_m and target_m are the same point; move one of them"},
  };
}

std::vector<WrongProject> WrongNames() {
  return {
      {Check::kUnknownJoint, Read("/regions/0/joints/0", "\"r_wirst\""),
       "regions[0].joints[0]: no joint \"r_wirst\"; did you mean \"r_wrist\"?"},
      {Check::kUnknownJoint, Read("/regions/0/joints/2/beyond", "\"tail\""),
       "regions[0].joints[2]: no joint \"tail\"; use one of \"waist\", \"r_shoulder\", "
       "\"r_elbow\", \"r_wrist\", \"l_shoulder\", \"l_elbow\", \"l_wrist\", \"r_hip\", \"r_knee\", "
       "\"r_ankle\", \"l_hip\", \"l_knee\" (and 22 more)"},
      {Check::kUnknownJoint, Read("/regions/0/friction/joints/r_elbo", "0.5"),
       "regions[0].friction.joints.r_elbo: no joint \"r_elbo\"; did you mean \"r_elbow\"?"},
      {Check::kUnknownJoint, Read("/joints/r_kne", R"({"keys": []})"),
       "joints.r_kne: no joint \"r_kne\"; did you mean \"r_knee\"?"},
      {Check::kUnknownJoint, Read("/placements/1/joint", "\"l_ankel\""),
       "placements[1].joint: no joint \"l_ankel\"; did you mean \"l_ankle\"?"},
      {Check::kUnknownJoint, Read("/goals/0/joints/0", "\"l_ankel\""),
       "goals[0].joints[0]: no joint \"l_ankel\"; did you mean \"l_ankle\"?"},
      {Check::kUnknownJoint, Read("/goals/1/joint", "\"r_wist\""),
       "goals[1].joint: no joint \"r_wist\"; did you mean \"r_wrist\"?"},
      {Check::kUnknownJoint, Read("/fills/0/joints/0", "\"l_ankel\""),
       "fills[0].joints[0]: no joint \"l_ankel\"; did you mean \"l_ankle\"?"},
      {Check::kFillsOverlap, Read("/fills/1/joints/0", "\"r_elbow\""),
       "fills[1]: \"arm\" fills \"r_elbow\" in frames 2 to 8, too; end one where the other "
       "begins, or take the joint out of one"},
      {Check::kUnknownJoint, Read("/selection_sets/0/joints/0", "\"l_ankel\""),
       "selection_sets[0].joints[0]: no joint \"l_ankel\"; did you mean \"l_ankle\"?"},
      {Check::kUnknownJoint, Read("/placements/0/pin", "\"r_ancle\""),
       "placements[0].pin: no joint \"r_ancle\"; did you mean \"r_ankle\"?"},
      {Check::kUnknownJoint, Read("/placements/0/landing_pin", "\"l_ancle\""),
       "placements[0].landing_pin: no joint \"l_ancle\"; did you mean \"l_ankle\"?"},
      {Check::kUnknownJoint, Read("/holds/0/joint", "\"\""),
       "holds[0].joint: no joint \"\"; use one of \"waist\", \"r_shoulder\", \"r_elbow\", "
       "\"r_wrist\", \"l_shoulder\", \"l_elbow\", \"l_wrist\", \"r_hip\", \"r_knee\", \"r_ankle\", "
       "\"l_hip\", \"l_knee\" (and 22 more)"},
      {Check::kUnknownJoint, Read("/held_objects/0/joint", "\"r_wristt\""),
       "held_objects[0].joint: no joint \"r_wristt\"; did you mean \"r_wrist\"?"},
      {Check::kKeysOnGroup, Read("/joints/r_wrist", R"({"keys": []})"),
       "joints.r_wrist: \"r_wrist\" has 2 hinges; key each by its name: \"r_wrist_flexion\", "
       "\"r_wrist_deviation\""},
      {Check::kRootInRegion, Read("/regions/0/joints/0", "\"root\""),
       "regions[0].joints[0]: \"root\" is the root, which method \"paper\" leaves to its keys; "
       "choose method \"exact\" for this region, or name joints beyond the root"},
      {Check::kRootInRegion, Read("/regions/0/joints/2/beyond", "\"pelvis\""),
       "regions[0].joints[2]: \"pelvis\" is the root, which method \"paper\" leaves to its keys; "
       "choose method \"exact\" for this region, or name joints beyond the root"},
      {Check::kRootInRegion, Read("/regions/1/joints/0", "\"pelvis\""),
       "regions[1].joints[0]: \"pelvis\" is the root, which method \"paper\" leaves to its keys; "
       "choose method \"exact\" for this region, or name joints beyond the root"},
      {Check::kRootNotAJoint, Read("/placements/1/joint", "\"pelvis\""),
       "placements[1].joint: \"pelvis\" is the root, not a joint; name a joint (the root's own "
       "keys stand under \"root\")"},
      {Check::kRootNotAJoint, Read("/joints/root", R"({"keys": []})"),
       "joints.root: \"root\" is the root, not a joint; name a joint (the root's own keys stand "
       "under \"root\")"},
      {Check::kFrictionOnRoot,
       Read({{"/regions/0", kTumble},
             {"/regions/0/friction", R"({"default": 1, "joints": {"pelvis": 0.5}})"}}),
       "regions[0].friction.joints.pelvis: \"pelvis\" is the root: friction acts in joints, and "
       "the root has none; remove it"},
      {Check::kFrictionOnRoot, Read("/regions/1/friction/joints", R"({"root": 0.5})"),
       "regions[1].friction.joints.root: \"root\" is the root: friction acts in joints, and the "
       "root has none; remove it"},
      {Check::kFrictionNotInRegion, Read("/regions/1/friction/joints", R"({"r_ankle": 0.5})"),
       "regions[1].friction.joints.r_ankle: \"r_ankle\" is not in this region; add it to the "
       "region's joints or remove its friction"},
  };
}

std::vector<WrongProject> Contradictions() {
  return {
      {Check::kOutsideFrames, Compile({{"/regions/1/last_frame", "31"}}),
       "regions[1]: frames 15 to 31 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kOutsideFrames, Compile({{"/placements/2/first_frame", "-1"}}),
       "placements[2]: frames -1 to 5 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kOutsideFrames, Compile({{"/holds/0/last_frame", "40"}}),
       "holds[0]: frames 0 to 40 are not within the project's frames 0 to 30; move them or "
       "lengthen the project"},
      {Check::kReleaseOutside, Compile({{"/held_objects/0/release_frame", "31"}}),
       "held_objects[0].release_frame: frame 31 is not within the project's frames 0 to 30"},
      {Check::kReleaseOutside,
       Compile({{"/held_objects/1/release_frame", "4"},
                {"/held_objects/1/holders", R"([{"joint": "l_wrist", "first_frame": 31}])"}}),
       "held_objects[1].holders[0].first_frame: frame 31 is not within the project's frames 0 to "
       "30"},
      {Check::kPlacedByNobody, Compile({{"/held_objects/1/joint", ""}}),
       "held_objects[1]: nobody has \"brick\" in frame 0, and it has no position; give it a joint "
       "or keys of its position"},
      {Check::kRegionsOverlap,
       Compile(
           {{"/regions/1/first_frame", "14"}, {"/regions/1/joints", R"(["r_knee", "l_elbow"])"}}),
       "regions[1]: regions \"arm\" and \"leg\" both drive \"l_elbow\" in frames 14 to 15; end one "
       "where the other begins, or take it out of one"},
      {Check::kRegionsOverlap, Compile({{"/regions", "[" + kTumble + ", " + kRoll + "]"}}),
       "regions[1]: regions \"tumble\" and \"roll\" both drive the root in frames 8 to 10; end one "
       "where the other begins, or take it out of one"},
      {Check::kMethodsDiffer,
       Compile({{"/regions/1/first_frame", "14"}, {"/regions/1/method", "\"exact\""}}),
       "regions[1]: regions \"arm\" and \"leg\" share frames 14 to 15, but one has method "
       "\"paper\" and the other \"exact\"; give them the same, or end one where the other begins"},
      {Check::kMethodInGravity, Compile({{"/regions/1/method", "\"exact\""}}),
       "regions[1]: region \"leg\" has method \"exact\", but in frames 15 to 20 gravity places the "
       "figure (placements[0]) by the solver's method \"paper\"; leave out the region's, or end "
       "one where the other begins"},
      {Check::kRegionAllFixed, Compile({{"/regions/1/joints", R"(["r_shoulder_twist"])"}}),
       "regions[1].joints: every joint of region \"leg\" is fixed by equal limits, so nothing can "
       "swing; name others"},
      {Check::kPlacementsOverlap, Compile({{"/placements/1/last_frame", "16"}}),
       "placements[1]: overlaps placements[0] in frames 15 to 16; end one where the other begins"},
      {Check::kNothingToSolve, Compile({{"/holds/0/joint", "\"r_hip\""}}),
       "holds[0]: no joint lies between the root and \"r_hip\", so nothing can hold it in place; "
       "pin it instead"},
      {Check::kHoldsConflict, Compile({{"/holds", kHoldByBody}}),
       "holds[1]: \"l_wrist\" and \"r_wrist\" (holds[0]) are held in frames 3 to 5 and both need "
       "\"waist\", so they cannot be solved together; let go of one or give it the reach \"limb\""},
      {Check::kHoldsConflict, Compile({{"/holds", kHoldTwice}}),
       "holds[1]: \"r_wrist\" and \"r_elbow\" (holds[0]) are held in frames 3 to 5 and both need "
       "\"r_shoulder\", so they cannot be solved together; let go of one"},
      {Check::kLoopOfHolds, Compile({{"/holds", kHoldBoth}, {"/regions", kWaistRegion}}),
       "holds[1]: region \"trunk\" drives \"waist\", which lies between the root and both "
       "\"l_wrist\" and \"r_wrist\", held in frames 4 to 5: a closed loop, which cannot swing; let "
       "go of one, or take the joint out of the region"},
      {Check::kHoldOnPin,
       Compile({{"/placements/1/joint", "\"r_ankle\""}, {"/holds/0/last_frame", "7"}}),
       "holds[0]: \"r_ankle\" is pinned by placements[1] in frames 5 to 7 already; remove the hold "
       "there"},
      {Check::kHoldConflictsPin, Compile({{"/holds", kHoldWrist}, {"/placements", kPinWrist}}),
       "holds[0]: holding \"r_wrist\" needs \"waist\", which also carries \"l_wrist\", pinned by "
       "placements[0] in frames 2 to 5; let go of one or give it the reach \"limb\""},
      {Check::kHoldConflictsPin,
       Compile({{"/placements/1/joint", "\"r_knee\""}, {"/holds/0/last_frame", "7"}}),
       "holds[0]: holding \"r_ankle\" needs \"r_hip\", which also carries \"r_knee\", pinned by "
       "placements[1] in frames 5 to 7; let go of one"},
      {Check::kHoldInGravity, Compile({{"/holds", kHoldWrist}, {"/placements", kFall}}),
       "holds[0]: \"r_wrist\" is held while gravity places the figure (placements[0]) in frames 2 "
       "to 5; hold it before or after, or pin it"},
      {Check::kLoopWithPin,
       Compile({{"/holds", kHoldWrist}, {"/placements", kPinWrist}, {"/regions", kWaistRegion}}),
       "holds[0]: region \"trunk\" drives \"waist\", which lies between the root and both "
       "\"r_wrist\", held, and \"l_wrist\", pinned, in frames 4 to 5: a closed loop, which cannot "
       "swing; let go of one, or take the joint out of the region"},
      {Check::kRegionInHold, Compile({{"/regions/1/first_frame", "3"}}),
       "holds[0]: region \"leg\" drives \"r_knee\", which the hold of \"r_ankle\" (holds[0]) needs "
       "in frames 3 to 5; end one where the other begins, or take the joint out of the region"},
      {Check::kRootInHold,
       Compile({{"/regions", "[" + kTumble + "]"}, {"/regions/0/first_frame", "4"}}),
       "holds[0]: region \"tumble\" swings the root, which the hold of \"r_ankle\" (holds[0]) "
       "needs in frames 4 to 5; end the hold before the region begins, or leave the root out of "
       "the region"},
      // Documents that no file could give are checked all the same.
      {Check::kUnknownJoint, Spoilt([](Project& p) { p.holds[0].joint = "nose"; }),
       "holds[0].joint: no joint \"nose\"; use one of \"waist\", \"r_shoulder\", \"r_elbow\", "
       "\"r_wrist\", \"l_shoulder\", \"l_elbow\", \"l_wrist\", \"r_hip\", \"r_knee\", \"r_ankle\", "
       "\"l_hip\", \"l_knee\" (and 22 more)"},
      {Check::kRange, Spoilt([](Project& p) { p.regions[0].friction.default_factor = 2; }),
       "regions[0].friction.default: must lie between 0 and 1, is 2 (speed that is left after 1/30 "
       "s: 0 frozen, 1 no friction)"},
      {Check::kNumChecks, Spoilt([](Project& p) { p.figure.spec = {}; }),
       "figure: the figure has no mass"},
  };
}

std::vector<WrongProject> Misspellings() {
  return {
      {Check::kUnknownField, Doubt("/joints/r_knee/keys/2/interpolaton", "\"hold\""),
       "joints.r_knee.keys[2]: unknown field \"interpolaton\"; did you mean \"interpolation\"?"},
      {Check::kUnknownField, Doubt("/joints/r_knee/keys/1/rate_deg", "30"),
       "joints.r_knee.keys[1]: unknown field \"rate_deg\"; did you mean \"rate_deg_s\"?"},
      {Check::kUnknownField, Doubt("/root/z/keys/0/rate", "1"),
       "root.z.keys[0]: unknown field \"rate\"; did you mean \"rate_m_s\"?"},
      {Check::kUnknownField, Doubt("/regions/0/step", "0.01"),
       "regions[0]: unknown field \"step\"; did you mean \"step_s\"?"},
      {Check::kUnknownField, Doubt("/regions/1/frction", "{}"),
       "regions[1]: unknown field \"frction\"; did you mean \"friction\"?"},
      {Check::kUnknownField, Doubt("/solver/step", "0.01"),
       "solver: unknown field \"step\"; did you mean \"step_s\"?"},
      {Check::kUnknownField, Doubt("/regions/1/tolerance", "0.1"),
       "regions[1]: unknown field \"tolerance\"; did you mean \"tolerance_deg\"?"},
      {Check::kUnknownField, Doubt("/regoins", "[]"),
       "regoins: unknown field \"regoins\"; did you mean \"regions\"?"},
      {Check::kUnknownField, Doubt("/scene/gravity", "1.6"),
       "scene: unknown field \"gravity\"; did you mean \"gravity_m_s2\"?"},
      {Check::kUnknownField, Doubt("/figure/joints/0/hinges/0/rest", "5"),
       "figure.joints[0].hinges[0]: unknown field \"rest\"; did you mean \"rest_deg\"?"},
      {Check::kUnknownField, DoubtFigureFile,
       "figure.joints[0]: unknown field \"link\"; did you mean \"links\"?"},
      // Not every unknown field is a slip.
      {Check::kNumChecks,
       Doubt({{"/x_regions", "1"},
              {"/regions/0/note", "1"},
              {"/regions/0/notes", "1"},
              {"/regions/0/comment_1", "1"},
              {"/joints/r_knee/keys/0/locked", "true"}}),
       ""},
  };
}

std::vector<WrongProject> Warnings() {
  return {
      {Check::kFixedLeftOut, Warn({}),
       "regions[0].joints: fixed by equal limits and left out of the region: l_shoulder_twist"},
      {Check::kNothingToLandOn, Warn({{"/scene/objects", "[]"}}),
       "placements[0]: gravity without objects in the scene: there is nothing to land on"},
      {Check::kKeyOutsideLimits,
       Warn({{"/joints/r_knee/keys/1/angle_deg", "-12"},
             {"/joints/r_knee/keys/2/angle_deg", "151"},
             {"/regions", "[]"}}),
       "joints.r_knee.keys[1].angle_deg: -12 is outside the limits 0 to 150 of \"r_knee\", and is "
       "kept; keys outside: 2"},
  };
}

}  // namespace

std::vector<WrongProject> WrongDocuments() {
  std::vector<WrongProject> all = WrongValues();
  for (const auto& list : {WrongNames(), Contradictions(), Misspellings(), Warnings()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace hazumi::testing
