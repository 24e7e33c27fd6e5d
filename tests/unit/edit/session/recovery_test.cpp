#include "ui/edit/recovery/recovery.h"

#include <fstream>
#include <sstream>

#include "engine/project/project_reader.h"
#include "tests/unit/edit/random/random_operators.h"
#include "tests/unit/edit/session/journals.h"

namespace hazumi::test {
namespace {

namespace fs = std::filesystem;
using edit::AbandonedJournal;
using edit::Journal;
using edit::Recovered;
using edit::RecoverJournal;
using edit::Session;

std::string Read(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void Write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

void SetKnee(Session* session, int frame) {
  Do(session, "key.set", {{"curve", "r_knee"}, {"frame", frame}, {"value", 10.0 * frame}});
}

// Crashes after four keys. Lines of the journal: head, base, state, four operators, digest.
std::string Crash(const TemporaryFolder& folder, const std::string& project = "") {
  Session session;
  if (!project.empty()) Do(&session, "file.save", {{"path", project}});
  Journal journal(&session, folder.path());
  for (int i = 0; i < 4; ++i) SetKnee(&session, i);
  EXPECT_TRUE(journal.WriteNow(At(0.0)).ok());
  return journal.file();
}

TEST(Recovery, FindsNothingWhereNothingIs) {
  const TemporaryFolder folder;
  EXPECT_TRUE(Abandoned(folder.path()).empty());
  EXPECT_TRUE(Abandoned(folder / "nowhere").empty());
  Write(folder / "file", "");
  EXPECT_FALSE(edit::FindAbandonedJournals(folder / "file").ok());
}

TEST(Recovery, DescribesWhatItFinds) {
  const TemporaryFolder folder;
  const std::string project = folder / "jump.kfa";
  Crash(folder);
  const std::string second = Crash(folder, project);
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(second, now + std::chrono::seconds(5));
  std::vector<AbandonedJournal> journals = Abandoned(folder.path());
  ASSERT_EQ(journals.size(), 2u);
  EXPECT_EQ(journals[0].file, second);
  EXPECT_EQ(journals[0].project(), project);
  EXPECT_EQ(journals[0].num_operators, 4);
  EXPECT_FALSE(journals[0].is_project_newer);
  EXPECT_FALSE(journals[0].damage);
  EXPECT_EQ(journals[1].project(), "untitled");
  const auto age = std::chrono::system_clock::now() - journals[1].written;
  EXPECT_LT(std::chrono::abs(age), std::chrono::minutes(1));
  fs::last_write_time(project, now + std::chrono::seconds(10));
  EXPECT_TRUE(Abandoned(folder.path())[0].is_project_newer);
}

TEST(Recovery, KeepsThePathAndSavesThere) {
  const TemporaryFolder folder;
  const std::string project = folder / "jump.kfa";
  const std::string file = Crash(folder, project);
  Session session;
  const Recovered recovered = Recover(folder.path(), &session);
  EXPECT_EQ(recovered.num_operators, 4);
  EXPECT_EQ(session.document().path(), project);
  EXPECT_FALSE(session.document().is_saved());
  while (session.document().Undo()) {
  }
  EXPECT_FALSE(session.document().is_saved());  // whatever the file holds
  while (session.document().Redo()) {
  }
  Do(&session, "file.save");
  EXPECT_EQ(LoadProject(project).value().joints[0].value.keys.size(), 4u);
  ASSERT_TRUE(edit::DiscardJournal(file).ok());
  EXPECT_TRUE(Abandoned(folder.path()).empty());
}

TEST(Recovery, FindsTheFigureOfAProjectInAnotherFolder) {
  const TemporaryFolder folder;
  const std::string project = folder / "jump.kfa";
  fs::copy(HAZUMI_SOURCE_DIR "/assets/figures/human.json", folder / "human.json");
  Session session;
  Project changed = session.project();
  changed.figure.embedded_json.clear();
  changed.figure.file = "human.json";
  ASSERT_TRUE(SaveProject(changed, project).ok());
  {
    Do(&session, "file.open", {{"path", project}});
    Journal journal(&session, folder.path());
    SetKnee(&session, 3);
    ASSERT_TRUE(journal.WriteNow(At(0.0)).ok());
  }
  Session other;
  EXPECT_FALSE(Recover(folder.path(), &other).damage);
  EXPECT_EQ(TextOf(other), TextOf(session));
  fs::remove(folder / "human.json");
  const std::string before = TextOf(other);
  const auto failed = RecoverJournal(Abandoned(folder.path())[0].file, &other);
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().place, "line 2");
  EXPECT_NE(failed.error().message.find("human.json"), std::string::npos);
  EXPECT_EQ(TextOf(other), before);
}

TEST(Recovery, GoesOnInAJournalOfItsOwn) {
  const TemporaryFolder folder;
  const std::string old = Crash(folder);
  std::string text;
  {
    Session session;
    Journal journal(&session, folder.path());
    Recover(folder.path(), &session);
    text = TextOf(session);
    ASSERT_TRUE(journal.WriteNow(At(0.0)).ok());
    ASSERT_TRUE(edit::DiscardJournal(old).ok());
  }  // and crashes again
  Session session;
  EXPECT_EQ(Recover(folder.path(), &session).num_operators, 4);
  EXPECT_EQ(TextOf(session), text);
}

TEST(Recovery, OfASnapshotAloneIsNotSavedEither) {
  const TemporaryFolder folder;
  std::string text;
  {
    Session session;
    Journal journal(&session, folder.path());
    SetKnee(&session, 3);
    Tick(&journal, 0.0);
    Tick(&journal, 120.0);
    text = TextOf(session);
  }
  Session session;
  {
    Journal journal(&session, folder.path());
    const std::string old = Abandoned(folder.path())[0].file;
    EXPECT_EQ(Recover(folder.path(), &session).num_operators, 0);
    ASSERT_TRUE(journal.WriteNow(At(0.0)).ok());
    ASSERT_TRUE(edit::DiscardJournal(old).ok());
  }
  Session other;
  Recover(folder.path(), &other);
  EXPECT_EQ(TextOf(other), text);
}

// Wherever writing stopped: nothing, or all operators whose lines are whole.
TEST(Recovery, LeavesOutALineThatWasCutOff) {
  const TemporaryFolder folder;
  const std::string file = Crash(folder), text = Read(file);
  const size_t base_end = text.find('\n', text.find('\n') + 1) + 1;
  for (size_t size = base_end; size <= text.size(); ++size) {
    Write(file, text.substr(0, size));
    Session session;
    const Recovered recovered = Recover(folder.path(), &session);
    const std::string whole = text.substr(0, text.rfind('\n', size - 1) + 1);
    EXPECT_FALSE(recovered.damage);
    EXPECT_EQ(recovered.is_cut_off, text[size - 1] != '\n') << size;
    int operators = 0;
    for (size_t at = 0; (at = whole.find("{\"op\"", at)) != std::string::npos; ++at) ++operators;
    ASSERT_EQ(recovered.num_operators, operators) << size;
    ASSERT_EQ(session.project().joints.empty() ? 0 : session.project().joints[0].value.keys.size(),
              static_cast<size_t>(operators));
  }
}

TEST(Recovery, SaysWhereAJournalIsDamagedAndWhatIsLeft) {
  const TemporaryFolder folder;
  const std::string file = Crash(folder);
  std::string text = Read(file);
  size_t line_6 = 0;
  for (int i = 1; i < 6; ++i) line_6 = text.find('\n', line_6) + 1;
  text[line_6] = '\0';
  Write(file, text);
  Session session;
  const Recovered recovered = Recover(folder.path(), &session);
  EXPECT_EQ(recovered.num_operators, 2);
  ASSERT_TRUE(recovered.damage);
  EXPECT_EQ(recovered.damage->file, file);
  EXPECT_EQ(recovered.damage->place, "line 6");
  EXPECT_EQ(recovered.damage->message,
            "is damaged; 2 of 3 operators were recovered; look at the project before you save it");
}

TEST(Recovery, SaysWhenTheProjectCameOutDifferent) {
  const TemporaryFolder folder;
  const std::string file = Crash(folder);
  std::string text = Read(file);
  text.replace(text.find("\"value\":30"), 10, "\"value\":31");
  Write(file, text);
  Session session;
  const Recovered recovered = Recover(folder.path(), &session);
  EXPECT_EQ(recovered.num_operators, 4);
  ASSERT_TRUE(recovered.damage);
  EXPECT_EQ(recovered.damage->place, "line 8");
}

TEST(Recovery, DoesNotTouchFiles) {
  const TemporaryFolder folder;
  const std::string file = Crash(folder), victim = folder / "victim.kfa";
  Write(file, Read(file) + R"({"op": "file.save", "path": ")" + victim + "\"}\n");
  Session session;
  EXPECT_TRUE(Recover(folder.path(), &session).damage);
  EXPECT_FALSE(fs::exists(victim));
}

// Any byte of the head, and some of the rest, may be anything.
TEST(Recovery, SurvivesAnyDamage) {
  const TemporaryFolder folder;
  const std::string file = Crash(folder), text = Read(file);
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    std::string damaged = text;
    const int last = static_cast<int>(text.size()) - 1;
    const int from_end = random.Chance(0.5) ? last - random.Integer(0, std::min(last, 600)) : 0;
    const int at = from_end ? from_end : random.Integer(0, random.Chance(0.5) ? 80 : last);
    damaged[at] = static_cast<char>(random.Integer(0, 255));
    Write(file, damaged);
    Session session;
    const std::vector<AbandonedJournal> journals = Abandoned(folder.path());
    ASSERT_EQ(journals.size(), 1u);
    const auto recovered = RecoverJournal(file, &session);
    // What cannot be recovered at all is found out at once, but for the project's own errors.
    if (journals[0].damage) {
      ASSERT_FALSE(recovered.ok());
      EXPECT_EQ(recovered.error().ToString(), journals[0].damage->ToString());
    } else if (!recovered.ok()) {
      EXPECT_EQ(recovered.error().place, "line 2");
    } else {
      EXPECT_LE(recovered.value().num_operators, 4);
      EXPECT_TRUE(recovered.value().num_operators == 4 || recovered.value().damage);
    }
  }
}

TEST(Recovery, RefusesWhatIsNoJournal) {
  const TemporaryFolder folder;
  const std::string file = folder / "1.journal";
  const auto error = [&](const std::string& text) {
    Write(file, text);
    Session session;
    const auto recovered = RecoverJournal(file, &session);
    EXPECT_TRUE(Abandoned(folder.path())[0].damage);
    return recovered.ok() ? "no error" : recovered.error().place + ": " + recovered.error().message;
  };
  EXPECT_EQ(error(""), "line 1: this is not a journal of Hazumi");
  EXPECT_EQ(error("[]\n"), "line 1: this is not a journal of Hazumi");
  EXPECT_EQ(error("{\"journal\": 2}\n"),
            "line 1: a journal of version 2; recover it with the Hazumi that wrote it");
  EXPECT_EQ(error("{\"journal\": 1, \"path\": 3}\n"), "line 1: does not say the document's path");
  const std::string damaged =
      "line 2: the project that the journal begins with is damaged; nothing can be recovered";
  EXPECT_EQ(error("{\"journal\": 1, \"path\": \"\"}\n"), damaged);
  EXPECT_EQ(error("{\"journal\": 1, \"path\": [47, 255]}\n\n"), damaged);
}

TEST(Recovery, ClearsUpWhatWasNotFinished) {
  const TemporaryFolder folder;
  Write(folder / "1.journal.new", "{\"journ");
  EXPECT_TRUE(Abandoned(folder.path()).empty());
  EXPECT_FALSE(fs::exists(folder / "1.journal.new"));
}

// After the crash, before the recovery.
TEST(Recovery, DoesNotSaveOverWhatAnotherProgramHasWritten) {
  const TemporaryFolder folder;
  const std::string project = folder / "jump.kfa";
  Crash(folder, project);
  Write(project, Read(project) + "\n");
  Session session;
  Recover(folder.path(), &session);
  EXPECT_NE(Refused(&session, "file.save", edit::Json::object()).message.find("another program"),
            std::string::npos);
  Do(&session, "file.save", {{"path", folder / "mine.kfa"}});
}

}  // namespace
}  // namespace hazumi::test
