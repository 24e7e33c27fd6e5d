#include "app/cli/man_page.h"

#include <algorithm>
#include <string_view>

#include "app/cli/help_text.h"
#include "app/cli/option_table.h"
#include "engine/base/version.h"

namespace hazumi {

namespace {

// Text as troff prints it: a hyphen is the one that is typed, and no line is taken for a request.
std::string Roff(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const bool begins = plain.empty() || plain.back() == '\n';
    if (begins && (c == '.' || c == '\'')) plain += "\\&";
    if (c == '-') {
      plain += "\\-";
    } else if (c == '\\') {
      plain += "\\e";
    } else if (c == '\n') {
      plain += "\n.br\n";
    } else {
      plain += c;
    }
  }
  return plain;
}

std::string Bold(std::string_view text) { return "\\fB" + Roff(text) + "\\fR"; }
std::string Italic(std::string_view text) { return "\\fI" + Roff(text) + "\\fR"; }

std::string PageHead() {
  return std::string(".\\\" Written by: hazumi --man\n") + ".TH HAZUMI 1 \"\" \"Hazumi " +
         Roff(kVersion) + "\" \"User Commands\"\n.SH NAME\nhazumi \\- " + Roff(kSummary) + "\n";
}

// "OUT [options] FILE": capitals are words to be replaced.
std::string PageCall(std::string_view call) {
  std::string text;
  while (!call.empty()) {
    const size_t end = std::min(call.find(' '), call.size());
    const std::string_view word = call.substr(0, end);
    const bool is_option = word.find("--") != std::string_view::npos;
    text.append(text.empty() ? "" : " ").append(is_option ? Bold(word) : Italic(word));
    call.remove_prefix(std::min(end + 1, call.size()));
  }
  return text;
}

std::string Synopsis() {
  std::string text = ".SH SYNOPSIS\n.B hazumi\n[" + Italic("FILE") + "]\n";
  for (const OptionRule& task : Tasks()) {
    text.append(".br\n").append(Bold(std::string("hazumi ") + task.name));
    if (const char* rest = task.call ? task.call : task.value) {
      text.append(" ").append(PageCall(rest));
    }
    text += "\n";
  }
  return text;
}

std::string Description() {
  return ".SH DESCRIPTION\n"
         "Without a task: the editor, in a window, with FILE or a new project.\n.PP\n" +
         Roff(kWhatFilesAre) + "\n.PP\n" + Roff(kStreams) + "\n";
}

std::string PageEntry(const OptionRule& rule) {
  std::string text = ".TP\n" + Bold(rule.name);
  if (rule.value) text += " " + Italic(rule.value);
  text += "\n" + Roff(rule.help) + ".\n";
  if (rule.fallback) text += "Default: " + Roff(rule.fallback) + ".\n";
  if (rule.more) text += ".br\n" + Roff(rule.more) + ".\n";
  if (rule.section != Section::kTasks) {
    text += ".br\nGoes with " + Roff(TaskNames(rule.tasks)) + ".\n";
  }
  return text;
}

std::string PageEntries() {
  std::string text = ".SH OPTIONS\n";
  for (const SectionTitle& section : Sections()) {
    text += ".SS \"" + Roff(section.title) + "\"\n";
    for (const OptionRule& rule : AllOptions()) {
      if (rule.section == section.section) text += PageEntry(rule);
    }
  }
  return text;
}

std::string PageExits() {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : ExitMeanings()) {
    text += ".TP\n" + Bold(std::to_string(exit.code)) + "\n" + Roff(exit.meaning) + "\n";
  }
  return text;
}

struct Named {
  const char* name;
  const char* text;
};

constexpr Named kVariables[] = {
    {"HAZUMI_READER",
     "The program that opens files of other programs, if it is not hazumi-reader beside hazumi or "
     "in libexec/hazumi beside its folder."},
    {"XDG_CONFIG_HOME", "Where the folder hazumi with settings and own poses is; ~/.config."},
    {"XDG_STATE_HOME",
     "Where the folder hazumi with what is kept safe from a crash is; ~/.local/state."},
    {"LC_ALL, LC_MESSAGES, LANG",
     "Japanese for the editor if the first of them that is set begins with ja, until the "
     "preferences say otherwise."},
};

constexpr Named kFiles[] = {
    {"share/hazumi/examples", "Projects to begin with, below the folder of the installation."},
    {"share/hazumi/schema", "JSON schemas of projects (.kfa), figures and poses."},
};

template <size_t kSize>
std::string PagePart(const char* title, const Named (&entries)[kSize]) {
  std::string text = std::string(".SH ") + title + "\n";
  for (const Named& entry : entries) {
    text += ".TP\n" + Bold(entry.name) + "\n" + Roff(entry.text) + "\n";
  }
  return text;
}

std::string PageExamples() {
  std::string text = ".SH EXAMPLES\n";
  for (const CallExample& example : CallExamples()) {
    text += ".TP\n" + Bold(std::string("hazumi ") + example.call) + "\n";
    text += *example.remark ? Roff(example.remark) + "\n" : "";
  }
  return text;
}

}  // namespace

std::string ManPage() {
  return PageHead() + Synopsis() + Description() + PageEntries() + PageExits() +
         PagePart("ENVIRONMENT", kVariables) + PagePart("FILES", kFiles) + PageExamples() +
         ".SH SEE ALSO\n.BR ffmpeg (1)\n";
}

}  // namespace hazumi
