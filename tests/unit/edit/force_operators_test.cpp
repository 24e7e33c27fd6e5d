#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

std::string ForcesOf(const Session& session) {
  std::string text;
  for (const ProjectForce& force : session.project().forces) {
    text += (text.empty() ? "" : " ") + force.name + ":" + NameOf(force.kind());
  }
  return text;
}

const AttractForce& PullOf(const Session& session) {
  return std::get<AttractForce>(session.project().forces[0].action);
}

// With a region that moves the right arm.
void AddSwing(Session* session) {
  Do(session, "region.add", {{"joints", {"r_shoulder+"}}, {"first", 0}, {"last", 30}});
}

TEST(ForceOperators, EachKindBeginsWithSomethingThatIsFelt) {
  Session session;
  AddSwing(&session);
  Do(&session, "time.frame", {{"frame", 12}});
  Do(&session, "select.joints", {{"joints", {"r_elbow"}}});
  for (const char* kind : kForceKinds) Do(&session, "force.add", {{"kind", kind}});
  EXPECT_EQ(ForcesOf(session), "wind:wind attract:attract push:push");
  const std::vector<ProjectForce>& forces = session.project().forces;
  EXPECT_EQ(forces[0].last_frame, session.project().frames.last);
  EXPECT_EQ(forces[1].joint, "r_elbow");
  EXPECT_EQ(forces[2].first_frame, 12);
  for (const ProjectForce& force : forces) EXPECT_TRUE(force.identity.id.is_valid());
}

TEST(ForceOperators, AreUndoneAndNamedOnce) {
  Session session;
  AddSwing(&session);
  Do(&session, "force.add", {{"kind", "attract"}, {"joint", "r_wrist"}, {"to_x", 0.5}});
  Do(&session, "force.add", {{"kind", "attract"}, {"joint", "r_elbow"}, {"name", "attract"}});
  EXPECT_EQ(ForcesOf(session), "attract:attract attract 2:attract");
  for (const double pull : {10.0, 20.0}) {
    Do(&session, "force.set", {{"force", "attract"}, {"pull", pull}, {"drag", "1"}});
  }
  EXPECT_EQ(PullOf(session).force, 20.0);
  Do(&session, "force.set", {{"force", "attract"}, {"name", "magnet"}});
  Do(&session, "force.remove", {{"force", "attract 2"}});
  EXPECT_EQ(ForcesOf(session), "magnet:attract");
  for (int i = 0; i < 2; ++i) Do(&session, "edit.undo");
  EXPECT_EQ(ForcesOf(session), "attract:attract attract 2:attract");
  Do(&session, "edit.undo");
  EXPECT_EQ(PullOf(session).force, 40.0);
  EXPECT_EQ(PullOf(session).to.x(), 0.5);
}

// A changed kind starts from values that the file says: the reopened project becomes the same.
TEST(ForceOperators, AnotherKindIsTheSameAfterOpeningAgain) {
  const TemporaryFolder folder;
  for (const char* from : kForceKinds) {
    for (const char* to : kForceKinds) {
      Session session, again;
      AddSwing(&session);
      Do(&session, "select.joints", {{"joints", {"r_wrist"}}});
      Do(&session, "force.add",
         {{"kind", from}, {"velocity_y", 2}, {"pull", 7}, {"impulse_y", 3}, {"offset_x", 0.1}});
      Do(&session, "file.save", {{"path", folder / "force.kfa"}});
      Do(&again, "file.open", {{"path", folder / "force.kfa"}});
      Do(&again, "select.joints", {{"joints", {"r_wrist"}}});
      const std::string name = session.project().forces[0].name;
      for (Session* each : {&session, &again})
        Do(each, "force.set", {{"force", name}, {"kind", to}, {"first", 2}});
      EXPECT_EQ(WriteProject(again.project()), WriteProject(session.project()))
          << from << " to " << to;
    }
  }
}

TEST(ForceOperators, AnotherKindGetsWhatItNeeds) {
  Session session;
  AddSwing(&session);
  Do(&session, "select.joints", {{"joints", {"r_wrist"}}});
  Do(&session, "force.add", {{"kind", "push"}, {"frame", 7}});
  Do(&session, "force.set", {{"force", "push"}, {"kind", "wind"}, {"velocity_x", 3}});
  EXPECT_EQ(session.project().forces[0].first_frame, 7);
  EXPECT_GT(session.project().forces[0].last_frame, 7);
  Do(&session, "force.remove", {{"force", "push"}});
  Do(&session, "force.add", {{"kind", "wind"}});
  Do(&session, "force.set", {{"force", "wind"}, {"kind", "attract"}});
  EXPECT_EQ(session.project().forces[0].joint, "r_wrist");
}

TEST(ForceOperators, RefuseWhatCannotBe) {
  Session session;
  AddSwing(&session);
  Do(&session, "force.add", {{"kind", "wind"}});
  EXPECT_EQ(Refused(&session, "force.set", {{"force", "breeze"}, {"density", 1}}).ToString(),
            "force.set.force: there is no \"breeze\"; there is \"wind\"");
  Refused(&session, "force.set", {{"force", "wind"}, {"density", -1}});
  EXPECT_EQ(Refused(&session, "force.add", {{"kind", "wind"}}).place, "force.add.forces[1]");
  Refused(&session, "force.add", {{"kind", "attract"}, {"joint", "nose"}});
  Refused(&session, "force.add", {{"kind", "push"}, {"joint", "l_wrist"}});
}

// As those of a hold, its ends go along where all keys between are moved.
TEST(ForceOperators, GoAlongWithTheKeysAboutThem) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 10}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 20}, {"value", 40}});
  Do(&session, "region.add", {{"joints", {"r_shoulder+"}}, {"first", 4}, {"last", 16}});
  Do(&session, "force.add", {{"kind", "wind"}, {"first", 4}, {"last", 12}});
  Do(&session, "force.add", {{"kind", "push"}, {"joint", "r_wrist"}, {"frame", 8}});
  Do(&session, "keys.select_all");
  Do(&session, "keys.move", {{"frames", 5}});
  EXPECT_EQ(session.project().forces[0].first_frame, 9);
  EXPECT_EQ(session.project().forces[0].last_frame, 17);
  EXPECT_EQ(session.project().forces[1].first_frame, 13);
}

}  // namespace
}  // namespace hazumi::test
