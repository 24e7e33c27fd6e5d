// How motion is computed, instead of what the file and its regions say.

#include "app/cli/option_values.h"
#include "app/cli/table/sections.h"
#include "engine/project/fields/project_fields.h"

namespace hazumi {

namespace {

// As in files.
template <const Field& kField, std::optional<double> Options::*kMember>
bool ReadField(const std::string& text, Options* options) {
  const auto number = ReadFinite(text);
  return number && *number >= kField.range.lower && *number <= kField.range.upper &&
         Keep(number, &(options->*kMember));
}

bool ReadMethod(const std::string& text, Options* options) {
  for (const auto& method : EnumNames<Method>::kNames) {
    if (text == method.name) options->method = method.value;
  }
  return options->method.has_value();
}

constexpr OptionRule kMotionRules[] = {
    {.name = "--method",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "M",
     .help = "exact, or paper: the steps of the published method",
     .choices = "exact paper",
     .remedy = "the methods are: exact, paper",
     .read = ReadMethod},
    {.name = "--tolerance",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "DEG",
     .help = "of method exact: greatest error of an angle in a region, in degrees, 1e-10 to 5",
     .remedy = "give degrees from 1e-10 to 5",
     .read = ReadField<kToleranceField, &Options::tolerance_deg>},
    {.name = "--step",
     .tasks = kMotion,
     .section = Section::kMotion,
     .value = "S",
     .help = "of method paper: its step in seconds, 0.000001 to 1",
     .remedy = "give seconds from 0.000001 to 1",
     .read = ReadField<kStepField, &Options::step_s>},
};

}  // namespace

std::span<const OptionRule> MotionRules() { return kMotionRules; }

}  // namespace hazumi
