// Whatever is read as an input is not written over, and files are told by where they lead.

#include "engine/base/input_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace hazumi::test {
namespace {

namespace fs = std::filesystem;

std::string Make(const std::string& path) {
  std::ofstream(path) << "text";
  return path;
}

TEST(FilePlace, ALinkLiesWhereItLeads) {
  const TemporaryFolder home, elsewhere;
  const std::string own = Make(home / "own"), other = Make(elsewhere / "other");
  fs::create_directory(home / "below");
  const std::string below = Make(home / "below/file");
  fs::create_symlink(other, home / "link");
  fs::create_symlink(home / "link", home / "link_of_link");
  fs::create_symlink(elsewhere.path(), home / "folder");
  fs::create_symlink(own, elsewhere / "back");
  EXPECT_TRUE(LiesIn(own, home.path()));
  EXPECT_TRUE(LiesIn(below, home.path()));
  EXPECT_TRUE(LiesIn(home / "below/../own", home.path()));
  EXPECT_TRUE(LiesIn(elsewhere / "back", home.path()));
  EXPECT_FALSE(LiesIn(home / "link", home.path()));
  EXPECT_FALSE(LiesIn(home / "link_of_link", home.path()));
  EXPECT_FALSE(LiesIn(home / "folder/other", home.path()));
  EXPECT_FALSE(LiesIn(home / "missing", home.path()));
  EXPECT_FALSE(LiesIn(home.path(), home.path()));
  EXPECT_FALSE(LiesIn(home.path() + "x", home.path()));
  EXPECT_EQ(FollowLinks(home / "link_of_link"), FollowLinks(other));
  EXPECT_EQ(FollowLinks(home / "folder/new"), FollowLinks(elsewhere / "new"));
}

TEST(InputFiles, NoneIsWrittenOverByWhateverName) {
  const TemporaryFolder folder;
  const std::string sound = Make(folder / "a.wav");
  fs::create_symlink(sound, folder / "link.png");
  EXPECT_FALSE(WhyKept(sound));
  KeepInput(sound, InputKind::kSound);
  for (const std::string& name : {sound, folder / "link.png", folder / "./a.wav"}) {
    const Result<Done> written = WriteFileAtomically(name, "other");
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().ToString(),
              name +
                  ": is the sound of a project that was read; nothing is written over it: name "
                  "another file");
    EXPECT_EQ(written.error().code, ErrorCode::kCannotWrite);
  }
  EXPECT_EQ(fs::file_size(sound), 4u);
  EXPECT_TRUE(WriteFileAtomically(folder / "b.wav", "other").ok());
}

TEST(InputFiles, WhatIsOfTheSameKindMayBe) {
  const TemporaryFolder folder;
  const std::string poses = Make(folder / "poses.json");
  KeepInput(poses, InputKind::kPoses);
  const auto write = [&](InputKind kind) {
    return WriteFileAtomically(poses, "other", WriteMode::kFast, nullptr, kind).ok();
  };
  EXPECT_TRUE(write(InputKind::kPoses));
  EXPECT_FALSE(write(InputKind::kProject));
  KeepInput(poses, InputKind::kScript);  // it is both
  EXPECT_FALSE(write(InputKind::kPoses));
}

}  // namespace
}  // namespace hazumi::test
