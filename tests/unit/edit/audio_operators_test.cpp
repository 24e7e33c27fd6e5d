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
  Project project;
  project.fps = {24, 1, {}};
  EXPECT_FALSE(edit::HeardIn(project, "/shots/a.kfa", 0.0, 1.0));
  project.audio = ProjectAudio{"sounds/voice.wav", 12, -6.0, false, {}};
  EXPECT_EQ(edit::HeardIn(project, "/shots/a.kfa", 2.0, 1.5),
            (SoundPart{"/shots/sounds/voice.wav", 1.5, 1.5, -6.0}));
  EXPECT_EQ(edit::HeardIn(project, "/shots/a.kfa", 0.0, 1.5)->start_s, -0.5);
  project.audio->file = "/elsewhere/voice.wav";
  EXPECT_EQ(edit::SoundPath(project, "/shots/a.kfa"), "/elsewhere/voice.wav");
  project.audio->mute = true;
  EXPECT_FALSE(edit::HeardIn(project, "/shots/a.kfa", 2.0, 1.5));
}

}  // namespace
}  // namespace hazumi::test
