// Random scripts of everything that the editor can do, as `--run` does them but that they go on
// after what is refused. Each batch of them is a process of its own, whose end tells of crashes.

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <new>

#include "engine/base/memory.h"
#include "tests/support/from_environment.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/commands/commands.h"
#include "tests/unit/edit/random/random_projects.h"
#include "ui/shell/scripted_editor.h"

namespace hazumi::test {
namespace {

constexpr int kCommandsAScript = 50;
constexpr int kScriptsABatch = 250;  // of one set of files, and in one process
#ifdef NDEBUG
constexpr double kLongest = 10.0;  // [s] of a command
#else
constexpr double kLongest = 40.0;  // the engine is a third as fast without optimisation
#endif
constexpr double kMostMemory = 1024.0;  // [MiB] of a process, but for a sanitizer's own

// What a batch tells, in memory that outlives it.
struct Told {
  int seed;          // of the script that runs
  char command[40];  // that runs
  long tried, done;
  double longest_s;
  char slowest[40];
  int slowest_seed;
};

class Batch {
 public:
  Batch(const RandomFiles& files, Told* told)
      : files_(files), commands_(AllCommands()), told_(told) {}

  void Run(int seed) {
    told_->seed = seed;
    RestoreRandomFiles(files_);
    Random random(seed);
    ui::ScriptedEditor scripted({320, 200});
    const std::string& project = files_.projects[seed % files_.projects.size()];
    (void)scripted.Do("file.open", {{"path", project}});
    for (int i = 0; i < kCommandsAScript; ++i) DoOne(&scripted, &random);
  }

 private:
  void DoOne(ui::ScriptedEditor* scripted, Random* random) {
    const edit::Session& session = scripted->editor().session();
    const Command& command = SomeThatCanBeDone(commands_, session, random);
    const edit::Json parameters =
        RandomParameters(command.id, command.parameters, session, files_, random);
    command.id.copy(told_->command, sizeof told_->command - 1);
    told_->command[std::min(command.id.size(), sizeof told_->command - 1)] = '\0';
    const std::clock_t start = std::clock();
    const bool done = scripted->Do(command.id, parameters).ok();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    ++told_->tried;
    told_->done += done;
    if (seconds <= told_->longest_s) return;
    told_->longest_s = seconds;
    told_->slowest_seed = told_->seed;
    std::copy(std::begin(told_->command), std::end(told_->command), told_->slowest);
  }

  const RandomFiles& files_;
  std::vector<Command> commands_;
  Told* told_;
};

class RandomScripts : public ::testing::Test {
 protected:
  RandomScripts() {
    void* memory =
        ::mmap(nullptr, sizeof(Told), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    told_ = new (memory) Told();
  }
  ~RandomScripts() override { ::munmap(told_, sizeof(Told)); }

  // Seeds from first up to last; goes on behind one that ends the process.
  void RunAll(int first, int last) {
    while (first <= last) {
      const int block = first / kScriptsABatch;
      const int end = std::min(last, (block + 1) * kScriptsABatch - 1);
      first = RunBatch(first, end) + 1;
    }
  }

  Told* told_;
  double most_memory_ = 0.0;  // [MiB] of a batch

 private:
  // Returns the last seed that was run.
  int RunBatch(int first, int last) {
    const TemporaryFolder folder;
    const bool had_failed = ::testing::Test::HasFailure();
    const pid_t child = ::fork();
    if (child == 0) {
      std::filesystem::current_path(folder.path());  // where names without a folder lead
      const RandomFiles files = WriteRandomFiles(folder.path(), first / kScriptsABatch);
      Batch batch(files, told_);
      for (int seed = first; seed <= last; ++seed) batch.Run(seed);
      std::_Exit(::testing::Test::HasFailure() && !had_failed ? 1 : 0);
    }
    int status = 0;
    rusage used = {};
    EXPECT_EQ(::wait4(child, &status, 0, &used), child);
    most_memory_ = std::max(most_memory_, used.ru_maxrss / 1024.0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return last;
    ADD_FAILURE() << "HAZUMI_FIRST_CASE=" << told_->seed << ", " << told_->command << ": "
                  << (WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "ended with an error");
    return told_->seed;
  }
};

// HAZUMI_CASES scripts, else forty; from HAZUMI_FIRST_CASE on.
TEST_F(RandomScripts, NeitherCrashNorTakeLongAndHalfOfWhatTheySayIsDone) {
  const RandomCases cases(1, 40);
  const int count = cases.count();
  RunAll(cases.first(), cases.first() + count - 1);
  std::printf(
      "%d scripts, %ld commands, %ld done, longest %.2f s (%s, seed %d), at most %.0f MiB\n", count,
      told_->tried, told_->done, told_->longest_s, told_->slowest, told_->slowest_seed,
      most_memory_);
  EXPECT_EQ(told_->tried, long{kCommandsAScript} * count);
  EXPECT_GE(2 * told_->done, told_->tried) << "at least half are to be done";
  if (kHasShadowMemory) return;
  EXPECT_LT(told_->longest_s, kLongest) << told_->slowest;
  EXPECT_LT(most_memory_, kMostMemory);
}

}  // namespace
}  // namespace hazumi::test
