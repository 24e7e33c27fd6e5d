// What the right button offers in the viewport.

#include "ui/panels/viewport/popups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/ui/viewport/fixture.h"
#include "ui/panels/forms/parameter_form.h"

namespace hazumi::ui {
namespace {

using ViewportPopups = ViewportFixture;

TEST_F(ViewportPopups, ARegionFromAJointOutwardsIsMarkedByItsMenu) {
  editor_.Do("select.joints", {{"joints", {"r_elbow"}}});
  ViewportHit hit;
  hit.joint = *editor_.session().figure().FindGroup("r_elbow");
  const auto items = ItemsAt(editor_, hit);
  const auto item = std::find_if(items.begin(), items.end(), [](const MenuEntry& entry) {
    return std::string(entry.id) == "region.add";
  });
  ASSERT_NE(item, items.end());
  ASSERT_TRUE(editor_.Do(item->id, item->parameters));
  const ProjectRegion& region = editor_.session().project().regions.at(0);
  ASSERT_EQ(region.joints.size(), 1u);
  EXPECT_EQ(region.joints[0].name, "r_elbow");
  EXPECT_TRUE(region.joints[0].beyond);
}

TEST_F(ViewportPopups, EveryMenuOfTheViewportOffersWhatThereIs) {
  ASSERT_TRUE(editor_.Do("object.add_box", {{"name", "crate"}}));
  ViewportHit joint, root, object, nothing;
  joint.joint = *editor_.session().figure().FindGroup("l_knee");
  root.is_root = true;
  object.object = editor_.session().project().scene.objects.back().identity.id;
  for (const ViewportHit& hit : {joint, root, object, nothing}) {
    for (const MenuEntry& entry : ItemsAt(editor_, hit)) {
      EXPECT_NE(LabelOf(entry), "") << entry.id;
      const auto known = edit::Parameters::Check(ParametersOf(entry.id), entry.parameters);
      EXPECT_TRUE(known.ok()) << entry.id;
    }
  }
}

TEST_F(ViewportPopups, ShiftAOpensAllThatCanBeAdded) {
  const Rect& rect = editor_.viewport.rect;
  shell_->MoveMouse(rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h);
  shell_->Frame();
  const auto before = shell_->picture().rgba;
  shell_->PressKey(kLeftShift, true);
  shell_->PressKey('A', true);
  shell_->Frame();
  shell_->PressKey('A', false);
  shell_->PressKey(kLeftShift, false);
  for (int i = 0; i < 3; ++i) shell_->Frame();
  EXPECT_NE(shell_->picture().rgba, before);
  EXPECT_TRUE(editor_.session().selected_joints().empty());
  std::set<std::string> offered;
  for (const MenuEntry& entry : ItemsToAdd()) {
    EXPECT_NE(LabelOf(entry), "") << entry.id;
    offered.insert(entry.id);
  }
  for (const char* id : {"tool.add_box", "object.add_box", "held.add_ball", "file.mesh_dialog"}) {
    EXPECT_TRUE(offered.count(id)) << id;
  }
}

}  // namespace
}  // namespace hazumi::ui
