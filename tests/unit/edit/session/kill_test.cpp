// An editor that is killed at any moment loses no more than its journal promises, and the file on
// the disk is whole. Each case forks an editor that does what it likes, and kills it.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <thread>

#include "engine/project/project_reader.h"
#include "tests/support/from_environment.h"
#include "tests/unit/edit/random/random_operators.h"
#include "tests/unit/edit/session/journals.h"
#include "ui/edit/document/document.h"

namespace hazumi::test {
namespace {

using edit::Journal;
using edit::Json;
using edit::Session;
using Clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

constexpr edit::JournalTimes kTimes = {milliseconds(40), milliseconds(150)};

// What the editor tells of itself. It is in the file when the call returns: a kill loses none.
enum class Event : uint64_t { kOperator, kTicked, kSaving, kSaved };
struct Note {
  Event event;
  char digest[16];  // of the document
  int64_t time_ns;  // kTicked: when the tick began
};

nanoseconds Now() { return Clock::now().time_since_epoch(); }

std::string DigestOf(const Session& session) { return edit::DigestOf(TextOf(session)); }

class Editor {
 public:
  Editor(const TemporaryFolder& folder, uint64_t seed)
      : random_(seed),
        project_(folder / "project.kfa"),
        notes_(::open((folder / "notes").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600)),
        journal_(&session_, folder / "journals", kTimes) {
    for (const edit::Operator& op : edit::AllOperators()) {
      const std::string id = op.id;
      // Files are saved otherwise; whole motions take too long for many operators in little time.
      if (!id.starts_with("file.") && id != "region.to_keys") operators_.push_back(&op);
    }
  }

  [[noreturn]] void Run() {
    Tell(Event::kOperator, Now());
    for (;;) {
      if (random_.Chance(0.02)) {
        Save();
      } else if (random_.Chance(0.1)) {
        Drag();
      } else {
        RunAny();
      }
      Tick();
    }
  }

 private:
  void Tell(Event event, nanoseconds time) {
    Note note = {event, {}, time.count()};
    DigestOf(session_).copy(note.digest, sizeof note.digest);
    if (::write(notes_, &note, sizeof note) != sizeof note) ::_exit(3);
  }

  void Tick() {
    const Clock::time_point now = Clock::now();
    if (!journal_.Tick(now).ok()) ::_exit(4);
    Tell(Event::kTicked, now.time_since_epoch());
  }

  void RunAny() {
    const int last = static_cast<int>(operators_.size()) - 1;
    const edit::Operator& op =
        random_.Chance(0.2) ? *edit::FindOperator(random_.Chance(0.6) ? "edit.undo" : "edit.redo")
                            : *operators_[random_.Integer(0, last)];
    (void)session_.Run(op.id,
                       RandomParameters(op.id, op.parameters, session_, RandomFiles(), &random_));
    Tell(Event::kOperator, Now());
  }

  void Drag() {
    const std::string drag = "drag " + std::to_string(++num_drags_);
    for (int i = random_.Integer(2, 20); i > 0; --i) {
      (void)session_.Run(
          "key.set",
          {{"curve", "r_knee"}, {"frame", 5}, {"value", random_.Integer(0, 3)}, {"drag", drag}});
      Tell(Event::kOperator, Now());
      if (random_.Chance(0.5)) Tick();
    }
    if (random_.Chance(0.8)) (void)session_.Run("edit.end_drag");
  }

  void Save() {
    Tell(Event::kSaving, Now());
    if (!session_.Run("file.save", {{"path", project_}}).ok()) ::_exit(5);
    Tell(Event::kSaved, Now());
  }

  Random random_;
  std::string project_;
  int notes_;
  Session session_;
  Journal journal_;
  std::vector<const edit::Operator*> operators_;
  int num_drags_ = 0;
};

std::vector<Note> ReadNotes(const std::string& path) {
  std::vector<Note> notes;
  std::FILE* file = std::fopen(path.c_str(), "rb");
  Note note;
  while (file && std::fread(&note, sizeof note, 1, file) == 1) notes.push_back(note);
  if (file) std::fclose(file);
  return notes;
}

std::string Digest(const Note& note) { return {note.digest, sizeof note.digest}; }

// What the file may hold: what was saved last, or what was being saved.
void CheckFile(const std::string& path, const std::vector<Note>& notes) {
  std::string saved, saving;
  for (const Note& note : notes) {
    if (note.event == Event::kSaved) saved = Digest(note);
    if (note.event == Event::kSaving) saving = Digest(note);
  }
  if (!std::filesystem::exists(path)) {
    EXPECT_EQ(saved, "") << "the file is gone";
    return;
  }
  const Result<Project> project = LoadProject(path);
  ASSERT_TRUE(project.ok()) << project.error().ToString();
  const std::string found = edit::DigestOf(WriteProject(project.value()));
  EXPECT_TRUE(found == saved || found == saving) << found << " " << saved << " " << saving;
}

// The document as a user has it again after the crash.
std::string RecoveredDigest(const TemporaryFolder& folder) {
  Session session;
  const std::vector<edit::AbandonedJournal> journals = Abandoned(folder / "journals");
  EXPECT_LE(journals.size(), 1u);
  if (!journals.empty()) {
    const auto recovered = edit::RecoverJournal(journals[0].file, &session);
    EXPECT_TRUE(recovered.ok()) << (recovered.ok() ? "" : recovered.error().ToString());
    if (recovered.ok() && recovered.value().damage) {
      ADD_FAILURE() << recovered.value().damage->ToString();
    }
  } else if (std::filesystem::exists(folder / "project.kfa")) {
    Do(&session, "file.open", {{"path", folder / "project.kfa"}});
  }
  return DigestOf(session);
}

// No change is lost that was older than the journal's time when it had its last chance to write.
// What came after that tick began was younger still, or the editor was in the midst of it.
void CheckLoss(const std::string& recovered, const std::vector<Note>& notes) {
  nanoseconds tick(0);
  for (const Note& note : notes) {
    if (note.event == Event::kTicked) tick = nanoseconds(note.time_ns);
  }
  const nanoseconds must_have = tick - kTimes.write_after;
  bool is_known = false, is_recent = false;
  for (size_t i = 0; i < notes.size(); ++i) {
    if (Digest(notes[i]) != recovered) continue;
    is_known = true;
    // It held until another one came.
    size_t next = i;
    while (next < notes.size() && Digest(notes[next]) == recovered) ++next;
    // The journal counts from the tick that first sees a change.
    while (next < notes.size() && notes[next].event != Event::kTicked) ++next;
    is_recent |= next == notes.size() || nanoseconds(notes[next].time_ns) > must_have;
  }
  EXPECT_TRUE(is_known) << "a document that never was";
  EXPECT_TRUE(is_recent) << "more is lost than the journal promises";
}

// Waits until an editor has written its first journal, on a machine of any speed.
void WaitForJournal(const std::string& folder) {
  while (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
    std::this_thread::sleep_for(milliseconds(1));
  }
}

// Of one editor that was killed: whether there was a journal. The moment is counted from its start,
// with every second one from its first journal.
bool KillOne(uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  const TemporaryFolder folder;
  Random random(seed);
  const pid_t child = ::fork();
  if (child == 0) Editor(folder, seed).Run();
  if (seed % 2 == 0) WaitForJournal(folder / "journals");
  std::this_thread::sleep_for(std::chrono::microseconds(random.Integer(1'000, 500'000)));
  EXPECT_EQ(::kill(child, SIGKILL), 0);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
      << "it ended by itself with " << WEXITSTATUS(status);
  const std::vector<Note> notes = ReadNotes(folder / "notes");
  CheckFile(folder / "project.kfa", notes);
  const bool has_journal = !Abandoned(folder / "journals").empty();
  if (!notes.empty()) CheckLoss(RecoveredDigest(folder), notes);
  return has_journal;
}

// HAZUMI_CASES kills, else twenty.
TEST(Kill, LosesNoMoreThanTheJournalPromises) {
  const RandomCases cases(1, 20);
  int num_journals = 0;
  for (const int seed : cases) num_journals += KillOne(static_cast<uint64_t>(seed));
  EXPECT_GT(num_journals, cases.count() / 4);  // enough runs had work to lose
}

}  // namespace
}  // namespace hazumi::test
