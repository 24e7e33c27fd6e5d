// What the properties show, and where.

#include <gtest/gtest.h>

#include "ui/edit/operators/keys/at_frame.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::test {
namespace {

using namespace ui;

TEST(FieldState, TellsWhereAValueComesFrom) {
  ProjectCurve curve;
  EXPECT_EQ(StateOfField(nullptr, 5.0, 12.0, false), FieldState::kPlain);
  EXPECT_EQ(StateOfField(&curve, 5.0, 12.0, false), FieldState::kPlain);
  ProjectKey key;
  key.frame = 5.0;
  key.value = 12.0;
  curve.keys = {key};
  EXPECT_EQ(StateOfField(&curve, 5.0, 12.0, false), FieldState::kKeyed);
  EXPECT_EQ(StateOfField(&curve, 5.0, 12.5, false), FieldState::kChanged);
  EXPECT_EQ(StateOfField(&curve, 6.0, 12.0, false), FieldState::kInterpolated);
  EXPECT_EQ(StateOfField(&curve, 5.0, 12.0, true), FieldState::kComputed);
}

TEST(FieldState, ARegionComputesAfterItsFirstFrame) {
  Animation animation;
  DynamicsRegion region;
  region.first_frame = 10;
  region.last_frame = 20;
  region.joints = {JointIndex(3), JointIndex(4)};
  animation.regions = {region};
  EXPECT_FALSE(edit::IsSwung(animation, JointIndex(3), 10.0));
  EXPECT_TRUE(edit::IsSwung(animation, JointIndex(3), 10.5));
  EXPECT_TRUE(edit::IsSwung(animation, JointIndex(3), 20.0));
  EXPECT_FALSE(edit::IsSwung(animation, JointIndex(3), 21.0));
  EXPECT_FALSE(edit::IsSwung(animation, JointIndex(5), 15.0));
  // What another region leaves behind where this one begins is computed as well.
  region.first_frame = 0;
  region.last_frame = 10;
  animation.regions.push_back(region);
  EXPECT_TRUE(edit::IsSwung(animation, JointIndex(3), 10.0));
}

TEST(PropertiesLayout, TabsAreBesideTheContentAndFoundByTheMouse) {
  for (const double scale : {1.0, 1.5}) {
    const PropertiesLayout layout = LayOutProperties({100.0f, 50.0f, 300.0f, 400.0f}, scale);
    ASSERT_EQ(layout.tabs.size(), 7u);
    for (size_t i = 0; i < layout.tabs.size(); ++i) {
      const Rect& tab = layout.tabs[i];
      EXPECT_LE(tab.right(), layout.content.x);
      EXPECT_EQ(TabAt(layout, {tab.x + 1.0f, tab.y + 1.0f}), static_cast<Section>(i));
    }
    EXPECT_EQ(layout.content.right(), 400.0f);
    EXPECT_FALSE(TabAt(layout, {layout.content.x + 1.0f, 60.0f}));
  }
}

TEST(PropertiesLayout, PartsOfARowDoNotOverlap) {
  for (const bool has_button : {false, true}) {
    const RowParts parts = PartsOfRow({10.0f, 0.0f, 240.0f, 20.0f}, 40.0f, has_button, 1.0);
    EXPECT_LT(parts.label.right(), parts.field.x);
    EXPECT_LE(parts.field.right(), parts.button.x);
    EXPECT_EQ(parts.button.right(), 250.0f);
  }
}

TEST(PropertiesRow, ALongLabelIsWrittenInFull) {
  const Rect row = {10.0f, 0.0f, 240.0f, 20.0f};
  const RowParts longer = PartsOfRow(row, 130.0f, true, 1.0);  // than its column
  EXPECT_GE(longer.label.w, 130.0f);
  EXPECT_GE(longer.field.w, 60.0f);
  EXPECT_EQ(longer.field.y, row.y);
  const RowParts longest = PartsOfRow(row, 200.0f, true, 1.0);
  EXPECT_GE(longest.label.w, 200.0f);
  EXPECT_EQ(longest.field.y, row.bottom());
  EXPECT_EQ(longest.button.right(), 250.0f);
}

TEST(ShownRegion, IsTheChosenOneElseOneAtTheFrame) {
  Project project;
  EXPECT_FALSE(ShownRegion(project, ItemId(), 0.0));
  ProjectRegion first, second;
  first.name = "first";
  first.last_frame = 5;
  second.name = "second";
  second.first_frame = 10;
  second.last_frame = 15;
  first.identity.id = ItemId(1);
  second.identity.id = ItemId(2);
  project.regions = {first, second};
  EXPECT_EQ(ShownRegion(project, ItemId(), 12.0), 1u);
  EXPECT_EQ(ShownRegion(project, ItemId(1), 12.0), 0u);
  EXPECT_EQ(ShownRegion(project, ItemId(9), 30.0), 0u);
}

TEST(ModelText, SaysWhatWasSolved) {
  RegionReport report;
  report.free_joints = 14;
  report.all_joints = 37;
  report.islands = {7, 7};
  report.bodies = 6;
  SetLanguage(Language::kEnglish);
  EXPECT_EQ(ModelText(report), "14 of 37 joints, 2 groups of 7, 6 bodies");
  report.islands = {7, 2};
  EXPECT_EQ(ModelText(report), "14 of 37 joints, 1 group of 7, 1 group of 2, 6 bodies");
}

}  // namespace
}  // namespace hazumi::test
