#include "engine/exchange/import/role_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/exchange/import/import_project.h"
#include "tests/support/random.h"
#include "tests/unit/exchange/made_people.h"

namespace hazumi {
namespace {

TEST(RoleMap, EachRoleIsReadBackFromItsText) {
  for (int i = 0; i < kNumBodyRoles; ++i) {
    for (const BodySide side : {BodySide::kMiddle, BodySide::kLeft, BodySide::kRight}) {
      const BodyPlace place = {static_cast<BodyRole>(i), side};
      const Result<RoleMap> map = RolesFromText(
          R"({"format": "hazumi-roles", "roles": {"a b": ")" + TextOfPlace(place) + "\"}}",
          "m.json");
      ASSERT_TRUE(map.ok()) << map.error().ToString();
      EXPECT_EQ(map.value().at("a b"), place);
    }
  }
}

TEST(RoleMap, BrokenMapsSayWhatIsWrong) {
  for (const auto& [text, says] :
       {std::pair{"", "hazumi-roles"},
        {"[]", "hazumi-roles"},
        {"{\"format\": 1}", "hazumi-roles"},
        {R"({"format": "hazumi-roles"})", "bones and their roles"},
        {R"({"format": "hazumi-roles", "roles": {"a": "elbow"}})", "must be one of"},
        {R"({"format": "hazumi-roles", "roles": {"a": ["hand"]}})", "must be one of"}}) {
    const Result<RoleMap> map = RolesFromText(text, "m.json");
    ASSERT_FALSE(map.ok()) << text;
    EXPECT_NE(map.error().ToString().find(says), std::string::npos) << map.error().ToString();
  }
}

// Bones whose names say nothing and whose one arm was told wrong.
TEST(RoleMap, GivenRolesMakeTheHingesOfABody) {
  Character person = test::Person({});
  for (size_t b = 0; b < person.bones.size(); ++b) person.bones[b].name = "b" + std::to_string(b);
  const Character named = test::Person({});
  ImportOptions options;
  int arm = -1;
  for (size_t b = 0; b < named.bones.size(); ++b) {
    if (named.bones[b].name.ends_with("LeftArm")) arm = static_cast<int>(b);
  }
  ASSERT_GE(arm, 0);
  options.roles["b" + std::to_string(arm)] = {BodyRole::kUpperArm, BodySide::kLeft};
  const Result<Imported> imported = ImportProject(person, options);
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  for (const JointSpec& joint : imported.value().project.figure.spec.joints) {
    if (joint.name != "b" + std::to_string(arm)) continue;
    ASSERT_TRUE(joint.body);
    EXPECT_EQ(*joint.body, (BodyPlace{BodyRole::kUpperArm, BodySide::kLeft}));
    ASSERT_EQ(joint.hinges.size(), 3u);
    EXPECT_EQ(joint.hinges[0].name, "flexion");
  }
}

TEST(RoleMap, RoleOfWhichABodyHasOneLeavesTheBoneBefore) {
  ImportOptions options;
  const Character person = test::Person({});
  std::string spine, head;
  for (const Bone& bone : person.bones) {
    if (bone.name.ends_with("Spine1")) spine = bone.name;
    if (bone.name.ends_with("Head")) head = bone.name;
  }
  options.roles[spine] = {BodyRole::kHead, BodySide::kMiddle};
  const Result<Imported> imported = ImportProject(person, options);
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  for (const ImportedBone& bone : imported.value().report.bones) {
    if (bone.name == spine) EXPECT_EQ(bone.place.role, BodyRole::kHead);
    if (bone.name == head) EXPECT_EQ(bone.place.role, BodyRole::kNone);
  }
}

TEST(RoleMap, WhatALimbLacksThenIsSaid) {
  ImportOptions options;
  options.roles["RightForeArm"] = {BodyRole::kNeck, BodySide::kMiddle};
  const Result<Imported> imported = ImportProject(test::Person({}), options);
  ASSERT_TRUE(imported.ok()) << imported.error().ToString();
  const std::vector<Warning>& warnings = imported.value().report.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.message.starts_with("no bone is the right forearm; ");
  }));
  const Result<Imported> whole = ImportProject(test::Person({}), {});
  for (const Warning& warning : whole.value().report.warnings) EXPECT_NE(warning.place, "roles");
}

TEST(RoleMap, RolesThatCannotBeAreRefused) {
  ImportOptions options;
  options.roles["nobody"] = {BodyRole::kSpine, BodySide::kMiddle};
  const Result<Imported> unknown = ImportProject(test::Person({}), options);
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().message.find("nobody"), std::string::npos);
  options.roles.clear();
  options.roles[test::Person({}).bones.back().name] = {BodyRole::kShin, BodySide::kMiddle};
  const Result<Imported> sideless = ImportProject(test::Person({}), options);
  ASSERT_FALSE(sideless.ok());
  EXPECT_NE(sideless.error().message.find("left shin"), std::string::npos);
}

// Maps with random roles are imported or refused, and never anything else.
TEST(RoleMap, RandomRolesAreImportedOrRefused) {
  test::Random random(43);
  const Character person = test::Person({});
  int imported = 0;
  for (int trial = 0; trial < 60; ++trial) {
    ImportOptions options;
    for (const Bone& bone : person.bones) {
      if (random.Integer(0, 2) > 0) continue;
      options.roles[bone.name] = {static_cast<BodyRole>(random.Integer(0, kNumBodyRoles - 1)),
                                  static_cast<BodySide>(random.Integer(0, 2))};
    }
    const Result<Imported> result = ImportProject(person, options);
    imported += result.ok();
    if (!result.ok()) EXPECT_FALSE(result.error().message.empty());
  }
  EXPECT_GT(imported, 0);
}

}  // namespace
}  // namespace hazumi
