// What is not saved survives a crash. A journal that goes stands for one: its file stays.

#include "ui/edit/recovery/journal.h"

#include "tests/unit/edit/session/journals.h"

namespace hazumi::test {
namespace {

namespace fs = std::filesystem;
using edit::Journal;
using edit::Recovered;
using edit::Session;

class JournalTest : public testing::Test {
 protected:
  void Start() { journal_ = std::make_unique<Journal>(&session_, folder_.path()); }
  // Everything that is written so far is recovered as the session has it.
  void ExpectRecovery() {
    Recovered recovered;
    Session other;
    journal_.reset();
    recovered = Recover(folder_.path(), &other);
    EXPECT_FALSE(recovered.damage) << recovered.damage->ToString();
    EXPECT_EQ(TextOf(other), TextOf(session_));
    EXPECT_EQ(other.frame(), session_.frame());
    EXPECT_EQ(other.selected_joints(), session_.selected_joints());
    EXPECT_EQ(other.clipboard(), session_.clipboard());
    EXPECT_FALSE(other.document().is_saved());
  }
  void WriteAll() { EXPECT_TRUE(journal_->WriteNow(At(1000.0)).ok()); }
  void SetKnee(int frame, double value, const char* drag = nullptr) {
    edit::Json parameters = {{"curve", "r_knee"}, {"frame", frame}, {"value", value}};
    if (drag) parameters["drag"] = drag;
    Do(&session_, "key.set", parameters);
  }
  bool has_file() const { return !journal_->file().empty() && fs::exists(journal_->file()); }

  TemporaryFolder folder_;
  Session session_;
  std::unique_ptr<Journal> journal_;
};

TEST_F(JournalTest, WritesTwoSecondsAfterTheFirstChange) {
  Start();
  Tick(journal_.get(), 0.0);
  EXPECT_FALSE(journal_->next_deadline());
  SetKnee(5, 40.0);
  Tick(journal_.get(), 1.0);
  EXPECT_EQ(journal_->next_deadline(), At(3.0));
  SetKnee(6, 50.0);
  Tick(journal_.get(), 2.9);
  EXPECT_FALSE(has_file());
  EXPECT_EQ(journal_->next_deadline(), At(3.0));
  Tick(journal_.get(), 3.0);
  EXPECT_TRUE(has_file());
  EXPECT_EQ(journal_->next_deadline(), At(121.0));  // the autosave
  ExpectRecovery();
}

TEST_F(JournalTest, AppendsLaterOperators) {
  Start();
  SetKnee(5, 40.0);
  WriteAll();
  const auto size = fs::file_size(journal_->file());
  SetKnee(6, 50.0);
  Do(&session_, "edit.undo");
  Do(&session_, "edit.redo");
  WriteAll();
  EXPECT_LT(fs::file_size(journal_->file()), size + 500);  // the snapshot is not written again
  ExpectRecovery();
}

TEST_F(JournalTest, ReplaysWhatDependsOnTheSession) {
  Do(&session_, "region.add", {{"first", 5}, {"last", 20}, {"joints", {"r_shoulder+"}}});
  Do(&session_, "select.joints", {{"joints", {"r_shoulder", "r_elbow"}}});
  Do(&session_, "time.frame", {{"frame", 12}});
  Do(&session_, "pose.copy");
  Start();
  session_.document().MarkUnsaved();
  Do(&session_, "key.insert");  // of the selected joints as they swing
  Do(&session_, "time.frame", {{"frame", 3}});
  Do(&session_, "pose.paste", {{"flipped", true}});
  session_.set_frame(9);  // by no operator: playback
  Do(&session_, "pose.rotate", {{"joint", "l_knee"}, {"by", 7.5}});
  Do(&session_, "select.joints", {{"joints", {"chest"}}});
  session_.set_frame(10);
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, GoesWhenNothingIsUnsaved) {
  Start();
  const std::string path = folder_ / "knee.kfa";
  SetKnee(5, 40.0);
  WriteAll();
  EXPECT_TRUE(has_file());
  Do(&session_, "file.save", {{"path", path}});
  Tick(journal_.get(), 2000.0);
  EXPECT_FALSE(has_file());
  EXPECT_TRUE(Abandoned(folder_.path()).empty());
  EXPECT_FALSE(journal_->next_deadline());
  SetKnee(6, 40.0);
  WriteAll();
  EXPECT_TRUE(has_file());
  Do(&session_, "edit.undo");  // as saved
  Tick(journal_.get(), 2001.0);
  EXPECT_FALSE(has_file());
  Do(&session_, "edit.redo");
  WriteAll();
  EXPECT_TRUE(has_file());
  ExpectRecovery();
}

TEST_F(JournalTest, BeginsAnewWithAnotherDocument) {
  Start();
  SetKnee(5, 40.0);
  Do(&session_, "file.save", {{"path", folder_ / "a.kfa"}});
  Do(&session_, "file.new");
  SetKnee(6, 10.0);
  WriteAll();
  Do(&session_, "file.open", {{"path", folder_ / "a.kfa"}});
  Tick(journal_.get(), 1001.0);
  EXPECT_FALSE(has_file());
  SetKnee(7, 20.0);
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, UndoBeyondTheSnapshotTakesAnother) {
  for (int i = 0; i < 4; ++i) SetKnee(i, i);
  Do(&session_, "file.save", {{"path", folder_ / "a.kfa"}});
  Start();
  SetKnee(9, 9.0);
  WriteAll();
  Do(&session_, "edit.undo");
  Do(&session_, "edit.undo");
  Do(&session_, "edit.undo");
  SetKnee(8, 8.0);
  Do(&session_, "edit.undo");
  Do(&session_, "edit.undo");
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, RedoOfWhatWasUndoneBeforeTheSnapshotTakesAnother) {
  for (int i = 0; i < 4; ++i) SetKnee(i, i);
  Do(&session_, "edit.undo");
  Do(&session_, "edit.undo");
  Do(&session_, "file.save", {{"path", folder_ / "a.kfa"}});
  Start();
  Do(&session_, "edit.redo");
  Do(&session_, "edit.redo");
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, SnapshotsDoNotPutOffWriting) {
  for (int i = 0; i < 9; ++i) SetKnee(i, i);
  Do(&session_, "file.save", {{"path", folder_ / "a.kfa"}});
  Start();
  for (int i = 0; i < 9; ++i) {
    Do(&session_, "edit.undo");  // each beyond the snapshot
    Tick(journal_.get(), 0.25 * i);
  }
  ASSERT_TRUE(has_file());
  ExpectRecovery();
}

TEST_F(JournalTest, FollowsChangesThatAreNoOperators) {
  Start();
  SetKnee(5, 40.0);
  WriteAll();
  (void)session_.Edit("Rename", [](Project* project) -> Result<Done> {
    project->name = "by hand";
    return Done();
  });
  SetKnee(6, 41.0);
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, AutosavesTwoMinutesAfterTheFirstChange) {
  Start();
  for (int i = 0; i < 1000; ++i) SetKnee(i % 20, i);
  Tick(journal_.get(), 0.0);
  Tick(journal_.get(), 2.0);
  const auto before = fs::file_size(journal_->file());
  Tick(journal_.get(), 119.9);
  EXPECT_EQ(fs::file_size(journal_->file()), before);
  Tick(journal_.get(), 120.0);
  EXPECT_LT(fs::file_size(journal_->file()), before);  // a snapshot, and no operators
  EXPECT_FALSE(journal_->next_deadline());
  Do(&session_, "edit.undo");  // a step from before the snapshot
  SetKnee(3, 3.0);
  Tick(journal_.get(), 200.0);
  Tick(journal_.get(), 202.0);
  EXPECT_EQ(journal_->next_deadline(), At(320.0));
  ExpectRecovery();
}

TEST_F(JournalTest, DoesNotAutosaveInADrag) {
  Start();
  SetKnee(5, 1.0);
  Do(&session_, "time.frame", {{"frame", 5}});
  for (int i = 0; i < 200; ++i) SetKnee(5, i, "drag 1");
  Tick(journal_.get(), 0.0);
  Tick(journal_.get(), 2.0);
  const auto before = fs::file_size(journal_->file());
  SetKnee(5, 2.0, "drag 1");
  Tick(journal_.get(), 125.0);
  EXPECT_EQ(fs::file_size(journal_->file()), before);
  EXPECT_EQ(journal_->next_deadline(), At(127.0));  // to write, not to save
  Tick(journal_.get(), 127.0);
  EXPECT_GT(fs::file_size(journal_->file()), before);
  EXPECT_FALSE(journal_->next_deadline());
  Do(&session_, "edit.end_drag");
  Tick(journal_.get(), 128.0);
  EXPECT_LT(fs::file_size(journal_->file()), before);
  Do(&session_, "edit.undo");
  EXPECT_EQ(session_.project().joints[0].value.keys[0].value, 1.0);
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, OfTwoSessionsAreTwo) {
  Start();
  SetKnee(5, 40.0);
  WriteAll();
  Session other;
  Journal others(&other, folder_.path());
  Do(&other, "project.rename", {{"name", "other"}});
  ASSERT_TRUE(others.WriteNow(At(0.0)).ok());
  EXPECT_NE(others.file(), journal_->file());
  EXPECT_TRUE(Abandoned(folder_.path()).empty());  // both are alive
  ExpectRecovery();                                // now one is
  EXPECT_FALSE(edit::DiscardJournal(others.file()).ok());
  EXPECT_TRUE(fs::exists(others.file()));
}

TEST_F(JournalTest, IsGoneWhenDiscarded) {
  Start();
  SetKnee(5, 40.0);
  WriteAll();
  const std::string file = journal_->file();
  ASSERT_TRUE(journal_->Discard().ok());
  EXPECT_FALSE(fs::exists(file));
  SetKnee(6, 40.0);
  WriteAll();
  EXPECT_TRUE(journal_->file().empty());
}

TEST_F(JournalTest, IsWrittenAgainIfSomeoneRemovesIt) {
  Start();
  SetKnee(5, 40.0);
  WriteAll();
  fs::remove_all(folder_.path());
  SetKnee(6, 40.0);
  WriteAll();
  ExpectRecovery();
}

TEST_F(JournalTest, TriesAgainWhatCouldNotBeWritten) {
  const std::string blocked = folder_ / "file";
  ASSERT_TRUE(SaveProject(session_.project(), blocked).ok());
  journal_ = std::make_unique<Journal>(&session_, blocked + "/journals");
  SetKnee(5, 40.0);
  Tick(journal_.get(), 0.0);
  const Result<Done> written = journal_->Tick(At(2.0));
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(journal_->next_deadline(), At(4.0));
  fs::remove(blocked);
  Tick(journal_.get(), 4.0);
  journal_.reset();
  Session other;
  Recover(blocked + "/journals", &other);
  EXPECT_EQ(TextOf(other), TextOf(session_));
}

TEST_F(JournalTest, IsForItsOwnersEyesOnly) {
  journal_ = std::make_unique<Journal>(&session_, folder_ / "state");
  SetKnee(5, 40.0);
  WriteAll();
  EXPECT_EQ(fs::status(journal_->file()).permissions(), fs::perms(0600));
  EXPECT_EQ(fs::status(folder_ / "state").permissions(), fs::perms(0700));
}

}  // namespace
}  // namespace hazumi::test
