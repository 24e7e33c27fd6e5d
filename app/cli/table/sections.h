#pragma once

// The parts of the table of options (../option_table.h), a file for each section of the help: its
// entries in the order of the help.

#include <span>

#include "app/cli/option_table.h"

namespace hazumi {

std::span<const OptionRule> TaskRules();
std::span<const OptionRule> DrawingRules();
std::span<const OptionRule> ForeignFileRules();
std::span<const OptionRule> MotionRules();
std::span<const OptionRule> OutputRules();
std::span<const OptionRule> SweepRules();
std::span<const OptionRule> EditorRules();

}  // namespace hazumi
