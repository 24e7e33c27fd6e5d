// Cells of a sweep of the shipped throw, against bakes of the project as a cell makes it.

#include "engine/sweep/sweep_run.h"

#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/sweep/table_text.h"
#include "tests/unit/project/sample.h"
#include "tests/unit/sweep/sweeps.h"

namespace hazumi {
namespace {

using testing::TemporaryFolder, testing::WriteFile;

constexpr const char* kThrow = HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa";

std::string SweepOfThrow(const std::string& fields) {
  return std::string(R"({"format": "hazumi-sweep", "version": 1, "project": ")") + kThrow + "\", " +
         fields + "}";
}

Result<Sweep> Loaded(const TemporaryFolder& folder, const std::string& fields) {
  WriteFile(folder / "s.json", SweepOfThrow(fields));
  return Sweep::Load(folder / "s.json");
}

std::string LoadRefusal(const std::string& fields) {
  const TemporaryFolder folder;
  const Result<Sweep> sweep = Loaded(folder, fields);
  return sweep.ok() ? "" : sweep.error().ToString().substr((folder / "").size());
}

std::vector<std::string> RowOf(const Sweep& sweep, long cell) {
  return ReadCsv(sweep.RowOf(cell, {}).value()).at(0);
}

constexpr const char* kFields = R"("vary": [
    {"field": "held_objects[ball].release_frame", "values": [10, 12]},
    {"field": "scene.gravity_m_s2", "values": [9.81, 3.7]}],
    "measure": [{"quantity": "com_highest_m"}, {"quantity": "landing_frame", "of": "ball"}])";

TEST(Sweep, MeasuresEachCellAsIfItHadBeenBakedAlone) {
  const TemporaryFolder folder;
  const Sweep sweep = Loaded(folder, kFields).value();
  EXPECT_EQ(sweep.Header(),
            "cell,held_objects[ball].release_frame,scene.gravity_m_s2,com_highest_m,"
            "landing_frame ball,error\n");
  for (long cell = 0; cell < 4; ++cell) {
    Project project = LoadProject(kThrow).value();
    project.held_objects[0].release_frame = cell < 2 ? 10 : 12;
    project.scene.gravity_m_s2 = cell % 2 == 0 ? 9.81 : 3.7;
    const Animation animation = CompileAnimation(project).value().animation;
    const Motion motion = Bake(animation).value();
    double highest = -1e9;
    for (const MotionFrame& frame : motion.frames) highest = std::max(highest, frame.com.z());
    const std::vector<std::string> row = RowOf(sweep, cell);
    ASSERT_EQ(row.size(), 6u);
    EXPECT_EQ(row[0], std::to_string(cell));
    EXPECT_EQ(row[3], FormatNumber(highest)) << cell;
    EXPECT_EQ(row[5], "");
  }
}

TEST(Sweep, ACellThatFailsSaysWhyAndNoOtherMinds) {
  const TemporaryFolder folder;
  // A region whose end comes before its beginning passes for each field by itself.
  const Sweep sweep = Loaded(folder, R"("vary": [{"field": "regions[0].last_frame",
                                                  "values": [15, 2, 14]}],
                                        "measure": [{"quantity": "com_highest_m"}])")
                          .value();
  EXPECT_EQ(RowOf(sweep, 0)[3], "");
  EXPECT_NE(RowOf(sweep, 0)[2], "");
  EXPECT_EQ(RowOf(sweep, 1)[2], "");
  EXPECT_NE(RowOf(sweep, 1)[3].find("must be before last_frame 2"), std::string::npos)
      << RowOf(sweep, 1)[3];
  EXPECT_EQ(RowOf(sweep, 2)[3], "");
}

TEST(Sweep, StopsForAnInterruptAndForWhatCannotBeWritten) {
  const TemporaryFolder folder;
  const Sweep sweep = Loaded(folder, kFields).value();
  const std::atomic<bool> cancel = true;
  EXPECT_EQ(sweep.RowOf(0, {}, &cancel).error().code, ErrorCode::kInterrupted);
  const auto full = [](const SweptCell&) -> Result<Done> {
    return Error{ErrorCode::kCannotWrite, "0.png", "", "the disk is full"};
  };
  EXPECT_EQ(sweep.RowOf(0, full).error().code, ErrorCode::kCannotWrite);
  const auto failing = [](const SweptCell&) -> Result<Done> {
    return Error{ErrorCode::kFailed, "", "", "cannot be drawn"};
  };
  EXPECT_EQ(ReadCsv(sweep.RowOf(0, failing).value())[0].back(), "cannot be drawn");
}

TEST(Sweep, IsAnotherIfAnythingThatMakesItsRowsIs) {
  const TemporaryFolder folder;
  const Sweep sweep = Loaded(folder, kFields).value();
  const std::string identity = sweep.Identity("Hazumi 1");
  EXPECT_EQ(Loaded(folder, kFields).value().Identity("Hazumi 1"), identity);
  EXPECT_NE(sweep.Identity("Hazumi 2"), identity);
  const std::string other = R"("vary": [{"field": "scene.gravity_m_s2", "values": [9.81, 3.8]}])";
  EXPECT_NE(Loaded(folder, other).value().Identity("Hazumi 1"), identity);
}

TEST(Sweep, IsRefusedWithFileAndPlace) {
  EXPECT_EQ(LoadRefusal(R"("vary": [{"field": "scene.gravity", "values": [1]}])"),
            "s.json: vary[0].values[0]: scene.gravity = 1: there is no field \"gravity\" here; use "
            "one of \"gravity_m_s2\", \"objects\"");
  EXPECT_EQ(LoadRefusal(R"("vary": [{"field": "scene.gravity_m_s2", "values": [1]}],
                      "measure": [{"quantity": "warnigs"}])"),
            "s.json: measure[0].quantity: there is no quantity \"warnigs\"; did you mean "
            "\"warnings\"?");
  const TemporaryFolder folder;
  WriteFile(folder / "s.json", test::SweepText(R"("vary": [{"field": "a", "values": [1]}])"));
  const Result<Sweep> missing = Sweep::Load(folder / "s.json");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::kNoInput);
  EXPECT_EQ(missing.error().file, folder / "throw.kfa");
}

}  // namespace
}  // namespace hazumi
