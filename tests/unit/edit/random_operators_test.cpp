// Whatever is done can be undone and done again, to the byte.

#include "tests/unit/edit/random_operators.h"

#include <set>

#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Operator;
using edit::Session;

// Files, undo and redo are left out, and what needs the whole motion, which takes long.
std::vector<const Operator*> EditOperators() {
  std::vector<const Operator*> edits;
  for (const Operator& op : edit::AllOperators()) {
    const std::string id = op.id;
    if (id.starts_with("file.") || id == "edit.undo" || id == "edit.redo") continue;
    if (id == "region.to_keys" || id == "placement.flight") continue;
    edits.push_back(&op);
    if (id == "region.add") edits.insert(edits.end(), 3, &op);  // refused more often than not
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
  std::set<const Operator*> succeeded;
  for (int i = 0; i < NumOperators(); ++i) {
    const Operator& op = *edits[random.Integer(0, static_cast<int>(edits.size()) - 1)];
    const std::string before = i % 50 == 0 ? WriteProject(session.project()) : "";
    const bool ok = session.Run(op.id, RandomParameters(op, session.project(), &random)).ok();
    done += ok;
    if (ok) succeeded.insert(&op);
    if (ok || before.empty()) continue;
    ASSERT_EQ(WriteProject(session.project()), before) << op.id;
  }
  EXPECT_GT(done, NumOperators() / 10);
  const size_t most = NumOperators() >= 1000 ? 50 : 0;
  EXPECT_GE(succeeded.size(), most);  // most operators, once at least
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
