#include "app/cli/completion.h"

namespace hazumi {

namespace {

constexpr const char* kBashHead =
    R"bash(# What bash completes calls of hazumi by. Written by: hazumi --completion bash

# Folders, and files with one of the suffixes named, "/" for folders alone.
_hazumi_files() {
  local suffix IFS=$'\n'
  compopt -o filenames 2>/dev/null
  if declare -F _filedir >/dev/null; then
    case $1 in
      /) _filedir -d ;;
      *) _filedir "@($(IFS='|'; echo "$*"))" ;;
    esac
    return
  fi
  COMPREPLY=($(compgen -d -- "$cur"))
  for suffix in "$@"; do
    [[ $suffix == / ]] || COMPREPLY+=($(compgen -f -X "!*.$suffix" -- "$cur"))
  done
}

_hazumi() {
  local cur=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]}
  local task=editor word options
  COMPREPLY=()
  # bash takes --size=6 for three words.
  if [[ $cur == = ]]; then
    cur=
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-2]}
  fi
)bash";

std::string BashTaskSearch() {
  return "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case $word in\n"
         "      " +
         Joined(TasksWith(~kWindow), "|") +
         ") task=$word ;;\n"
         "    esac\n"
         "  done\n";
}

std::string BashValue(const OptionRule& rule) {
  const std::string beginning = std::string("    ") + rule.name + ") ";
  if (rule.choices) {
    return beginning + "COMPREPLY=($(compgen -W '" + rule.choices + "' -- \"$cur\")); return ;;\n";
  }
  if (rule.files) return beginning + "_hazumi_files " + rule.files + "; return ;;\n";
  return beginning + "return ;;\n";
}

std::string BashValues() {
  std::string text = "  case $option in\n";
  for (const OptionRule& rule : AllOptions()) {
    if (rule.value) text += BashValue(rule);
  }
  return text + "  esac\n";
}

// The names of options that go with a task; without one those of the tasks as well.
std::string BashNamesBeside(unsigned task) {
  std::vector<std::string> names;
  for (const OptionRule& rule : TaskOptions()) {
    if (rule.tasks & task) names.push_back(rule.name);
  }
  if (task != kWindow) return Joined(names, " ");
  for (const OptionRule& rule : Tasks()) names.push_back(rule.name);
  for (const OptionRule& rule : StandardOptions()) names.push_back(rule.name);
  return Joined(names, " ");
}

std::string BashNames() {
  std::string text = "  case $task in\n";
  for (const OptionRule& task : Tasks()) {
    text +=
        std::string("    ") + task.name + ") options='" + BashNamesBeside(task.tasks) + "' ;;\n";
  }
  return text + "    *) options='" + BashNamesBeside(kWindow) + "' ;;\n  esac\n";
}

std::string BashFiles() {
  std::string text = "  [[ $cur == -* ]] || case $task in\n";
  for (const FileKinds& kinds : FilesOfTasks()) {
    text += "    " + Joined(TasksWith(kinds.tasks), "|") + ") _hazumi_files " +
            Joined(kinds.suffixes, " ") + "; return ;;\n";
  }
  return text + "  esac\n";
}

}  // namespace

std::string BashCompletion() {
  return kBashHead + BashTaskSearch() + BashValues() + BashNames() + BashFiles() +
         "  COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
         "}\n"
         "complete -F _hazumi hazumi\n";
}

}  // namespace hazumi
