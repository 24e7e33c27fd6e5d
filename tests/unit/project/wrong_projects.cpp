#include "tests/unit/project/wrong_projects.h"

#include "engine/project/json/json.h"
#include "engine/project/pose_file.h"
#include "engine/project/project_writer.h"
#include "engine/sweep/sweep_plan.h"
#include "tests/unit/project/wrong_makers.h"

namespace hazumi::testing {

namespace {

std::string LoadFolder() {
  const TemporaryFolder folder;
  return Complaint(LoadProject(folder.path()));
}

std::string LoadHugeFile() {
  const TemporaryFolder folder;
  WriteFile(folder / "huge.kfa", "{");
  std::filesystem::resize_file(folder / "huge.kfa", (160u << 20) + 1);
  return Complaint(LoadProject(folder / "huge.kfa"));
}

std::string LoadWithWrongFigureFile() {
  const TemporaryFolder folder;
  WriteFile(folder / "doll.json", R"({"format": "hazumi-project"})");
  WriteFile(folder / "a.kfa",
            Changed(SampleProject(), {{"/figure", R"({"file": "doll.json"})"}}).dump());
  return Complaint(LoadProject(folder / "a.kfa"));
}

Say SaveTo(std::string name) {
  return [name] {
    const TemporaryFolder folder;
    return Complaint(SaveProject(ParseGood(SampleProject()), folder / name));
  };
}

std::string SaveHuge() {
  const TemporaryFolder folder;
  Project project = ParseGood(SampleProject());
  project.name.assign(161u << 20, 'a');
  const std::string said = Complaint(SaveProject(project, folder / "huge.kfa"));
  return std::filesystem::exists(folder / "huge.kfa") ? "it is saved" : said;
}

std::string Repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string ParseInto3MB() {
  FirstError errors;
  const bool is_read = ParseJson("[" + Repeated("0,", 100000) + "0]", &errors, 3000000).has_value();
  return is_read ? "it is read" : errors.error()->ToString();
}

std::vector<WrongProject> WrongFiles() {
  return {
      {Check::kCannotRead, [] { return Complaint(LoadProject("/nowhere/a.kfa")); },
       "cannot be read: No such file or directory"},
      {Check::kNotAFile, LoadFolder, "is not a file"},
      {Check::kNotAFile, [] { return Complaint(LoadProject("/dev/zero")); }, "is not a file"},
      {Check::kFileTooBig, LoadHugeFile, "is larger than 160 MiB, the most that Hazumi reads"},
      {Check::kNotUtf8, Text("{\n \"name\": \"弾\xFF\"}"),
       "line 2, column 12: not UTF-8 text; save the file as UTF-8"},
      {Check::kNotJson, Text(""),
       "line 1, column 1: not JSON: unexpected end of input; expected '[', '{', or a literal"},
      {Check::kNotJson, Text("{\"a\": 1,\n \"b\": tru}"),
       "line 2, column 10: not JSON: invalid literal; last read: '\"b\": tru}'"},
      {Check::kNotJson, Text("{\"a\": NaN}"),
       "line 1, column 7: not JSON: invalid literal; last read: '\"a\": N'"},
      {Check::kNotJson, Text("{} {}"),
       "line 1, column 4: not JSON: unexpected '{'; expected end of input"},
      {Check::kNumberOverflow, Text("{\n\"a\": 1e999}"),
       "line 2, column 10: the number 1e999 is out of range"},
      {Check::kTooDeep, Text(Repeated("[", 1000000)),
       "[0][0][0][0][0][0][0][0]: more than 64 objects and arrays inside each other"},
      {Check::kTooDeep, Text(Repeated("{\"a\":", 1000)),
       "a.a.a.a.a.a.a.a: more than 64 objects and arrays inside each other"},
      {Check::kTooManyValues, ParseInto3MB,
       "[93750]: its values would need more than 3 MB of memory"},
      {Check::kFieldTwice, Text(R"({"joints": {"r_knee": 1, "r_knee": 2}})"),
       "joints.r_knee: the field \"r_knee\" is given twice; keep one of them"},
      {Check::kFigureUnreadable, Read("/figure", R"({"file": "missing.json"})"),
       "figure.file: the figure \"missing.json\" cannot be read: No such file or directory; looked "
       "for as " +
           (std::filesystem::current_path() / "missing.json").string() +
           "; paths are relative to the project file"},
      {Check::kNotAFigure, LoadWithWrongFigureFile,
       "not a Hazumi figure: expected an object with \"format\": \"hazumi-figure\""},
      {Check::kCannotWrite, SaveTo("missing/a.kfa"),
       "cannot be written: No such file or directory"},
      {Check::kTooLargeToSave, SaveHuge,
       "would be 161 MiB, which Hazumi does not read back (at most 160 MiB, and 600 MB in memory): "
       "use fewer keys (of a clip: --import with --reduce 1) or no skin (--no-skin)"},
      {Check::kCannotReplace, SaveTo("."), "cannot be replaced: it is not a file"},
  };
}

std::vector<WrongProject> WrongFields() {
  return {
      {Check::kNotAProject, Text("[1, 2]"),
       "not a Hazumi project: expected an object with \"format\": \"hazumi-project\""},
      {Check::kNotAProject, Read("/format", ""),
       "not a Hazumi project: expected an object with \"format\": \"hazumi-project\""},
      {Check::kNotAProject, Read("/format", "\"hazumi-figure\""),
       "not a Hazumi project: expected an object with \"format\": \"hazumi-project\""},
      {Check::kNewerFormat, Read("/version", "3"),
       "version: made by a newer Hazumi: this is format version 3, this Hazumi reads 2; please "
       "update it"},
      {Check::kUnknownFormat, Read("/version", "0"),
       "version: there is no format version 0; write 1"},
      {Check::kMissingField, Read("/version", ""), "the field \"version\" is missing; add it"},
      {Check::kMissingField, Read("/solver", ""), "the field \"solver\" is missing; add it"},
      {Check::kMissingField, Read("/solver/method", ""),
       "solver: the field \"method\" is missing; add it"},
      {Check::kMissingField, Read("/solver/version", ""),
       "solver: the field \"version\" is missing; add it"},
      {Check::kMissingField, Read("/figure", "{}"),
       "figure: the field \"file\" is missing; add it"},
      {Check::kMissingField, Read("/joints/r_knee/keys/2/angle_deg", ""),
       "joints.r_knee.keys[2]: the field \"angle_deg\" is missing; add it"},
      {Check::kMisspelledField, Read({{"/holds/0/joint", ""}, {"/holds/0/jiont", "\"x\""}}),
       "holds[0]: the field \"joint\" is missing; did you mean it by \"jiont\"?"},
      {Check::kWrongType, Read("/frames", "[0, 30]"), "frames: expected an object, found an array"},
      {Check::kWrongType, Read("/regions", "{}"), "regions: expected an array, found an object"},
      {Check::kWrongType, Read("/regions/0/friction/joints", "[0.4]"),
       "regions[0].friction.joints: expected an object, found an array"},
      {Check::kWrongType, Read("/joints", "null"), "joints: expected an object, found null"},
      {Check::kWrongType, Read("/name", "7"), "name: expected a string, found a number"},
      {Check::kWrongType, Read("/holds/0/orientation", "\"yes\""),
       "holds[0].orientation: expected true or false, found a string"},
      {Check::kWrongType, Read("/joints/r_knee/keys/0/rate_deg_s", "true"),
       "joints.r_knee.keys[0].rate_deg_s: expected a number, found true or false"},
      {Check::kNumberTooLarge, Read("/joints/r_knee/keys/1/angle_deg", "1e300"),
       "joints.r_knee.keys[1].angle_deg: 1e+300 is too large: numbers lie between -1e9 and 1e9"},
      {Check::kNotWhole, Read("/regions/0/first_frame", "5.5"),
       "regions[0].first_frame: expected a whole number, found 5.5"},
      {Check::kWrongCount, Read("/camera/eye_m", "[0, 1]"),
       "camera.eye_m: expected 3 values, found 2"},
      {Check::kUnknownChoice, Read("/joints/r_knee/keys/0/interpolation", "\"cubik\""),
       "joints.r_knee.keys[0].interpolation: there is no interpolation \"cubik\"; did you mean "
       "\"cubic\"?"},
      {Check::kUnknownChoice, Read("/solver/method", "\"magic\""),
       "solver.method: there is no method \"magic\"; use one of \"exact\", \"paper\""},
      {Check::kUnknownChoice, Read("/regions/0/method", "\"exakt\""),
       "regions[0].method: there is no method \"exakt\"; did you mean \"exact\"?"},
      {Check::kUnknownChoice, Read("/placements/1/kind", "\"pined\""),
       "placements[1].kind: there is no placement kind \"pined\"; did you mean \"pinned\"?"},
      {Check::kNotOneOf, Read("/scene/objects/0/plane", ""),
       "scene.objects[0]: needs exactly one of \"plane\" and \"box\""},
      {Check::kNotOneOf, Read("/held_objects/0/box", R"({"size_m": [1, 1, 1]})"),
       "held_objects[0]: needs exactly one of \"sphere\" and \"box\""},
      {Check::kBadColor, Read("/scene/objects/0/color", "\"red\""),
       "scene.objects[0].color: \"red\" is no colour; write it as \"#rrggbb\", for example "
       "\"#d9482b\""},
      {Check::kBadColor, Read("/held_objects/0/color", "\"#12345g\""),
       "held_objects[0].color: \"#12345g\" is no colour; write it as \"#rrggbb\", for example "
       "\"#d9482b\""},
      {Check::kNotPositive, Read("/scene/objects/1/box/size_m", "[1, 0, 1]"),
       "scene.objects[1].box.size_m[1]: must be greater than 0, is 0"},
      {Check::kNotPositive, Read("/held_objects/0/sphere/radius_m", "-1"),
       "held_objects[0].sphere.radius_m: must be greater than 0, is -1"},
      {Check::kNotPositive, Read("/held_objects/1/box/size_m", "[1, 1, -1]"),
       "held_objects[1].box.size_m[2]: must be greater than 0, is -1"},
      {Check::kNotPositive, Read("/held_objects/0/mass_kg", "0"),
       "held_objects[0].mass_kg: must be greater than 0, is 0"},
      {Check::kNotPositive, Read("/solver/version", "0"),
       "solver.version: must be greater than 0, is 0"},
      {Check::kNegative, Read("/scene/gravity_m_s2", "-9.81"),
       "scene.gravity_m_s2: must not be negative, is -9.81"},
      {Check::kZeroVector, Read("/scene/objects/0/plane/normal", "[0, 0, 0]"),
       "scene.objects[0].plane.normal: must not be zero: it gives a direction"},
      {Check::kNotUnit, Read("/scene/objects/0/plane/normal", "[0, 1, 1]"),
       "scene.objects[0].plane.normal: must have length 1, has 1.4142; write [0, 0.7071, 0.7071]"},
      {Check::kEmptyName, Read("/regions/0/name", "\"\""), "regions[0].name: must not be empty"},
      {Check::kEmptyName, Read("/markers/1/name", "\"\""), "markers[1].name: must not be empty"},
      {Check::kEmptyName, Read("/figure", R"({"file": ""})"), "figure.file: must not be empty"},
  };
}

std::string ReadPosesOfAProject() {
  return Complaint(ParsePoses(SampleProject().dump(), "wrong.json"));
}

std::string ReadSweepOfAProject() {
  return Complaint(ParseSweep(SampleProject().dump(), "wrong.json"));
}

std::vector<WrongProject> WrongFigures() {
  const std::string axis = "/joints/0/hinges/0/axis", link = "/joints/0/links/0";
  return {
      {Check::kNotAFigure, Read("/figure/format", "\"hazumi-project\""),
       "figure: not a Hazumi figure: expected an object with \"format\": \"hazumi-figure\""},
      {Check::kNotPoses, ReadPosesOfAProject,
       "not a file of Hazumi poses: expected an object with \"format\": \"hazumi-poses\""},
      {Check::kNotASweep, ReadSweepOfAProject,
       "not a Hazumi sweep: expected an object with \"format\": \"hazumi-sweep\""},
      {Check::kNewerFormat, Read("/figure/version", "7"),
       "figure.version: made by a newer Hazumi: this is format version 7, this Hazumi reads 1; "
       "please update it"},
      {Check::kMissingField, Figure("/root", ""), "the field \"root\" is missing; add it"},
      {Check::kMissingField, Figure("/joints/1/hinges/0/limits_deg", ""),
       "joints[1].hinges[0]: the field \"limits_deg\" is missing; add it"},
      {Check::kUnknownChoice, Figure(axis, "\"w\""),
       "joints[0].hinges[0].axis: there is no axis \"w\"; use one of \"x\", \"y\", \"z\", \"-x\", "
       "\"-y\", \"-z\""},
      {Check::kZeroVector, Figure(axis, "[0, 0, 0]"),
       "joints[0].hinges[0].axis: must not be zero: it gives a direction"},
      {Check::kNotUnit, Figure(axis, "[0, 2, 0]"),
       "joints[0].hinges[0].axis: must have length 1, has 2; write [0, 1, 0]"},
      {Check::kNotPositive, Figure(link + "/radius_m", "0"),
       "joints[0].links[0].radius_m: must be greater than 0, is 0"},
      {Check::kNegative, Figure(link + "/density_kg_m3", "-1"),
       "joints[0].links[0].density_kg_m3: must not be negative, is -1"},
      {Check::kNotOneOf, Figure(link + "/mass_kg", "1"),
       "joints[0].links[0]: needs exactly one of \"mass_kg\" and \"density_kg_m3\""},
      {Check::kWrongCount, Figure("/root/links/0/inertia_kg_m2", "[1, 1, 1]"),
       "root.links[0].inertia_kg_m2: expected 6 values, found 3"},
      {Check::kUnknownChoice, Figure(link + "/look/0/shape", "\"cube\""),
       "joints[0].links[0].look[0].shape: there is no shape \"cube\"; use one of "
       "\"tapered_capsule\", \"ellipsoid\""},
      {Check::kNotPositive, Figure(link + "/look/0/half_axes_m", "[1, 0, 1]"),
       "joints[0].links[0].look[0].half_axes_m[1]: must be greater than 0, is 0"},
      {Check::kNotPositive, Figure("/joints/1/links/0/look/0/radii_m", "[1, 0]"),
       "joints[1].links[0].look[0].radii_m[1]: must be greater than 0, is 0"},
      {Check::kBadColor, Figure(link + "/look/0/color", "\"blue\""),
       "joints[0].links[0].look[0].color: \"blue\" is no colour; write it as \"#rrggbb\", for "
       "example \"#d9482b\""},
      {Check::kBadColor, Figure("/joints/1/links/0/look/0/mirror_color", "\"blue\""),
       "joints[1].links[0].look[0].mirror_color: \"blue\" is no colour; write it as \"#rrggbb\", "
       "for example \"#d9482b\""},
      {Check::kEmptyName, Figure("/joints/0/name", "\"\""), "joints[0].name: must not be empty"},
      {Check::kEmptyName, Figure("/mirror/from", "\"\""), "mirror.from: must not be empty"},
      {Check::kUnknownParent, Figure("/joints/1/parent", "\"wiast\""),
       "joints[1].parent: no joint \"wiast\" to hang on; did you mean \"waist\"?"},
      {Check::kTooManyJoints,
       Figure("/joints", "[" +
                             Repeated(R"({"name": "a", "parent": "pelvis", "offset_m": [0, 0, 0],
                                           "hinges": []},)",
                                      10000) +
                             R"({"name": "a", "parent": "pelvis", "offset_m": [0, 0, 0],
                                 "hinges": []}])"),
       "joints: 10001 joints; a figure has 10000 at most"},
      // The figure builder's own.
      {Check::kNumChecks, Read("/figure/joints/0/parent", "\"r_wrist\""),
       "figure.joints[0].parent: \"waist\" is its own ancestor: the parents form a loop"},
      {Check::kNumChecks, Read("/figure/joints/2/name", "\"waist\""),
       "figure.joints[3].parent: no joint \"r_elbow\" to hang on; use one of \"pelvis\", "
       "\"waist\", \"r_shoulder\", \"waist\", \"r_wrist\", \"r_hip\", \"r_knee\", \"r_ankle\", "
       "\"l_shoulder\", \"l_wrist\", \"l_hip\", \"l_knee\" (and 1 more)"},
      {Check::kNumChecks, Figure("/joints/0/hinges", "[]"),
       "joints[0].hinges: a joint has one to three hinges"},
      {Check::kNumChecks, Figure("/joints/0/hinges/0/limits_deg", "[10, -10]"),
       "joints[0].hinges[0].limits_deg: the lower limit is above the upper one"},
      {Check::kNumChecks, Figure("/root/links/0/inertia_kg_m2", "[1, 1, 5, 0, 0, 0]"),
       "root.links[0].inertia_kg_m2: no body has these moments: each must be positive and at most "
       "the sum of the other two"},
  };
}

}  // namespace

bool Instantiates(std::string_view message, Check check) {
  std::string_view sentence = TextOf(check).text;
  for (size_t hole; (hole = sentence.find("{}")) != std::string_view::npos;) {
    const size_t at = message.find(sentence.substr(0, hole));
    if (at == std::string_view::npos) return false;
    message.remove_prefix(at + hole);
    sentence.remove_prefix(hole + 2);
  }
  return message.ends_with(sentence);
}

std::vector<WrongProject> WrongProjects() {
  std::vector<WrongProject> all = WrongDocuments();
  for (const auto& list : {WrongFiles(), WrongFields(), WrongFigures(), WrongSkins(), WrongDrives(),
                           WrongForces(), WrongConstraints(), WrongContacts()}) {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

}  // namespace hazumi::testing
