#include "tests/unit/edit/random/random_operators.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "engine/makers/aims/aims.h"
#include "engine/makers/jumps/jumps.h"
#include "tests/unit/edit/random/drives_of_regions.h"
#include "tests/unit/edit/random/held_by_hands.h"
#include "tests/unit/edit/random/likely_numbers.h"
#include "tests/unit/edit/random/named_things.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/posing.h"

namespace hazumi::test {

namespace {

using edit::Json;
using edit::ParameterInfo;
using edit::ParameterKind;
using edit::Session;

template <typename T>
const T& OneOf(const std::vector<T>& list, Random* random) {
  return list[random->Integer(0, static_cast<int>(list.size()) - 1)];
}

// Texts that mean something to one operator or another.
const std::vector<std::string> kTexts = {"r_knee", "root.z", "root.angle_y", "floor",        "arms",
                                         "cubic",  "hold",   "exact",        "gravity",      "add",
                                         "before", "nobody", "a\nb\t",       "\u5f3e\u307f", ""};

Json AnyValue(ParameterKind kind, Random* random) {
  Json list = Json::array();
  switch (kind) {
    case ParameterKind::kText:
      return OneOf(kTexts, random);
    case ParameterKind::kNumber:
      return random->Chance(0.5) ? Json(random->Integer(-5, 40)) : Json(random->Uniform(-1.0, 1.0));
    case ParameterKind::kInteger:
      return random->Integer(-5, 40);
    case ParameterKind::kYesNo:
      return random->Chance(0.5);
    case ParameterKind::kNames:
      for (int i = random->Integer(0, 3); i > 0; --i) list.push_back(OneOf(kTexts, random));
      return list;
    case ParameterKind::kNumbers:
      for (int i = random->Integer(0, 3); i > 0; --i) list.push_back(random->Integer(-5, 40));
      return list;
  }
  return list;
}

Json LikelyNumberFor(const std::string& id, const ParameterInfo& info, const Session& session,
                     Random* random) {
  const Likely likely = LikelyRange(id, info, session);
  const double value = random->Uniform(likely.low, likely.high);
  const bool is_whole = info.kind == ParameterKind::kInteger || IsFrame(info.name);
  return is_whole ? Json(static_cast<int>(std::lround(value))) : Json(value);
}

std::string RandomColor(Random* random) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", random->Integer(0, 0xffffff));
  return text;
}

// A name or number of something that there is; null if there is nothing.
Json SomeOf(Thing thing, const Session& session, Random* random) {
  if (thing == Thing::kColor) return RandomColor(random);
  if (const auto count = CountOf(thing, session.project())) {
    return *count == 0 ? Json() : Json(random->Integer(0, static_cast<int>(*count) - 1));
  }
  const std::vector<std::string> names = NamesOf(thing, session);
  return names.empty() ? Json() : Json(OneOf(names, random));
}

Json SomeNames(const std::string& id, Thing thing, const Session& session, Random* random) {
  Json list = Json::array();
  for (int i = random->Integer(1, 3); i > 0; --i) {
    Json name = SomeOf(thing, session, random);
    if (name.is_null()) continue;
    if (id == "region.add" && random->Chance(0.3)) name = name.get<std::string>() + "+";
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
  }
  return list;
}

const std::map<std::string, std::vector<const char*>> kEndings = {
    {"file.export", {".bvh", ".glb", ".gltf", ".csv", ".json"}}, {"file.save", {".kfa"}}};

Json SomePath(const std::string& id, const RandomFiles& files, Random* random) {
  if (id == "file.add_mesh") return files.mesh;
  if (id == "file.import") return OneOf(files.characters, random);
  const auto endings = kEndings.find(id);
  if (endings == kEndings.end()) return OneOf(files.projects, random);
  return files.folder + "/written_" + std::to_string(random->Integer(0, 3)) +
         OneOf(endings->second, random);
}

Json LikelyText(const std::string& id, const std::string& name, const RandomFiles& files,
                Random* random) {
  if (name == "path") return SomePath(id, files, random);
  if (name == "drag") return "drag " + std::to_string(random->Integer(0, 1));
  if (name == "name") return "name " + std::to_string(random->Integer(0, 40));
  return OneOf(kTexts, random);
}

Json LikelyValue(const std::string& id, const ParameterInfo& info, const Session& session,
                 const RandomFiles& files, Random* random) {
  const std::vector<std::string> words = edit::WordsOf(info.offer);
  if (!words.empty()) return OneOf(words, random);
  if (info.kind == ParameterKind::kNames) return SomeNames(id, info.offer.thing, session, random);
  if (info.offer.thing != Thing::kAny) {
    const Json some = SomeOf(info.offer.thing, session, random);
    return some.is_null() ? AnyValue(info.kind, random) : some;
  }
  if (info.kind == ParameterKind::kText) return LikelyText(id, info.name, files, random);
  if (info.kind != ParameterKind::kNumber && info.kind != ParameterKind::kInteger) {
    return AnyValue(info.kind, random);
  }
  return LikelyNumberFor(id, info, session, random);
}

struct KeyPlace {
  std::string curve;
  double frame;
};

std::vector<KeyPlace> PlacesOfKeys(const Project& project) {
  std::vector<KeyPlace> places;
  for (const Named<ProjectCurve>& curve : project.joints) {
    for (const ProjectKey& key : curve.value.keys) places.push_back({curve.name, key.frame});
  }
  return places;
}

// Of an operator that wants keys: some that there are.
void NameKeys(const std::string& id, const Project& project, Random* random, Json* parameters) {
  const std::vector<KeyPlace> places = PlacesOfKeys(project);
  if (places.empty()) return;
  if (id == "keys.select") {
    Json curves = Json::array(), frames = Json::array();
    for (int i = random->Integer(0, 12); i > 0; --i) {
      const KeyPlace& place = OneOf(places, random);
      curves.push_back(place.curve);
      frames.push_back(place.frame);
    }
    parameters->update({{"curves", curves}, {"frames", frames}});
  } else if (id.starts_with("key.") && parameters->contains("frame")) {
    const KeyPlace& place = OneOf(places, random);
    if (parameters->contains("curve")) (*parameters)["curve"] = place.curve;
    (*parameters)["frame"] = place.frame;
  }
}

// A first and a last frame in their order.
void Order(const char* first, const char* last, const ProjectFrames& all, Json* parameters) {
  if (!parameters->contains(first) || !parameters->contains(last)) return;
  Json &a = (*parameters)[first], &b = (*parameters)[last];
  if (a > b) std::swap(a, b);
  if (a != b || !a.is_number_integer()) return;
  if (a.get<int>() > all.first) {
    a = a.get<int>() - 1;
  } else {
    b = b.get<int>() + 1;
  }
}

// A little longer or shorter.
void KeepRange(const ProjectFrames& frames, Random* random, Json* parameters) {
  const int last = std::clamp(frames.last + random->Integer(-3, 3), frames.first + 5, 60);
  if (parameters->contains("first")) (*parameters)["first"] = frames.first;
  if (parameters->contains("last")) (*parameters)["last"] = last;
}

// A frame or a hinge of the region that is named.
void KeepInRegion(const Session& session, Random* random, Json* parameters) {
  const std::vector<ProjectRegion>& regions = session.project().regions;
  if (!parameters->contains("region") || regions.empty()) return;
  const ProjectRegion& region = OneOf(regions, random);
  (*parameters)["region"] = region.name;
  if (parameters->contains("frame")) {
    (*parameters)["frame"] = random->Integer(region.first_frame, region.last_frame);
  }
  if (!parameters->contains("joint") || region.joints.empty()) return;
  const std::string& name = OneOf(region.joints, random).name;
  const auto group = session.figure().FindGroup(name);
  const Figure& figure = session.figure();
  (*parameters)["joint"] = group ? figure.joint(figure.group(*group).first).name : name;
}

// Only what this item has: a plane has no size.
template <typename T>
void KeepToItem(const std::vector<T>& list, const std::vector<ParameterInfo>& infos,
                Json* parameters) {
  const std::string name = parameters->value("object", "");
  const auto item =
      std::find_if(list.begin(), list.end(), [&](const T& each) { return each.name == name; });
  if (item == list.end()) return;
  const edit::ParameterInfos own = edit::FieldsOf(*item);
  const auto has = [](const edit::ParameterInfos& of, const std::string& parameter) {
    return std::any_of(of.begin(), of.end(),
                       [&](const ParameterInfo& info) { return info.name == parameter; });
  };
  for (const ParameterInfo& info : infos) {
    const bool is_special = std::string(info.name) == "object" ||
                            std::string(info.name) == "drag" || std::string(info.name) == "never";
    if (!is_special && !has(own, info.name)) parameters->erase(info.name);
  }
}

// A later holder that there is, and frames near those it has.
void KeepToHolder(const Session& session, Random* random, Json* parameters) {
  const std::vector<ProjectHeldObject> passed = PassedOn(session);
  if (passed.empty()) return;
  const ProjectHeldObject& object = OneOf(passed, random);
  const int number = random->Integer(0, static_cast<int>(object.holders.size()) - 1);
  (*parameters)["object"] = object.name;
  (*parameters)["number"] = number;
  const int first = object.holders[number].first_frame;
  if (parameters->contains("first")) (*parameters)["first"] = first + random->Integer(0, 1);
  if (parameters->contains("release")) (*parameters)["release"] = first + random->Integer(2, 4);
}

// As many as there are curves.
void KeepToCurves(Random* random, Json* parameters) {
  Json values = Json::array();
  for (size_t i = 0; i < parameters->value("curves", Json::array()).size(); ++i) {
    values.push_back(random->Uniform(-20.0, 60.0));
  }
  (*parameters)["values"] = values;
}

// Goals that a region can meet.
std::vector<ProjectGoal> Aimable(const Session& session) {
  std::vector<ProjectGoal> goals;
  for (const ProjectGoal& goal : session.project().goals) {
    if (makers::RegionOf(goal, session.figure(), session.project())) goals.push_back(goal);
  }
  return goals;
}

// A new goal is where a region ends, and a hand is what reaches.
void KeepToGoal(const std::string& id, const Session& session, Random* random, Json* parameters) {
  const auto& regions = session.project().regions;
  if (id == "goal.aim" && !Aimable(session).empty()) {
    (*parameters)["goal"] = OneOf(Aimable(session), random).name;
  }
  if (id == "goal.add" && !regions.empty()) {
    (*parameters)["frame"] = OneOf(regions, random).last_frame;
  }
  if (id != "goal.reach" || !session.figure().FindGroup("r_wrist")) return;
  (*parameters)["joint"] = "r_wrist";
  (*parameters)["frame"] = session.project().frames.last;
  (*parameters)["rests"] = false;
}

// Only what a format has.
void KeepToFormat(Json* parameters) {
  const std::string path = parameters->value("path", "");
  if (!path.ends_with(".bvh")) parameters->erase("up"), parameters->erase("unit");
  if (!path.ends_with("f") && !path.ends_with("glb")) parameters->erase("skin");
}

}  // namespace

Json RandomParameters(const std::string& id, const std::vector<ParameterInfo>& infos,
                      const Session& session, const RandomFiles& files, Random* random) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : infos) {
    if (!info.is_required && !random->Chance(0.35)) continue;
    parameters[info.name] = random->Chance(0.03) ? AnyValue(info.kind, random)
                                                 : LikelyValue(id, info, session, files, random);
  }
  if (random->Chance(0.1)) return parameters;
  NameKeys(id, session.project(), random, &parameters);
  if (id == "time.range") KeepRange(session.project().frames, random, &parameters);
  if (id.starts_with("region.")) KeepInRegion(session, random, &parameters);
  if (id == "file.export") KeepToFormat(&parameters);
  if (id == "object.set") KeepToItem(session.project().scene.objects, infos, &parameters);
  if (id.starts_with("drive.")) {
    KeepToDrive(id, session, random, &parameters);
  } else if (parameters.contains("number")) {
    KeepToHolder(session, random, &parameters);
  }
  if (id == "held.throw_onto" && !Thrown(session).empty()) {
    parameters["object"] = OneOf(Thrown(session), random).name;
  }
  if (id == "throw.add" && !InAHand(session).empty()) {
    parameters["object"] = OneOf(InAHand(session), random).name;
  }
  if (id.starts_with("goal.")) KeepToGoal(id, session, random, &parameters);
  if (id == "pose.blend") KeepToCurves(random, &parameters);
  if (id == "held.set") KeepToItem(session.project().held_objects, infos, &parameters);
  Order("first", "last", session.project().frames, &parameters);
  Order("to_first", "to_last", session.project().frames, &parameters);
  return parameters;
}

// Whether a posed curve has a key before the current frame and another after it.
static bool IsBetweenKeys(const Session& session) {
  for (const std::string& name : edit::PosedCurves(session)) {
    const ProjectCurve* curve = FindCurve(name, session.project());
    if (!curve || curve->keys.empty()) continue;
    if (curve->keys.front().frame < session.frame() && curve->keys.back().frame > session.frame()) {
      return true;
    }
  }
  return false;
}

bool IsSeldomPossible(const std::string& id) {
  static const char* const kIds[] = {
      "audio.remove",     "constraint.set", "drive.key",        "drive.remove",
      "drive.remove_key", "drive.set",      "goal.aim",         "goal.reach",
      "figure.embed",     "held.pass",      "held.set_frames",  "held.set_holder",
      "held.throw_onto",  "jump.aim",       "keys.paste",       "pose.breakdown",
      "pose.push",        "pose.relax",     "reference.remove", "throw.add"};
  return std::find(std::begin(kIds), std::end(kIds), id) != std::end(kIds);
}

bool HasWhatItNeeds(const std::string& id, const std::vector<ParameterInfo>& infos,
                    const Session& session) {
  const bool is_of_selected = id.starts_with("keys.") && !id.starts_with("keys.select");
  if (id == "audio.remove") return session.project().audio.has_value();
  if (id == "reference.remove") return session.project().reference.has_value();
  if (id == "held.throw_onto") return !Thrown(session).empty();
  if (id == "goal.aim") return !Aimable(session).empty();
  if (id == "throw.add") return !InAHand(session).empty();
  if (id == "jump.aim") return JumpAt(session.frame(), session.project().placements).has_value();
  if (id == "edit.redo") return session.document().redo_label().has_value();
  if (id == "keys.paste") return !session.key_clipboard().empty();
  if (id == "pose.paste") return !session.clipboard().empty();
  if (id == "select.save_set") return !session.selected_joints().empty();
  if (id == "pose.breakdown" || id == "pose.relax" || id == "pose.push") {
    return IsBetweenKeys(session);
  }
  const bool is_of_drive = id.starts_with("drive.") && id != "drive.add";
  if (is_of_drive && DrivesFor(id, session).empty()) return false;
  if (is_of_selected && session.selected_keys().empty()) return false;
  const bool is_of_holder = id.starts_with("held.") &&
                            std::any_of(infos.begin(), infos.end(), [](const ParameterInfo& info) {
                              return std::string(info.name) == "number";
                            });
  if (is_of_holder && PassedOn(session).empty()) return false;
  return std::all_of(infos.begin(), infos.end(), [&](const ParameterInfo& info) {
    return !info.is_required || HasAny(info.offer.thing, session);
  });
}

}  // namespace hazumi::test
