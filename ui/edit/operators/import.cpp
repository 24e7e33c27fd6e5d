// Characters of other programs.

#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/foreign_files.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

// A positive number, if it is given.
Result<Done> TakePositive(const Parameters& p, const char* name, std::optional<double>* field) {
  if (!p.has(name)) return Done();
  if (p.number(name) <= 0.0) return Refusal(name, "must be greater than 0");
  *field = p.number(name);
  return Done();
}

Result<ImportOptions> OptionsFrom(const Parameters& p) {
  ImportOptions options;
  options.character = p.text("character");
  options.clip = p.text("clip");
  const std::string up = p.text("up"), limits = p.text("limits", "clip");
  if (!up.empty() && up != "y" && up != "z") {
    return Refusal("up", "\"" + up + "\" is none of y, z");
  }
  if (!up.empty()) options.up = up == "y" ? UpAxis::kY : UpAxis::kZ;
  if (limits != "clip" && limits != "none") {
    return Refusal("limits", "\"" + limits + "\" is none of clip, none");
  }
  options.limits = limits == "clip" ? ImportLimits::kClip : ImportLimits::kNone;
  const std::string hinges = p.text("hinges", "body");
  if (hinges != "body" && hinges != "file") {
    return Refusal("hinges", "\"" + hinges + "\" is none of body, file");
  }
  options.hinges = hinges == "body" ? ImportHinges::kBody : ImportHinges::kFile;
  options.faces_forward = p.yes("faces_forward", true);
  options.skin = p.yes("skin", true);
  if (p.has("roles")) {
    Result<RoleMap> roles = ReadRoles(p.text("roles"));
    if (!roles.ok()) return roles.error();
    options.roles = std::move(roles).value();
  }
  for (const auto& [name, field] : {std::pair{"unit", &options.metres_per_unit},
                                    {"height", &options.height_m},
                                    {"mass", &options.mass_kg},
                                    {"fps", &options.fps},
                                    {"reduce", &options.reduce_deg}}) {
    const Result<Done> taken = TakePositive(p, name, field);
    if (!taken.ok()) return taken.error();
  }
  if (options.fps && (*options.fps < kLeastImportFps || *options.fps > kMostImportFps)) {
    return Refusal("fps", "must be from 0.1 to 10000");
  }
  return options;
}

Result<Done> Import(Session* session, const Parameters& p) {
  const Result<ImportOptions> options = OptionsFrom(p);
  if (!options.ok()) return options.error();
  const Result<Character> character =
      ReadCharacter(p.text("path"), ReadOptionsFor(options.value()));
  if (!character.ok()) return character.error();
  Result<Imported> imported = ImportProject(character.value(), options.value());
  if (!imported.ok()) return imported.error();
  TakeImported(std::move(imported).value(), session);
  return Done();
}

}  // namespace

void TakeImported(Imported imported, Session* session) {
  session->Replace(std::move(imported.project), "");
  session->document().MarkUnsaved();
}

std::vector<Operator> ImportOperators() {
  return {
      {"file.import",
       "Import character",
       "Makes a project of a character and its clip: BVH, FBX, glTF, GLB or Collada.",
       {{"path", kText, true, "a file of another program"},
        {"character", kText, false, "name of one of several; not given: the one that moves most"},
        {"clip", kText, false, "name of a clip; not given: the first one"},
        {"up", kText, false, "the axis that is up; not given: as the file says, or guessed", "y z"},
        {"unit", kNumber, false, "metres of the file's unit of length"},
        {"height", kNumber, false, "metres that it is tall, instead of a unit"},
        {"mass", kNumber, false, "kilograms; not given: of a person so tall"},
        {"fps", kNumber, false,
         "frames a second, the motion being the same; not given: the clip's"},
        {"reduce", kNumber, false, "degrees that fewer keys may be off the clip"},
        {"limits", kText, false, "clip: as far as people go, or a little beyond the clip; none",
         "clip none"},
        {"hinges", kText, false, "body: about a body's axes; file: about the file's", "body file"},
        {"roles", kText, false, "a file with roles of bones whose names and shape tell them wrong"},
        {"faces_forward", kYesNo, false, "false: turned as the file has it", kOnUnlessGiven},
        {"skin", kYesNo, false, "false: without its meshes", kOnUnlessGiven}},
       Import}};
}

}  // namespace hazumi::edit
