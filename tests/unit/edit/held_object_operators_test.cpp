#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

const ProjectHeldObject& Last(const Session& session) {
  return session.project().held_objects.back();
}

TEST(HeldObjectOperators, ABallIsPutIntoTheSelectedHandAndThrown) {
  Session session;
  Do(&session, "select.joints", {{"joints", {"r_wrist"}}});
  Do(&session, "held.add_ball");
  EXPECT_EQ(Last(session).joint, "r_wrist");
  EXPECT_EQ(Last(session).name, "ball");
  // In the palm: half way along the hand, at its side.
  EXPECT_LE((Last(session).offset_m - Vec3(0.0, 0.037, -0.09175)).norm(), 1e-12);
  Do(&session, "held.set", {{"object", "ball"}, {"release", 7}});
  const Result<const Motion*> motion = session.WholeMotion();
  ASSERT_TRUE(motion.ok()) << motion.error().ToString();
  EXPECT_TRUE(motion.value()->frames[6].objects[0].held);
  EXPECT_FALSE(motion.value()->frames[8].objects[0].held);
}

TEST(HeldObjectOperators, ChangeWhatIsGiven) {
  Session session;
  Do(&session, "held.add_box", {{"joint", "l_wrist"}, {"name", "brick"}, {"offset_x", 0.1}});
  EXPECT_EQ(Last(session).offset_m, Vec3(0.1, 0.0, 0.0));
  Do(&session, "held.set", {{"object", "brick"}, {"size_z", 0.3}, {"mass", 2}, {"drag", "a"}});
  Do(&session, "held.set", {{"object", "brick"}, {"joint", "r_wrist"}, {"release", 9}});
  EXPECT_EQ(std::get<ProjectBoxShape>(Last(session).shape).size_m, Vec3(0.1, 0.1, 0.3));
  EXPECT_EQ(Last(session).mass_kg, 2.0);
  EXPECT_EQ(Last(session).joint, "r_wrist");
  Do(&session, "held.set", {{"object", "brick"}, {"never", true}});
  EXPECT_EQ(Last(session).release_frame, std::nullopt);
  Do(&session, "held.add_ball", {{"joint", "l_wrist"}, {"name", "brick"}});
  EXPECT_EQ(Last(session).name, "brick 2");
  Do(&session, "held.remove", {{"object", "brick"}});
  EXPECT_EQ(session.project().held_objects.size(), 1u);
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().held_objects.size(), 2u);
}

TEST(HeldObjectOperators, SayWhatTheyRefuse) {
  Session session;
  const auto refused = [&](const char* id, const edit::Json& given) {
    return Refused(&session, id, given).ToString();
  };
  EXPECT_EQ(refused("held.add_ball", edit::Json::object()),
            "held.add_ball.joint: is missing, and no joint is selected");
  EXPECT_EQ(refused("held.add_ball", {{"joint", "tail"}}),
            "held.add_ball.joint: there is no joint \"tail\"");
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  EXPECT_EQ(refused("held.set", {{"object", "ball"}, {"size_x", 1}}),
            "held.set.size_x: a ball has none; boxes have");
  EXPECT_EQ(refused("held.set", {{"object", "ball"}, {"mass", 0}}),
            "held.set.held_objects[0].mass_kg: must be greater than 0, is 0");
  EXPECT_EQ(refused("held.set", {{"object", "stone"}, {"mass", 1}}),
            "held.set.object: there is no \"stone\"; there is \"ball\"");
}

}  // namespace
}  // namespace hazumi::test
