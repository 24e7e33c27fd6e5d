// What is chosen: a sound, a reference, keys of the keyboard.

#include <algorithm>
#include <fstream>

#include "engine/project/project_writer.h"
#include "tests/ui/dialogs/fixture.h"

namespace hazumi::ui {
namespace {

TEST_F(Dialogs, ASoundIsChosenFromAListAndKeptRelativeToTheProject) {
  fs::create_directories(folder_ / "sounds");
  std::ofstream(File("sounds/voice.wav")) << "a sound";
  std::ofstream(File("sounds/notes.txt")) << "none";
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("shot.kfa")}}));
  ASSERT_TRUE(editor_.Do("file.sound_dialog"));
  Frames();
  GoToFolder(File("sounds"), &editor_);
  ASSERT_EQ(editor_.dialogs.files.entries.size(), 1u);
  SelectEntry(0, &editor_);
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.files.error;
  ASSERT_TRUE(editor_.session().project().audio);
  EXPECT_EQ(editor_.session().project().audio->file, "sounds/voice.wav");
}

// A project that somebody else made names a file elsewhere.
class OutsideFiles : public Dialogs {
 protected:
  void SetUp() override {
    Dialogs::SetUp();
    for (const char* name : {"home", "elsewhere"}) fs::create_directories(folder_ / name);
    std::ofstream(File("elsewhere/voice.wav")) << "a sound";
    Project project = editor_.session().project();
    project.audio = ProjectAudio();
    project.audio->file = "../elsewhere/voice.wav";
    ASSERT_TRUE(SaveProject(project, File("home/shot.kfa")).ok());
    Open();
  }
  void Open() {
    ASSERT_TRUE(editor_.Do("file.open", {{"path", File("home/shot.kfa")}}));
    while (Tick(), editor_.sound.is_busy()) {
    }
    Frames();
  }
  void Tick() {
    editor_.Tick(0.0);
    shell_->Frame();
  }
  bool is_closed() {
    Tick();
    while (editor_.sound.is_busy()) Tick();
    return editor_.sound.error().find("outside of the project's folder") != std::string::npos;
  }
  bool is_asked() const { return !editor_.dialogs.asked_outside.empty(); }
};

TEST_F(OutsideFiles, EscAndEnterKeepThemClosed) {
  for (const int key : {kEscape, kEnter}) {
    editor_.dialogs.kept_closed.clear();
    Frames();
    EXPECT_TRUE(is_asked());
    EXPECT_TRUE(is_closed());
    Press({key});
    EXPECT_FALSE(is_asked());
    EXPECT_TRUE(is_closed());
  }
  EXPECT_TRUE(editor_.settings.opened_outside.empty());
}

TEST_F(OutsideFiles, AreOpenedOnceItIsAgreed) {
  EXPECT_TRUE(is_asked());
  Press({'O'});
  EXPECT_FALSE(is_asked());
  EXPECT_FALSE(is_closed());
  EXPECT_EQ(editor_.settings.opened_outside.size(), 1u);
  Open();
  EXPECT_FALSE(is_asked());
}

TEST_F(OutsideFiles, WhoChoosesOneIsNotAsked) {
  ASSERT_TRUE(editor_.Do("file.open", {{"path", File("home/shot.kfa")}}));
  ASSERT_TRUE(editor_.Do("audio.set", {{"file", File("elsewhere/voice.wav")}}));
  Frames();
  EXPECT_FALSE(is_asked());
  EXPECT_FALSE(is_closed());
  EXPECT_EQ(editor_.settings.opened_outside.size(), 1u);
}

TEST_F(Dialogs, AMeshIsChosenAndIsInTheSelectedHand) {
  fs::create_directories(folder_ / "things");
  std::ofstream(File("things/wedge.obj"))
      << "v 0 0 0\nv 0.2 0 0\nv 0 0.1 0\nv 0 0 0.3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  std::ofstream(File("things/notes.txt")) << "none";
  ASSERT_TRUE(editor_.Do("select.joints", {{"joints", {"l_wrist"}}}));
  ASSERT_TRUE(editor_.Do("file.mesh_dialog"));
  FileDialogState& files = editor_.dialogs.files;
  GoToFolder(File("things"), &editor_);
  ASSERT_EQ(files.entries.size(), 1u);
  SelectEntry(0, &editor_);
  ChooseFile(&editor_);
  EXPECT_EQ(editor_.dialogs.modal, Modal::kNone) << files.error;
  ASSERT_EQ(editor_.session().project().held_objects.size(), 1u);
  EXPECT_EQ(editor_.session().project().held_objects[0].joint, "l_wrist");
  EXPECT_TRUE(editor_.session().project().held_objects[0].mesh);
}

TEST_F(Dialogs, AReferenceIsChosenAmongPicturesAndVideos) {
  for (const char* name : {"take.mp4", "pose.PNG", "notes.txt"}) std::ofstream(File(name)) << "-";
  ASSERT_TRUE(editor_.Do("file.save", {{"path", File("shot.kfa")}}));
  ASSERT_TRUE(editor_.Do("file.reference_dialog"));
  Frames();
  GoToFolder(folder_.string(), &editor_);
  ASSERT_EQ(editor_.dialogs.files.entries.size(), 2u);
  SelectEntry(1, &editor_);
  Press({kEnter});
  EXPECT_EQ(modal(), Modal::kNone) << editor_.dialogs.files.error;
  ASSERT_TRUE(editor_.session().project().reference);
  EXPECT_EQ(editor_.session().project().reference->file, "take.mp4");
}

TEST_F(Dialogs, PreferencesGiveAShortcutTheKeyThatIsPressed) {
  ASSERT_TRUE(editor_.Do("app.preferences"));
  Frames();
  const std::vector<Shortcut>& all = DefaultShortcuts();
  const auto jump = std::find_if(all.begin(), all.end(), [](const Shortcut& shortcut) {
    return std::string(shortcut.id) == "tool.jump";
  });
  editor_.dialogs.preferences.waits = static_cast<int>(jump - all.begin());
  Press({kEscape});  // as it is
  EXPECT_EQ(modal(), Modal::kPreferences);
  EXPECT_EQ(KeyOf("tool.jump"), "J");
  editor_.dialogs.preferences.waits = static_cast<int>(jump - all.begin());
  Press({'U'});
  EXPECT_EQ(KeyOf("tool.jump"), "U");
  EXPECT_EQ(editor_.settings.keymap.size(), 1u);
  EXPECT_EQ(editor_.dialogs.preferences.waits, -1);
  ASSERT_TRUE(editor_.Do("keymap.reset"));
  Press({kEscape});
  EXPECT_EQ(modal(), Modal::kNone);
}

}  // namespace
}  // namespace hazumi::ui
