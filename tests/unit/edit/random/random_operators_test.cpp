// Whatever is done can be undone and done again, to the byte, and what is saved is what was there.

#include "tests/unit/edit/random/random_operators.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "engine/project/project_reader.h"
#include "tests/support/from_environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/random/random_projects.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Operator;
using edit::Session;

constexpr int kOperatorsARun = 60, kRunsABlock = 40;
constexpr int kRuns = 60, kRunsMore = 20;  // more runs for an operator that was not done yet

// How often operators were tried, and were done.
struct Count {
  int tried = 0, done = 0;
};

// A document with all the states that it went through, each as its file would be.
class History {
 public:
  explicit History(Session* session) : session_(session) { Begin(); }

  // After an operator, of which `done` says whether it was done.
  void Note(const std::string& id, bool done) {
    if (number_ != session_->document_number()) return Begin();
    const edit::Document& document = session_->document();
    const std::string text = WriteProject(session_->project());
    const bool was_refused = !done && document.num_steps() == num_steps_;
    // Several steps at once, too.
    if ((id == "edit.undo" || id == "edit.redo") && done) at_ = document.undo_labels().size();
    if (id == "edit.cancel_drag" && done && document.num_steps() < num_steps_) --at_;
    const bool is_new = done && document.revision() != revision_ && id != "edit.undo" &&
                        id != "edit.redo" && id != "edit.cancel_drag";
    if (is_new) {
      // A drag goes on as the same step.
      at_ = document.num_steps();
      states_.resize(at_);
      states_.push_back(text);
      ExpectNothingHidden(id, text);
    }
    num_steps_ = document.num_steps();
    revision_ = document.revision();
    ASSERT_TRUE(done || was_refused) << id << " was refused and left a step";
    ASSERT_LT(at_, states_.size());
    ASSERT_EQ(text, states_[at_]) << id << (done ? " was done" : " was refused");
  }

  // To every state before and back again.
  void WalkToAndFro() {
    session_->document().EndMerge();
    const size_t end = at_;
    while (session_->document().Undo()) ExpectState(--at_);
    EXPECT_EQ(at_, 0u);
    while (session_->document().Redo()) ExpectState(++at_);
    EXPECT_GE(at_, end);
    num_steps_ = session_->document().num_steps();
    revision_ = session_->document().revision();
  }

 private:
  void Begin() {
    session_->document().set_history_limit(size_t{1} << 40);
    number_ = session_->document_number();
    num_steps_ = session_->document().num_steps();
    revision_ = session_->document().revision();
    at_ = 0;
    states_ = {WriteProject(session_->project())};
  }
  // The document holds no value that its file does not say: a later operator could bring it to
  // light.
  void ExpectNothingHidden(const std::string& id, const std::string& text) {
    const Result<Project> read = ParseProject(text, session_->document().path());
    ASSERT_TRUE(read.ok()) << id << ": " << read.error().ToString();
    const bool is_same = read.value() == session_->project();
    EXPECT_TRUE(is_same || hides_) << id << " hides a value";  // said once
    hides_ = !is_same;
  }
  void ExpectState(size_t i) {
    ASSERT_LT(i, states_.size());
    EXPECT_EQ(WriteProject(session_->project()), states_[i]) << "state " << i;
  }

  Session* session_;
  bool hides_ = false;  // the document holds a value that its file does not say
  long number_ = 0, revision_ = 0;
  size_t num_steps_ = 0, at_ = 0;
  std::vector<std::string> states_;
};

bool IsReplacing(const std::string& id) {
  return id == "file.open" || id == "file.new" || id == "file.import";
}

// What a file says is what the session had, and it can be animated as far as that could.
void SaveAndLoad(Session* session, const std::string& path) {
  Do(session, "file.save", {{"path", path}});
  const Result<Project> project = LoadProject(path);
  ASSERT_TRUE(project.ok()) << project.error().ToString();
  EXPECT_EQ(WriteProject(project.value()), WriteProject(session->project()));
  Session again;
  Do(&again, "file.open", {{"path", path}});
  EXPECT_EQ(again.animation() != nullptr, session->animation() != nullptr);
  EXPECT_EQ(again.WholeMotion().ok(), session->WholeMotion().ok());
}

// Every other operator of a run is the next one of a list of all in a fixed disorder, which goes on
// from run to run; where that cannot be done, and in between, it is any. A wanted operator is done
// half of the times that it can be.
const Operator& Next(int seed, int i, const std::string& wanted, const Session& session,
                     Random* random) {
  constexpr size_t kStride = 7919;  // a prime
  const std::vector<Operator>& all = edit::AllOperators();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Operator& op) { return op.id == wanted; });
  const bool can_be = found != all.end() && HasWhatItNeeds(wanted, found->parameters, session);
  if (can_be && random->Chance(0.5)) return *found;
  if (i % 2 == 0) {
    const size_t at = static_cast<size_t>(seed) * (kOperatorsARun / 2) + i / 2;
    const Operator& next = all[at * kStride % all.size()];
    if (HasWhatItNeeds(next.id, next.parameters, session)) return next;
  }
  return SomeThatCanBeDone(all, session, random);
}

// Runs of the same block have the same files.
class RandomRuns {
 public:
  explicit RandomRuns(int block) : files_(WriteRandomFiles(folder_.path(), block)) {
    std::filesystem::current_path(folder_.path());  // where names without a folder lead
  }
  ~RandomRuns() { std::filesystem::current_path(before_); }
  RandomRuns(const RandomRuns&) = delete;
  RandomRuns& operator=(const RandomRuns&) = delete;

  void Run(int seed, std::map<std::string, Count>* counts, const std::string& wanted = "") {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RestoreRandomFiles(files_);
    Random random(seed);
    Session session;
    const auto& projects = files_.projects;
    Do(&session, "file.open", {{"path", projects[seed % projects.size()]}});
    History history(&session);
    for (int i = 0; i < kOperatorsARun && !testing::Test::HasFatalFailure(); ++i) {
      const Operator& op = Next(seed, i, wanted, session, &random);
      const edit::Json parameters =
          RandomParameters(op.id, op.parameters, session, files_, &random);
      if (IsReplacing(op.id)) history.WalkToAndFro();
      const Result<Done> done = session.Run(op.id, parameters);
      Count& count = (*counts)[op.id];
      ++count.tried;
      count.done += done.ok();
      history.Note(op.id, done.ok());
    }
    history.WalkToAndFro();
    SaveAndLoad(&session, folder_ / "saved.kfa");
  }

 private:
  const std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
  RandomFiles files_;
};

// HAZUMI_CASES runs, else sixty, and some for each operator that these did not do.
TEST(RandomOperators, AreUndoneAndDoneAgainToTheByte) {
  const RandomCases cases(1, kRuns);
  std::map<std::string, Count> counts;
  std::optional<RandomRuns> runs;
  for (const int seed : cases) {
    if (HasFatalFailure()) break;
    if (!runs || seed % kRunsABlock == 0) runs.emplace(seed / kRunsABlock);
    runs->Run(seed, &counts);
  }
  const bool is_complete = cases.count() >= kRuns;
  for (const Operator& op : edit::AllOperators()) {
    for (int more = 0; is_complete && more < kRunsMore && counts[op.id].done == 0; ++more)
      runs->Run(1 + kRuns + more, &counts, op.id);
  }
  Count all;
  std::string never;
  for (const auto& [id, count] : counts) {
    all.tried += count.tried;
    all.done += count.done;
    if (count.done == 0) never += " " + id;
    if (std::getenv("HAZUMI_VERBOSE")) {
      std::printf("%-24s %6d tried %6d done\n", id.c_str(), count.tried, count.done);
    }
  }
  std::printf("%d of %d operators were done\n", all.done, all.tried);
  EXPECT_GE(2 * all.done, all.tried) << "at least half are to be done";
  if (!is_complete) return;
  EXPECT_EQ(counts.size(), edit::AllOperators().size()) << "each is tried";
  EXPECT_EQ(never, "") << "each is done once at least";
}

}  // namespace
}  // namespace hazumi::test
