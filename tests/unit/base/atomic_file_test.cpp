// Files are written all or nothing, and what a killed process left does not stay.

#include "engine/base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace hazumi::test {
namespace {

const std::string kLong(size_t{32} << 20, 'x');

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void WriteFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

bool HasHidden(const TemporaryFolder& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.path().filename().string().starts_with('.')) return true;
  }
  return false;
}

// Starts a process that writes the file, and kills it as soon as it has begun to.
void KillWhileWriting(const TemporaryFolder& folder, const std::string& path) {
  const pid_t child = ::fork();
  if (child == 0) {
    ReplaceFile(path, kLong, WriteMode::kDurable);
    ::_exit(0);
  }
  int status = 0;
  while (!HasHidden(folder) && ::waitpid(child, &status, WNOHANG) == 0) {
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, &status, 0);
}

TEST(ReplaceFile, RemovesWhatAKilledProcessLeft) {
  const TemporaryFolder folder;
  for (int i = 0; i < 100 && !HasHidden(folder); ++i) KillWhileWriting(folder, folder / "a.kfa");
  ASSERT_TRUE(HasHidden(folder)) << "no process could be killed while it wrote";
  ASSERT_EQ(ReplaceFile(folder / "a.kfa", "new", WriteMode::kDurable), 0);
  EXPECT_FALSE(HasHidden(folder));
  EXPECT_EQ(folder.num_entries(), 1u);
  EXPECT_EQ(ReadFile(folder / "a.kfa"), "new");
}

TEST(ReplaceFile, SeveralThatWriteOneFileDoNotDisturbEachOther) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.kfa";
  std::vector<pid_t> children;
  for (const char letter : {'a', 'b', 'c', 'd'}) {
    children.push_back(::fork());
    if (children.back() != 0) continue;
    int failed = 0;
    const std::string own(100000, letter);
    for (int i = 0; i < 200; ++i) failed |= ReplaceFile(path, own, WriteMode::kFast);
    ::_exit(failed == 0 ? 0 : 1);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  const std::string text = ReadFile(path);
  EXPECT_EQ(text, std::string(100000, text[0]));
  EXPECT_EQ(folder.num_entries(), 1u);
}

TEST(ReplaceFile, LeavesAloneWhatIsNotItsOwn) {
  const TemporaryFolder folder;
  WriteFile(folder / "precious", "mine");
  std::filesystem::create_symlink("precious", folder / ".a.kfa.tmp");
  ASSERT_EQ(::mkfifo((folder / ".a.kfa.1.tmp").c_str(), 0600), 0);
  std::filesystem::create_directory(folder / ".a.kfa.2.tmp");
  ASSERT_EQ(ReplaceFile(folder / "a.kfa", "new", WriteMode::kFast), 0);
  EXPECT_EQ(ReadFile(folder / "a.kfa"), "new");
  EXPECT_EQ(ReadFile(folder / "precious"), "mine");
  EXPECT_EQ(folder.num_entries(), 5u);
}

TEST(ReplaceFile, CancelledLeavesTheOldFileAlone) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.kfa", "old");
  const std::atomic<bool> cancel = true;
  EXPECT_EQ(ReplaceFile(folder / "a.kfa", "new", WriteMode::kFast, &cancel), ECANCELED);
  EXPECT_EQ(ReadFile(folder / "a.kfa"), "old");
  EXPECT_EQ(folder.num_entries(), 1u);
}

}  // namespace
}  // namespace hazumi::test
