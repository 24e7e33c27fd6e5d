#include "app/cli/completion.h"

namespace hazumi {

namespace {

// Inside of '...'.
std::string FishQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string FishFiles(const std::vector<std::string>& suffixes) {
  if (suffixes.front() == "/") return "(__fish_complete_directories)";
  return "(__fish_complete_suffix ." + Joined(suffixes, " .") + ")";
}

std::string FishWhen(const std::vector<std::string>& tasks) {
  return "complete -c hazumi -n '__hazumi_task_is " + Joined(tasks, " ") + "'";
}

std::string FishLine(const std::vector<std::string>& tasks, const OptionRule& rule) {
  std::string line = FishWhen(tasks) + " -l " + std::string(rule.name).substr(2);
  if (rule.value) line += " -x";
  if (rule.choices) line += " -a " + FishQuoted(rule.choices);
  if (rule.files) line += " -a " + FishQuoted(FishFiles(Words(rule.files)));
  return line + " -d " + FishQuoted(ShortHelp(rule)) + "\n";
}

}  // namespace

std::string FishCompletion() {
  std::string text =
      "# What fish completes calls of hazumi by. Written by: hazumi --completion fish\n"
      "\n"
      "# Whether the task that is named, or editor, is one of these.\n"
      "function __hazumi_task_is\n"
      "    set -l task editor\n"
      "    for word in (commandline -opc | string replace -r '=.*' '')\n"
      "        if contains -- $word " +
      Joined(TasksWith(~kWindow), " ") +
      "\n"
      "            set task $word\n"
      "        end\n"
      "    end\n"
      "    contains -- $task $argv\n"
      "end\n"
      "\n"
      "complete -c hazumi -f\n";
  for (const OptionRule& task : Tasks()) text += FishLine({kNoTask, task.name}, task);
  for (const OptionRule& rule : StandardOptions()) text += FishLine({kNoTask}, rule);
  for (const OptionRule& rule : TaskOptions()) text += FishLine(TasksWith(rule.tasks), rule);
  for (const FileKinds& kinds : FilesOfTasks()) {
    text +=
        FishWhen(TasksWith(kinds.tasks)) + " -a " + FishQuoted(FishFiles(kinds.suffixes)) + "\n";
  }
  return text;
}

}  // namespace hazumi
