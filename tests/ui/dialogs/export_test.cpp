#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/dialogs/export_summary.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::ui {
namespace {

namespace fs = std::filesystem;

// An editor in memory with the throw, and a folder to export to.
class Export : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(
        editor_.Do("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa"}}));
    auto made = OffscreenShell::Create(&editor_, {720, 600});
    ASSERT_TRUE(made.ok());
    shell_ = std::move(made).value();
    ASSERT_TRUE(editor_.Do("file.export_dialog"));
    SetPath("a.glb");
  }

  ExportState& state() { return editor_.dialogs.exporting; }
  Modal modal() const { return editor_.dialogs.modal; }
  std::string File(const std::string& name) const { return folder_ / name; }
  void SetPath(const std::string& name) {
    state().path = File(name);
    TakeTypedPath(&state());
  }
  void Frames(int count = 3) {
    for (int i = 0; i < count; ++i) shell_->Frame();
  }
  void Press(int key) {
    shell_->PressKey(key, true);
    shell_->Frame();
    shell_->PressKey(key, false);
    Frames();
  }
  template <typename F>
  void FramesUntil(F is_reached) {
    for (int i = 0; i < 5000 && !is_reached(); ++i) shell_->Frame();
    ASSERT_TRUE(is_reached());
  }
  // The preview with the options as they are.
  const ExportedFile& Previewed() {
    FramesUntil([&] { return CurrentPreview(editor_) != nullptr; });
    const Result<ExportedFile>* file = CurrentPreview(editor_);
    EXPECT_TRUE(file->ok()) << (file->ok() ? "" : file->error().ToString());
    return file->value();
  }
  static std::string Read(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::string left_out() {
    std::string all;
    for (const std::string& part : LeftOut(editor_, &Previewed().summary)) all += part + ";";
    return all;
  }

  test::TemporaryFolder folder_;
  Editor editor_;
  std::unique_ptr<OffscreenShell> shell_;
};

TEST_F(Export, ThePreviewFollowsTheOptions) {
  ASSERT_TRUE(editor_.Do("figure.skin", {{"skin", "none"}}));
  state().settings.skin = edit::ExportSkin::kCapsules;
  const Project& project = editor_.session().project();
  const ExportSummary glb = Previewed().summary;
  EXPECT_EQ(glb.animations, 1);
  const int num_held = static_cast<int>(project.held_objects.size());
  EXPECT_GT(glb.meshes, num_held);
  EXPECT_EQ(glb.joints, 1 + static_cast<int>(editor_.session().figure().groups().size()));
  EXPECT_GT(glb.triangles, 100);
  EXPECT_EQ(glb.regions, static_cast<int>(project.regions.size()));
  EXPECT_TRUE(glb.names.contains(editor_.session().figure().root_name()));
  state().settings.skin = edit::ExportSkin::kNone;
  EXPECT_EQ(Previewed().summary.meshes, num_held);
  ChooseFormat(MotionFormat::kBvh, &state());
  EXPECT_EQ(state().path, File("a.bvh"));
  const ExportSummary bvh = Previewed().summary;
  EXPECT_TRUE(bvh.head.starts_with("HIERARCHY"));
  EXPECT_EQ(bvh.joints, 1 + static_cast<int>(editor_.session().figure().groups().size()));
  state().range = ExportRange::kFromTo;
  state().first = 4;
  state().last = 9;
  EXPECT_NE(Previewed().summary.head.find("Frames: 6\n"), std::string::npos);
  EXPECT_NE(ExportFacts(editor_, &Previewed().summary).at(0).find("6 frames, "), std::string::npos);
  ChooseFormat(MotionFormat::kCsv, &state());
  const ExportSummary csv = Previewed().summary;
  EXPECT_EQ(csv.columns.at(0), (std::vector<std::string>{"frame", "4", "5", "6", "7"}));
  EXPECT_EQ(csv.joints, editor_.session().figure().num_joints());
}

TEST_F(Export, ThePreviewRangeIsWhatIsPlayed) {
  ASSERT_TRUE(editor_.Do("time.preview", {{"first", 2}, {"last", 6}}));
  ChooseFormat(MotionFormat::kCsv, &state());
  state().range = ExportRange::kPreview;
  EXPECT_EQ(Previewed().summary.columns.at(0).at(1), "2");
  EXPECT_EQ(std::count(Previewed().bytes.begin(), Previewed().bytes.end(), '\n'), 1 + 5);
  ASSERT_TRUE(editor_.Do("time.preview", {{"off", true}}));
  Frames();
  EXPECT_EQ(state().range, ExportRange::kAll);
}

TEST_F(Export, ThePreviewFollowsTheDocument) {
  ChooseFormat(MotionFormat::kCsv, &state());
  const std::string before = Previewed().bytes;
  ASSERT_TRUE(editor_.Do("pose.rotate", {{"joint", "neck_flexion"}, {"to", 9}}));
  EXPECT_EQ(CurrentPreview(editor_), nullptr);
  EXPECT_NE(Previewed().bytes, before);
}

TEST_F(Export, WritesWhatWasPreviewedAndSaysWhere) {
  const std::string bytes = Previewed().bytes;
  Press(kEnter);
  FramesUntil([&] { return modal() == Modal::kNone; });
  EXPECT_EQ(Read(File("a.glb")), bytes);
  EXPECT_EQ(editor_.message.text.rfind("Exported: " + File("a.glb"), 0), 0u)
      << editor_.message.text;
  EXPECT_EQ(folder_.num_entries(), 1u);
  // As the operator writes it.
  ASSERT_TRUE(editor_.Do("file.export", {{"path", File("b.glb")}}));
  EXPECT_EQ(Read(File("b.glb")), bytes);
}

TEST_F(Export, WhatIsCancelledLeavesNoFile) {
  StartExport(&editor_);
  EXPECT_TRUE(state().wants_write);
  Press(kEscape);
  EXPECT_FALSE(state().wants_write);
  Previewed();
  Frames(10);
  EXPECT_EQ(modal(), Modal::kExport);
  EXPECT_EQ(folder_.num_entries(), 0u);
  Press(kEscape);
  EXPECT_EQ(modal(), Modal::kNone);
}

TEST_F(Export, AsksBeforeItOverwrites) {
  std::ofstream(File("a.glb")) << "mine";
  Frames();
  Press(kEnter);
  EXPECT_TRUE(state().asks_overwrite);
  Press(kEscape);
  EXPECT_EQ(modal(), Modal::kExport);
  EXPECT_EQ(Read(File("a.glb")), "mine");
  Press(kEnter);
  Press(kEnter);
  FramesUntil([&] { return modal() == Modal::kNone; });
  EXPECT_TRUE(Read(File("a.glb")).starts_with("glTF"));
}

TEST_F(Export, SaysWhatIsNotWritten) {
  EXPECT_EQ(left_out().find("region"), std::string::npos);
  ChooseFormat(MotionFormat::kBvh, &state());
  const size_t regions = editor_.session().project().regions.size();
  EXPECT_NE(left_out().find(regions == 1 ? "1 region;" : std::to_string(regions) + " regions;"),
            std::string::npos)
      << left_out();
  const Project& project = editor_.session().project();
  ASSERT_FALSE(project.held_objects.empty());
  EXPECT_NE(left_out().find(project.held_objects[0].name + ";"), std::string::npos);
  state().range = ExportRange::kFromTo;
  state().first = project.frames.first + 5;
  EXPECT_NE(left_out().find("5 frames;"), std::string::npos);
  ChooseFormat(MotionFormat::kJson, &state());
  EXPECT_EQ(left_out().find(project.held_objects[0].name), std::string::npos);
}

TEST_F(Export, WhatCannotBeWrittenIsSaidAtOnce) {
  state().range = ExportRange::kFromTo;
  state().first = 9;
  state().last = 8;
  EXPECT_EQ(ExportTrouble(editor_), "The first frame must not come after the last one.");
  state().range = ExportRange::kAll;
  SetPath("no/such/a.glb");
  StartExport(&editor_);
  EXPECT_NE(state().error.find("there is no folder"), std::string::npos) << state().error;
  ChooseFormat(std::nullopt, &state());
  state().width = 641;
  EXPECT_EQ(ExportTrouble(editor_), "Videos have even sizes: add a pixel.");
  EXPECT_EQ(modal(), Modal::kExport);
}

TEST_F(Export, TheSuffixAndTheFormatAgree) {
  SetPath("a.CSV");
  EXPECT_EQ(state().settings.format, MotionFormat::kCsv);
  SetPath("walk.take2");
  EXPECT_EQ(ExportPath(state()), File("walk.take2.csv"));
  ChooseFormat(std::nullopt, &state());
  EXPECT_EQ(ExportPath(state()), File("walk.take2.mp4"));
  SetPath("b.bvh");
  EXPECT_FALSE(state().is_video);
}

TEST_F(Export, TheFileIsChosenFromAListThatComesBack) {
  std::ofstream(File("old.glb")) << "old";
  std::ofstream(File("other.kfa")) << "{}";
  OpenExportFileDialog(&editor_);
  ASSERT_EQ(editor_.dialogs.files.entries.size(), 1u);
  Frames();
  Press(kEscape);
  EXPECT_EQ(modal(), Modal::kExport);
  EXPECT_EQ(state().path, File("a.glb"));
  OpenExportFileDialog(&editor_);
  SelectEntry(0, &editor_);
  ChooseFile(&editor_);
  EXPECT_EQ(modal(), Modal::kExport);
  EXPECT_EQ(state().path, File("old.glb"));
  EXPECT_EQ(Read(File("old.glb")), "old");
}

TEST_F(Export, OptionsStayUntilAnotherProjectIsOpened) {
  ChooseFormat(MotionFormat::kBvh, &state());
  state().range = ExportRange::kFromTo;
  state().first = 3;
  Press(kEscape);
  ASSERT_TRUE(editor_.Do("file.export_dialog"));
  EXPECT_EQ(state().path, File("a.bvh"));
  EXPECT_EQ(state().first, 3);
  ASSERT_TRUE(editor_.Do("file.new"));
  ASSERT_TRUE(editor_.Do("file.export_dialog"));
  EXPECT_EQ(state().settings.format, MotionFormat::kBvh);
  EXPECT_EQ(state().range, ExportRange::kAll);
  EXPECT_TRUE(state().path.ends_with(".bvh")) << state().path;
  EXPECT_NE(state().path, File("a.bvh"));
}

bool Has(const std::string& program) {
  return std::system((program + " -version >/dev/null 2>&1").c_str()) == 0;
}

std::string NumFramesOf(const std::string& video) {
  const std::string command =
      "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 " + video;
  FILE* pipe = popen(command.c_str(), "r");
  char text[64] = "";
  if (!std::fgets(text, sizeof text, pipe)) text[0] = '\0';
  pclose(pipe);
  return text;
}

// A video of the frames 4 to 9.
void ChooseSmallVideo(ExportState* state) {
  ChooseFormat(std::nullopt, state);
  state->range = ExportRange::kFromTo;
  state->first = 4;
  state->last = 9;
  state->width = state->height = 64;
}

TEST_F(Export, AVideoHasEveryFrame) {
  if (!Has("ffmpeg") || !Has("ffprobe")) GTEST_SKIP() << "ffmpeg or ffprobe is not installed";
  ChooseSmallVideo(&state());
  StartExport(&editor_);
  ASSERT_EQ(modal(), Modal::kProgress) << state().error;
  const std::shared_ptr<RenderJob> job = editor_.dialogs.render.job;
  FramesUntil([&] { return job->result().has_value(); });
  ASSERT_TRUE(job->result()->ok()) << job->result()->error().ToString();
  EXPECT_EQ(NumFramesOf(File("a.mp4")), "6\n");
  Press(kEnter);
  EXPECT_EQ(editor_.message.text, "Exported: " + File("a.mp4"));
}

TEST_F(Export, AVideoHasTheProjectsSound) {
  if (!Has("ffmpeg") || !Has("ffprobe")) GTEST_SKIP() << "ffmpeg or ffprobe is not installed";
  const std::string make = "ffmpeg -loglevel error -f lavfi -i sine=duration=1 " + File("tone.wav");
  ASSERT_EQ(std::system(make.c_str()), 0);
  Press(kEscape);
  ASSERT_TRUE(editor_.Do("audio.set", {{"file", File("tone.wav")}}));
  ASSERT_TRUE(editor_.Do("file.export_dialog"));
  ChooseSmallVideo(&state());
  EXPECT_EQ(ExportFacts(editor_, nullptr).back(),
            "H.264 with its sound in AAC, made by the program ffmpeg");
  state().path = File("a.mp4");
  StartExport(&editor_);
  ASSERT_EQ(modal(), Modal::kProgress) << state().error;
  const std::shared_ptr<RenderJob> job = editor_.dialogs.render.job;
  FramesUntil([&] { return job->result().has_value(); });
  ASSERT_TRUE(job->result()->ok()) << job->result()->error().ToString();
  const std::string seen = "ffprobe -v error -show_entries stream=codec_name -of csv=p=0 " +
                           File("a.mp4") + " | tr '\\n' ' ' | grep -q 'h264 aac'";
  EXPECT_EQ(std::system(seen.c_str()), 0);
}

TEST_F(Export, AVideoThatIsCancelledLeavesNoFile) {
  if (!Has("ffmpeg")) GTEST_SKIP() << "ffmpeg is not installed";
  ChooseSmallVideo(&state());
  StartExport(&editor_);
  const std::shared_ptr<RenderJob> job = editor_.dialogs.render.job;
  ASSERT_TRUE(job);
  job->Cancel();
  FramesUntil([&] { return job->result().has_value(); });
  EXPECT_EQ(folder_.num_entries(), 0u);
}

TEST(ExportSummary, ReadsWhatIsInAFile) {
  const ExportSummary bvh = SummaryOf(MotionFormat::kBvh,
                                      "HIERARCHY\nROOT hips\n{\n\tCHANNELS 6 Xposition\n"
                                      "\tJOINT knee\n\tCHANNELS 3 Zrotation\n}\n"
                                      "MOTION\nFrames: 2\nFrame Time: 0.1\n0 0\n1 1\n");
  EXPECT_EQ(bvh.joints, 2);
  EXPECT_EQ(bvh.channels, 9);
  EXPECT_TRUE(bvh.head.ends_with("0 0\n...\n")) << bvh.head;
  EXPECT_EQ(SizeText(999), "999 bytes");
  EXPECT_EQ(SizeText(1234), "1.2 kB");
  EXPECT_EQ(SizeText(45'600'000), "46 MB");
}

}  // namespace
}  // namespace hazumi::ui
