// Whatever is done can be undone and done again, to the byte.

#include "tests/support/random.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Operator;
using edit::ParameterInfo;
using edit::ParameterKind;
using edit::Session;

// Texts that mean something to one operator or another.
const char* const kTexts[] = {"r_knee",   "l_elbow_flexion", "root.z", "root.angle_y", "r_shoulder",
                              "l_toe",    "floor",           "box",    "arms",         "region",
                              "region 2", "cubic",           "hold",   "exact",        "paper",
                              "pinned",   "gravity",         "keyed",  "replace",      "add",
                              "#112233",  "before",          "auto",   "flat",         "toggle",
                              "r_hand",   "nobody",          ""};
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
    case ParameterKind::kNumbers: {
      Json numbers = Json::array();
      for (int i = random->Integer(1, 3); i > 0; --i) numbers.push_back(random->Integer(0, 30));
      return numbers;
    }
  }
  return {};
}

Json RandomParameters(const Operator& op, Random* random) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : op.parameters) {
    if (info.is_required || random->Chance(0.4)) {
      parameters[info.name] = RandomValue(info.kind, random);
    }
  }
  return parameters;
}

// Files, undo and redo are left out, and what needs the motion, which takes long.
std::vector<const Operator*> EditOperators() {
  std::vector<const Operator*> edits;
  for (const Operator& op : edit::AllOperators()) {
    const std::string id = op.id;
    if (id.starts_with("file.") || id == "edit.undo" || id == "edit.redo") continue;
    if (id == "key.insert" || id == "pose.copy" || id == "region.to_keys") continue;
    edits.push_back(&op);
  }
  return edits;
}

// HAZUMI_CASES operators, else a thousand.
int NumOperators() {
  const char* text = std::getenv("HAZUMI_CASES");
  return text ? std::atoi(text) : 1000;
}

TEST(RandomOperators, AreUndoneAndDoneAgainToTheByte) {
  Session session;
  session.document().set_history_limit(size_t{1} << 40);
  const std::vector<const Operator*> edits = EditOperators();
  Random random(1);
  const std::string first = WriteProject(session.project());
  int done = 0;
  for (int i = 0; i < NumOperators(); ++i) {
    const Operator& op = *edits[random.Integer(0, static_cast<int>(edits.size()) - 1)];
    const std::string before = i % 50 == 0 ? WriteProject(session.project()) : "";
    const bool ok = session.Run(op.id, RandomParameters(op, &random)).ok();
    done += ok;
    if (ok || before.empty()) continue;
    ASSERT_EQ(WriteProject(session.project()), before) << op.id;
  }
  EXPECT_GT(done, NumOperators() / 10);
  session.document().EndMerge();
  const std::string last = WriteProject(session.project());
  ASSERT_NE(first, last);
  while (session.document().Undo()) {
  }
  EXPECT_EQ(WriteProject(session.project()), first);
  while (session.document().Redo()) {
  }
  EXPECT_EQ(WriteProject(session.project()), last);
}

}  // namespace
}  // namespace hazumi::test
