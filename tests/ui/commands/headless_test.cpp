// No operator and no action needs a window, whatever is in hand or open.

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/ui/commands/commands.h"
#include "tests/unit/edit/random/random_projects.h"
#include "ui/edit/script.h"
#include "ui/shell/scripted_editor.h"

namespace hazumi::test {
namespace {

using edit::Json;
using ui::Editor;
using ui::ScriptedEditor;

// A script that takes something in hand, or opens something on top of the panels.
struct Opening {
  const char* what;
  std::vector<std::pair<const char*, Json>> steps;
};

const std::vector<Opening>& Tools() {
  static const Json knee = {{"joints", {"r_knee"}}}, root = {{"joints", {"pelvis"}}};
  static const std::vector<Opening> tools = {
      {"turn a joint", {{"select.joints", knee}, {"tool.rotate", {}}}},
      {"turn the root", {{"select.joints", root}, {"tool.rotate", {}}}},
      {"drag a joint", {{"select.joints", knee}, {"tool.move", {}}}},
      {"drag the root", {{"select.joints", root}, {"tool.move", {}}}},
      {"move keys", {{"keys.select_all", {}}, {"sheet.move", {}}}},
      {"copy keys", {{"keys.select_all", {}}, {"sheet.duplicate", {}}}},
      {"stretch keys", {{"keys.select_all", {}}, {"sheet.scale", {}}}},
      {"select by a box", {{"sheet.box", {}}}},
      {"mark a region", {{"sheet.mark_region", {}}}},
      {"mark a region of a joint", {{"select.joints", knee}, {"sheet.mark_region", {}}}},
      {"preview range", {{"sheet.preview", {}}}},
      {"move keys in the graph",
       {{"view.sheet", {{"graph", true}}}, {"keys.select_all", {}}, {"sheet.move", {}}}},
      {"box in the graph", {{"view.sheet", {{"graph", true}}}, {"sheet.box", {}}}}};
  return tools;
}

const std::vector<Opening>& Dialogs() {
  static const std::vector<Opening> dialogs = {
      {"search", {{"app.search", {}}}},
      {"form", {{"app.form", {{"id", "placement.set"}}}}},
      {"form of an action", {{"app.form", {{"id", "view.overlay"}}}}},
      {"unsaved", {{"marker.add", {{"name", "new"}}}, {"app.new", {}}}},
      {"open", {{"file.open_dialog", {}}}},
      {"import", {{"file.import_dialog", {}}}},
      {"mesh", {{"file.mesh_dialog", {}}}},
      {"export", {{"file.export_dialog", {}}}},
      {"save as", {{"file.save_as", {}}}},
      {"render", {{"render.dialog", {}}}},
      {"manual", {{"help.manual", {}}}},
      {"about", {{"help.about", {}}}}};
  return dialogs;
}

class Headless : public ::testing::Test {
 protected:
  Headless() : files_(WriteRandomFiles(folder_.path(), 1)) {}

  void Open(const Opening& opening, ScriptedEditor* scripted) {
    Json steps = Json::array({{{"op", "file.open"}, {"path", files_.projects[0]}}});
    for (const auto& [id, parameters] : opening.steps) {
      Json step = {{"op", id}};
      if (!parameters.is_null()) step.update(parameters);
      steps.push_back(step);
    }
    const Result<Done> done =
        edit::RunScript(steps.dump(), opening.what,
                        [&](const std::string& id, const Json& p) { return scripted->Do(id, p); });
    ASSERT_TRUE(done.ok()) << done.error().ToString();
  }

  // Every command, while it is open; what is refused says why.
  void DoEverythingAfter(const Opening& opening, bool (*is_open)(const Editor&)) {
    SCOPED_TRACE(opening.what);
    ScriptedEditor scripted({320, 200});
    for (const Command& command : AllCommands()) {
      SCOPED_TRACE(command.id);
      Open(opening, &scripted);
      ASSERT_TRUE(is_open(scripted.editor()));
      const Result<Done> done =
          scripted.Do(command.id, RandomParameters(command.id, command.parameters,
                                                   scripted.editor().session(), files_, &random_));
      EXPECT_TRUE(done.ok() || !done.error().message.empty());
      (void)scripted.editor().tool_hint();
      scripted.editor().Take(nullptr);
      scripted.editor().dialogs.modal = ui::Modal::kNone;
    }
  }

  TemporaryFolder folder_;
  RandomFiles files_;
  Random random_{1};
};

TEST_F(Headless, EveryCommandIsDoneOrRefusedWithEachToolInHand) {
  for (const Opening& tool : Tools()) {
    DoEverythingAfter(tool, [](const Editor& editor) { return editor.has_tool(); });
  }
}

TEST_F(Headless, EveryCommandIsDoneOrRefusedWithEachDialogOpen) {
  for (const Opening& dialog : Dialogs()) {
    DoEverythingAfter(
        dialog, [](const Editor& editor) { return editor.dialogs.modal != ui::Modal::kNone; });
  }
}

TEST_F(Headless, ToolsGoOnWhenTimePassesAndAreGivenUpWithoutAMouse) {
  for (const Opening& tool : Tools()) {
    SCOPED_TRACE(tool.what);
    ScriptedEditor scripted({320, 200});
    Open(tool, &scripted);
    const long revision = scripted.editor().session().document().revision();
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(scripted.Do("wait", {{"seconds", 0.02}}).ok());
    EXPECT_TRUE(scripted.editor().has_tool());
    EXPECT_TRUE(scripted.Do("app.search", Json::object()).ok());
    EXPECT_FALSE(scripted.editor().has_tool());
    if (std::string(tool.what) != "copy keys") {
      EXPECT_EQ(scripted.editor().session().document().revision(), revision);
    }
  }
}

// A tool keeps names and numbers of what it was taken for.
TEST_F(Headless, AnotherDocumentTakesToolsOutOfTheHand) {
  for (const Opening& tool : Tools()) {
    SCOPED_TRACE(tool.what);
    ScriptedEditor scripted({320, 200});
    Open(tool, &scripted);
    ASSERT_TRUE(scripted.Do("file.open", {{"path", files_.projects[4]}}).ok());
    EXPECT_FALSE(scripted.editor().has_tool());
    EXPECT_FALSE(scripted.editor().sheet.box);
  }
}

// Held feet that are out of reach, for the root is far up; the pose is shown as it was.
TEST_F(Headless, ToolsAreTakenWhereTheMotionHasBecomeImpossible) {
  for (const Opening& tool : Tools()) {
    SCOPED_TRACE(tool.what);
    ScriptedEditor scripted({320, 200});
    Opening opening = tool;
    opening.steps.insert(opening.steps.begin(),
                         {{"time.frame", {{"frame", 3}}},
                          {"view.frame_all", {}},
                          {"key.set", {{"curve", "root.z"}, {"frame", 3}, {"value", 2}}}});
    Open(opening, &scripted);
    EXPECT_TRUE(scripted.editor().has_tool());
    EXPECT_FALSE(scripted.editor().session().FrameNow().ok());
    EXPECT_TRUE(scripted.Do("wait", {{"seconds", 0.02}}).ok());
  }
}

}  // namespace
}  // namespace hazumi::test
