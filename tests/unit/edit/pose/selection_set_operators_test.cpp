#include "engine/project/project_reader.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

const std::set<std::string> kArmAndRoot = {"r_shoulder_flexion", "r_shoulder_rotation",
                                           "r_shoulder_abduction", "r_elbow_flexion", "pelvis"};

void SaveArm(Session* session) {
  session->set_selected_joints(kArmAndRoot);
  Do(session, "select.save_set", {{"name", "arm"}});
  Do(session, "select.none");
}

TEST(SelectionSets, AreSelectedAgainWhereverTheProjectIsOpened) {
  Session session;
  SaveArm(&session);
  Session other;
  const auto read = ParseProject(WriteProject(session.project()), "arm.kfa");
  ASSERT_TRUE(read.ok()) << read.error().ToString();
  other.Replace(read.value(), "");
  Do(&other, "select.set", {{"name", "arm"}});
  EXPECT_EQ(other.selected_joints(), kArmAndRoot);
  Do(&other, "select.joints", {{"joints", {"l_knee"}}});
  Do(&other, "select.set", {{"name", "arm"}, {"add", true}});
  EXPECT_EQ(other.selected_joints().size(), kArmAndRoot.size() + 1);
}

TEST(SelectionSets, AreReplacedRemovedAndUndone) {
  Session session;
  SaveArm(&session);
  Do(&session, "select.joints", {{"joints", {"l_knee"}}});
  Do(&session, "select.save_set", {{"name", "arm"}});
  ASSERT_EQ(session.project().selection_sets.size(), 1u);
  EXPECT_EQ(session.project().selection_sets[0].joints.size(), 1u);
  Do(&session, "edit.undo");
  Do(&session, "select.set", {{"name", "arm"}});
  EXPECT_EQ(session.selected_joints(), kArmAndRoot);
  Do(&session, "select.remove_set", {{"name", "arm"}});
  EXPECT_TRUE(session.project().selection_sets.empty());
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().selection_sets.size(), 1u);
}

TEST(SelectionSets, SayWhatIsWrong) {
  Session session;
  EXPECT_EQ(Refused(&session, "select.save_set", {{"name", "arm"}}).ToString(),
            "select.save_set: nothing is selected; click on a joint");
  SaveArm(&session);
  EXPECT_EQ(Refused(&session, "select.set", {{"name", "leg"}}).ToString(),
            "select.set.name: there is no \"leg\"; there is \"arm\"");
  EXPECT_EQ(Refused(&session, "select.remove_set", {{"name", "leg"}}).ToString(),
            "select.remove_set.name: there is no \"leg\"; there is \"arm\"");
}

}  // namespace
}  // namespace hazumi::test
