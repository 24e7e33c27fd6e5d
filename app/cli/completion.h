#pragma once

// What shells complete calls of hazumi by, from the table of options: names of tasks, then of the
// options that go with the task, the words that a value can be, and files of the right suffixes.

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"

namespace hazumi {

// `shell` is bash, zsh or fish, as --completion takes it. Empty for another one.
std::string CompletionFor(std::string_view shell);

std::string BashCompletion();
std::string ZshCompletion();
std::string FishCompletion();

// What they share.

// The task when none is named.
inline constexpr const char* kNoTask = "editor";

// The tasks that have one of these bits, as they are typed, and kNoTask.
std::vector<std::string> TasksWith(unsigned tasks);
std::vector<std::string> Words(std::string_view text);
std::string Joined(const std::vector<std::string>& words, std::string_view between);
// What is said of an option, as far as a list of choices has room for it: the first line or part.
std::string ShortHelp(const OptionRule& rule);

// Which files a FILE may be, and the tasks that take such.
struct FileKinds {
  unsigned tasks;
  std::vector<std::string> suffixes;
};
std::vector<FileKinds> FilesOfTasks();

}  // namespace hazumi
