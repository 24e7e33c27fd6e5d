// The outliner: which rows there are, where they are, and what a click does.

#include <gtest/gtest.h>

#include <algorithm>

#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/outliner/hit_test.h"
#include "ui/panels/outliner/input.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/window/panels.h"
#include "ui/shell/offscreen_shell.h"

namespace hazumi::test {
namespace {

using namespace ui;

std::vector<OutlinerRow> RowsOf(const Editor& editor) {
  return OutlinerRows(editor.session().figure(), editor.session().project(), editor.side);
}

size_t RowNamed(const std::string& name, const std::vector<OutlinerRow>& rows) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const OutlinerRow& r) { return r.name == name; });
  EXPECT_NE(row, rows.end()) << name;
  return static_cast<size_t>(row - rows.begin());
}

std::vector<std::string> NamesOfRows(const std::vector<OutlinerRow>& rows) {
  std::vector<std::string> names;
  for (const OutlinerRow& row : rows) names.push_back(row.name);
  return names;
}

TEST(OutlinerRows, LimbsFollowTheFigureFromTheRootOn) {
  const Editor editor;
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  EXPECT_EQ(rows[0].kind, OutlinerRowKind::kRoot);
  const size_t shoulder = RowNamed("r_shoulder", rows);
  EXPECT_EQ(rows[shoulder + 1].name, "r_elbow");
  EXPECT_EQ(rows[shoulder + 2].name, "r_wrist");
  EXPECT_EQ(rows[shoulder + 1].depth, rows[shoulder].depth + 1);
  EXPECT_EQ(rows[shoulder].side, BodySide::kRight);
  EXPECT_EQ(rows[RowNamed("l_knee", rows)].side, BodySide::kLeft);
  EXPECT_EQ(rows[RowNamed("neck", rows)].side, BodySide::kMiddle);
  EXPECT_LT(RowNamed("l_toe", rows), RowNamed("Scene", rows));
}

TEST(OutlinerRows, AnOpenedJointShowsItsHingesByTheirShortNames) {
  Editor editor;
  editor.side.opened = {"r_wrist"};
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  const size_t wrist = RowNamed("r_wrist", rows);
  EXPECT_TRUE(rows[wrist].is_open);
  EXPECT_EQ(rows[wrist + 1].name, "r_wrist_flexion");
  EXPECT_EQ(rows[wrist + 1].label, "flexion");
  EXPECT_EQ(rows[wrist + 2].label, "deviation");
}

TEST(OutlinerRows, ASearchLeavesWhatHasTheText) {
  Editor editor;
  editor.side.search = "KNEE";
  EXPECT_EQ(NamesOfRows(RowsOf(editor)), (std::vector<std::string>{"pelvis", "r_knee", "l_knee"}));
  editor.side.search = "r_wrist_dev";
  EXPECT_EQ(NamesOfRows(RowsOf(editor)),
            (std::vector<std::string>{"pelvis", "r_wrist", "r_wrist_deviation"}));
  editor.side.search = "no such thing";
  EXPECT_TRUE(RowsOf(editor).empty());
}

TEST(OutlinerRows, ItemsOfEveryKindWithAHeadingAreListed) {
  Editor editor;
  ASSERT_TRUE(editor.Do("force.add", {{"kind", "wind"}, {"name", "gale"}, {"velocity_x", 5.0}}));
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  const OutlinerRow& gale = rows[RowNamed("gale", rows)];
  EXPECT_EQ(rows[RowNamed("gale", rows) - 1].name, "Forces");
  EXPECT_EQ(gale.thing, Thing::kForce);
  EXPECT_EQ(gale.item, editor.session().project().forces[0].identity.id);
}

TEST(OutlinerHitTest, FindsTheRowAndItsTriangle) {
  const Editor editor;
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  OutlinerPlace place;
  place.list = {100.0f, 50.0f, 200.0f, 100.0f};
  place.scroll = 30.0f;
  const auto hit = HitOutliner(rows, place, {250.0f, 50.0f + 15.0f});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->row, 2u);  // 45 px below the first one's upper edge
  EXPECT_EQ(hit->part, OutlinerPart::kLabel);
  const Rect triangle = place.Disclosure(rows[2], 2);
  EXPECT_EQ(HitOutliner(rows, place, {triangle.x + 2.0f, triangle.y + 12.0f})->part,
            OutlinerPart::kDisclosure);
  const Rect eye = place.Eye(2), lock = place.Lock(2);
  EXPECT_EQ(HitOutliner(rows, place, {eye.x + 2.0f, eye.y + 12.0f})->part, OutlinerPart::kEye);
  EXPECT_EQ(HitOutliner(rows, place, {lock.x + 2.0f, lock.y + 12.0f})->part, OutlinerPart::kLock);
  EXPECT_FALSE(HitOutliner(rows, place, {90.0f, 60.0f}));
  place.scroll = 10000.0f;
  EXPECT_FALSE(HitOutliner(rows, place, {250.0f, 60.0f}));
}

TEST(OutlinerClick, ShiftSelectsFromTheRowThatWasClickedBefore) {
  Editor editor;
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  ClickOutliner(&editor, rows, {RowNamed("r_shoulder", rows), OutlinerPart::kLabel},
                ClickMode::kOnly);
  ClickOutliner(&editor, rows, {RowNamed("r_wrist", rows), OutlinerPart::kLabel},
                ClickMode::kExtend);
  const std::set<std::string>& selected = editor.session().selected_joints();
  EXPECT_EQ(selected.size(), 7u);
  EXPECT_TRUE(selected.contains("r_elbow_pronation"));
  ClickOutliner(&editor, rows, {RowNamed("r_elbow", rows), OutlinerPart::kLabel},
                ClickMode::kToggle);
  EXPECT_EQ(selected.size(), 5u);
  EXPECT_FALSE(selected.contains("r_elbow_pronation"));
  EXPECT_EQ(editor.session().document().num_steps(), 0u);  // nothing to undo
}

TEST(OutlinerClick, TheEyeHidesAJointAndShowsItAgain) {
  Editor editor;
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  const OutlinerHit eye = {RowNamed("r_elbow", rows), OutlinerPart::kEye};
  ClickOutliner(&editor, rows, eye, ClickMode::kOnly);
  EXPECT_EQ(editor.session().hidden_joints(),
            (std::set<std::string>{"r_elbow_flexion", "r_elbow_pronation"}));
  EXPECT_TRUE(editor.session().selected_joints().empty());
  ClickOutliner(&editor, rows, eye, ClickMode::kOnly);
  EXPECT_TRUE(editor.session().hidden_joints().empty());
}

TEST(OutlinerClick, TheLockKeepsAJointFromBeingPosed) {
  Editor editor;
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  ClickOutliner(&editor, rows, {RowNamed("r_elbow", rows), OutlinerPart::kLock}, ClickMode::kOnly);
  EXPECT_FALSE(editor.Do("pose.rotate", {{"joint", "r_elbow_flexion"}, {"to", 30}}));
  EXPECT_NE(editor.message.text.find("locked"), std::string::npos);
  EXPECT_TRUE(editor.Do("pose.rotate", {{"joint", "l_elbow_flexion"}, {"to", 30}}));
}

TEST(OutlinerClick, AConstraintIsChosenByItsBar) {
  Editor editor;
  ASSERT_TRUE(editor.Do("held.add_ball", {{"joint", "r_wrist"}}));
  SelectObject(&editor, editor.session().project().held_objects[0].identity.id);
  ASSERT_TRUE(editor.Do("constraint.add", {{"kind", "distance"},
                                           {"name", "rope"},
                                           {"a_joint", "r_wrist"},
                                           {"b_joint", "neck"},
                                           {"first", 5},
                                           {"last", 10}}));
  const std::vector<OutlinerRow> rows = RowsOf(editor);
  ClickOutliner(&editor, rows, {RowNamed("rope", rows), OutlinerPart::kLabel}, ClickMode::kOnly);
  const auto bar = ChosenBar(editor.session().project(), editor.sheet);
  ASSERT_TRUE(bar);
  EXPECT_EQ(*bar, (BarRef{BarKind::kConstraint, 0}));
  EXPECT_FALSE(editor.viewport.selected_object.is_valid());
  EXPECT_EQ(editor.side.section, Section::kScene);
}

TEST(Outliner, AClickOnARowSelectsItsJoint) {
  Editor editor;
  auto made = OffscreenShell::Create(&editor, {640, 400});
  ASSERT_TRUE(made.ok()) << made.error().ToString();
  OffscreenShell& shell = *made.value();
  shell.Frame();
  const Rect panel =
      LayOutWindow({0.0f, 0.0f, 640.0f, 400.0f}, editor.settings.shares, 1.0).outliner;
  // The third row, the chest, lies below the search field.
  shell.MoveMouse(panel.x + 60.0f, panel.y + 80.0f);
  shell.Frame();
  shell.PressButton(0, true);
  shell.Frame();
  shell.PressButton(0, false);
  shell.Frame();
  EXPECT_EQ(editor.session().selected_joints(),
            (std::set<std::string>{"chest_bend", "chest_flexion", "chest_rotation"}));
  EXPECT_EQ(editor.side.active, "chest");
}

}  // namespace
}  // namespace hazumi::test
