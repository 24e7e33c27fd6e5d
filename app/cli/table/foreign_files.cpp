// How files of other programs are read.

#include "app/cli/option_values.h"
#include "app/cli/table/sections.h"

namespace hazumi {

namespace {

bool ReadSaved(const std::string& text, Options* options) {
  options->output = text;
  return text.ends_with(".kfa");
}

bool ReadUp(const std::string& text, Options* options) {
  if (text == "y") options->import.up = UpAxis::kY;
  if (text == "z") options->import.up = UpAxis::kZ;
  return options->import.up.has_value();
}

bool ReadLimits(const std::string& text, Options* options) {
  if (text == "none") options->import.limits = ImportLimits::kNone;
  return text == "none" || text == "clip";
}

bool ReadHinges(const std::string& text, Options* options) {
  if (text == "file") options->import.hinges = ImportHinges::kFile;
  return text == "file" || text == "body";
}

bool ReadFacing(const std::string& text, Options* options) {
  options->import.faces_forward = text == "forward";
  return text == "file" || text == "forward";
}

// A positive number, `most` at most.
bool KeepPositive(const std::string& text, double most, std::optional<double>* field) {
  const auto number = ReadFinite(text);
  return number && *number > 0.0 && *number <= most && Keep(number, field);
}

constexpr OptionRule kForeignFileRules[] = {
    {.name = "--save",
     .tasks = kImport,
     .section = Section::kForeignFiles,
     .value = "OUT.kfa",
     .help = "of --import: the project that is written",
     .files = kProjectSuffix,
     .remedy = "the name must end in .kfa",
     .read = ReadSaved},
    {.name = "--character",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "NAME",
     .help = "which of several characters in it",
     .fallback = "the one that moves most",
     .remedy = "name a character of the file",
     .read =
         [](const std::string& text, Options* o) {
           o->import.character = text;
           return !text.empty();
         }},
    {.name = "--clip",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "NAME",
     .help = "which of its clips",
     .fallback = "the first",
     .remedy = "name a clip of the file",
     .read =
         [](const std::string& text, Options* o) {
           o->import.clip = text;
           return !text.empty();
         }},
    {.name = "--up",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "y|z",
     .help = "the axis that is up",
     .fallback = "the file's, or guessed",
     .choices = "y z",
     .remedy = "give y or z",
     .read = ReadUp},
    {.name = "--unit",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "M",
     .help = "metres of its unit of length",
     .fallback = "the file's, or guessed",
     .remedy = "give the metres of the file's unit, such as 0.01",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1e6, &o->import.metres_per_unit); }},
    {.name = "--height",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "M",
     .help = "or how tall the character is, in metres",
     .remedy = "give metres, such as 1.75",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1000.0, &o->import.height_m); }},
    {.name = "--mass",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "KG",
     .help = "of all of it",
     .fallback = "of a person so tall",
     .remedy = "give kilograms, such as 70",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 1e6, &o->import.mass_kg); }},
    {.name = "--reduce",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "DEG",
     .help = "keys only where they are needed, so that angles stay within DEG degrees of the clip",
     .fallback = "a key every frame",
     .remedy = "give degrees, such as 1",
     .read = [](const std::string& text,
                Options* o) { return KeepPositive(text, 90.0, &o->import.reduce_deg); }},
    {.name = "--limits",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "L",
     .help = "clip: a body's joints go as far as people's do or the clip does, others a little "
             "farther than in the clip; none",
     .choices = "clip none",
     .remedy = "give clip or none",
     .read = ReadLimits},
    {.name = "--hinges",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "H",
     .help =
         "body: arms, legs, spine and head turn about a body's axes; file: all joints turn about "
         "the file's, in its order",
     .choices = "body file",
     .remedy = "give body or file",
     .read = ReadHinges},
    {.name = "--roles",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "MAP.json",
     .help = "what bones are whose names and shape tell it wrong: {\"format\": \"hazumi-roles\", "
             "\"roles\": {\"BONE\": \"left upper_arm\"}}",
     .files = "json",
     .remedy = "name a map of roles, a .json file",
     .read =
         [](const std::string& text, Options* o) {
           o->roles = text;
           return !text.empty();
         }},
    {.name = "--facing",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .value = "F",
     .help = "forward: turned so that it faces x at rest; file: as the file has it",
     .choices = "forward file",
     .remedy = "give forward or file",
     .read = ReadFacing},
    {.name = "--no-skin",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .help = "leave out its meshes",
     .read =
         [](const std::string&, Options* o) {
           o->import.skin = false;
           return true;
         }},
    {.name = "--all-warnings",
     .tasks = kForeign,
     .section = Section::kForeignFiles,
     .help = "say all that is dropped or changed, not the first ten lines",
     .is_silent = true,
     .read = Set<&Options::all_warnings>},
};

}  // namespace

std::span<const OptionRule> ForeignFileRules() { return kForeignFileRules; }

}  // namespace hazumi
