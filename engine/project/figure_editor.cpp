#include "engine/project/figure_editor.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "engine/project/edits/entries.h"
#include "engine/project/figure_file.h"
#include "engine/project/json/json.h"
#include "engine/project/json/text_file.h"

namespace hazumi {

namespace {

// The name itself, or that of the side that is mirrored.
std::string OriginalName(const std::string& name, const FigureSpec& spec) {
  if (!spec.mirror || !name.starts_with(spec.mirror->to)) return name;
  return spec.mirror->from + name.substr(spec.mirror->to.size());
}

// Reads the text again; only then the figure changes.
Result<Done> Take(const Json& json, ProjectFigure* figure) {
  std::string text = CompactJson(json);
  Result<FigureSpec> spec = ParseFigure(text, "");
  if (!spec.ok()) return spec.error();
  figure->embedded_json = std::move(text);
  figure->spec = std::move(spec).value();
  return Done();
}

// `edit(json)` of the figure's text, which may refuse.
template <typename Edit>
Result<Done> EditText(ProjectFigure* figure, Edit edit) {
  if (!figure->file.empty()) {
    return Refusal("figure",
                   "is the file " + Quoted(figure->file) +
                       ", which other projects may use; embed it first with \"figure.embed\"");
  }
  FirstError errors;
  std::optional<Json> json = ParseJson(figure->embedded_json, &errors);
  if (!json) return *errors.error();
  const Result<Done> done = edit(&*json);
  return done.ok() ? Take(*json, figure) : done;
}

// Fields of a joint's JSON that say its hinges and its role.
constexpr const char* kHingeFields[] = {"orientation_deg", "hinges", "role", "side"};

// "joints" and "hinges" are of the same order in the text and in what was read.
Json* FindHinge(const std::string& name, const FigureSpec& spec, Json* json) {
  for (size_t i = 0; i < spec.joints.size(); ++i) {
    for (size_t h = 0; h < spec.joints[i].hinges.size(); ++h) {
      if (spec.joints[i].NameOf(spec.joints[i].hinges[h]) != name) continue;
      return &(*json)["joints"][i]["hinges"][h];
    }
  }
  return nullptr;
}

struct FoundLink {
  const LinkSpec* spec = nullptr;
  Json* json = nullptr;
};

FoundLink FindIn(const std::vector<LinkSpec>& links, const std::string& name, Json* owner) {
  for (size_t i = 0; i < links.size(); ++i) {
    if (links[i].name == name) return {&links[i], &(*owner)["links"][i]};
  }
  return {};
}

FoundLink FindLink(const std::string& name, const FigureSpec& spec, Json* json) {
  FoundLink found = FindIn(spec.root_links, name, &(*json)["root"]);
  for (size_t i = 0; i < spec.joints.size() && !found.json; ++i) {
    found = FindIn(spec.joints[i].links, name, &(*json)["joints"][i]);
  }
  return found;
}

void SetMass(double mass, const LinkSpec& link, Json* json) {
  json->erase("density_kg_m3");
  (*json)["mass_kg"] = mass;
  if (!link.inertia || !link.mass || *link.mass <= 0.0) return;
  for (Json& moment : (*json)["inertia_kg_m2"]) {
    moment = moment.get<double>() * (mass / *link.mass);
  }
}

}  // namespace

Result<Done> SetHingeLimits(const std::string& hinge, std::optional<double> lower,
                            std::optional<double> upper, ProjectFigure* figure) {
  return EditText(figure, [&](Json* json) -> Result<Done> {
    Json* found = FindHinge(hinge, figure->spec, json);
    if (!found) found = FindHinge(OriginalName(hinge, figure->spec), figure->spec, json);
    if (!found) return Refusal("joint", "the figure has no hinge " + Quoted(hinge));
    Json& limits = (*found)["limits_deg"];
    const double low = lower.value_or(limits[0].get<double>());
    const double high = upper.value_or(limits[1].get<double>());
    if (low > high) {
      return Refusal("lower", "the lower limit " + NumberText(low) + " is above the upper one, " +
                                  NumberText(high));
    }
    limits = {low, high};
    const double rest = found->value("rest_deg", 0.0);
    if (rest < low || rest > high) (*found)["rest_deg"] = std::clamp(rest, low, high);
    return Done();
  });
}

Result<Done> ChangeLink(const std::string& link, const LinkChange& change, ProjectFigure* figure) {
  return EditText(figure, [&](Json* json) -> Result<Done> {
    FoundLink found = FindLink(link, figure->spec, json);
    if (!found.json) found = FindLink(OriginalName(link, figure->spec), figure->spec, json);
    if (!found.json) return Refusal("link", "the figure has no link " + Quoted(link));
    if (change.mass_kg) SetMass(*change.mass_kg, *found.spec, found.json);
    if (change.radius_m) (*found.json)["radius_m"] = *change.radius_m;
    return Done();
  });
}

Result<Done> ReplaceHinges(const std::vector<JointSpec>& joints, ProjectFigure* figure) {
  FigureSpec changed = figure->spec;
  std::set<std::string> names;
  for (const JointSpec& joint : joints) {
    for (JointSpec& own : changed.joints) {
      if (own.name != joint.name) continue;
      own.orientation = joint.orientation;
      own.hinges = joint.hinges;
      own.body = joint.body;
      names.insert(own.name);
    }
  }
  const Json written = Json::parse(FigureText(changed));
  return EditText(figure, [&](Json* json) -> Result<Done> {
    for (size_t i = 0; i < changed.joints.size(); ++i) {
      if (!names.contains(changed.joints[i].name)) continue;
      Json& own = (*json)["joints"][i];
      for (const char* field : kHingeFields) {
        own.erase(field);
        if (written["joints"][i].contains(field)) own[field] = written["joints"][i][field];
      }
    }
    return Done();
  });
}

Result<Done> EmbedFigure(const std::string& folder, ProjectFigure* figure) {
  if (figure->file.empty()) return Refusal("figure", "is embedded already");
  const std::string path =
      (std::filesystem::path(folder) / figure->file).lexically_normal().string();
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  FirstError errors;
  std::optional<Json> json = ParseJson(text.value(), &errors);
  if (!json) return errors.In(path);
  for (const ExtraField& field : figure->extra) {
    if (!json->contains(field.name)) (*json)[field.name] = Json::parse(field.json, nullptr, false);
  }
  ProjectFigure embedded;
  Result<Done> taken = Take(*json, &embedded);
  if (taken.ok()) *figure = std::move(embedded);
  return taken;
}

}  // namespace hazumi
