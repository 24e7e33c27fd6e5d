// Fields of items as parameters: listed, set and read back, all that their descriptions name.

#include "ui/edit/fields/item_fields.h"

#include "tests/unit/edit/sessions.h"
#include "ui/edit/operator.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::ParameterInfo;
using edit::ParameterInfos;
using edit::ParameterKind;

// Something that the parameter takes and that no field says at first.
Json SomethingFor(const ParameterInfo& info) {
  switch (info.kind) {
    case ParameterKind::kText: {
      const std::vector<std::string> words = edit::WordsOf(info.offer);
      return words.empty() ? Json("something") : Json(words.back());
    }
    case ParameterKind::kNumber:
      return std::min(info.range.upper, 0.625);
    case ParameterKind::kInteger:
      return 7;
    case ParameterKind::kYesNo:
      return true;
    case ParameterKind::kNames:
      return {"r_shoulder+", "neck"};
    case ParameterKind::kNumbers:
      break;
  }
  return Json();
}

// Sets a field of an item and reads it back.
template <typename T>
void ExpectIsSet(const ParameterInfo& info, T* item, const char* what) {
  const Json wanted = SomethingFor(info);
  const auto given = edit::Parameters::Check({info}, {{info.name, wanted}});
  ASSERT_TRUE(given.ok()) << given.error().ToString();
  ASSERT_TRUE(edit::SetFields(given.value(), item).ok()) << what << " " << info.name;
  EXPECT_EQ(edit::FieldValue(*item, info.name), wanted) << what << " " << info.name;
  EXPECT_STRNE(info.help, "") << what << " " << info.name;
  EXPECT_STRNE(info.label, "") << what << " " << info.name;
}

// Every one, one after the other.
template <typename T>
void ExpectAllAreSet(T item, const char* what) {
  const ParameterInfos infos = edit::FieldsOf(item);
  EXPECT_FALSE(infos.empty()) << what;
  for (const ParameterInfo& info : infos) ExpectIsSet(info, &item, what);
}

template <typename Shape>
ProjectSceneObject ObjectOf(Shape shape) {
  ProjectSceneObject object;
  object.shape = shape;
  return object;
}

template <typename Item>
void ExpectAllKindsAreSet(const char* what) {
  ForEachKind<Item>([&](Item item, const char*) {
    for (const ParameterInfo& info : edit::FieldsOf(item)) {
      if (std::string(info.name) != "kind") ExpectIsSet(info, &item, what);
    }
  });
}

TEST(ItemFields, AreSetAndReadBack) {
  ExpectAllAreSet(ProjectRegion(), "region");
  ExpectAllAreSet(ProjectDrive(), "drive");
  ExpectAllAreSet(ProjectHold(), "hold");
  ExpectAllAreSet(ProjectMarker(), "marker");
  ExpectAllKindsAreSet<ProjectForce>("force");
  ExpectAllKindsAreSet<ProjectConstraint>("constraint");
  ExpectAllAreSet(ProjectFill(), "fill");
  ExpectAllKindsAreSet<ProjectGoal>("goal");
  ExpectAllAreSet(ProjectSolver(), "solver");
  ExpectAllAreSet(ProjectCamera(), "camera");
  ExpectAllAreSet(ProjectAudio(), "audio");
  ExpectAllAreSet(ProjectReference(), "reference");
  ExpectAllAreSet(ProjectKey(), "key");
  ExpectAllAreSet(ProjectScene(), "scene");
  ExpectAllAreSet(ProjectRate(), "rate");
  ExpectAllAreSet(ProjectFrames(), "frames");
  ExpectAllAreSet(ProjectHeldObject(), "held object");
  ExpectAllAreSet(ObjectOf(ProjectPlane()), "plane");
  ExpectAllAreSet(ObjectOf(ProjectBox()), "box");
}

TEST(ItemFields, OfAllKindsAreListedOnce) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : edit::FieldsOf<ProjectPlacement>()) names.push_back(info.name);
  EXPECT_EQ(names, (std::vector<std::string>{"kind", "pin", "first", "last", "landing_pin"}));
}

TEST(ItemFields, ARotationIsNamedByItsAxesInTheFilesOrder) {
  ProjectSceneObject box = ObjectOf(ProjectBox());
  const ParameterInfos infos = edit::FieldsOf(box);
  const auto given = edit::Parameters::Check(infos, {{"angle_z", 30}, {"size_y", 2}});
  ASSERT_TRUE(edit::SetFields(given.value(), &box).ok());
  EXPECT_EQ(std::get<ProjectBox>(box.shape).rotation_deg, Vec3(30.0, 0.0, 0.0));
  EXPECT_EQ(std::get<ProjectBox>(box.shape).size_m, Vec3(1.0, 2.0, 1.0));
}

TEST(ItemFields, AWordThatIsNoneOfItsEnumerationIsRefused) {
  ProjectHold hold;
  const auto given = edit::Parameters::Check(edit::FieldsOf(hold), {{"reach", "far"}});
  const Result<Done> set = edit::SetFields(given.value(), &hold);
  ASSERT_FALSE(set.ok());
  EXPECT_EQ(set.error().ToString(), "reach: \"far\" is none of limb, body");
}

bool Takes(const char* id, const char* parameter) {
  const std::vector<ParameterInfo>& infos = edit::FindOperator(id)->parameters;
  return std::any_of(infos.begin(), infos.end(), [&](const ParameterInfo& info) {
    return std::string(info.name) == parameter;
  });
}

// Whatever an item says in a file, an operator says too.
TEST(ItemFields, AreParametersOfTheirOperators) {
  const auto expect = [](const ParameterInfos& infos, std::initializer_list<const char*> ids) {
    for (const ParameterInfo& info : infos) {
      for (const char* id : ids) EXPECT_TRUE(Takes(id, info.name)) << id << " " << info.name;
    }
  };
  expect(edit::FieldsOf<ProjectRegion>(), {"region.add", "region.set"});
  expect(edit::FieldsOf<ProjectPlacement>(), {"placement.set", "placement.edit"});
  expect(edit::FieldsOf<ProjectHold>(), {"hold.add", "hold.set"});
  expect(edit::FieldsOf<ProjectMarker>(), {"marker.add"});
  expect(edit::FieldsOf<ProjectForce>(), {"force.add", "force.set"});
  expect(edit::FieldsOf<ProjectConstraint>(), {"constraint.add", "constraint.set"});
  expect(edit::FieldsOf<ProjectFill>(), {"fill.add", "fill.set"});
  expect(edit::FieldsOf<ProjectGoal>(), {"goal.add", "goal.set"});
  expect(edit::FieldsOf<ProjectSolver>(), {"solver.set"});
  expect(edit::FieldsOf(ProjectHeldObject()), {"held.add_ball", "held.set"});
  expect(edit::FieldsOf<ProjectCamera>(), {"camera.set"});
  expect(edit::FieldsOf<ProjectAudio>(), {"audio.set"});
  expect(edit::FieldsOf<ProjectReference>(), {"reference.set"});
  expect(edit::FieldsOf<ProjectKey>(), {"key.set"});
  expect(edit::FieldsOf<ProjectScene>(), {"scene.gravity"});
  expect(edit::FieldsOf<ProjectRate>(), {"time.rate"});
  expect(edit::FieldsOf<ProjectFrames>(), {"time.range", "time.preview"});
  expect(edit::FieldsOf(ObjectOf(ProjectBox())), {"object.add_box", "object.set"});
  expect(edit::FieldsOf(ObjectOf(ProjectPlane())), {"object.add_plane", "object.set"});
}

}  // namespace
}  // namespace hazumi::test
