// What Hazumi has written as glTF it knows again: shapes and masses.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "engine/bake/bake.h"
#include "engine/exchange/export_motion.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "render/motion/figure_skin.h"
#include "tests/support/temporary_folder.h"

namespace hazumi::test {
namespace {

struct RoundTrip {
  std::shared_ptr<const Figure> before, after;
  ImportReport report;
};

// `spoiled`: a word of the file, which is another one when it is read again.
RoundTrip ThereAndBack(const std::string& example, const ImportOptions& options = {},
                       const std::string& generator = "Hazumi", const std::string& spoiled = "") {
  const TemporaryFolder folder;
  const Result<Project> project =
      LoadProject(HAZUMI_SOURCE_DIR "/assets/examples/" + example + ".kfa");
  const Result<Compiled> compiled = CompileAnimation(project.value());
  const Animation& animation = compiled.value().animation;
  const Result<Motion> motion = Bake(animation, {});
  const Skin skin = render::SkinOfLinks(*animation.figure);
  MotionExportOptions as_gltf;
  as_gltf.skin = &skin;
  as_gltf.format = spoiled.empty() ? MotionFormat::kGlb : MotionFormat::kGltf;
  as_gltf.generator = generator;
  std::string file = ExportMotion(animation, motion.value(), as_gltf).value();
  for (size_t at = 0; !spoiled.empty() && (at = file.find(spoiled, at)) != std::string::npos;) {
    file.replace(at, spoiled.size(), std::string(spoiled.size(), 'x'));
  }
  std::ofstream(folder / "there.gltf", std::ios::binary) << file;
  const Result<Character> character = ReadCharacter(folder / "there.gltf", {});
  EXPECT_TRUE(character.ok()) << character.error().ToString();
  Result<Imported> imported = ImportProject(character.value(), options);
  EXPECT_TRUE(imported.ok()) << imported.error().ToString();
  const Result<Project> saved = ParseProject(WriteProject(imported.value().project), "back.kfa");
  EXPECT_TRUE(saved.ok()) << saved.error().ToString();
  const Result<Compiled> back = CompileAnimation(saved.value());
  EXPECT_TRUE(back.ok()) << back.error().ToString();
  return {animation.figure, back.value().animation.figure, imported.value().report};
}

const Link* LinkNamed(const std::string& name, const Figure& figure) {
  for (const Link& link : figure.links()) {
    if (link.name == name) return &link;
  }
  return nullptr;
}

const RigidInertia& BodyOf(const Link& link, const Figure& figure) {
  return link.joint.is_valid() ? figure.body(link.joint) : figure.root_body();
}

class KnownBodies : public testing::TestWithParam<const char*> {};

TEST_P(KnownBodies, OfAnExampleAreAsTheyWere) {
  const RoundTrip trip = ThereAndBack(GetParam());
  EXPECT_NEAR(trip.after->total_mass(), trip.before->total_mass(), 0.01);
  ASSERT_EQ(trip.after->links().size(), trip.before->links().size());
  for (const Link& link : trip.before->links()) {
    const Link* now = LinkNamed(link.name, *trip.after);
    ASSERT_NE(now, nullptr) << link.name;
    EXPECT_LT((now->capsule.a - link.capsule.a).norm(), 1e-3) << link.name;
    EXPECT_LT((now->capsule.b - link.capsule.b).norm(), 1e-3) << link.name;
    EXPECT_NEAR(now->capsule.radius, link.capsule.radius, 1e-3) << link.name;
    const RigidInertia& was = BodyOf(link, *trip.before);
    const RigidInertia& is = BodyOf(*now, *trip.after);
    EXPECT_NEAR(is.mass, was.mass, 1e-3) << link.name;
    EXPECT_LT((is.I_com - was.I_com).norm(), 1e-6) << link.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, KnownBodies, testing::Values("throw", "jump"));

TEST(ImportedAgain, AreAsHeavyAsIsAskedFor) {
  ImportOptions options;
  options.mass_kg = 35.0;
  EXPECT_NEAR(ThereAndBack("throw", options).after->total_mass(), 35.0, 1e-6);
}

TEST(ImportedAgain, AreGuessedWithAWordWhereTheyCannotBeRead) {
  const RoundTrip trip = ThereAndBack("throw", {}, "Hazumi", "mass_kg");
  const std::vector<Warning>& warnings = trip.report.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.message.find("cannot be read from its extras") != std::string::npos;
  }));
  EXPECT_GT(trip.after->total_mass(), 0.0);
}

TEST(ImportedAgain, AreGuessedInAFileThatAnotherProgramHasWrittenSince) {
  const RoundTrip trip = ThereAndBack("throw", {}, "Another program, from a file of Hazumi");
  EXPECT_FALSE(trip.report.facts.back().empty());
  for (const std::string& fact : trip.report.facts) {
    EXPECT_EQ(fact.find("as Hazumi wrote it"), std::string::npos) << fact;
  }
}

}  // namespace
}  // namespace hazumi::test
