#include "app/cli/option_table.h"

#include <utility>

#include "app/cli/table/sections.h"

namespace hazumi {

namespace {

constexpr OptionRule kStandard[] = {
    {.name = "--help", .help = "say all this"},
    {.name = "--version", .help = "say the version, and the commit that it was built from"},
};

constexpr SectionTitle kSections[] = {
    {Section::kTasks, "Tasks"},
    {Section::kDrawing, "Drawing, with --render and --export to .mp4"},
    {Section::kForeignFiles, "Reading files of other programs"},
    {Section::kMotion, "Motion, with any task, instead of what the file and its regions say"},
    {Section::kOutput, "Output"},
    {Section::kSweep, "Sweeps, with --sweep"},
    {Section::kEditor, "Editor"},
};

std::vector<OptionRule> Together(const std::vector<std::span<const OptionRule>>& parts) {
  std::vector<OptionRule> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::span<const OptionRule> Tasks() { return TaskRules(); }

std::span<const OptionRule> TaskOptions() {
  static const std::vector<OptionRule> kOptions =
      Together({DrawingRules(), ForeignFileRules(), MotionRules(), OutputRules(), SweepRules(),
                EditorRules()});
  return kOptions;
}

std::span<const OptionRule> StandardOptions() { return kStandard; }
std::span<const SectionTitle> Sections() { return kSections; }

std::vector<OptionRule> AllOptions() {
  return Together({Tasks(), StandardOptions(), TaskOptions()});
}

std::string TaskNames(unsigned tasks) {
  std::string text;
  const auto add = [&](unsigned named, const std::string& name) {
    if ((named & tasks) != named) return;
    tasks &= ~named;
    text += (text.empty() ? "" : tasks ? ", " : " and ") + name;
  };
  for (const OptionRule& task : TaskRules()) add(task.tasks, task.name);
  for (const auto& [format, suffix] : {std::pair(kBvh, ".bvh"), std::pair(kJson, ".json"),
                                       std::pair(kCsv, ".csv"), std::pair(kVideo, ".mp4")})
    add(format, std::string("--export to ") + suffix);
  add(kWindow, "the editor");
  return text;
}

}  // namespace hazumi
