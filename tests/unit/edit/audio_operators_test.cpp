#include <filesystem>
#include <fstream>

#include "engine/base/input_files.h"
#include "engine/project/project_files.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/media_files.h"

namespace hazumi::test {
namespace {

using edit::Session;

TEST(AudioOperators, TheSoundKeepsWhatIsNotGivenAndIsUndone) {
  Session session;
  Do(&session, "audio.set", {{"file", "voice.wav"}});
  Do(&session, "audio.set", {{"gain", -3}, {"drag", "gain"}});
  Do(&session, "audio.set", {{"gain", -6}, {"drag", "gain"}});
  Do(&session, "audio.set", {{"start", 12}, {"mute", true}});
  const ProjectAudio wanted{"voice.wav", 12, -6.0, true, {}};
  EXPECT_EQ(session.project().audio, wanted);
  EXPECT_EQ(session.document().num_steps(), 3u);
  Do(&session, "audio.remove");
  EXPECT_FALSE(session.project().audio);
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().audio, wanted);
}

TEST(AudioOperators, WhatCannotBeIsRefused) {
  Session session;
  EXPECT_EQ(Refused(&session, "audio.set", {{"gain", 3}}).ToString(),
            "audio.set.file: name a sound file");
  EXPECT_EQ(Refused(&session, "audio.remove", edit::Json::object()).ToString(),
            "audio.remove: the project has no sound");
  Do(&session, "audio.set", {{"file", "voice.wav"}});
  Refused(&session, "audio.set", {{"gain", 25}});
  Refused(&session, "audio.set", {{"file", ""}});
  EXPECT_EQ(session.document().num_steps(), 1u);
}

TEST(Heard, BeginsOnItsFrameAtTheProjectsRate) {
  const edit::MediaAccess none, all(true);
  Project project;
  project.fps = {24, 1, {}};
  const auto heard = [&](double first_s) {
    return edit::HeardIn(project, "/shots/a.kfa", first_s, 1.5, all).value();
  };
  EXPECT_FALSE(heard(0.0));
  project.audio = ProjectAudio{"sounds/voice.wav", 12, -6.0, false, {}};
  EXPECT_EQ(heard(2.0), (SoundPart{"/shots/sounds/voice.wav", 1.5, 1.5, -6.0}));
  EXPECT_EQ(heard(0.0)->start_s, -0.5);
  project.audio->file = "/bin/sh";
  EXPECT_EQ(heard(0.0)->file, "/bin/sh");
  EXPECT_EQ(edit::HeardIn(project, "/shots/a.kfa", 0.0, 1.5, none).error().place, "audio.file");
  project.audio->mute = true;
  EXPECT_FALSE(heard(2.0));
  EXPECT_TRUE(edit::HeardIn(project, "/shots/a.kfa", 0.0, 1.5, none).ok());
}

// Files outside of the project's folder are open once somebody agreed.
TEST(MediaAccess, OpensWhatLiesInTheFolderOrIsAllowed) {
  const TemporaryFolder home, elsewhere;
  for (const std::string& file : {home / "a.wav", elsewhere / "b.wav"}) std::ofstream(file) << "-";
  std::filesystem::create_symlink(elsewhere / "b.wav", home / "link.wav");
  const std::string project = home / "a.kfa";
  edit::MediaAccess access;
  EXPECT_FALSE(access.WhyClosed("", project));
  EXPECT_FALSE(access.WhyClosed(home / "a.wav", project));
  EXPECT_FALSE(access.WhyClosed(home / "missing.wav", project));
  for (const std::string& file : {elsewhere / "b.wav", home / "link.wav"}) {
    const auto closed = access.WhyClosed(file, project);
    ASSERT_TRUE(closed) << file;
    EXPECT_NE(closed->message.find("--open-outside"), std::string::npos);
  }
  EXPECT_TRUE(access.WhyClosed(home / "a.wav", ""));  // a project without a file has no folder
  access.Allow(home / "link.wav");
  EXPECT_FALSE(access.WhyClosed(elsewhere / "b.wav", project));
  EXPECT_TRUE(access.WhyClosed(home / "a.wav", ""));
  access = edit::MediaAccess(true);
  EXPECT_FALSE(access.WhyClosed(home / "a.wav", ""));
}

// Who names a file agrees, and saving elsewhere takes nothing back.
TEST(MediaAccess, FollowsWhatTheUserDoes) {
  const TemporaryFolder home, elsewhere;
  for (const std::string& file : {home / "a.wav", elsewhere / "b.png"}) std::ofstream(file) << "-";
  Session session;
  Do(&session, "file.save", {{"path", home / "a.kfa"}});
  Do(&session, "audio.set", {{"file", "a.wav"}});
  Do(&session, "reference.set", {{"file", elsewhere / "b.png"}});
  EXPECT_FALSE(session.media().WhyClosed(elsewhere / "b.png", home / "a.kfa"));
  Do(&session, "file.save", {{"path", elsewhere / "a.kfa"}});
  const std::string& path = session.document().path();
  const std::string sound = SoundPath(session.project(), path);
  EXPECT_TRUE(edit::MediaAccess().WhyClosed(sound, path)) << sound;
  EXPECT_FALSE(session.media().WhyClosed(sound, path));
  // Neither is written over.
  EXPECT_TRUE(WhyKept(sound));
  EXPECT_FALSE(session.Run("file.save", {{"path", sound}, {"overwrite", true}}).ok());
}

}  // namespace
}  // namespace hazumi::test
