#include "app/cli/completion.h"

namespace hazumi {

namespace {

// Inside of '...' and, as _arguments wants it, of [...].
std::string ZshEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\'') {
      escaped += "'\\''";
    } else {
      if (c == '[' || c == ']' || c == '\\') escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string ZshFiles(const std::vector<std::string>& suffixes) {
  if (suffixes.front() == "/") return "_files -/";
  // One alone in parentheses would be a qualifier of the pattern.
  const std::string any = Joined(suffixes, "|");
  return "_files -g \"*." + (suffixes.size() == 1 ? any : "(" + any + ")") + "\"";
}

// As _arguments takes it: '--size=[what it is]:WxH:what to offer'.
std::string ZshSpec(const OptionRule& rule) {
  std::string spec = std::string("'") + rule.name + (rule.value ? "=" : "") + "[" +
                     ZshEscaped(ShortHelp(rule)) + "]";
  if (rule.value) spec += std::string(":") + rule.value + ":";
  if (rule.choices) spec += std::string("(") + rule.choices + ")";
  if (rule.files) spec += ZshFiles(Words(rule.files));
  return spec + "'";
}

std::string ZshIf(const std::vector<std::string>& tasks, const std::string& spec) {
  return "  [[ $task == (" + Joined(tasks, "|") + ") ]] && specs+=(" + spec + ")\n";
}

std::string ZshSpecs() {
  std::string text;
  for (const OptionRule& task : Tasks()) text += ZshIf({task.name, kNoTask}, ZshSpec(task));
  for (const OptionRule& rule : StandardOptions()) text += ZshIf({kNoTask}, ZshSpec(rule));
  for (const OptionRule& rule : TaskOptions()) text += ZshIf(TasksWith(rule.tasks), ZshSpec(rule));
  for (const FileKinds& kinds : FilesOfTasks()) {
    text += ZshIf(TasksWith(kinds.tasks), "'*:FILE:" + ZshFiles(kinds.suffixes) + "'");
  }
  return text;
}

}  // namespace

std::string ZshCompletion() {
  return "#compdef hazumi\n"
         "# What zsh completes calls of hazumi by. Written by: hazumi --completion zsh\n"
         "\n"
         "_hazumi() {\n"
         "  local task=editor word\n"
         "  local -a specs\n"
         "  for word in ${words[2,CURRENT-1]}; do\n"
         "    case ${word%%=*} in\n"
         "      " +
         Joined(TasksWith(~kWindow), "|") +
         ") task=${word%%=*} ;;\n"
         "    esac\n"
         "  done\n" +
         ZshSpecs() +
         "  _arguments $specs\n"
         "}\n"
         "\n"
         "if [[ $funcstack[1] == _hazumi ]]; then _hazumi \"$@\"; else compdef _hazumi hazumi; "
         "fi\n";
}

}  // namespace hazumi
