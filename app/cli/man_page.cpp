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

// The same between .nf and .fi, where lines end as they do here.
std::string Verbatim(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    lines.append(lines.empty() ? "" : "\n").append(Roff(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::string Bold(std::string_view text) { return "\\fB" + Roff(text) + "\\fR"; }
std::string Italic(std::string_view text) { return "\\fI" + Roff(text) + "\\fR"; }

std::string PageHead() {
  std::string text = ".\\\" Written by: hazumi --man\n.TH HAZUMI 1 \"\" \"Hazumi ";
  text += Roff(kVersion) + "\" \"User Commands\"\n.SH NAME\nhazumi \\- " + Roff(kSummary) + "\n";
  return text;
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
    {"XDG_CONFIG_HOME", "Where the folder hazumi with settings and own poses is; ~/.config."},
    {"XDG_STATE_HOME",
     "Where the folder hazumi with what is kept safe from a crash is; ~/.local/state."},
    {"LC_ALL, LC_MESSAGES, LANG",
     "Japanese for the editor if the first of them that is set begins with ja, until the "
     "preferences say otherwise."},
};

constexpr Named kFiles[] = {
    {HAZUMI_PREFIX "/share/hazumi/examples",
     "Projects to begin with, and a sweep of one of them. A copy opens anywhere."},
    {HAZUMI_PREFIX "/share/hazumi/figures", "The human as a figure file."},
    {HAZUMI_PREFIX "/share/hazumi/schema",
     "JSON schemas of projects (.kfa), figures, poses and sweeps."},
    {HAZUMI_PREFIX "/share/doc/hazumi",
     "What Hazumi is (README.md), the examples and a first throw in five minutes "
     "(examples/README.md), sweeps (sweeps.md)."},
};

constexpr Named kSweepFields[] = {
    {"format, version", "\"hazumi-sweep\" and 1."},
    {"project", "The project that is varied, relative to the folder of the sweep file."},
    {"vary",
     "A list, of which each entry is an axis: field, the address of a field of the project, such "
     "as "
     "regions[arms].friction.default (hazumi --fields FILE lists them); also, a list of fields "
     "that "
     "are given the same value; and either values, a list, or numbers from, to and count, with a "
     "spacing that is linear, log or whole."},
    {"combine",
     "grid: every value with every other one, the last axis fastest; list: the first values "
     "together, then the second ones; random: count cells from seed, both beside it. Default: "
     "grid."},
    {"measure",
     "A list of what is measured: quantity (hazumi --quantities lists them), of what, at which "
     "frame, and a name for its column. Left out: where held objects land, height of the centre of "
     "mass, rates, limits that are hit, clearance, estimated error."},
    {"picture",
     "What is drawn of each cell: frames, a list, side by side, or video, true; options of "
     "drawing, "
     "a list of words as on the command line."},
};

constexpr const char* kSweepExample = R"({
  "format": "hazumi-sweep", "version": 1,
  "project": "throw.kfa",
  "vary": [
    {"field": "regions[arms].friction.default", "from": 0.5, "to": 1, "count": 6},
    {"field": "held_objects[ball].release_frame", "values": [7, 8]}
  ],
  "measure": [{"quantity": "landing_x_m", "of": "ball"}, {"quantity": "limit_hits"}],
  "picture": {"frames": [5, 8], "options": ["--size", "160x120"]}
})";

template <size_t kSize>
std::string Entries(const Named (&entries)[kSize]) {
  std::string text;
  for (const Named& entry : entries) {
    text += ".TP\n" + Bold(entry.name) + "\n" + Roff(entry.text) + "\n";
  }
  return text;
}

template <size_t kSize>
std::string PagePart(const char* title, const Named (&entries)[kSize]) {
  return std::string(".SH ").append(title).append("\n").append(Entries(entries));
}

std::string PageFiles() {
  return ".SH FILES\nWhere they are unless Hazumi was put elsewhere; else below the folder that "
         "its bin is "
         "in.\n" +
         Entries(kFiles);
}

std::string PageSweeps() {
  return ".SH SWEEP FILES\nWhat " + Bold("--sweep") +
         " reads: JSON. Each combination of values is a "
         "cell, one row of the table. Fields:\n" +
         Entries(kSweepFields) + ".PP\nAn example, beside a copy of throw.kfa:\n.PP\n.nf\n" +
         Verbatim(kSweepExample) + "\n.fi\n.PP\nIts schema is " +
         Italic(HAZUMI_PREFIX "/share/hazumi/schema/sweep.schema.json") + ".\n";
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
  return PageHead() + Synopsis() + Description() + PageEntries() + PageSweeps() + PageExits() +
         PagePart("ENVIRONMENT", kVariables) + PageFiles() + PageExamples() +
         ".SH SEE ALSO\n.BR ffmpeg (1)\n";
}

}  // namespace hazumi
