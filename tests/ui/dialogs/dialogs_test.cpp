#include <fstream>

#include "tests/ui/dialogs/fixture.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/window/status_line.h"

namespace hazumi::ui {
namespace {

TEST_F(Dialogs, ANewProjectIsSavedUnderTheNameThatIsTyped) {
  Change();
  Press({'S', true});
  ASSERT_EQ(modal(), Modal::kFiles);
  Type(File("投げる"));
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.files.error;
  EXPECT_TRUE(fs::exists(File("投げる.kfa")));
  EXPECT_TRUE(is_saved());
  EXPECT_EQ(editor_.settings.recent_files, (std::vector<std::string>{File("投げる.kfa")}));
}

TEST_F(Dialogs, AnotherFileIsOverwrittenAfterAQuestionOnly) {
  std::ofstream(File("a.kfa")) << "mine";
  Press({'S', true, true});
  Type(File("a"));
  Press({kEnter});
  EXPECT_TRUE(editor_.dialogs.files.asks_overwrite);
  EXPECT_EQ(fs::file_size(File("a.kfa")), 4u);
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_GT(fs::file_size(File("a.kfa")), 100u);
}

TEST_F(Dialogs, ArrowsAndEnterOpenFoldersAndProjects) {
  fs::create_directories(folder_ / "takes");
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("takes/one.kfa")}}));
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("two.kfa")}}));
  Press({'O', true});
  ASSERT_EQ(modal(), Modal::kFiles);
  EXPECT_EQ(editor_.dialogs.files.folder, folder_.string());
  Press({kDown});
  Press({kEnter});
  EXPECT_EQ(editor_.dialogs.files.folder, File("takes"));
  Press({kDown});
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_EQ(editor_.session().document().path(), File("takes/one.kfa"));
}

TEST_F(Dialogs, TabAndArrowsLeadToRecentFilesAndEnterOpensThem) {
  fs::create_directories(folder_ / "takes");
  for (const char* name : {"takes/one.kfa", "takes/two.kfa", "three.kfa"}) {
    ASSERT_TRUE(editor_.Do("file.save", {{"path", File(name)}}));
  }
  Press({'O', true});
  Press({kTab, false, true});  // back to the places, whose first one it is
  const size_t places = Shelves(HomeFolder(), editor_.settings.recent_files, "").size();
  for (size_t i = 0; i < places + 1; ++i) Press({kDown});
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.files.error;
  EXPECT_EQ(editor_.session().document().path(), File("takes/two.kfa"));
}

TEST_F(Dialogs, ALongNameLeavesTheButtonsInTheDialog) {
  std::string name;
  while (name.size() < 240) name += "投げる";
  std::ofstream(File(name.substr(0, 180) + ".kfa")) << "mine";
  Press({'S', true, true});
  Type(File(name.substr(0, 180)));
  Press({kEnter});
  ASSERT_TRUE(editor_.dialogs.files.asks_overwrite);
  Click(645.0f, 433.0f);  // the last button, in the dialog's lower right corner
  EXPECT_FALSE(editor_.dialogs.files.asks_overwrite);
  EXPECT_EQ(modal(), Modal::kFiles);
}

TEST_F(Dialogs, AFormThatIsTallerThanTheWindowKeepsItsButtonsInIt) {
  editor_.settings.scale = 1.5;
  ASSERT_TRUE(RunOrAsk(&editor_, "region.add", Json::object()).ok());
  Frames(4);
  ASSERT_EQ(modal(), Modal::kForm);
  Click(620.0f, 436.0f);
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Dialogs, EnterPressesTheButtonThatTabHasLedTo) {
  Change();
  Press({'Q', true});
  Press({kTab});
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_TRUE(editor_.wants_to_quit);  // "Don't save"
}

TEST_F(Dialogs, TheManualIsScrolledByKeys) {
  Press({kF1});
  ASSERT_EQ(modal(), Modal::kManual);
  Frames(30);  // what is behind it has grown dark
  const auto seen = [&] { return shell_->picture().rgba; };
  const auto beginning = seen();
  Press({kPageDown});
  const auto page = seen();
  EXPECT_TRUE(page != beginning);
  Press({kDown});
  EXPECT_TRUE(seen() != page);
  Press({kUp});
  EXPECT_TRUE(seen() == page);
  Press({kEnd});
  const auto end = seen();
  EXPECT_TRUE(end != page);
  Press({kPageDown});
  EXPECT_TRUE(seen() == end);
  Press({kHome});
  EXPECT_TRUE(seen() == beginning);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
}

// What it does is said by its label: no tooltip lies over the buttons beside it.
TEST_F(Dialogs, AButtonWhoseLabelSaysItHasNoTooltip) {
  Change();
  Press({'Q', true});
  ASSERT_EQ(modal(), Modal::kUnsaved);
  Frames(30);  // what is behind it has grown dark
  for (float x = 180.0f; x < 560.0f; x += 40.0f) {
    shell_->MoveMouse(x, 262.0f);
    Frames(2);
    const auto before = shell_->picture().rgba;
    for (int i = 0; i < 12; ++i) shell_->Frame(0.1);
    EXPECT_TRUE(shell_->picture().rgba == before) << x;
  }
}

TEST_F(Dialogs, AFileThatIsNoProjectIsSaidInTheDialog) {
  std::ofstream(File("broken.kfa")) << "{";
  Press({'O', true});
  Type(File("broken.kfa"));
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kFiles);
  EXPECT_NE(editor_.dialogs.files.error.find("broken.kfa"), std::string::npos);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Dialogs, LeavingAsksAboutUnsavedChangesAndCanBeCancelled) {
  Change();
  Press({'Q', true});
  EXPECT_EQ(modal(), Modal::kUnsaved);
  EXPECT_FALSE(editor_.wants_to_quit);
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_FALSE(editor_.wants_to_quit);
  Press({'Q', true});
  AnswerDiscard(&editor_);
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, DLeavesWithoutSaving) {
  Change();
  Press({'Q', true});
  Press({'D'});
  EXPECT_EQ(modal(), Modal::kNone);
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, AltIDeletesTheKeysOfTheFrame) {
  Change();
  Press({'I', false, false, true});
  EXPECT_TRUE(editor_.session().project().joints.at(0).value.keys.empty());
  Press({'I', false, false, true});
  EXPECT_EQ(editor_.message.text, "Delete key (frame): there is no key on frame 0");
}

TEST_F(Dialogs, FilesAreLookedForWhereTheProjectIsElseWhereTheLastOneWas) {
  fs::create_directories(folder_ / "a");
  fs::create_directories(folder_ / "b");
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("b/one.kfa")}}));
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("a/one.kfa")}}));
  OpenFileDialog(&editor_, kOpenProject);
  EXPECT_EQ(editor_.dialogs.files.folder, File("a"));
  ASSERT_TRUE(editor_.Do("file.new"));
  OpenFileDialog(&editor_, kOpenProject);
  EXPECT_EQ(editor_.dialogs.files.folder, File("a"));
  fs::remove_all(folder_ / "a");
  OpenFileDialog(&editor_, kSaveProject);
  EXPECT_EQ(editor_.dialogs.files.folder, File("b"));
}

TEST_F(Dialogs, ErrorsInFilesSayFileAndLine) {
  std::ofstream(File("throw.kfa")) << "{\n  bad";
  EXPECT_FALSE(editor_.Do("file.open", {{"path", File("throw.kfa")}}));
  EXPECT_EQ(editor_.message.text.rfind("throw.kfa, line 2", 0), 0u) << editor_.message.text;
}

TEST_F(Dialogs, LeavingAfterSaveWaitsForTheName) {
  Change();
  Press({'Q', true});
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kFiles);
  EXPECT_FALSE(editor_.wants_to_quit);
  Type(File("last"));
  Press({kEnter});
  EXPECT_TRUE(fs::exists(File("last.kfa"))) << editor_.dialogs.files.error;
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, ASavedProjectIsLeftAtOnceAndScriptsAreNotAsked) {
  Change();
  ASSERT_TRUE(editor_.Do("file.new"));
  EXPECT_EQ(modal(), Modal::kNone);
  ASSERT_TRUE(editor_.Do("app.quit"));
  EXPECT_TRUE(editor_.wants_to_quit);
}

TEST_F(Dialogs, ADroppedFileIsOpenedAfterTheQuestion) {
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("a.kfa")}}));
  Change();
  ASSERT_TRUE(editor_.Do("app.open", {{"path", File("a.kfa")}}));
  EXPECT_EQ(modal(), Modal::kUnsaved);
  AnswerDiscard(&editor_);
  EXPECT_TRUE(is_saved());
}

TEST_F(Dialogs, SearchRunsWhatItFindsAndAsksForWhatItNeeds) {
  Press({kF3});
  ASSERT_EQ(modal(), Modal::kSearch);
  Type("gravity");
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kForm);
  Type("1.62");
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.form.error;
  EXPECT_EQ(editor_.session().project().scene.gravity_m_s2, 1.62);
}

TEST_F(Dialogs, TabGoesToTheNextFieldOfAForm) {
  ASSERT_TRUE(RunOrAsk(&editor_, "region.add", {{"joints", {"r_elbow"}}}).ok());
  ASSERT_EQ(modal(), Modal::kForm);
  Frames();
  Type("5");
  Press({kTab});
  Type("9");
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kNone) << editor_.dialogs.form.error;
  const ProjectRegion& region = editor_.session().project().regions.at(0);
  EXPECT_EQ(region.first_frame, 5);
  EXPECT_EQ(region.last_frame, 9);
}

TEST_F(Dialogs, KeysOfTheEditorRestWhileADialogIsOpen) {
  Press({kF1});
  ASSERT_EQ(modal(), Modal::kManual);
  Press({kSpace});
  EXPECT_FALSE(editor_.playback.is_on());
  Press({kEscape});
  Press({kSpace});
  EXPECT_TRUE(editor_.playback.is_on());
}

TEST_F(Dialogs, TheFirstEntryOfTheFileMenuAsksToo) {
  Change();
  const auto click = [&](float x, float y) {
    shell_->MoveMouse(x, y);
    Frames();
    shell_->PressButton(0, true);
    Frames(1);
    shell_->PressButton(0, false);
    Frames();
  };
  click(20.0f, 10.0f);
  click(40.0f, 38.0f);
  EXPECT_EQ(modal(), Modal::kUnsaved);
}

TEST_F(Dialogs, TheCurrentFrameIsDrawnBesideTheInterface) {
  editor_.session().set_frame(3);
  Press({kF12});
  ASSERT_EQ(modal(), Modal::kRender);
  RenderState& render = editor_.dialogs.render;
  render.folder = File("pictures");
  render.width = 64;
  render.height = 48;
  Press({kEnter});
  ASSERT_EQ(modal(), Modal::kProgress) << render.error;
  const std::shared_ptr<RenderJob> job = render.job;
  for (int i = 0; i < 2000 && !job->result(); ++i) shell_->Frame();
  ASSERT_TRUE(job->result().has_value());
  ASSERT_TRUE(job->result()->ok()) << job->result()->error().ToString();
  EXPECT_TRUE(fs::exists(File("pictures/Untitled_0003.png")));
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Dialogs, ARangeIsRenderedAfterItIsSaidWhatIsWritten) {
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("a.kfa")}}));
  OpenRenderDialog(&editor_, true);
  RenderState& render = editor_.dialogs.render;
  EXPECT_EQ(SummaryOf(OutlineOf(editor_)),
            "31 pictures, 1280 x 720, a_0000.png - a_0030.png, into " + File("render"));
  render.first = 4;
  render.last = 5;
  render.width = render.height = 32;
  fs::create_directories(File("render"));
  std::ofstream(File("render/a_0005.png")) << "mine";
  Frames();
  EXPECT_EQ(render.num_existing, 1);
  StartRender(&editor_);
  ASSERT_TRUE(render.job) << render.error;
  while (!render.job->result()) shell_->Frame();
  EXPECT_EQ(render.job->result()->value(), 2);
  EXPECT_TRUE(fs::exists(File("render/a_0004.png")));
  EXPECT_FALSE(fs::exists(File("render/a_0006.png")));
}

TEST_F(Dialogs, ARangeOutsideOfTheAnimationIsNotRendered) {
  OpenRenderDialog(&editor_, true);
  RenderState& render = editor_.dialogs.render;
  render.last = 31;
  StartRender(&editor_);
  EXPECT_EQ(render.error, "The animation has the frames from 0 to 30.");
  render.first = 12;
  render.last = 11;
  StartRender(&editor_);
  EXPECT_EQ(render.error, "The first frame must not come after the last one.");
  EXPECT_EQ(modal(), Modal::kRender);
}

TEST_F(Dialogs, TheRangeOfARenderStaysAsLongAsItsFramesDo) {
  OpenRenderDialog(&editor_, true);
  RenderState& render = editor_.dialogs.render;
  render.first = 3;
  render.last = 8;
  Press({kEscape});
  OpenRenderDialog(&editor_, true);
  EXPECT_EQ(render.first, 3);
  EXPECT_EQ(render.last, 8);
  Press({kEscape});
  ASSERT_TRUE(editor_.Do("time.range", {{"first", 0}, {"last", 20}}));
  OpenRenderDialog(&editor_, true);
  EXPECT_EQ(render.first, 0);
  EXPECT_EQ(render.last, 20);
}

TEST_F(Dialogs, TheFolderOfPicturesIsChosenFromAListThatComesBack) {
  fs::create_directories(folder_ / "shots");
  std::ofstream(File("a.kfa")) << "{}";
  OpenRenderDialog(&editor_, false);
  RenderState& render = editor_.dialogs.render;
  render.folder = File("not yet/made");
  OpenFolderDialog(&editor_);
  EXPECT_EQ(editor_.dialogs.files.folder, folder_.string());
  ASSERT_EQ(editor_.dialogs.files.entries.size(), 1u);  // files are none of its business
  Frames();
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kRender);
  EXPECT_EQ(render.folder, File("not yet/made"));
  OpenFolderDialog(&editor_);
  Frames();
  Press({kDown});
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kRender);
  EXPECT_EQ(render.folder, File("shots"));
}

TEST_F(Dialogs, ARenderThatIsCancelledEndsEarly) {
  OpenRenderDialog(&editor_, true);
  RenderState& render = editor_.dialogs.render;
  render.folder = File("pictures");
  StartRender(&editor_);
  ASSERT_TRUE(render.job);
  const std::shared_ptr<RenderJob> job = render.job;
  job->Cancel();
  while (!job->result()) shell_->Frame();
  ASSERT_TRUE(job->result()->ok());
  EXPECT_LT(job->result()->value(), 31);
}

TEST_F(Dialogs, WhoStaysAfterAllSeesHowFarTheRenderIs) {
  Change();
  OpenRenderDialog(&editor_, true);
  editor_.dialogs.render.folder = File("pictures");
  StartRender(&editor_);
  ASSERT_TRUE(editor_.Do("app.quit"));
  ASSERT_EQ(modal(), Modal::kUnsaved);
  Frames();
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kProgress);
}

TEST_F(Dialogs, AFolderThatCannotBeMadeIsSaid) {
  std::ofstream(File("file")) << "x";
  OpenRenderDialog(&editor_, false);
  editor_.dialogs.render.folder = File("file/inside");
  StartRender(&editor_);
  const std::shared_ptr<RenderJob> job = editor_.dialogs.render.job;
  ASSERT_TRUE(job);
  while (!job->result()) shell_->Frame();
  ASSERT_FALSE(job->result()->ok());
  EXPECT_EQ(job->result()->error().code, ErrorCode::kCannotWrite);
}

TEST(StatusBar, LeavesOutWholeKeysOfAHintAndNeverItsValue) {
  const auto width_of = [](const std::string& text) { return static_cast<float>(text.size()); };
  const std::string hint = "Move: 1.0 m   Enter: confirm   Esc: cancel";
  EXPECT_EQ(FittingHint(hint, 100.0f, width_of), hint);
  EXPECT_EQ(FittingHint(hint, 30.0f, width_of), "Move: 1.0 m   Enter: confirm");
  EXPECT_EQ(FittingHint(hint, 5.0f, width_of), "Move: 1.0 m");
  EXPECT_EQ(FittingHint("", 5.0f, width_of), "");
}

TEST_F(Dialogs, TheStatusBarSaysFileFrameAndMemory) {
  EXPECT_EQ(StatusParts(editor_)[0], "Untitled (saved)");
  Change();
  editor_.session().set_frame(12);
  EXPECT_EQ(StatusParts(editor_)[0], "Untitled (not saved)");
  EXPECT_EQ(StatusParts(editor_)[1], "Frame 12 / 30");
  EXPECT_EQ(MemoryText(12'345), "13 kB");
  EXPECT_EQ(MemoryText(3'400'000), "3.4 MB");
}

}  // namespace
}  // namespace hazumi::ui
