// What the right button offers in the viewport.

#include "ui/panels/viewport/popups.h"

#include <gtest/gtest.h>

#include <algorithm>

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

}  // namespace
}  // namespace hazumi::ui
