// What is drawn, and how: options of --render and of --export to .mp4.

#include <limits>

#include "app/cli/option_values.h"
#include "app/cli/table/sections.h"

namespace hazumi {

namespace {

constexpr OptionRule kDrawingRules[] = {
    {.name = "--frames",
     .tasks = kRender | kExport,
     .section = Section::kDrawing,
     .value = "A..B",
     .help = "only these frames, or one: N",
     .fallback = "all",
     .more = "--frames counts output frames when --fps is given, and belongs to --export of any "
             "format",
     .remedy = "give a frame, or A..B with A <= B",
     .is_silent = true,
     .read = [](const std::string& text, Options* o) { return Keep(ReadRange(text), &o->frames); }},
    {.name = "--size",
     .tasks = kDraw | kRun,
     .section = Section::kDrawing,
     .value = "WxH",
     .help = "picture size in pixels, 16 to 16384",
     .fallback = "1280x720",
     .more = "of videos even: an odd one grows by a pixel",
     .remedy = "give WxH, each from 16 to 16384",
     .read = [](const std::string& text, Options* o) { return Keep(ReadSize(text), &o->size); }},
    {.name = "--camera",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "VIEW",
     .help = "front, back, left, right, top, three-quarter, or EX,EY,EZ,TX,TY,TZ[,FOV]: eye and "
             "target in metres, angle in degrees",
     .fallback = "the file's, or three-quarter",
     .choices = "front back left right top three-quarter",
     .remedy = "give front, back, left, right, top, three-quarter, or EX,EY,EZ,TX,TY,TZ[,FOV]",
     .read = [](const std::string& text,
                Options* o) { return Keep(ReadCamera(text), &o->camera); }},
    {.name = "--samples",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "samples a pixel, 1 or 4",
     .fallback = "4",
     .choices = "1 4",
     .remedy = "give 1 or 4",
     .read =
         [](const std::string& text, Options* o) {
           return KeepInt(text, 1, 4, &o->samples) && (o->samples == 1 || o->samples == 4);
         }},
    {.name = "--threads",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "at most 2 are used: one draws, one writes",
     .fallback = "2",
     .remedy = "give a whole number from 1",
     .is_silent = true,
     .read =
         [](const std::string& text, Options* o) {
           return KeepInt(text, 1, std::numeric_limits<int>::max(), &o->threads);
         }},
    {.name = "--body",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "LOOK",
     .help = "skin, capsules, or both: the capsules in a see-through skin; figures without a skin "
             "are capsules",
     .fallback = "skin",
     .choices = "skin capsules both",
     .remedy = "give skin, capsules or both",
     .read = [](const std::string& text, Options* o) { return Keep(ReadBody(text), &o->body); }},
    {.name = "--ghosts",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .value = "N",
     .help = "a translucent figure every N frames",
     .fallback = "none",
     .remedy = "give a whole number from 1 to 1000000",
     .read = [](const std::string& text,
                Options* o) { return KeepInt(text, 1, 1000000, &o->ghosts); }},
    {.name = "--paths",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw the paths of centre of mass, hands, feet and head",
     .read = Set<&Options::paths>},
    {.name = "--marks",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw a ring at the pinned joint",
     .read = Set<&Options::marks>},
    {.name = "--tint",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "tint the joints that a dynamics region moves",
     .read = Set<&Options::tint>},
    {.name = "--frame-number",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw the frame number",
     .read = Set<&Options::frame_number>},
    {.name = "--open-outside",
     .tasks = kDraw | kRun | kSweep | kVerify,
     .section = Section::kDrawing,
     .help = "open the sound and the reference of the project also where they lie outside of its "
             "folder",
     .is_silent = true,
     .read = Set<&Options::open_outside>},
    {.name = "--no-shadow",
     .tasks = kDraw,
     .section = Section::kDrawing,
     .help = "draw no shadow",
     .read = Set<&Options::shadow, false>},
};

}  // namespace

std::span<const OptionRule> DrawingRules() { return kDrawingRules; }

}  // namespace hazumi
