// What is written, and in which units and frames.

#include "app/cli/option_values.h"
#include "app/cli/table/sections.h"
#include "engine/exchange/onto/export_onto.h"

namespace hazumi {

namespace {

bool ReadBvhUp(const std::string& text, Options* options) {
  options->z_up = text == "z";
  return text == "y" || text == "z";
}

bool ReadBvhUnit(const std::string& text, Options* options) {
  options->in_metres = text == "m";
  return text == "m" || text == "cm";
}

constexpr OptionRule kOutputRules[] = {
    {.name = "--fps",
     .tasks = kRender | kBake | kInfo | kFlight | kImport | kExport,
     .section = Section::kOutput,
     .value = "N",
     .help = "output frames a second, 0.1 to 10000, such as 60, 29.97 or 30000/1001; the motion "
             "is the same",
     .fallback = "the file's",
     .more = "with --render, --bake, --export, --info, --flight",
     .remedy = "give 0.1 to 10000 frames a second, such as 60, 29.97 or 30000/1001",
     .read = [](const std::string& text, Options* o) { return Keep(ReadRate(text), &o->rate); }},
    {.name = "--onto",
     .tasks = kBvh | kPlain,
     .section = Section::kOutput,
     .value = "SOURCE",
     .help = "of --export to .glb, .gltf, .vrm and .bvh: SOURCE, which the project was imported "
             "from, with its changed bones; all else stays as it is there",
     .files = "glb gltf vrm bvh",
     .remedy = "name the file that the project was imported from: .glb, .gltf, .vrm or .bvh",
     .read =
         [](const std::string& text, Options* o) {
           o->onto = text;
           return CanBeOnto(text);
         }},
    {.name = "--bvh-up",
     .tasks = kBvh,
     .section = Section::kOutput,
     .value = "y|z",
     .help = "of --export to .bvh: the axis that is up",
     .fallback = "y",
     .choices = "y z",
     .remedy = "give y or z",
     .read = ReadBvhUp},
    {.name = "--bvh-unit",
     .tasks = kBvh,
     .section = Section::kOutput,
     .value = "m|cm",
     .help = "of --export to .bvh: its unit of length",
     .fallback = "cm",
     .choices = "m cm",
     .remedy = "give m or cm",
     .read = ReadBvhUnit},
    {.name = "--timings",
     .tasks = kBake | kJson,
     .section = Section::kOutput,
     .help = "with --bake and --export to .json: reports carry microseconds, off by default so "
             "that two are equal bytes",
     .is_silent = true,
     .read = Set<&Options::timings>},
    {.name = "--torques",
     .tasks = kBake | kJson | kCsv,
     .section = Section::kOutput,
     .help = "with --bake and --export to .json and .csv: also the torque that every joint needs, "
             "by inverse dynamics (that of --effort), and the force that nothing supplies",
     .read = Set<&Options::torques>},
    {.name = "--effort",
     .tasks = kBake | kJson | kCsv | kInfo,
     .section = Section::kOutput,
     .help =
         "with --bake and --export to .json and .csv: also the torque that muscles give in every "
         "joint, as a share of its strength too, and what soles and hands carry; with --info: "
         "more than the largest of them",
     .read = Set<&Options::effort>},
    {.name = "--strict",
     .tasks = kCheck,
     .section = Section::kOutput,
     .help = "with --check: fields that are not known are errors, also of figure and sweep files, "
             "which are read by themselves then",
     .is_silent = true,
     .read = Set<&Options::strict>},
    {.name = "--json",
     .tasks = kCheck | kInfo | kFlight | kRun,
     .section = Section::kOutput,
     .help = "with --check, --info, --flight: answer in JSON; with --run: a line of JSON for each "
             "operator, with the items that it made and what it measured",
     .is_silent = true,
     .read = Set<&Options::json>},
};

}  // namespace

std::span<const OptionRule> OutputRules() { return kOutputRules; }

}  // namespace hazumi
