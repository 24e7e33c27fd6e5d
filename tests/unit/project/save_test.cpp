#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/unit/project/sample.h"

namespace hazumi::testing {
namespace {

// While it lives, files cannot grow beyond `bytes`: a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &old_); }

 private:
  rlimit old_{};
};

mode_t PermissionsOf(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 0777;
}

TEST(SaveProject, WritesWhatLoads) {
  const TemporaryFolder folder;
  const Project project = ParseGood(SampleProject());
  ASSERT_TRUE(SaveProject(project, folder / "a.kfa").ok());
  EXPECT_EQ(ReadFile(folder / "a.kfa"), WriteProject(project));
  EXPECT_EQ(folder.num_entries(), 1u);
  EXPECT_TRUE(LoadProject(folder / "a.kfa").ok());
}

TEST(SaveProject, KeepsPermissionsAndFollowsLinks) {
  const TemporaryFolder folder;
  WriteFile(folder / "real.kfa", "old");
  std::filesystem::create_symlink("real.kfa", folder / "link.kfa");
  ASSERT_EQ(::chmod((folder / "real.kfa").c_str(), 0640), 0);
  const Project project = ParseGood(SampleProject());
  ASSERT_TRUE(SaveProject(project, folder / "link.kfa").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.kfa"));
  EXPECT_EQ(ReadFile(folder / "real.kfa"), WriteProject(project));
  EXPECT_EQ(PermissionsOf(folder / "real.kfa"), 0640u);
  EXPECT_EQ(folder.num_entries(), 2u);
}

TEST(SaveProject, AFailureLeavesTheOldFileAndNoTemporary) {
  const TemporaryFolder folder;
  WriteFile(folder / "a.kfa", "old");
  const FileSizeLimit full_disk(1000);
  const Result<Done> saved = SaveProject(ParseGood(SampleProject()), folder / "a.kfa");
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().code, ErrorCode::kCannotWrite);
  EXPECT_EQ(ReadFile(folder / "a.kfa"), "old");
  EXPECT_EQ(folder.num_entries(), 1u);
}

TEST(SaveProject, CannotReplaceAFolderOrWriteIntoNone) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.kfa");
  const Project project = ParseGood(SampleProject());
  for (const char* path : {"a.kfa", "missing/a.kfa"}) {
    const Result<Done> saved = SaveProject(project, folder / path);
    ASSERT_FALSE(saved.ok()) << path;
    EXPECT_EQ(saved.error().code, ErrorCode::kCannotWrite);
    EXPECT_EQ(saved.error().file, folder / path);
  }
  EXPECT_EQ(folder.num_entries(), 1u);
}

// Runs as an ordinary user who owns the folder while this object exists, since root may write
// anywhere.
class AnyUser {
 public:
  explicit AnyUser(const std::string& folder) {
    if (!was_root_) return;
    EXPECT_EQ(::chown(folder.c_str(), kNobody, -1u), 0);
    EXPECT_EQ(::seteuid(kNobody), 0);
  }
  ~AnyUser() {
    if (!was_root_) return;
    EXPECT_EQ(::seteuid(0), 0);
  }
  AnyUser(const AnyUser&) = delete;
  AnyUser& operator=(const AnyUser&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  const bool was_root_ = ::geteuid() == 0;
};

TEST(SaveProject, CannotWriteIntoAReadOnlyFolder) {
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0500), 0);
  const Result<Done> saved = [&] {
    const AnyUser any(folder.path());
    return SaveProject(ParseGood(SampleProject()), folder / "a.kfa");
  }();
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().message, "cannot be written: Permission denied");
  EXPECT_EQ(folder.num_entries(), 0u);
}

}  // namespace
}  // namespace hazumi::testing
