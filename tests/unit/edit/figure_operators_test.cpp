#include "engine/body/figure_body.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

const Joint& JointOf(const Session& session, const char* hinge) {
  return session.figure().joint(*session.figure().FindJoint(hinge));
}

double MassOf(const Session& session, const std::string& name) {
  for (const JointSpec& joint : session.project().figure.spec.joints) {
    for (const LinkSpec& link : joint.links) {
      if (link.name == name) return link.mass.value();
    }
  }
  ADD_FAILURE() << "no link " << name;
  return 0.0;
}

TEST(FigureOperators, LimitsOfBothSidesFollow) {
  Session session;
  for (const int upper : {120, 110, 100}) {
    Do(&session, "figure.joint_limits", {{"joint", "l_knee"}, {"upper", upper}, {"drag", "1"}});
  }
  EXPECT_NEAR(JointOf(session, "r_knee").upper * 57.29577951308232, 100.0, 1e-9);
  EXPECT_NEAR(JointOf(session, "l_knee").upper * 57.29577951308232, 100.0, 1e-9);
  EXPECT_EQ(session.document().num_steps(), 1u);
  Do(&session, "pose.rotate", {{"joint", "r_knee"}, {"to", 125}});
  EXPECT_NEAR(session.ValueNow("r_knee").value(), 100.0, 1e-9);
  Do(&session, "edit.undo");
  Do(&session, "edit.undo");
  ASSERT_TRUE(session.WholeMotion().ok());
  EXPECT_NEAR(JointOf(session, "r_knee").upper * 57.29577951308232, 130.0, 1e-9);
}

TEST(FigureOperators, ALinkGetsHeavier) {
  Session session;
  const double before = session.figure().total_mass();
  const double hand = MassOf(session, "r_hand");
  Do(&session, "figure.link", {{"link", "r_hand"}, {"mass", 2}, {"radius", 0.05}});
  EXPECT_NEAR(session.figure().total_mass() - before, 2.0 * (2.0 - hand), 1e-9);
}

TEST(FigureOperators, RolesOfAFigureWithMirroredSidesAreToldByNames) {
  Session session;
  const Project before = session.project();
  EXPECT_NE(Refused(&session, "figure.role", {{"joint", "waist"}, {"role", "tail"}})
                .ToString()
                .find("mirror"),
            std::string::npos);
  EXPECT_EQ(session.project(), before);
}

TEST(FigureOperators, ARoleIsChangedAndUndone) {
  Session session;
  Project project = session.project();
  project.figure.spec = WithMirroredTwins(project.figure.spec);
  project.figure.spec.mirror.reset();
  project.figure.embedded_json = FigureText(project.figure.spec);
  session.Replace(project, "");
  session.set_selected_joints({"l_toe"});
  Do(&session, "figure.role", {{"joint", "l_toe"}, {"role", "finger"}, {"side", "left"}});
  EXPECT_EQ(session.selected_joints(),
            (std::set<std::string>{"l_toe_flexion", "l_toe_spread", "l_toe_rotation"}));
  const FigureBody body(session.figure());
  const GroupIndex toe = *session.figure().FindGroup("l_toe");
  EXPECT_EQ(body.PlaceOf(toe), (BodyPlace{BodyRole::kFinger, BodySide::kLeft}));
  EXPECT_EQ(session.figure().group(toe).size, 3) << "a finger has three hinges";
  EXPECT_EQ(body.PlaceOf(*session.figure().FindGroup("r_toe")),
            (BodyPlace{BodyRole::kToe, BodySide::kRight}));
  Do(&session, "edit.undo");
  EXPECT_EQ(session.figure().group(*session.figure().FindGroup("l_toe")).size, 1);
}

TEST(FigureOperators, ASkinIsTakenOffAndPutOnAndTheMotionStays) {
  Session session;
  ASSERT_TRUE(session.project().skin) << "a new project has one";
  const Motion before = *session.WholeMotion().value();
  Do(&session, "figure.skin", {{"skin", "none"}});
  EXPECT_FALSE(session.project().skin);
  EXPECT_EQ(session.WholeMotion().value()->frames[0].q, before.frames[0].q);
  Do(&session, "edit.undo");
  EXPECT_TRUE(session.project().skin);
  Do(&session, "edit.redo");
  Do(&session, "figure.skin", {{"skin", "human"}});
  EXPECT_EQ(session.project().skin.meshes(), MeshesOf(ShippedSkin::kHuman));
}

TEST(FigureOperators, ASkinIsRefusedByAFigureThatLacksItsJoints) {
  Session session;
  Project project = session.project();
  std::string& text = project.figure.embedded_json;
  for (size_t at = 0; (at = text.find("pelvis", at)) != std::string::npos;) {
    text.replace(at, 6, "middle");
  }
  project.skin = {};
  project.figure.spec = ParseFigure(text, "").value();
  session.Replace(std::move(project), "");
  EXPECT_EQ(Refused(&session, "figure.skin", {{"skin", "human"}}).ToString(),
            "figure.skin.skin: the figure has no joint \"pelvis\", as the skin needs");
  EXPECT_EQ(Refused(&session, "figure.skin", {{"skin", "fur"}}).ToString(),
            "figure.skin.skin: \"fur\" is none of human, none");
}

TEST(FigureOperators, SayWhatIsWrong) {
  Session session;
  const auto refused = [&](const char* id, const Json& parameters) {
    return Refused(&session, id, parameters).ToString();
  };
  EXPECT_EQ(refused("figure.joint_limits", {{"joint", "r_knee"}, {"lower", 140}}),
            "figure.joint_limits.lower: the lower limit 140 is above the upper one, 130");
  EXPECT_EQ(refused("figure.link", {{"link", "r_hand"}, {"mass", -1}}),
            "figure.link.mass: must not be negative");
  EXPECT_EQ(refused("figure.link", {{"link", "r_hand"}, {"radius", 0}}),
            "figure.link.radius: must be greater than 0");
  EXPECT_EQ(refused("figure.embed", Json::object()), "figure.embed.figure: is embedded already");
}

TEST(FigureOperators, UndoBringsTheFigureBackAtOnce) {
  Session session;
  const auto upper = [&] {
    return session.figure().joint(*session.figure().FindJoint("r_knee")).upper;
  };
  const double before = upper();
  Do(&session, "figure.joint_limits", {{"joint", "r_knee"}, {"upper", 60}});
  EXPECT_NE(upper(), before);
  Do(&session, "edit.undo");
  EXPECT_EQ(upper(), before);
}

}  // namespace
}  // namespace hazumi::test
