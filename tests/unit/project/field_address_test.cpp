// Fields by their addresses: what is listed can be read and set, and what is wrong is said.

#include "engine/project/address/field_address.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/project/address/all_addresses.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

FieldAddress At(const std::string& text) { return ParseAddress(text).value(); }

std::string Get(const std::string& address, const Project& project) {
  const Result<std::string> value = GetField(At(address), project);
  return value.ok() ? value.value() : value.error().ToString();
}

// What is wrong with it, or nothing.
std::string Set(const std::string& address, const std::string& json, Project* project) {
  const Result<Done> set = SetField(At(address), json, project);
  return set.ok() ? "" : set.error().ToString();
}

// Of the sample as it is.
std::string Refusal(const std::string& address, const std::string& json) {
  Project project = ParseGood(SampleProject());
  return Set(address, json, &project);
}

std::string ParseRefusal(const std::string& text) {
  const Result<FieldAddress> address = ParseAddress(text);
  return address.ok() ? "" : address.error().ToString();
}

TEST(FieldAddress, IsNamesBehindDotsAndItemsInBrackets) {
  const FieldAddress address = At("regions[left arm. 2].friction.joints[r_wrist]");
  const std::vector<AddressStep> steps = {{"regions", false},
                                          {"left arm. 2", true},
                                          {"friction", false},
                                          {"joints", false},
                                          {"r_wrist", true}};
  EXPECT_EQ(address.steps, steps);
}

TEST(FieldAddress, ComesBackAsTextAsItWasWritten) {
  for (const char* text : {"name", "scene.gravity_m_s2", "joints[r_knee].keys[2.5].angle_deg",
                           "held_objects[a.b c].offset_m[z]", "a[b][c].d"}) {
    EXPECT_EQ(TextOf(At(text)), text);
  }
}

TEST(FieldAddress, ThatIsNoneIsRefusedWithTheReason) {
  const std::map<std::string, std::string> refusals = {
      {"", "is no address of a field: it begins with one, such as scene.gravity_m_s2"},
      {"[arm]", "[arm]: is no address of a field: it begins with one, such as scene.gravity_m_s2"},
      {"regions[arm", "regions[arm: is no address of a field: a ] is missing"},
      {"regions[arm]name", "regions[arm]name: is no address of a field: behind ] comes a dot or ["},
      {"regions[arm]].name",
       "regions[arm]].name: is no address of a field: behind ] comes a dot or ["},
      {"scene..name", "scene..name: is no address of a field: a name is missing"},
      {"scene.", "scene.: is no address of a field: a name is missing"},
      {".scene", ".scene: is no address of a field: a name is missing"},
      {"regions[].name", "regions[].name: is no address of a field: a name is missing"}};
  for (const auto& [text, refusal] : refusals) EXPECT_EQ(ParseRefusal(text), refusal);
}

TEST(ListFields, GivesEachFieldOnceWithTheTextThatGetFieldHas) {
  const Project project = ParseGood(SampleProject());
  const std::vector<ListedField> fields = ListFields(project);
  EXPECT_GT(fields.size(), 150u);
  std::set<std::string> seen;
  for (const ListedField& field : fields) {
    EXPECT_TRUE(seen.insert(field.address).second) << field.address;
    EXPECT_EQ(Get(field.address, project), field.json) << field.address;
  }
}

TEST(ListFields, NamesWhatTheFileSays) {
  const Project project = ParseGood(SampleProject());
  std::map<std::string, std::string> values;
  for (const ListedField& field : ListFields(project)) values[field.address] = field.json;
  EXPECT_EQ(values["name"], "\"Sample\"");
  EXPECT_EQ(values["solver.method"], "\"paper\"");
  EXPECT_EQ(values["scene.objects[platform].box.size_m"], "[1, 1, 0.2]");
  EXPECT_EQ(values["root.z.keys[0].rate_m_s"], "0.1");
  EXPECT_EQ(values["joints[r_knee].keys[2.5].angle_deg"], "20.25");
  EXPECT_EQ(values["joints[r_knee].keys[2.5].rate_deg_s"], "null");
  EXPECT_EQ(values["regions[arm].joints"], R"(["r_wrist", "r_elbow", {"beyond": "l_shoulder"}])");
  EXPECT_EQ(values["regions[arm].friction.joints[r_wrist]"], "0.4");
  EXPECT_EQ(values["placements[1].joint"], "\"l_ankle\"");
  EXPECT_EQ(values["held_objects[ball].release_frame"], "9");
  EXPECT_EQ(values["camera.eye_m"], "[0, -3, 1]");
}

// What cannot stand in brackets, or stands for two, is named by its number.
TEST(ListFields, GivesAddressesThatAreReadWhateverItemsAreNamed) {
  Project project = ParseGood(SampleProject());
  project.regions[0].name = "an ] arm";
  project.regions[1].name = "";
  project.markers[1].name = project.markers[0].name;
  std::set<std::string> seen;
  for (const ListedField& field : ListFields(project)) {
    EXPECT_TRUE(seen.insert(field.address).second) << field.address;
    ASSERT_EQ(ParseRefusal(field.address), "");
    EXPECT_EQ(Get(field.address, project), field.json) << field.address;
  }
  EXPECT_TRUE(seen.contains("regions[0].friction.default"));
  EXPECT_TRUE(seen.contains("regions[1].friction.default"));
  EXPECT_TRUE(seen.contains("markers[throw].frame"));
  EXPECT_TRUE(seen.contains("markers[1].frame"));
}

TEST(SetField, ToWhatItIsChangesNothing) {
  const Project project = ParseGood(SampleProject());
  for (const ListedField& field : ListFields(project)) {
    Project set = project;
    EXPECT_EQ(Set(field.address, field.json, &set), "") << field.address;
    EXPECT_TRUE(set == project) << field.address << " = " << field.json;
  }
}

TEST(SetField, SetsWhatGetFieldReads) {
  Project project = ParseGood(SampleProject());
  const std::map<std::string, std::string> values = {
      {"scene.gravity_m_s2", "1.62"},
      {"frames.last", "40"},
      {"regions[arm].method", "\"exact\""},
      {"regions[leg].friction.default", "0.25"},
      {"joints[r_knee].keys[30].angle_deg", "-12.5"},
      {"joints[r_knee].keys[30].interpolation", "\"hold\""},
      {"regions[leg].joints", R"(["r_hip", {"beyond": "r_knee"}])"},
      {"held_objects[brick].box.size_m", "[0.1, 0.2, 0.3]"},
      {"placements[0].last_frame", "28"},
      {"audio.mute", "false"}};
  for (const auto& [address, value] : values) EXPECT_EQ(Set(address, value, &project), "");
  for (const auto& [address, value] : values) EXPECT_EQ(Get(address, project), value);
  EXPECT_EQ(project.scene.gravity_m_s2, 1.62);
  EXPECT_EQ(project.regions[1].friction.default_factor, 0.25);
}

TEST(SetField, GivesAJointFrictionThatHadNone) {
  Project project = ParseGood(SampleProject());
  const std::string address = "regions[leg].friction.joints[r_knee]";
  EXPECT_EQ(Get(address, project), "null");
  ASSERT_EQ(Set(address, "0.5", &project), "");
  ASSERT_EQ(project.regions[1].friction.joints.size(), 1u);
  EXPECT_EQ(project.regions[1].friction.joints[0].name, "r_knee");
  EXPECT_EQ(project.regions[1].friction.joints[0].value, 0.5);
  EXPECT_EQ(Get(address, project), "0.5");
}

TEST(SetField, TakesVectorsByAxisByLetterAndNumber) {
  Project project = ParseGood(SampleProject());
  EXPECT_EQ(Get("held_objects[ball].offset_m[z]", project), "-0.09");
  EXPECT_EQ(Set("held_objects[ball].offset_m[z]", "-0.1", &project), "");
  EXPECT_EQ(Set("held_objects[ball].offset_m[0]", "0.25", &project), "");
  EXPECT_EQ(Get("held_objects[ball].offset_m", project), "[0.25, 0, -0.1]");
  EXPECT_EQ(Refusal("held_objects[ball].offset_m[w]", "1"),
            "held_objects[ball].offset_m[w]: there is no axis \"w\"; use one of \"x\", \"y\", "
            "\"z\"");
  EXPECT_EQ(Refusal("held_objects[ball].offset_m[z].x", "1"),
            "held_objects[ball].offset_m[z].x: an axis is one number: nothing comes behind it");
}

TEST(SetField, BringsWhatWasLeftOutAndNullTakesItAway) {
  Project project = ParseGood(SampleProject());
  const Project before = project;
  EXPECT_EQ(Get("regions[leg].step_s", project), "null");
  EXPECT_EQ(Set("regions[leg].step_s", "0.02", &project), "");
  EXPECT_EQ(project.regions[1].step_s, 0.02);
  EXPECT_EQ(Set("regions[leg].step_s", "null", &project), "");
  EXPECT_TRUE(project == before);
  EXPECT_EQ(Set("joints[r_knee].keys[0].rate_deg_s", "null", &project), "");
  EXPECT_EQ(Get("joints[r_knee].keys[0].rate_deg_s", project), "null");
}

TEST(SetField, RefusesWhatIsNotThereWithTheNearest) {
  const std::map<std::string, std::string> refusals = {
      {"scene.gravity_m_s",
       "there is no field \"gravity_m_s\" here; did you mean "
       "\"gravity_m_s2\"?"},
      {"regions[arn].friction.default",
       "there is no \"arn\" among \"regions\"; did you mean \"arm\"?"},
      {"regions[xyzzy].friction.default",
       "there is no \"xyzzy\" among \"regions\"; use one of \"arm\", \"leg\""},
      {"joints[r_knee].keys[3].angle_deg",
       "there is no \"3\" among \"keys\"; use one of \"0\", \"2.5\", \"30\""},
      {"placements[3].first_frame",
       "there is no \"3\" among \"placements\"; use one of \"0\", \"1\", \"2\""},
      {"held_objects[ball].box.size_m", "there is no field \"box\" here; use one of "},
      {"root.x.keys[0].position_m", "there is no \"0\" among \"keys\", which is empty"}};
  for (const auto& [address, message] : refusals) {
    const std::string said = Refusal(address, "1");
    EXPECT_TRUE(said.starts_with(address + ": " + message)) << said;
  }
}

TEST(SetField, RefusesWhatIsNotOneField) {
  const std::map<std::string, std::string> refusals = {
      {"scene", "is several fields: name one of them, behind a dot"},
      {"regions[arm].friction", "is several fields: name one of them, behind a dot"},
      {"regions", "\"regions\" is a list: name an item of it, in brackets"},
      {"regions.friction", "\"regions\" is a list: name an item of it, in brackets"},
      {"regions[arm].friction.joints", "is a list: name an item of it, in brackets"},
      {"scene[0]", "is no list: nothing in brackets goes here"},
      {"name.first", "\"name\" is one value: nothing comes behind it"},
      {"regions[arm].friction.joints[r_wrist].x", "a number is one value: nothing comes behind it"},
      {"figure.joints", "is read from a file as a whole: no address leads into it"}};
  for (const auto& [address, message] : refusals) {
    EXPECT_EQ(Refusal(address, "1"), address + ": " + message);
  }
}

TEST(SetField, RefusesValuesOfAnotherTypeOrOutOfRange) {
  const std::vector<std::array<std::string, 3>> refusals = {
      {"regions[arm].friction.default", "1.5",
       "must lie between 0 and 1, is 1.5 (speed that is left after 1/30 s: 0 frozen, 1 no "
       "friction)"},
      {"regions[arm].friction.joints[r_wrist]", "-0.1",
       "must lie between 0 and 1, is -0.1 (the same, of single joints and hinges: 0 frozen, 1 no "
       "friction)"},
      {"regions[leg].step_s", "0",
       "must lie between 1e-06 and 1 s, is 0 (length of a step of method paper)"},
      {"regions[arm].first_frame", "2.5", "expected a whole number, found 2.5"},
      {"regions[arm].friction.default", "\"much\"", "expected a number, found a string"},
      {"regions[arm].friction.default", "null", "expected a number, found null"},
      {"audio.mute", "1", "expected true or false, found a number"},
      {"name", "7", "expected a string, found a number"},
      {"solver.method", "\"exakt\"", "there is no method \"exakt\"; did you mean \"exact\"?"},
      {"held_objects[ball].offset_m", "[1, 2]", "expected 3 values, found 2"}};
  for (const auto& [address, value, message] : refusals) {
    EXPECT_EQ(Refusal(address, value), address + ": " + message);
  }
}

TEST(SetField, RefusesWhatIsNotJson) {
  for (const char* text : {"", "abc", "[1,", "1 2", "{\"a\":}"}) {
    Project project = ParseGood(SampleProject());
    const Result<Done> set = SetField(At("scene.gravity_m_s2"), text, &project);
    ASSERT_FALSE(set.ok()) << text;
    EXPECT_EQ(set.error().code, ErrorCode::kSyntax);
    EXPECT_EQ(set.error().place, "scene.gravity_m_s2");
    EXPECT_TRUE(project == ParseGood(SampleProject())) << text;
  }
}

TEST(GetField, RefusesAsSetFieldDoes) {
  const Project project = ParseGood(SampleProject());
  EXPECT_EQ(Get("scene.gravity_m_s", project),
            "scene.gravity_m_s: there is no field \"gravity_m_s\" here; did you mean "
            "\"gravity_m_s2\"?");
  Project bare = project;
  bare.camera.reset();
  EXPECT_EQ(Get("camera.eye_m", bare), "camera.eye_m: \"camera\" is left out here");
}

}  // namespace
}  // namespace hazumi::testing
