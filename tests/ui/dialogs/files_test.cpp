// Projects opened and saved: names, folders, what cannot be read.

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/support/data_folder.h"
#include "tests/ui/dialogs/fixture.h"

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
  while (name.size() < 180) name += "投げる";
  const std::string path = File(name);
  std::ofstream(path + ".kfa") << "mine";
  Press({'S', true, true});
  Type(path);
  Press({kEnter});
  ASSERT_TRUE(editor_.dialogs.files.asks_overwrite);
  Click(645.0f, 433.0f);  // the last button, in the dialog's lower right corner
  EXPECT_FALSE(editor_.dialogs.files.asks_overwrite);
  EXPECT_EQ(modal(), Modal::kFiles);
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

// The dialog shows the first of two characters and lists both names.
TEST_F(Dialogs, AnotherCharacterOfAFileIsChosen) {
  HAZUMI_NEED_DATA("reports");
  ImportState& import = editor_.dialogs.import;
  const auto read = [&] {
    while (!import.job->character()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    Frames();
    return import.job->character()->value();
  };
  ASSERT_TRUE(
      editor_.Do("app.open", {{"path", test::DataPath("reports/g27_two_characters.gltf")}}));
  EXPECT_EQ(read().chosen, "Hips");
  ChooseCharacter("B_Hips", &import);
  EXPECT_EQ(read().chosen, "B_Hips");
  FinishImport(&editor_);
  EXPECT_EQ(editor_.session().project().figure.spec.root_name, "B_Hips");
}

}  // namespace
}  // namespace hazumi::ui
