// What the editor takes.

#include "app/cli/table/sections.h"

namespace hazumi {

namespace {

constexpr OptionRule kEditorRules[] = {
    {.name = "--trace",
     .tasks = kWindow,
     .section = Section::kEditor,
     .help = "say in the end how many events changed the project and how long they took until the "
             "picture was finished, and how many frames playback showed, passed over, and showed "
             "late",
     .read = Set<&Options::trace>},
};

}  // namespace

std::span<const OptionRule> EditorRules() { return kEditorRules; }

}  // namespace hazumi
