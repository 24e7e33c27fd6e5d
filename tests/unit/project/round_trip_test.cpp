#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

// Objects whose field names are joints take no unknown fields.
bool IsMap(const Json& parent, const std::string& name) {
  return name == "joints" && (parent.contains("default") || parent.contains("solver"));
}

// Gives every object of the tree an unknown field; returns how many.
int AddUnknownFields(Json* json, bool is_map = false) {
  if (!json->is_structured()) return 0;
  int count = 0;
  for (auto& item : json->items()) {
    count += AddUnknownFields(&item.value(), json->is_object() && IsMap(*json, item.key()));
  }
  if (!json->is_object() || is_map) return count;
  (*json)["x_unknown"] = Json::parse(R"({"deep": [1, -2.5, "\"\n\u00e9", null], "at": )" +
                                     std::to_string(count) + "}");
  return count + 1;
}

const Link& LinkOf(const Figure& figure, const std::string& name) {
  return *std::find_if(figure.links().begin(), figure.links().end(),
                       [&](const Link& link) { return link.name == name; });
}

int CountUnknownFields(const Json& json) {
  if (!json.is_structured()) return 0;
  int count = json.is_object() && json.contains("x_unknown") ? 1 : 0;
  for (const auto& item : json.items()) {
    if (item.key() != "x_unknown") count += CountUnknownFields(item.value());
  }
  return count;
}

TEST(RoundTrip, GivesTheSameDocument) {
  const Project project = ParseGood(SampleProject());
  const Result<Project> again = ParseProject(WriteProject(project), "again.kfa");
  ASSERT_TRUE(again.ok()) << again.error().ToString();
  EXPECT_TRUE(again.value() == project);
}

TEST(RoundTrip, SaveLoadSaveIsByteEqual) {
  const std::string once = WriteProject(ParseGood(SampleProject()));
  EXPECT_EQ(WriteProject(ParseGood(Json::parse(once))), once);
}

TEST(RoundTrip, KeepsWhatTheFileSays) {
  const Json before = SampleProject();
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["regions"][0], before["regions"][0]);
  EXPECT_EQ(after["placements"], before["placements"]);
  EXPECT_EQ(after["figure"], before["figure"]);
  EXPECT_EQ(after["joints"], before["joints"]);
  EXPECT_EQ(after["markers"], before["markers"]);
  EXPECT_EQ(after["preview"], before["preview"]);
}

TEST(RoundTrip, TheSolverIsWrittenAsItWasStated) {
  for (const char* solver :
       {R"({"method": "exact", "version": 1})", R"({"method": "paper", "version": 1})",
        R"({"method": "exact", "tolerance_deg": 0.01, "version": 1})",
        R"({"method": "exact", "step_s": 0.02, "version": 1})",
        R"({"method": "paper", "step_s": 0.03333333333333333,
                                 "tolerance_deg": 1e-10, "version": 1})"}) {
    const Json document = Changed(SampleProject(), {{"/solver", solver}});
    const Json saved = Json::parse(WriteProject(ParseGood(document)));
    EXPECT_EQ(saved["solver"].dump(), document["solver"].dump());
  }
}

// What older programs would make another motion of they are not to read.
TEST(RoundTrip, WhatChangesHandsIsOfVersionTwo) {
  const Json before = Changed(
      SampleProject(),
      {{"/held_objects/0/holders",
        R"([{"joint": "l_wrist", "first_frame": 9, "last_frame": 12, "offset_m": [0, 0.1, 0]}])"},
       {"/held_objects/1/position",
        R"({"x": {"keys": [{"frame": 0, "position_m": 1}]},
            "y": {"keys": [{"frame": 0, "position_m": 2}]},
            "z": {"keys": [{"frame": 0, "position_m": 3, "interpolation": "hold"}]}})"}});
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["version"], 2);
  EXPECT_EQ(after["held_objects"][0]["holders"], before["held_objects"][0]["holders"]);
  EXPECT_EQ(after["held_objects"][1]["position"], before["held_objects"][1]["position"]);
  EXPECT_EQ(Json::parse(WriteProject(ParseGood(SampleProject())))["version"], 1);
}

TEST(RoundTrip, MuscleIsOfVersionTwo) {
  const Json before =
      Changed(SampleProject(), {{"/regions/0/drives",
                                 R"([{"joints": [{"beyond": "r_wrist"}], "kind": "torque",
             "keys": [{"frame": 5, "torque_n_m": 1.5, "rate_n_m_s": 2},
                      {"frame": 7.5, "torque_n_m": -1, "interpolation": "hold"}]},
            {"joints": ["r_elbow"], "kind": "spring", "to": "rest", "frequency_hz": 2.5,
             "frequency_keys": [{"frame": 5, "value": 2, "rate_per_s": 0.5},
                                {"frame": 7, "value": 0, "interpolation": "linear"}],
             "damping_ratio": 0.7, "max_torque_n_m": 30,
             "strength_keys": [{"frame": 6.5, "value": 0.25}], "feed_forward": true},
            {"joints": ["l_wrist"], "kind": "keys"}])"}});
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["version"], 2);
  EXPECT_EQ(after["regions"][0]["drives"], before["regions"][0]["drives"]);
}

TEST(RoundTrip, ATurnInAHandIsOfVersionTwo) {
  const Json before =
      Changed(SampleProject(), {{"/held_objects/1/rotation_deg", "[90, 20.5, -10]"}});
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["version"], 2);
  EXPECT_EQ(after["held_objects"][1]["rotation_deg"], before["held_objects"][1]["rotation_deg"]);
  const Json unturned = Changed(SampleProject(), {{"/held_objects/1/rotation_deg", "[0, 0, 0]"}});
  EXPECT_EQ(WriteProject(ParseGood(unturned)), WriteProject(ParseGood(SampleProject())));
}

// How rough it is says nothing by itself.
TEST(RoundTrip, ABallThatTouchesTheSceneIsOfVersionTwo) {
  const Changes how = {{"/held_objects/0/friction_coefficient", "0.5"},
                       {"/held_objects/0/restitution", "0.75"}};
  Changes touches = how;
  touches.emplace_back("/held_objects/0/contacts", "true");
  const Json before = Changed(SampleProject(), touches);
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["version"], 2);
  for (const char* field : {"contacts", "friction_coefficient", "restitution"}) {
    EXPECT_EQ(after["held_objects"][0][field], before["held_objects"][0][field]) << field;
    EXPECT_FALSE(after["held_objects"][1].contains(field)) << field;
  }
  EXPECT_EQ(Json::parse(WriteProject(ParseGood(Changed(SampleProject(), how))))["version"], 1);
  const Json plain = Changed(SampleProject(), {{"/held_objects/0/contacts", "false"},
                                               {"/held_objects/0/friction_coefficient", "0.8"},
                                               {"/held_objects/0/restitution", "0"}});
  EXPECT_EQ(WriteProject(ParseGood(plain)), WriteProject(ParseGood(SampleProject())));
}

TEST(RoundTrip, ForcesAreOfVersionTwo) {
  const Json before = Changed(SampleProject(), {{"/forces", R"([
      {"name": "breeze", "kind": "wind", "velocity_m_s": [2, 0, -0.5], "density_kg_m3": 1.1,
       "first_frame": 0, "last_frame": 30},
      {"name": "magnet", "kind": "attract", "joint": "r_wrist", "offset_m": [0, 0, 0.1],
       "to_m": [1, 0, 1.2], "force_n": 40, "radius_m": 0.5, "first_frame": 5, "last_frame": 9},
      {"name": "blow", "kind": "push", "joint": "pelvis", "impulse_n_s": [70, 0, 0], "frame": 12,
       "note": "kept"}])"}});
  const std::string text = WriteProject(ParseGood(before));
  const Json after = Json::parse(text);
  EXPECT_EQ(after["version"], 2);
  EXPECT_EQ(after["forces"], before["forces"]);
  EXPECT_EQ(WriteProject(ParseGood(after)), text);
  const Json calm = Changed(SampleProject(), {{"/forces", "[]"}});
  EXPECT_EQ(WriteProject(ParseGood(calm)), WriteProject(ParseGood(SampleProject())));
}

TEST(RoundTrip, ConstraintsAreOfVersionTwo) {
  const Json before = Changed(SampleProject(), {{"/constraints", R"([
      {"name": "grip", "kind": "point", "a": {"joint": "r_wrist", "offset_m": [0, 0, -0.09]},
       "b": {"object": "platform", "note": "kept"}, "first_frame": 5, "last_frame": 9,
       "arrive_frames": 5, "break_force_n": 900, "break_impulse_n_s": 20},
      {"name": "glue", "kind": "weld", "a": {"object": "brick", "rotation_deg": [90, 0, 0]},
       "b": {"joint": "waist", "rotation_deg": [0, 20.5, -10]}, "first_frame": 0,
       "last_frame": 30},
      {"name": "rope", "kind": "distance", "a": {"joint": "l_wrist"},
       "b": {"offset_m": [0, 0, 2]}, "length_m": 0.3, "first_frame": 5, "last_frame": 15,
       "note": "kept"},
      {"name": "origin", "kind": "point", "a": {"joint": "pelvis"}, "first_frame": 5,
       "last_frame": 15}])"}});
  const std::string text = WriteProject(ParseGood(before));
  const Json after = Json::parse(text);
  EXPECT_EQ(after["version"], 2);
  EXPECT_EQ(after["constraints"], before["constraints"]);
  EXPECT_EQ(WriteProject(ParseGood(after)), text);
  const Json free = Changed(SampleProject(), {{"/constraints", "[]"}});
  EXPECT_EQ(WriteProject(ParseGood(free)), WriteProject(ParseGood(SampleProject())));
}

TEST(RoundTrip, ContactsAreOfVersionTwo) {
  for (const char* contacts : {R"({"scene": true})", R"({"self": true})"}) {
    const Json before = Changed(
        SampleProject(), {{"/regions/0/method", "\"exact\""}, {"/regions/0/contacts", contacts}});
    const std::string text = WriteProject(ParseGood(before));
    const Json after = Json::parse(text);
    EXPECT_EQ(after["version"], 2);
    EXPECT_EQ(after["regions"][0], before["regions"][0]);
    EXPECT_EQ(WriteProject(ParseGood(after)), text);
  }
  for (const char* none : {"{}", R"({"scene": false, "self": false})"}) {
    const Json without = Changed(SampleProject(), {{"/regions/0/contacts", none}});
    EXPECT_EQ(WriteProject(ParseGood(without)), WriteProject(ParseGood(SampleProject())));
  }
}

TEST(RoundTrip, WhatContactsSayThatIsUnknownIsKept) {
  const Json before = Changed(SampleProject(), {{"/regions/0/contacts", R"({"hands": [1]})"}});
  const Json after = Json::parse(WriteProject(ParseGood(before)));
  EXPECT_EQ(after["regions"][0], before["regions"][0]);
  EXPECT_EQ(after["version"], 1);
}

// A coefficient alone moves nothing, so that older builds may read it.
TEST(RoundTrip, AFrictionCoefficientIsWrittenUnlessItIsThatOfFigures) {
  const Json before = Changed(SampleProject(), {{"/scene/objects/0/friction_coefficient", "0.25"}});
  const Project project = ParseGood(before);
  EXPECT_EQ(project.scene.objects[0].friction_coefficient, 0.25);
  EXPECT_EQ(project.scene.objects[1].friction_coefficient, 0.8);
  const Json after = Json::parse(WriteProject(project));
  EXPECT_EQ(after["scene"], before["scene"]);
  EXPECT_EQ(after["version"], 1);
  const Json same = Changed(SampleProject(), {{"/scene/objects/0/friction_coefficient", "0.8"}});
  EXPECT_EQ(WriteProject(ParseGood(same)), WriteProject(ParseGood(SampleProject())));
}

TEST(RoundTrip, AirHasTheDensityThatItHasAtSeaLevel) {
  const Json before = Changed(SampleProject(), {{"/forces", R"([
      {"name": "calm", "kind": "wind", "velocity_m_s": [0, 0, 0], "first_frame": 0,
       "last_frame": 30}])"}});
  const Project project = ParseGood(before);
  EXPECT_EQ(std::get<WindForce>(project.forces[0].action).density, 1.225);
  EXPECT_EQ(Json::parse(WriteProject(project))["forces"], before["forces"]);
}

// And its twin has it too, reflected.
TEST(RoundTrip, ASurfaceIsReadAndWritten) {
  for (const char* coefficients : {R"("plate")", R"("wing")", R"({"lift": [0, 1], "drag": [2]})"}) {
    const std::string surface = std::string(R"({"area_m2": 0.02, "normal": [0, 0.6, 0.8],
                                                "center_m": [0, 0.1, -0.1], "coefficients": )") +
                                coefficients + "}";
    const Json document = Changed(SampleProject(), {{"/figure/joints/3/links/0/surface", surface}});
    const FigureSpec spec = ParseGood(document).figure.spec;
    const Json written = Json::parse(FigureText(spec));
    EXPECT_EQ(written["joints"][3]["links"][0]["surface"], Json::parse(surface));
    EXPECT_TRUE(ParseFigure(written.dump(), "again.json").ok());
    const Figure figure = BuildFigure(spec).value();
    const Link &right = LinkOf(figure, "r_hand"), &left = LinkOf(figure, "l_hand");
    EXPECT_LT((right.surface->normal - Vec3(0.0, 0.6, 0.8)).norm(), 1e-15);
    EXPECT_LT((left.surface->normal - Vec3(0.0, -0.6, 0.8)).norm(), 1e-15);
    EXPECT_EQ(left.surface->center, Vec3(0.0, -0.1, -0.1));
  }
}

TEST(RoundTrip, ANewDocumentIsExact) {
  const Json saved = Json::parse(WriteProject(Project()));
  EXPECT_EQ(saved["solver"].dump(), R"({"method":"exact","version":2})");
}

TEST(RoundTrip, UnknownFieldsSurviveAtEveryLevel) {
  Json document = SampleProject();
  const int added = AddUnknownFields(&document);
  ASSERT_GT(added, 60);
  const std::string text = WriteProject(ParseGood(document));
  const Json saved = Json::parse(text);
  EXPECT_EQ(CountUnknownFields(saved), added);
  EXPECT_EQ(saved["regions"][0]["friction"]["x_unknown"],
            document["regions"][0]["friction"]["x_unknown"]);
  EXPECT_EQ(WriteProject(ParseGood(saved)), text);
}

TEST(RoundTrip, AMisspelledFieldSurvivesAndItsWarningIsNotWritten) {
  const Json document = Changed(SampleProject(), {{"/regions/0/step", "0.02"}});
  const Project project = ParseGood(document);
  ASSERT_EQ(project.read.warnings.size(), 1u);
  EXPECT_EQ(Json::parse(WriteProject(project))["regions"][0], document["regions"][0]);
  Project unwarned = project;
  unwarned.read.warnings.clear();
  EXPECT_TRUE(unwarned == project);
  EXPECT_EQ(WriteProject(unwarned), WriteProject(project));
}

TEST(RoundTrip, AHostileFileGetsAHundredWarnings) {
  Json document = SampleProject();
  Json& keys = document["joints"]["r_knee"]["keys"] = Json::array();
  for (int i = 0; i < 500; ++i) keys.push_back({{"frame", i}, {"angle_deg", 1}, {"rate", 1}});
  EXPECT_EQ(ParseGood(document).read.warnings.size(), 100u);
}

TEST(RoundTrip, ReadsBackEveryNumberExactly) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-40, 9);
  Project project = ParseGood(SampleProject());
  auto& keys = project.joints[0].value.keys;
  keys.clear();
  for (int i = 0; i < 2000; ++i) {
    keys.push_back({i + 0.1, mantissa(random) * std::pow(10.0, exponent(random)), {}, {}, {}});
  }
  const Result<Project> again = ParseProject(WriteProject(project), "again.kfa");
  ASSERT_TRUE(again.ok()) << again.error().ToString();
  EXPECT_TRUE(again.value() == project);
}

TEST(RoundTrip, WritesNumbersAndLinesForPeople) {
  Project project = ParseGood(SampleProject());
  project.joints[0].value.keys[0].value = -0.0;
  project.joints[0].value.keys[1].value = 2.0;
  const std::string text = WriteProject(project);
  EXPECT_NE(text.find("  \"fps\": {\"num\": 30, \"den\": 1},\n"), std::string::npos) << text;
  EXPECT_NE(text.find("{\"frame\": 0, \"angle_deg\": 0, \"rate_deg_s\": 30, "
                      "\"interpolation\": \"linear\"},\n        {\"frame\": 2.5, "
                      "\"angle_deg\": 2},\n"),
            std::string::npos)
      << text;
  for (size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos;) {
    EXPECT_LE(end - begin, 100u) << text.substr(begin, end - begin);
    begin = end + 1;
  }
}

TEST(RoundTrip, WritesValidJsonWhateverTheDocumentHolds) {
  Project project = ParseGood(SampleProject());
  project.name = "bad \xff bytes \x01 \"quoted\\";
  project.root.curves[kRootX].keys = {{0.0, std::nan(""), {}, {}, {}}};
  project.extra = {{"x", "not json"}};
  const Json saved = Json::parse(WriteProject(project), nullptr, false);
  ASSERT_FALSE(saved.is_discarded());
  EXPECT_EQ(saved["name"], "bad \xEF\xBF\xBD bytes \x01 \"quoted\\");
  EXPECT_TRUE(saved["root"]["x"]["keys"][0]["position_m"].is_null());
  EXPECT_EQ(saved["x"], "not json");
}

// What an older build would move otherwise it shall refuse.
TEST(RoundTrip, KeysThatOlderBuildsDoNotKnowMakeAFileOfVersion2) {
  for (const char* field : {R"("rate_in_deg_s": 5)", R"("length_in": 0.5)", R"("length_out": 0.25)",
                            R"("interpolation": "elastic", "easing": "out")"}) {
    const std::string key = std::string(R"({"frame": 0, "angle_deg": 45, )") + field + "}";
    const Json document =
        Changed(SampleProject(), {{"/joints/r_shoulder_flexion/keys", "[" + key + "]"}});
    const Json after = Json::parse(WriteProject(ParseGood(document)));
    EXPECT_EQ(after["version"], 2) << field;
    EXPECT_EQ(after["joints"]["r_shoulder_flexion"]["keys"][0], Json::parse(key)) << field;
  }
}

TEST(RoundTrip, AReferenceStaysAReference) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "figures");
  std::filesystem::create_directory(folder / "projects");
  const Json embedded = SampleProject();
  WriteFile(folder / "figures/doll.json", embedded["figure"].dump());
  const Json document =
      Changed(embedded, {{"/figure", R"({"file": "../figures/doll.json", "x": 1})"}});
  WriteFile(folder / "projects/a.kfa", document.dump());
  Result<Project> project = LoadProject(folder / "projects/a.kfa");
  ASSERT_TRUE(project.ok()) << project.error().ToString();
  EXPECT_EQ(project.value().figure.spec.joints.size(), 7u);
  EXPECT_EQ(Json::parse(WriteProject(project.value()))["figure"], document["figure"]);
  RebaseReferences(&project.value(), folder / "projects", folder.path());
  EXPECT_EQ(project.value().figure.file, "figures/doll.json");
  EXPECT_EQ(project.value().audio->file, "projects/voice.wav");
  EXPECT_EQ(project.value().reference->file, "projects/take.mp4");
}

}  // namespace
}  // namespace hazumi::testing
