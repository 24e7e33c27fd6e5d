// Where a sweep's results go, and which share of them is computed.

#include "app/cli/table/sections.h"

namespace hazumi {

namespace {

constexpr OptionRule kSweepRules[] = {
    {.name = "--out",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "FOLDER",
     .help = "where the results are",
     .files = "/",
     .remedy = "name a folder",
     .read =
         [](const std::string& text, Options* o) {
           o->output = text;
           return !text.empty();
         }},
    {.name = "--tasks",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "N",
     .help = "share the cells out among N tasks, on one machine or many",
     .fallback = "all cells",
     .remedy = "give a whole number from 1 to 1000000",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 1, 1000000, &o->tasks); }},
    {.name = "--task",
     .tasks = kSweep,
     .section = Section::kSweep,
     .value = "K",
     .help = "this one's share, from 0 to N - 1; the table is made by a last call without it",
     .remedy = "give a whole number from 0",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 0, 999999, &o->task_number); }},
    {.name = "--count",
     .tasks = kSweep,
     .section = Section::kSweep,
     .help = "only say how many cells there are",
     .read = Set<&Options::count>},
};

}  // namespace

std::span<const OptionRule> SweepRules() { return kSweepRules; }

}  // namespace hazumi
