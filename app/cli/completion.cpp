#include "app/cli/completion.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace hazumi {

std::string CompletionFor(std::string_view shell) {
  if (shell == "bash") return BashCompletion();
  if (shell == "zsh") return ZshCompletion();
  return shell == "fish" ? FishCompletion() : "";
}

std::vector<std::string> TasksWith(unsigned tasks) {
  std::vector<std::string> names;
  for (const OptionRule& task : Tasks()) {
    if (task.tasks & tasks) names.push_back(task.name);
  }
  if (tasks & kWindow) names.push_back(kNoTask);
  return names;
}

std::vector<std::string> Words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string Joined(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) text.append(text.empty() ? "" : between).append(word);
  return text;
}

std::string ShortHelp(const OptionRule& rule) {
  const std::string_view help = rule.help;
  return std::string(help.substr(0, std::min(help.find_first_of(";\n"), help.find(", such as"))));
}

std::vector<FileKinds> FilesOfTasks() {
  std::vector<std::string> both = {kProjectSuffix};
  for (const std::string& suffix : Words(kCharacterSuffixes)) both.push_back(suffix);
  return {{kCharacters, both}, {kProjects & ~kCharacters, {kProjectSuffix}}};
}

}  // namespace hazumi
