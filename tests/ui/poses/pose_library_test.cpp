// The library of poses as a user has it: kept in a file, clicked, pulled.

#include <filesystem>
#include <fstream>

#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/user.h"
#include "ui/panels/poses/actions.h"
#include "ui/panels/poses/thumbnails.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::test {
namespace {

using edit::Json;

class PoseLibrary : public ::testing::Test {
 protected:
  PoseLibrary() : user("", {900, 800}) { user.editor().poses.library.set_path(path()); }

  std::string path() const { return folder / "poses.json"; }
  void Do(const std::string& id, const Json& parameters = Json::object()) {
    EXPECT_TRUE(user.editor().Do(id, parameters)) << user.editor().message.text;
  }
  std::string Refused(const std::string& id, const Json& parameters) {
    EXPECT_FALSE(user.editor().Do(id, parameters));
    return user.editor().message.text;
  }
  double Angle(const char* hinge) { return user.session().ValueNow(hinge).value(); }
  // A sitting pose of one's own, and the figure as it is in a new project.
  void KeepSitting() {
    Do("pose.rotate", {{"joint", "r_knee"}, {"to", 80}});
    Do("pose.rotate", {{"joint", "l_elbow_flexion"}, {"to", 40}});
    Do("pose.save", {{"name", "sitting"}});
    Do("edit.undo");
    Do("edit.undo");
  }
  // A point of the first picture among the properties: what else is clicked on the way down does
  // nothing to the project.
  ui::Point FirstPicture() {
    user.editor().settings.shares.side = 0.4;
    Do("view.properties", {{"section", "poses"}});
    user.Wait(3);
    const ui::Rect panel =
        ui::LayOutWindow({0.0f, 0.0f, 900.0f, 800.0f}, user.editor().settings.shares, 1.0)
            .properties;
    const size_t steps = user.num_steps();
    for (float y = panel.y + 70.0f; y < panel.bottom(); y += 12.0f) {
      user.Click({panel.x + 60.0f, y});
      if (user.num_steps() == steps) continue;
      Do("edit.undo");
      return {panel.x + 60.0f, y};
    }
    ADD_FAILURE() << "no picture";
    return {};
  }

  TemporaryFolder folder;
  User user;
};

TEST_F(PoseLibrary, WhatIsSavedInOneProjectIsAppliedInAnother) {
  KeepSitting();
  User other("throw.kfa");
  other.editor().poses.library.set_path(path());
  ASSERT_TRUE(other.editor().Do("pose.apply", {{"name", "sitting"}}));
  EXPECT_NEAR(other.session().ValueNow("r_knee").value(), 80.0, 1e-9);
  EXPECT_NEAR(other.session().ValueNow("l_elbow_flexion").value(), 40.0, 1e-9);
  EXPECT_EQ(other.num_steps(), 1u);
  ASSERT_TRUE(other.editor().Do("edit.undo"));
  ASSERT_TRUE(other.editor().Do("pose.apply", {{"name", "sitting"}, {"flipped", true}}));
  EXPECT_NEAR(other.session().ValueNow("l_knee").value(), 80.0, 1e-9);
}

TEST_F(PoseLibrary, AppliesAShareToWhatIsSelected) {
  KeepSitting();
  Do("select.joints", {{"joints", {"r_knee"}}});
  Do("pose.apply", {{"name", "sitting"}, {"share", 0.25}});
  EXPECT_NEAR(Angle("r_knee"), 20.0, 1e-9);
  EXPECT_NEAR(Angle("l_elbow_flexion"), 0.0, 1e-9);
  EXPECT_EQ(user.project().joints.size(), 1u);
}

// The heading and the place on the ground stay, the height and the lean come with the pose.
TEST_F(PoseLibrary, APoseOfTheWholeFigureBringsItsHeightAndLean) {
  for (const auto& [curve, value] : {std::pair("root.x", 2.0), std::pair("root.angle_z", 90.0)}) {
    Do("key.set", {{"curve", curve}, {"frame", 0}, {"value", value}});
  }
  Do("pose.apply", {{"name", "Crouch"}});
  const SavedPose crouch = *user.editor().poses.library.Find("Crouch");
  EXPECT_NEAR(Angle("root.z"), crouch.root->height_m, 1e-9);
  EXPECT_NEAR(Angle("root.angle_y"), crouch.root->angle_y_deg, 1e-9);
  EXPECT_NEAR(Angle("root.x"), 2.0, 1e-9);
  EXPECT_NEAR(Angle("root.angle_z"), 90.0, 1e-9);
}

TEST_F(PoseLibrary, APoseStandsOnTheGroundWhereverThatIs) {
  Project project = user.project();
  ProjectPlane* ground = nullptr;
  for (ProjectSceneObject& object : project.scene.objects) {
    if (auto* plane = std::get_if<ProjectPlane>(&object.shape)) ground = plane;
  }
  ASSERT_NE(ground, nullptr);
  ground->offset_m = -0.3;
  user.editor().session().Replace(std::move(project), "");
  Do("pose.apply", {{"name", "Crouch"}});
  const double height = user.editor().poses.library.Find("Crouch")->root->height_m;
  EXPECT_NEAR(Angle("root.z"), height - 0.3, 1e-9);
  Do("pose.save", {{"name", "low"}});
  EXPECT_NEAR(user.editor().poses.library.Find("low")->root->height_m, height, 1e-9);
}

TEST_F(PoseLibrary, SaysWhatTheFigureDoesNotHaveAndLeavesItAlone) {
  std::ofstream(path()) << R"({"format": "hazumi-poses", "version": 1, "poses": [
    {"name": "cat", "joints": {"tail_3": 20, "r_knee": 30}},
    {"name": "fish", "joints": {"fin": 20}}]})";
  Do("pose.apply", {{"name", "cat"}});
  EXPECT_NEAR(Angle("r_knee"), 30.0, 1e-9);
  EXPECT_EQ(user.editor().message.text, "Left alone, as the figure does not have them: tail_3");
  EXPECT_EQ(Refused("pose.apply", {{"name", "fish"}}),
            "name: the figure has none of the joints of \"fish\" (fin); it was made "
            "for another figure");
}

TEST_F(PoseLibrary, NamesAreKeptApart) {
  KeepSitting();
  EXPECT_EQ(Refused("pose.save", {{"name", "sitting"}}),
            "name: there is a pose \"sitting\" already; choose another name, or replace "
            "it");
  EXPECT_EQ(Refused("pose.save", {{"name", "Crouch"}}),
            "name: \"Crouch\" comes with Hazumi; choose another name");
  EXPECT_EQ(Refused("pose.remove", {{"name", "Crouch"}}),
            "name: \"Crouch\" comes with Hazumi and stays as it is");
  Do("pose.rename", {{"name", "sitting"}, {"to", "chair"}});
  EXPECT_TRUE(user.editor().poses.library.IsOwn("chair"));
  EXPECT_FALSE(user.editor().poses.library.Find("sitting"));
  Do("pose.save", {{"name", "chair"}, {"replace", true}});
  EXPECT_EQ(user.editor().poses.library.own().size(), 1u);
  Do("pose.remove", {{"name", "chair"}});
  EXPECT_TRUE(user.editor().poses.library.own().empty());
}

// What cannot be read is named and never written over.
TEST_F(PoseLibrary, ADamagedFileIsSaidAndStaysAsItIs) {
  std::ofstream(path()) << "{\"format\": \"hazumi-poses\", \"version\": 1, \"poses\": [{}]}";
  const std::string said = Refused("pose.save", {{"name", "mine"}});
  EXPECT_EQ(said, "poses.json, poses[0]: the field \"name\" is missing; add it");
  EXPECT_TRUE(LoadPoses(path()).error().ToString().ends_with("add it"));
  Do("pose.apply", {{"name", "Crouch"}});  // what comes with Hazumi is there all the same
}

TEST_F(PoseLibrary, AClickOnAPictureAppliesThePose) {
  KeepSitting();
  user.Click(FirstPicture());
  EXPECT_NEAR(Angle("r_knee"), 80.0, 1e-9);
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(PoseLibrary, PullingAPictureBlendsInOneStepAndEscTakesItBack) {
  KeepSitting();
  const ui::Point picture = FirstPicture();
  const std::string before = user.text();
  user.Pull(picture, {picture.x + 100.0f, picture.y});
  EXPECT_TRUE(user.editor().has_tool());
  EXPECT_NEAR(Angle("r_knee"), 40.0, 1.0);  // half the width
  user.MoveTo({picture.x + 50.0f, picture.y});
  EXPECT_NEAR(Angle("r_knee"), 20.0, 1.0);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_TRUE(user.text() == before);
  user.Drag(picture, {picture.x + 100.0f, picture.y});
  EXPECT_FALSE(user.editor().has_tool());
  EXPECT_NEAR(Angle("r_knee"), 40.0, 1.0);
  Do("edit.undo");
  EXPECT_TRUE(user.text() == before);
}

TEST_F(PoseLibrary, PicturesComeByThemselvesAndDifferFromPoseToPose) {
  Do("view.properties", {{"section", "poses"}});
  user.Wait();
  ASSERT_TRUE(user.editor().poses.thumbnails);
  EXPECT_TRUE(user.editor().poses.thumbnails->is_busy());
  EXPECT_LT(user.editor().NextDeadline(), 1.0);  // the window looks for them
  while (user.editor().poses.thumbnails->is_busy()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    user.Wait(1);
  }
  EXPECT_FALSE(user.editor().poses.thumbnails->is_busy());
  const auto figure = user.session().animation()->figure;
  std::vector<render::Scene> scenes;
  for (const SavedPose& pose : ui::ShippedPoses()) scenes.push_back(ui::SceneOf(pose, figure));
  const auto pictures = user.editor().pictures.draw(scenes, 64);
  ASSERT_TRUE(pictures.ok()) << pictures.error().ToString();
  for (size_t i = 1; i < pictures.value().size(); ++i) {
    EXPECT_NE(pictures.value()[i].rgba, pictures.value()[i - 1].rgba) << i;
  }
}

TEST_F(PoseLibrary, EachShippedPoseHasAJapaneseName) {
  ui::SetLanguage(ui::Language::kJapanese);
  for (const SavedPose& pose : ui::ShippedPoses()) {
    EXPECT_NE(ui::Tr(pose.name.c_str()), pose.name) << pose.name;
  }
  ui::SetLanguage(ui::Language::kEnglish);
}

}  // namespace
}  // namespace hazumi::test
