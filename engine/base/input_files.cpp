#include "engine/base/input_files.h"

#include <filesystem>
#include <mutex>
#include <set>
#include <utility>

namespace hazumi {

namespace fs = std::filesystem;

std::string FollowLinks(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : target.string();
}

bool LiesIn(const std::string& file, const std::string& folder) {
  std::error_code failed;
  const fs::path target = fs::canonical(file, failed);
  if (failed) return false;
  const fs::path around = fs::canonical(folder.empty() ? "." : folder, failed);
  if (failed) return false;
  const fs::path inside = target.lexically_relative(around);
  return !inside.empty() && *inside.begin() != ".." && inside != ".";
}

namespace {

const char* NameOf(InputKind kind) {
  switch (kind) {
    case InputKind::kProject:
      return "a project";
    case InputKind::kFigure:
      return "the figure of a project";
    case InputKind::kSound:
      return "the sound of a project";
    case InputKind::kReference:
      return "the reference of a project";
    case InputKind::kPoses:
      return "a pose library";
    case InputKind::kSweep:
      return "a sweep";
    case InputKind::kScript:
      return "a script";
  }
  HAZUMI_DEMAND(false);
}

// One list for the whole process: a file that one part reads is no output for another part.
struct InputFiles {
  std::mutex mutex;
  std::set<std::pair<std::string, InputKind>> all;
};

InputFiles& Inputs() {
  static InputFiles files;
  return files;
}

}  // namespace

void KeepInput(const std::string& path, InputKind kind) {
  if (path.empty()) return;
  std::pair<std::string, InputKind> input(FollowLinks(path), kind);
  const std::lock_guard lock(Inputs().mutex);
  Inputs().all.insert(std::move(input));
}

std::optional<Error> WhyKept(const std::string& path, std::optional<InputKind> own) {
  const std::string target = FollowLinks(path);
  const std::lock_guard lock(Inputs().mutex);
  const auto& all = Inputs().all;
  for (auto input = all.lower_bound({target, InputKind::kProject});
       input != all.end() && input->first == target; ++input) {
    if (input->second == own) continue;
    return Error{ErrorCode::kCannotWrite, path, "",
                 std::string("is ") + NameOf(input->second) +
                     " that was read; nothing is written over it: name another file"};
  }
  return std::nullopt;
}

}  // namespace hazumi
