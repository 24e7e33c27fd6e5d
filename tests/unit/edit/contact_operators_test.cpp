// Regions that touch the scene, and how rough what they touch is.

#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

// The right arm, raised to the side ahead, swings down beside a box.
void AddArmOverBox(Session* session, const Json& more = Json::object()) {
  Do(session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 100}});
  Do(session, "object.add_box",
     {{"name", "table"}, {"x", 0.5}, {"y", -0.2}, {"z", 0.5}, {"size_x", 0.6}});
  Json region = {{"name", "arm"}, {"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 30}};
  region.update(more);
  Do(session, "region.add", region);
}

double AngleAt(Session* session, int frame) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  if (!motion.ok()) return 0.0;
  const JointIndex j = *session->figure().FindJoint("r_shoulder_flexion");
  return motion.value()->frames[frame].q[j.value()];
}

TEST(ContactOperators, ARegionTouchesTheSceneIfThatIsSaid) {
  Session session;
  AddArmOverBox(&session);
  EXPECT_FALSE(session.project().regions[0].contacts.is_any());
  EXPECT_TRUE(Json::parse(WriteProject(session.project()))["version"] == 1);
  const double through = AngleAt(&session, 25);
  Do(&session, "region.set", {{"region", "arm"}, {"contacts", true}});
  EXPECT_TRUE(session.project().regions[0].contacts.scene);
  EXPECT_TRUE(Json::parse(WriteProject(session.project()))["version"] == 2);
  const double on_table = AngleAt(&session, 25);
  EXPECT_GT(on_table, through + 0.1);
  Do(&session, "edit.undo");
  EXPECT_FALSE(session.project().regions[0].contacts.scene);
  EXPECT_EQ(AngleAt(&session, 25), through);
  Do(&session, "edit.redo");
  EXPECT_EQ(AngleAt(&session, 25), on_table);
}

// An arm swings down and back, or is held up by a thigh that is spread.
TEST(ContactOperators, ARegionTouchesTheOwnBodyIfThatIsSaid) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 100}});
  Do(&session, "key.set", {{"curve", "r_hip_flexion"}, {"frame", 0}, {"value", 80}});
  Do(&session, "key.set", {{"curve", "r_hip_abduction"}, {"frame", 0}, {"value", 30}});
  Do(&session, "region.add",
     {{"name", "arm"}, {"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 30}});
  const double through = AngleAt(&session, 25);
  Do(&session, "region.set", {{"region", "arm"}, {"contacts_self", true}});
  EXPECT_TRUE(session.project().regions[0].contacts.self);
  EXPECT_FALSE(session.project().regions[0].contacts.scene);
  EXPECT_TRUE(Json::parse(WriteProject(session.project()))["version"] == 2);
  const double on_thigh = AngleAt(&session, 25);
  EXPECT_GT(on_thigh, through + 0.1);
  // Keys of what it lies on move it.
  Do(&session, "key.set", {{"curve", "r_hip_abduction"}, {"frame", 0}, {"value", 20}});
  const double lower = AngleAt(&session, 25);
  EXPECT_LT(lower, on_thigh - 0.05);
  Session fresh;
  fresh.Replace(session.project(), "");
  EXPECT_EQ(lower, AngleAt(&fresh, 25));
  Do(&session, "edit.undo");
  EXPECT_EQ(AngleAt(&session, 25), on_thigh);
  Do(&session, "edit.undo");
  EXPECT_EQ(AngleAt(&session, 25), through);
}

TEST(ContactOperators, TheMotionFollowsWhatIsTouched) {
  Session session;
  AddArmOverBox(&session, {{"contacts", true}});
  const double before = AngleAt(&session, 25);
  const auto changed = [&](const char* id, const Json& parameters) {
    Do(&session, id, parameters);
    const double after = AngleAt(&session, 25);
    Session fresh;
    fresh.Replace(session.project(), "");
    EXPECT_EQ(after, AngleAt(&fresh, 25)) << id;
    return after != before;
  };
  EXPECT_TRUE(changed("object.move", {{"object", "table"}, {"z", -0.1}}));
  EXPECT_TRUE(changed("object.set", {{"object", "table"}, {"size_z", 0.8}}));
  EXPECT_TRUE(changed("object.set", {{"object", "table"}, {"friction_coefficient", 0.0}}));
  EXPECT_TRUE(changed("object.remove", {{"object", "table"}}));
}

// A ball that falls from a hand by frame 5 and lies or bounces.
double HeightAt(Session* session, int frame) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return motion.ok() ? motion.value()->frames[frame].objects[0].X_WO.p.z() : 0.0;
}

TEST(ContactOperators, ABallThatIsLetGoTouchesTheSceneIfThatIsSaid) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 5}, {"radius", 0.1}});
  const int last = session.project().frames.last;
  const double through = HeightAt(&session, last);
  EXPECT_LT(through, 0.0);
  Do(&session, "held.set", {{"object", "ball"}, {"contacts", true}});
  EXPECT_EQ(Json::parse(WriteProject(session.project()))["version"], 2);
  const double on_floor = HeightAt(&session, last);
  EXPECT_NEAR(on_floor, 0.1, 1e-6);
  Do(&session, "held.set",
     {{"object", "ball"}, {"restitution", 0.9}, {"friction_coefficient", 0.3}});
  const double bounces = HeightAt(&session, last);
  EXPECT_GT(bounces, 0.11);
  Session fresh;
  fresh.Replace(session.project(), "");
  EXPECT_EQ(HeightAt(&fresh, last), bounces);
  Do(&session, "edit.undo");
  EXPECT_EQ(HeightAt(&session, last), on_floor);
  Do(&session, "edit.undo");
  EXPECT_EQ(HeightAt(&session, last), through);
  EXPECT_EQ(Json::parse(WriteProject(session.project()))["version"], 1);
}

TEST(ContactOperators, ABoxThatIsHeldCannotTouchTheSceneYet) {
  Session session;
  Do(&session, "held.add_box", {{"joint", "r_wrist"}});
  EXPECT_EQ(Refused(&session, "held.set", {{"object", "box"}, {"contacts", true}}).ToString(),
            "held.set.held_objects[0].contacts: \"box\" is a box, and of what is let go only balls "
            "can touch the scene yet; make it a sphere, or let it touch nothing");
}

TEST(ContactOperators, ByThePapersMethodNothingTouches) {
  Session session;
  AddArmOverBox(&session, {{"contacts", true}});
  const Error error = Refused(&session, "region.set", {{"region", "arm"}, {"method", "paper"}});
  EXPECT_NE(error.message.find("knows no contacts"), std::string::npos) << error.message;
  Do(&session, "region.set", {{"region", "arm"}, {"method", "paper"}, {"contacts", false}});
}

TEST(ContactOperators, PartsOfARegionTouchWhatItTouched) {
  Session session;
  AddArmOverBox(&session, {{"contacts", true}});
  Do(&session, "region.split", {{"region", "arm"}, {"frame", 12}});
  EXPECT_TRUE(session.project().regions[0].contacts.scene);
  EXPECT_TRUE(session.project().regions[1].contacts.scene);
}

TEST(ContactOperators, ObjectsHaveAFrictionThatIsNotNegative) {
  Session session;
  const auto last = [&] { return session.project().scene.objects.back().friction_coefficient; };
  Do(&session, "object.add_plane", {{"name", "ice"}, {"friction_coefficient", 0.05}});
  EXPECT_EQ(last(), 0.05);
  Do(&session, "object.add_box", {{"name", "box"}});
  EXPECT_EQ(last(), 0.8);
  Do(&session, "object.set", {{"object", "box"}, {"friction_coefficient", 1.5}});
  EXPECT_EQ(last(), 1.5);
  Do(&session, "object.duplicate", {{"object", "box"}, {"x", 2}});
  EXPECT_EQ(last(), 1.5);
  const Error error =
      Refused(&session, "object.set", {{"object", "box"}, {"friction_coefficient", -0.1}});
  EXPECT_NE(error.message.find("must not be negative"), std::string::npos) << error.message;
}

}  // namespace
}  // namespace hazumi::test
