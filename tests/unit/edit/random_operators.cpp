#include "tests/unit/edit/random_operators.h"

#include <map>

namespace hazumi::test {

namespace {

using edit::Json;
using edit::Operator;
using edit::ParameterInfo;
using edit::ParameterKind;

// Texts that mean something to one operator or another.
const char* const kTexts[] = {"r_knee",   "l_elbow_flexion", "root.z", "root.angle_y", "r_shoulder",
                              "l_toe",    "floor",           "box",    "arms",         "region",
                              "region 2", "cubic",           "hold",   "exact",        "paper",
                              "pinned",   "gravity",         "keyed",  "replace",      "add",
                              "#112233",  "before",          "auto",   "flat",         "toggle",
                              "r_hand",   "nobody",          ""};
const char* const kNames[] = {"pelvis",      "r_knee", "l_knee", "r_shoulder+",
                              "l_shoulder+", "chest",  "l_wrist"};

Json RandomValue(ParameterKind kind, Random* random) {
  switch (kind) {
    case ParameterKind::kText:
      return kTexts[random->Integer(0, std::size(kTexts) - 1)];
    case ParameterKind::kNumber:
      return random->Chance(0.5) ? Json(random->Integer(0, 30)) : Json(random->Uniform(-1.0, 1.0));
    case ParameterKind::kInteger:
      return random->Integer(0, 30);
    case ParameterKind::kYesNo:
      return random->Chance(0.5);
    case ParameterKind::kNames: {
      Json names = Json::array();
      for (int i = random->Integer(1, 3); i > 0; --i) {
        names.push_back(kNames[random->Integer(0, std::size(kNames) - 1)]);
      }
      return names;
    }
    case ParameterKind::kNumbers: {
      Json numbers = Json::array();
      for (int i = random->Integer(1, 3); i > 0; --i) numbers.push_back(random->Integer(0, 30));
      return numbers;
    }
  }
  return {};
}

// What a parameter of this name is likely to mean; the others get any text.
const std::map<std::string, std::vector<const char*>> kWords = {
    {"curve", {"r_knee", "l_elbow_flexion", "root.z", "root.angle_y"}},
    {"joint", {"r_knee", "l_elbow_flexion", "r_shoulder", "l_toe"}},
    {"link", {"r_hand", "l_thigh", "pelvis"}},
    {"region", {"region", "arms", "region 2"}},
    {"object", {"floor", "box"}},
    {"name", {"box", "arms", "region", "region 2", "floor"}},
    {"mode", {"replace", "add", "remove", "toggle"}},
    {"side", {"before", "after"}},
    {"kind", {"auto", "flat", "keyed", "pinned", "gravity"}},
    {"pin", {"l_toe", "r_wrist"}},
    {"interpolation", {"hold", "linear", "quadratic", "cubic"}}};

Json LikelyValue(const ParameterInfo& info, Random* random) {
  const std::string name = info.name;
  if (name == "index") return random->Integer(0, 2);
  if (name == "friction" || name == "factor") return random->Uniform(0.0, 1.1);
  if (name == "first" && random->Chance(0.9)) return random->Integer(0, 14);
  if (name == "last" && random->Chance(0.9)) return random->Integer(15, 30);
  // Scenes that someone might have: at 5 frames a second, with elbows that turn by a degree, the
  // swings last seconds and take millions of steps.
  if (name == "num") return random->Integer(24, 60);
  if (name == "den") return 1;
  if (name == "lower") return random->Integer(-120, -20);
  if (name == "upper") return random->Integer(20, 120);
  const auto words = kWords.find(name);
  if (words == kWords.end() || random->Chance(0.1)) return RandomValue(info.kind, random);
  return words->second[random->Integer(0, static_cast<int>(words->second.size()) - 1)];
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
void NameKeys(const Operator& op, const Project& project, Random* random, Json* parameters) {
  const std::vector<KeyPlace> places = PlacesOfKeys(project);
  if (places.empty()) return;
  const auto some = [&] { return places[random->Integer(0, int(places.size()) - 1)]; };
  if (op.id == std::string("keys.select")) {
    Json curves = Json::array(), frames = Json::array();
    for (int i = random->Integer(0, 20); i > 0; --i) {
      const KeyPlace place = some();
      curves.push_back(place.curve);
      frames.push_back(place.frame);
    }
    parameters->update({{"curves", curves}, {"frames", frames}});
  } else if (parameters->contains("curve") && parameters->contains("frame")) {
    const KeyPlace place = some();
    parameters->update({{"curve", place.curve}, {"frame", place.frame}});
  }
}

}  // namespace

Json RandomParameters(const edit::Operator& op, const Project& project, Random* random) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : op.parameters) {
    if (info.is_required || random->Chance(0.4)) {
      parameters[info.name] = LikelyValue(info, random);
    }
  }
  if (parameters.contains("region") && !project.regions.empty() && random->Chance(0.9)) {
    const int last = static_cast<int>(project.regions.size()) - 1;
    parameters["region"] = project.regions[random->Integer(0, last)].name;
  }
  if (random->Chance(0.7)) NameKeys(op, project, random, &parameters);
  return parameters;
}

}  // namespace hazumi::test
