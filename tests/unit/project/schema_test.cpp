// Every shipped file against the published schemas, and the schemas against the reader.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "engine/project/compile.h"
#include "engine/project/figure_file.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "engine/sweep/sweep_run.h"
#include "tests/unit/project/skin_sample.h"

namespace hazumi::testing {
namespace {

using PlainJson = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

const std::string kAssets = HAZUMI_SOURCE_DIR "/assets/";

PlainJson Load(const std::string& path) { return PlainJson::parse(ReadFile(path)); }

// The first complaint about the document; empty: it is valid.
std::string ComplaintOf(const std::string& schema_name, const PlainJson& document) {
  const PlainJson schema_json = Load(kAssets + "schema/" + schema_name);
  const PlainJson figure_json = Load(kAssets + "schema/figure.schema.json");
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7)
      .populateSchema(
          Adapter(schema_json), schema, [&](const std::string&) { return &figure_json; },
          [](const PlainJson*) {});
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema, Adapter(document), &results)) return "";
  std::string text;
  for (const auto& result : results) {
    for (const std::string& part : result.context) text += part;
    text += ": " + result.description + "\n";
  }
  return text;
}

std::vector<std::string> FilesIn(const std::string& folder, const std::string& extension) {
  std::vector<std::string> files;
  if (!std::filesystem::exists(kAssets + folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(kAssets + folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path().string());
  }
  return files;
}

TEST(Schema, IsTheOneThatTheFieldsDescribe) {
  EXPECT_TRUE(ReadFile(kAssets + "schema/kfa.schema.json") == ProjectSchema())
      << "hazumi --schema > assets/schema/kfa.schema.json brings it up to date";
}

TEST(Schema, TheSampleIsValid) {
  const PlainJson sample = PlainJson::parse(SampleProject().dump());
  EXPECT_EQ(ComplaintOf("kfa.schema.json", sample), "");
  EXPECT_EQ(ComplaintOf("figure.schema.json", sample["figure"]), "");
}

TEST(Schema, TakesBothMethodsWithAndWithoutTheirNumbers) {
  for (const char* solver :
       {R"({"method": "exact", "version": 1})", R"({"method": "paper", "version": 1})",
        R"({"method": "exact", "tolerance_deg": 1e-10, "version": 1})"}) {
    const std::string text = Changed(SampleProject(), {{"/solver", solver}}).dump();
    EXPECT_EQ(ComplaintOf("kfa.schema.json", PlainJson::parse(text)), "") << solver;
  }
}

TEST(Schema, KnowsSkins) {
  const auto complaint = [](const Changes& changes) {
    return ComplaintOf("kfa.schema.json", PlainJson::parse(WithSkin(changes).dump()));
  };
  EXPECT_EQ(complaint({}), "");
  EXPECT_NE(complaint({{"/skin/bones", ""}}), "");
  EXPECT_NE(complaint({{"/skin/meshes/0/weights", "\"A*\""}}), "");
  EXPECT_NE(complaint({{"/skin/meshes/0/binds/0/inverse_bind", "[1]"}}), "");
}

TEST(Schema, FindsMistakes) {
  const Changes mistakes = {{"/solver", ""},
                            {"/solver/method", ""},
                            {"/solver/version", ""},
                            {"/solver/method", "\"magic\""},
                            {"/solver/tolerance_deg", "6"},
                            {"/regions/0/tolerance_deg", "0"},
                            {"/regions/0/friction/default", "1.5"},
                            {"/joints/r_knee/keys/0/interpolation", "\"cubik\""},
                            {"/scene/objects/0/color", "\"red\""},
                            {"/figure/joints/0/hinges/0/limits_deg", "[1]"},
                            {"/markers/0/frame", "1.5"},
                            {"/markers/0/name", ""},
                            {"/preview/last", ""},
                            {"/fps/num", "0"},
                            {"/placements/0/kind", "\"magic\""},
                            {"/holds/0/reach", "\"far\""},
                            {"/regions/0/joints", "[]"},
                            {"/regions/0/blend_frames", "-1"},
                            {"/selection_sets/0/joints", ""}};
  for (const auto& mistake : mistakes) {
    const std::string wrong = Changed(SampleProject(), {mistake}).dump();
    EXPECT_NE(ComplaintOf("kfa.schema.json", PlainJson::parse(wrong)), "") << mistake.first;
  }
}

TEST(Schema, ShippedFiguresAreValidAndLoad) {
  const std::vector<std::string> files = FilesIn("figures", ".json");
  for (const std::string& file : files) {
    EXPECT_EQ(ComplaintOf("figure.schema.json", Load(file)), "") << file;
    const Result<FigureSpec> figure = LoadFigure(file);
    EXPECT_TRUE(figure.ok()) << figure.error().ToString();
  }
  if (files.empty()) ADD_FAILURE() << "no figures";
}

TEST(Schema, ShippedPosesAreValidAndMistakesInThemAreFound) {
  const PlainJson poses = Load(kAssets + "poses/human.json");
  EXPECT_EQ(ComplaintOf("poses.schema.json", poses), "");
  for (const char* place :
       {"/format", "/poses/0/name", "/poses/0/joints", "/poses/1/root/height_m"}) {
    PlainJson wrong = poses;
    wrong[PlainJson::json_pointer(place)] = true;
    EXPECT_NE(ComplaintOf("poses.schema.json", wrong), "") << place;
  }
}

TEST(Schema, ShippedSweepsAreValidAndMistakesInThemAreFound) {
  const PlainJson sweep = Load(kAssets + "examples/throw_sweep.json");
  EXPECT_EQ(ComplaintOf("sweep.schema.json", sweep), "");
  const Result<Sweep> loaded = Sweep::Load(kAssets + "examples/throw_sweep.json");
  EXPECT_TRUE(loaded.ok()) << loaded.error().ToString();
  for (const char* place :
       {"/format", "/vary/0/field", "/vary/0/values", "/measure/0/quantity", "/picture/frames"}) {
    PlainJson wrong = sweep;
    wrong[PlainJson::json_pointer(place)] = true;
    EXPECT_NE(ComplaintOf("sweep.schema.json", wrong), "") << place;
    EXPECT_FALSE(ParseSweep(wrong.dump(), "wrong.json").ok()) << place;
  }
}

TEST(Schema, ShippedExamplesAreValidLoadAndCompile) {
  const std::vector<std::string> files = FilesIn("examples", ".kfa");
  for (const std::string& file : files) {
    EXPECT_EQ(ComplaintOf("kfa.schema.json", Load(file)), "") << file;
    const Result<Project> project = LoadProject(file);
    ASSERT_TRUE(project.ok()) << project.error().ToString();
    EXPECT_TRUE(project.value().read.warnings.empty()) << file;
    const Result<Compiled> compiled = CompileAnimation(project.value());
    EXPECT_TRUE(compiled.ok()) << file << compiled.error().ToString();
    EXPECT_EQ(ComplaintOf("kfa.schema.json", PlainJson::parse(WriteProject(project.value()))), "");
  }
  if (files.empty()) ADD_FAILURE() << "no examples";
}

}  // namespace
}  // namespace hazumi::testing
