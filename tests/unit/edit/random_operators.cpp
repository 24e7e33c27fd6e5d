#include "tests/unit/edit/random_operators.h"

namespace hazumi::test {

namespace {

using edit::Json;
using edit::ParameterInfo;
using edit::ParameterKind;

// Texts that mean something to one operator or another.
const char* const kTexts[] = {"r_knee",   "l_elbow_flexion", "root.z", "root.angle_y", "r_shoulder",
                              "l_toe",    "floor",           "box",    "arms",         "region",
                              "region 2", "cubic",           "hold",   "exact",        "paper",
                              "pinned",   "gravity",         "keyed",  "replace",      "add",
                              "#112233",  "nobody",          ""};
const char* const kNames[] = {"r_knee", "l_knee", "r_shoulder+", "l_shoulder+", "chest", "l_wrist"};

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
  }
  return {};
}

}  // namespace

Json RandomParameters(const edit::Operator& op, Random* random) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : op.parameters) {
    if (info.is_required || random->Chance(0.4)) {
      parameters[info.name] = RandomValue(info.kind, random);
    }
  }
  return parameters;
}

}  // namespace hazumi::test
