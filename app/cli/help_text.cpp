#include "app/cli/help_text.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/cli/option_table.h"

namespace hazumi {

namespace {

// Columns: the whole; where what is said of an option begins; where its default does, if it can.
constexpr size_t kWidth = 80, kTextColumn = 20, kFallbackColumn = 63;

constexpr ExitMeaning kExitMeanings[] = {
    {kExitOk, "ok"},
    {kExitFailed, "failed"},
    {kExitUsage, "usage"},
    {kExitBadData, "bad data"},
    {kExitNoInput, "no input"},
    {kExitCannotWrite, "cannot write"},
    {kExitInterrupted, "interrupted"},
};

constexpr CallExample kCallExamples[] = {
    {"--render out/throw throw.kfa", "out/throw/frame_0000.png and so on"},
    {"--render out/t_####.png --frames 5..15 --size 640x360 throw.kfa", ""},
    {"--bake motion.json --fps 60 jump.kfa", ""},
    {"--bake - jump.kfa | less", ""},
    {"--export throw.glb throw.kfa", ""},
    {"--export throw.mp4 --size 640x360 throw.kfa", ""},
    {"--check *.kfa", ""},
};

// Lines of at most `width` columns, broken at blanks and at '\n'.
std::vector<std::string> Wrapped(std::string_view text, size_t width) {
  std::vector<std::string> lines = {""};
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    std::string& line = lines.back();
    if (line.empty()) {
      line = word;
    } else if (line.size() + 1 + word.size() <= width) {
      line.append(" ").append(word);
    } else {
      lines.emplace_back(word);
    }
    if (end < text.size() && text[end] == '\n') lines.emplace_back();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void PadTo(size_t column, std::string* line) {
  if (line->size() < column) line->append(column - line->size(), ' ');
}

// The default behind what is said, in its column, farther to the left or on a line of its own.
void AddFallback(const std::string& fallback, std::vector<std::string>* lines) {
  const std::string text = "(" + fallback + ")";
  const size_t room = kWidth - kTextColumn - text.size();
  if (lines->back().size() + 2 > room) lines->emplace_back();
  PadTo(std::min(kFallbackColumn - kTextColumn, room), &lines->back());
  lines->back() += text;
}

// `says_default`: the first one tells what is in the parentheses.
std::string HelpEntry(const OptionRule& rule, bool says_default) {
  std::vector<std::string> lines = Wrapped(rule.help, kWidth - kTextColumn);
  if (rule.fallback) {
    AddFallback(std::string(says_default ? "default: " : "") + rule.fallback, &lines);
  }
  if (rule.more) {
    for (std::string& line : Wrapped(rule.more, kWidth - kTextColumn)) lines.push_back(line);
  }
  std::string text = std::string("  ") + rule.name;
  if (rule.value) text.append(" ").append(rule.value);
  // A long name has its line for itself.
  if (text.size() + 1 > kTextColumn) text += "\n" + std::string(kTextColumn, ' ');
  PadTo(kTextColumn, &text);
  for (size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) text += "\n" + std::string(kTextColumn, ' ');
    text += lines[i];
  }
  return text + "\n";
}

std::string HelpCalls() {
  std::string text = "  hazumi [FILE]                         the editor, in a window\n";
  for (const OptionRule& task : Tasks()) {
    if (task.call) text += std::string("  hazumi ") + task.name + " " + task.call + "\n";
  }
  return text;
}

std::string Paragraph(std::string_view words) {
  std::string text;
  for (const std::string& line : Wrapped(words, kWidth)) text += line + "\n";
  return text;
}

std::string HelpOptions() {
  std::string text;
  bool says_default = true;
  for (const SectionTitle& section : Sections()) {
    text += std::string("\n") + section.title + "\n";
    for (const OptionRule& rule : AllOptions()) {
      if (rule.section != section.section) continue;
      text += HelpEntry(rule, says_default);
      if (rule.fallback) says_default = false;
    }
  }
  return text;
}

std::string HelpExits() {
  std::string text;
  for (const ExitMeaning& exit : kExitMeanings) {
    text += (text.empty() ? "Exit codes: " : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  }
  return Paragraph(text + ".");
}

std::string HelpExamples() {
  std::string text = "\nExamples\n";
  for (const CallExample& example : kCallExamples) {
    std::string line = std::string("  hazumi ") + example.call;
    if (*example.remark) PadTo(45, &line);
    text += line + example.remark + "\n";
  }
  return text;
}

}  // namespace

std::span<const ExitMeaning> ExitMeanings() { return kExitMeanings; }
std::span<const CallExample> CallExamples() { return kCallExamples; }

std::string HelpText() {
  return std::string("Hazumi: ") + kSummary + "\n\n" + HelpCalls() + "\n" +
         Paragraph(kWhatFilesAre) + HelpOptions() + "\n" + Paragraph(kStreams) + HelpExits() +
         HelpExamples();
}

}  // namespace hazumi
