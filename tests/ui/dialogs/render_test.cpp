// Pictures drawn beside the interface.

#include <fstream>

#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

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

}  // namespace
}  // namespace hazumi::ui
