#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;
using Names = std::set<std::string>;

TEST(SceneOperators, APlaneIsAddedWithAUnitNormal) {
  Session session;
  Do(&session, "object.add_plane",
     {{"name", "slope"}, {"normal_x", 3}, {"normal_z", 4}, {"offset", -1}, {"color", "#112233"}});
  Do(&session, "object.add_plane", {{"name", "level"}});
  const auto& objects = session.project().scene.objects;
  const auto& slope = std::get<ProjectPlane>(objects[1].shape);
  EXPECT_LE((slope.normal - Vec3(0.6, 0.0, 0.8)).norm(), 1e-15);
  EXPECT_EQ(slope.offset_m, -1.0);
  EXPECT_EQ(objects[1].color, "#112233");
  EXPECT_EQ(std::get<ProjectPlane>(objects[2].shape).normal, Vec3(0.0, 0.0, 1.0));
  EXPECT_EQ(Refused(&session, "object.add_plane", {{"name", "none"}, {"normal_x", 0}}).ToString(),
            "object.add_plane.normal_x: the normal must not be zero: it gives a direction");
  Refused(&session, "object.add_plane", {{"name", "slope"}});
}

TEST(SceneOperators, TheCameraKeepsWhatIsNotGiven) {
  Session session;
  Do(&session, "camera.set", {{"eye_x", 2}, {"drag", "orbit"}});
  Do(&session, "camera.set", {{"eye_y", -1}, {"fov", 50}, {"drag", "orbit"}});
  const ProjectCamera& camera = *session.project().camera;
  EXPECT_EQ(camera.eye_m, Vec3(2.0, -1.0, 1.0));
  EXPECT_EQ(camera.target_m, ProjectCamera().target_m);
  EXPECT_EQ(camera.vertical_fov_deg, 50.0);
  EXPECT_EQ(session.document().num_steps(), 1u);
  EXPECT_EQ(Refused(&session, "camera.set", {{"fov", 180}}).ToString(),
            "camera.set.camera.vertical_fov_deg: must lie between 1 and 179°, is 180 (vertical "
            "field of view)");
}

TEST(SceneOperators, AnObjectKeepsWhatIsNotGiven) {
  Session session;
  Do(&session, "object.add_box", {{"name", "box"}, {"z", 0.5}});
  Do(&session, "object.set", {{"object", "box"}, {"size_x", 0.3}, {"drag", "size"}});
  Do(&session, "object.set", {{"object", "box"}, {"color", "#112233"}, {"drag", "size"}});
  const ProjectSceneObject& box = session.project().scene.objects.back();
  EXPECT_EQ(std::get<ProjectBox>(box.shape).size_m, Vec3(0.3, 1.0, 1.0));
  EXPECT_EQ(box.color, "#112233");
  EXPECT_EQ(session.document().num_steps(), 2u);
  Refused(&session, "object.set", {{"object", "box"}, {"size_y", -1}});
  Refused(&session, "object.set", {{"object", "box"}, {"color", "pink"}});
  EXPECT_EQ(Refused(&session, "object.set", {{"object", "floor"}, {"size_z", 1}}).ToString(),
            "object.set.size_z: a plane has none; boxes have");
}

TEST(SceneOperators, ABoxThatIsMadeHigherKeepsItsBase) {
  Session session;
  Do(&session, "object.add_box", {{"name", "box"}, {"z", 0.5}});
  const auto box = [&] {
    return std::get<ProjectBox>(session.project().scene.objects.back().shape);
  };
  Do(&session, "object.set", {{"object", "box"}, {"size_z", 1.6}});
  EXPECT_NEAR(box().center_m.z(), 0.8, 1e-12);
  Do(&session, "object.set", {{"object", "box"}, {"size_z", 2}, {"z", 0}});
  EXPECT_EQ(box().center_m.z(), 0.0);
  // Turned onto its side it grows that way.
  Do(&session, "object.set", {{"object", "box"}, {"angle_x", 90}});
  Do(&session, "object.set", {{"object", "box"}, {"size_z", 3}});
  EXPECT_LE((box().center_m - Vec3(0.0, -0.5, 0.0)).norm(), 1e-12);
}

TEST(SceneOperators, ACopyIsSoFarFromTheBoxAndHasTheNextNumber) {
  Session session;
  Do(&session, "object.add_box", {{"name", "box"}, {"z", 0.5}});
  Do(&session, "object.duplicate", {{"object", "box"}, {"x", 1}});
  Do(&session, "object.duplicate", {{"object", "box 2"}, {"x", 1}});
  const auto& objects = session.project().scene.objects;
  EXPECT_EQ(objects.back().name, "box 3");
  EXPECT_EQ(std::get<ProjectBox>(objects.back().shape).center_m, Vec3(2.0, 0.0, 0.5));
}

TEST(SessionOperators, SelectMirrorAndNone) {
  Session session;
  Do(&session, "select.joints", {{"joints", {"r_knee", "l_toe", "chest_bend"}}});
  Do(&session, "select.mirror");
  EXPECT_EQ(session.selected_joints(), (Names{"chest_bend", "l_knee", "r_toe"}));
  Do(&session, "select.mirror", {{"add", true}});
  EXPECT_EQ(session.selected_joints(), (Names{"chest_bend", "l_knee", "l_toe", "r_knee", "r_toe"}));
  Do(&session, "select.none");
  EXPECT_TRUE(session.selected_joints().empty());
}

TEST(FieldOperators, SetSeveralFieldsByTheirAddressesInOneStep) {
  Session session;
  Do(&session, "field.set",
     {{"fields", {"scene.gravity_m_s2", "frames.last"}}, {"values", {"1.6", "40"}}});
  EXPECT_EQ(session.project().scene.gravity_m_s2, 1.6);
  EXPECT_EQ(session.project().frames.last, 40);
  EXPECT_EQ(session.document().num_steps(), 1u);
  Refused(&session, "field.set", {{"fields", {"scene.gravity_m_s2"}}, {"values", {"1", "2"}}});
  Refused(&session, "field.set", {{"fields", {"scene.gravity"}}, {"values", {"1"}}});
  Refused(&session, "field.set", {{"fields", {"scene.gravity_m_s2"}}, {"values", {"-1"}}});
  EXPECT_EQ(session.project().scene.gravity_m_s2, 1.6);
}

}  // namespace
}  // namespace hazumi::test
