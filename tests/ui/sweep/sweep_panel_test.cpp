// The cells of a sweep among the properties: looked at as in a drag, kept in one step or left.

#include <gtest/gtest.h>

#include <filesystem>

#include "engine/base/atomic_file.h"
#include "engine/project/address/field_address.h"
#include "engine/sweep/sweep_run.h"
#include "engine/sweep/sweep_store.h"
#include "render/image/png.h"
#include "tests/support/temporary_folder.h"
#include "ui/panels/sweep/actions.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {
namespace {

constexpr const char* kFriction = "regions[arms].friction.default";

class SweepPanel : public testing::Test {
 protected:
  void SetUp() override {
    const std::string throw_file = HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa";
    const std::string file = folder_.path() + "/sweep.json";
    const std::string text = R"({"format": "hazumi-sweep", "version": 1, "project": ")" +
                             throw_file + R"(", "picture": {"frames": [5]}, "vary": [
        {"field": "regions[arms].friction.default", "values": [0.5, 0.7, 1]},
        {"field": "held_objects[ball].release_frame", "values": [8, 12]}]})";
    ASSERT_TRUE(WriteFileAtomically(file, text).ok());
    MakeCells(file);
    auto shell = OffscreenShell::Create(&editor_, {900, 700});
    ASSERT_TRUE(shell.ok());
    shell_ = std::move(shell).value();
    Do("app.open", {{"path", throw_file}});
    Do("sweep.open", {{"path", folder_.path() + "/out"}});
  }

  void MakeCells(const std::string& file) {
    const auto sweep = Sweep::Load(file);
    ASSERT_TRUE(sweep.ok()) << sweep.error().ToString();
    const auto store = SweepStore::Open(folder_.path() + "/out", sweep.value().cells(),
                                        sweep.value().Identity("test"));
    ASSERT_TRUE(store.ok());
    std::string rows;
    for (long cell = 0; cell < sweep.value().cells(); ++cell) {
      rows += sweep.value().RowOf(cell, nullptr).value();
      Image picture(8, 4);
      ASSERT_TRUE(render::WritePng(store.value().PicturePath(cell, ".png"), picture, {}).ok());
    }
    ASSERT_TRUE(store.value().WriteBlock(0, rows).ok());
    ASSERT_TRUE(store.value().Merge(sweep.value().Header()).ok());
  }

  void Do(const std::string& id, const Json& parameters = Json::object()) {
    ASSERT_TRUE(editor_.Do(id, parameters)) << editor_.message.text;
    shell_->Frame();
  }
  std::string Value(const char* address) {
    return GetField(ParseAddress(address).value(), editor_.session().project()).value();
  }

  test::TemporaryFolder folder_;
  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

TEST_F(SweepPanel, ACellGivesTheProjectAllItsValues) {
  Do("sweep.preview", {{"cell", 3}});
  EXPECT_EQ(Value(kFriction), "0.7");
  EXPECT_EQ(Value("held_objects[ball].release_frame"), "12");
}

TEST_F(SweepPanel, ItsPictureIsReadWhenItIsLookedAt) {
  EXPECT_EQ(PictureOfCell(&editor_), 0u);
  EXPECT_EQ(editor_.sweep.aspect, 2.0);  // its place is kept
  Do("sweep.preview", {{"cell", 3}});
  EXPECT_NE(PictureOfCell(&editor_), 0u);
}

TEST_F(SweepPanel, LookingAtManyAndKeepingOneIsOneStep) {
  Do("sweep.preview", {{"cell", 5}});
  Do("sweep.step", {{"by", -1}});
  Do("sweep.adopt");
  EXPECT_EQ(Value(kFriction), "1");
  EXPECT_EQ(Value("held_objects[ball].release_frame"), "8");
  Do("edit.undo");
  EXPECT_EQ(Value(kFriction), "0.8");
  EXPECT_EQ(Value("held_objects[ball].release_frame"), "7");
  EXPECT_FALSE(editor_.session().document().undo_label());
}

TEST_F(SweepPanel, WhatIsKeptIsSaidAndMarkedAsLongAsItHolds) {
  Do("sweep.preview", {{"cell", 3}});
  EXPECT_FALSE(HasKeptCell(editor_));
  Do("sweep.adopt");
  EXPECT_EQ(editor_.message.text,
            "Cell 3 is kept: friction.default = 0.7, release_frame = 12. Undo takes it back.");
  EXPECT_EQ(editor_.sweep.kept, 3u);
  EXPECT_TRUE(HasKeptCell(editor_));
  Do("scene.gravity", {{"gravity", 1.6}});
  EXPECT_TRUE(HasKeptCell(editor_));
  Do("sweep.preview", {{"cell", 0}});
  EXPECT_TRUE(HasKeptCell(editor_));
  Do("edit.cancel_drag");
  Do("edit.undo");
  Do("edit.undo");
  EXPECT_FALSE(HasKeptCell(editor_));
}

TEST_F(SweepPanel, ItIsClosedWithItsProject) {
  Do("sweep.preview", {{"cell", 3}});
  Do("file.new");
  EXPECT_EQ(editor_.sweep.swept, nullptr);
  EXPECT_NE(editor_.message.text.find("is closed"), std::string::npos) << editor_.message.text;
  EXPECT_FALSE(editor_.Do("sweep.preview", {{"cell", 0}}));
}

// The table stays under the mouse as a first cell is clicked.
TEST_F(SweepPanel, TheFirstClickMovesNoCell) {
  const auto click_at = [&](float y) {
    shell_->MoveMouse(800.0f, y);
    shell_->PressButton(0, true);
    shell_->Frame();
    shell_->PressButton(0, false);
    shell_->Frame();
    shell_->Frame();
    return editor_.sweep.cell;
  };
  float y = 690.0f;
  while (y > 300.0f && !click_at(y)) y -= 12.0f;
  ASSERT_TRUE(editor_.sweep.cell);
  const size_t first = *editor_.sweep.cell;
  EXPECT_EQ(click_at(y), first);
}

TEST_F(SweepPanel, ClosedWithoutKeepingTheProjectIsAsItWas) {
  const Project before = editor_.session().project();
  Do("sweep.preview", {{"cell", 0}});
  Do("sweep.leave");
  EXPECT_TRUE(editor_.session().project() == before);
  EXPECT_EQ(editor_.sweep.swept, nullptr);
  EXPECT_FALSE(editor_.session().document().undo_label());
}

TEST_F(SweepPanel, WhatWasChangedSinceIsNotTakenBack) {
  Do("sweep.preview", {{"cell", 0}});
  Do("scene.gravity", {{"gravity", 1.6}});
  Do("sweep.leave");
  EXPECT_EQ(Value("scene.gravity_m_s2"), "1.6");
  EXPECT_EQ(Value(kFriction), "0.5");
}

TEST_F(SweepPanel, CellsThatAreNotThereAreRefused) {
  EXPECT_FALSE(editor_.Do("sweep.preview", {{"cell", 6}}));
  EXPECT_FALSE(editor_.Do("sweep.preview", {{"cell", -1}}));
  Do("sweep.leave");
  EXPECT_FALSE(editor_.Do("sweep.preview", {{"cell", 0}}));
  EXPECT_FALSE(editor_.Do("sweep.adopt"));
  EXPECT_FALSE(editor_.Do("sweep.open", {{"path", folder_.path()}}));
}

}  // namespace
}  // namespace hazumi::ui
