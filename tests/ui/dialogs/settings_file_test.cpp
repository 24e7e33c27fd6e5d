#include "ui/shell/settings_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {
namespace {

namespace fs = std::filesystem;

class SettingsFileTest : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string path() const { return (folder_ / "hazumi" / "settings.json").string(); }
  void Write(const std::string& text) {
    fs::create_directories(folder_ / "hazumi");
    std::ofstream(path()) << text;
  }

  // Of this process alone: others may run the same tests.
  fs::path folder_ =
      fs::path(testing::TempDir()) / ("hazumi_settings_test_" + std::to_string(getpid()));
};

TEST_F(SettingsFileTest, WhatWasChosenIsThereTheNextTime) {
  Editor editor;
  SettingsFile file(path());
  file.Load(&editor);
  editor.settings.dark = false;
  ASSERT_TRUE(editor.Do("view.language", {{"language", "ja"}}));
  editor.settings.scale = 1.5;
  editor.settings.shares.side = 0.3;
  editor.settings.recent_files = {"/a/投げる.kfa"};
  editor.OpenOutside("/b/声.wav");
  editor.settings.has_seen_first_steps = true;
  editor.settings.keymap = {{Place::kSheet, {'G'}, {'G', true}},
                            {Place::kViewport, {kDelete}, Chord()}};
  file.SaveIfChanged(&editor);
  Editor next;
  SettingsFile(path()).Load(&next);
  EXPECT_EQ(next.settings, editor.settings);
  EXPECT_EQ(next.settings.opened_outside, std::vector<std::string>{"/b/声.wav"});
}

TEST_F(SettingsFileTest, ADamagedFileIsKeptAsideAndSaid) {
  Write("{\"theme\": \"pink\"}");
  Editor editor;
  SettingsFile(path()).Load(&editor);
  EXPECT_EQ(editor.settings, Settings());
  EXPECT_TRUE(editor.message.is_error);
  EXPECT_NE(editor.message.text.find("theme"), std::string::npos) << editor.message.text;
  EXPECT_FALSE(fs::exists(path()));
  EXPECT_TRUE(fs::exists(path() + ".damaged"));
}

TEST_F(SettingsFileTest, NothingIsWrittenWhereNothingChanged) {
  Write("{\"theme\": \"light\"}");
  Editor editor;
  SettingsFile file(path());
  file.Load(&editor);
  EXPECT_FALSE(editor.settings.dark);
  file.SaveIfChanged(&editor);
  std::ostringstream text;
  text << std::ifstream(path()).rdbuf();
  EXPECT_EQ(text.str(), "{\"theme\": \"light\"}");
}

TEST_F(SettingsFileTest, ALanguageThatNobodyChoseStaysThatOfTheSystem) {
  const auto starts_in = [&](const char* language) {
    setenv("LC_ALL", language, 1);
    Editor editor;
    SettingsFile file(path());
    file.Load(&editor);
    editor.settings.dark = !editor.settings.dark;
    file.SaveIfChanged(&editor);
    return editor.settings.language;
  };
  const char* before = std::getenv("LC_ALL");
  const std::string kept = before ? before : "";
  EXPECT_EQ(starts_in("en_GB.UTF-8"), Language::kEnglish);
  EXPECT_EQ(starts_in("ja_JP.UTF-8"), Language::kJapanese);
  EXPECT_EQ(starts_in("C"), Language::kEnglish);
  Editor chosen;
  SettingsFile file(path());
  file.Load(&chosen);
  ASSERT_TRUE(chosen.Do("view.language", {{"language", "ja"}}));
  file.SaveIfChanged(&chosen);
  EXPECT_EQ(starts_in("C"), Language::kJapanese);
  before ? setenv("LC_ALL", kept.c_str(), 1) : unsetenv("LC_ALL");
}

TEST_F(SettingsFileTest, TheFirstStartChoosesNothingAndWritesNothing) {
  Editor editor;
  SettingsFile file(path());
  file.Load(&editor);
  file.SaveIfChanged(&editor);
  EXPECT_FALSE(fs::exists(path()));
}

TEST(Settings, OutOfRangeIsRefusedWithItsPlace) {
  for (const char* text : {"[]", "{", "{\"scale\": 100}", "{\"recent_files\": [1]}",
                           "{\"shares\": {\"side\": 2}}", "{\"language\": 3}"}) {
    EXPECT_FALSE(ReadSettings(text, {}).ok()) << text;
  }
  EXPECT_EQ(ReadSettings("{\"scale\": 100}", {}).error().place, "scale");
}

TEST(Settings, TheLatestOfTenRecentFilesGoesFirst) {
  Settings settings;
  for (int i = 0; i < 12; ++i) AddRecent("/a/" + std::to_string(i) + ".kfa", &settings);
  AddRecent("/a/5.kfa", &settings);
  ASSERT_EQ(settings.recent_files.size(), 10u);
  EXPECT_EQ(settings.recent_files[0], "/a/5.kfa");
  EXPECT_EQ(settings.recent_files[1], "/a/11.kfa");
}

}  // namespace
}  // namespace hazumi::ui
