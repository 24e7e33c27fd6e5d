// Where the dope sheet puts what, and what is under the mouse.

#include <gtest/gtest.h>

#include <map>

#include "engine/figure/figure_builder.h"
#include "tests/support/capture_skeletons.h"
#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/outliner/limbs.h"

namespace hazumi::ui {
namespace {

constexpr Rect kRect = {0.0f, 100.0f, 700.0f, 300.0f};

edit::Session Throw() {
  edit::Session session;
  const Result<Done> done =
      session.Run("file.open", {{"path", HAZUMI_SOURCE_DIR "/assets/examples/throw.kfa"}});
  EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().ToString());
  return session;
}

const RowBar& BarOn(const DopeSheetLayout& layout, const std::string& row) {
  for (const RowBar& bar : layout.bars) {
    if (layout.rows[bar.row].id == row) return bar;
  }
  ADD_FAILURE() << "no bar on " << row;
  static const RowBar none;
  return none;
}

Point Middle(const Rect& rect) { return {rect.x + 0.5f * rect.w, rect.y + 3.0f}; }

TEST(TimeAxis, ZoomKeepsTheFrameUnderTheMouse) {
  const TimeAxis axis = {0.0, 40.0, 150.0f, 400.0f};
  const TimeAxis closer = Zoomed(axis, 250.0f, 2.0);
  EXPECT_NEAR(closer.FrameAt(250.0f), axis.FrameAt(250.0f), 1e-9);
  EXPECT_NEAR(closer.last - closer.first, 20.0, 1e-9);
  const TimeAxis closest = Zoomed(axis, 250.0f, 1e9);
  EXPECT_GE(closest.last - closest.first, 1.9);
}

TEST(TimeAxis, NumbersStandOneTwoFiveFramesApart) {
  for (const auto& [last, step] :
       {std::pair(8.0, 1), {15.0, 2}, {40.0, 5}, {80.0, 10}, {160.0, 20}}) {
    EXPECT_EQ(FrameStep({0.0, last, 0.0f, 400.0f}, 46.0), step) << last;
  }
  for (const Tick& tick : FrameTicks({-3.0, 37.0, 0.0f, 400.0f}, 46.0)) {
    EXPECT_EQ(tick.is_major, static_cast<int>(tick.value) % 5 == 0) << tick.value;
  }
}

TEST(DopeSheetLayout, HasARowForEachLimb) {
  const edit::Session session;
  std::vector<std::string> names;
  for (const SheetRow& row : SheetRows(session, {})) names.push_back(row.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Summary", "Placement", "Root", "Torso", "Head",
                                             "Right arm", "Left arm", "Right leg", "Left leg"}));
}

// As captures call their joints, and characters.
TEST(DopeSheetLayout, LimbsOfImportedFiguresHaveSides) {
  const auto names = [](const FigureSpec& spec) {
    std::vector<std::string> limbs;
    for (const Limb& limb : LimbsOf(BuildFigure(spec).value())) limbs.push_back(limb.name);
    return limbs;
  };
  FigureSpec spec = test::CaptureSpec();
  EXPECT_EQ(names(spec), (std::vector<std::string>{"Torso", "Head", "Left arm", "Right arm",
                                                   "Left leg", "Right leg"}));
  const std::map<std::string, std::string> other = {{"LeftArm", "upperarm.l"},
                                                    {"RightArm", "upperarm.r"}};
  for (JointSpec& joint : spec.joints) {
    if (other.contains(joint.name)) joint.name = other.at(joint.name);
    if (other.contains(joint.parent)) joint.parent = other.at(joint.parent);
  }
  EXPECT_EQ(names(spec)[2], "Left arm");
  EXPECT_EQ(names(spec)[3], "Right arm");
  for (JointSpec& joint : spec.joints) joint.body = BodyPlace();
  EXPECT_EQ(names(spec)[3], "upperarm.r - RightHand") << "roles go before names";
}

TEST(DopeSheetLayout, RowsOpenToJointsAndHinges) {
  const edit::Session session;
  SheetState state;
  state.open = {"limb r_shoulder", "joint r_elbow"};
  std::vector<std::string> ids;
  for (const SheetRow& row : SheetRows(session, state)) {
    if (row.depth > 0) ids.push_back(row.id);
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"joint r_shoulder", "joint r_elbow", "r_elbow_flexion",
                                           "r_elbow_pronation", "joint r_wrist"}));
}

TEST(DopeSheetLayout, OnlySelectedLeavesTheirRows) {
  edit::Session session;
  session.set_selected_joints({"r_knee"});
  SheetState state;
  state.only_selected = true;
  std::vector<std::string> ids;
  for (const SheetRow& row : SheetRows(session, state)) ids.push_back(row.id);
  EXPECT_EQ(ids, (std::vector<std::string>{"summary", "placement", "limb r_hip"}));
}

TEST(DopeSheetLayout, RegionLiesOnTheRowsOfTheLimbsItHolds) {
  const edit::Session session = Throw();
  const SheetState state;
  const DopeSheetLayout layout = LayOutDopeSheet(session, state, kRect, 1.0);
  std::vector<std::string> ids;
  for (const RowBar& bar : layout.bars) {
    if (bar.ref.kind != BarKind::kRegion) continue;
    ids.push_back(layout.rows[bar.row].id);
    EXPECT_EQ(bar.num_held, bar.num_hinges);
    EXPECT_FLOAT_EQ(bar.rect.x, layout.frame.axis.XOf(5));
    EXPECT_FLOAT_EQ(bar.rect.right(), layout.frame.axis.XOf(15));
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"limb r_shoulder", "limb l_shoulder"}));
  EXPECT_EQ(BarOn(layout, "placement").ref.kind, BarKind::kPlacement);
}

TEST(DopeSheetLayout, ABarOfSomeJointsSaysHowMany) {
  edit::Session session = Throw();
  ASSERT_TRUE(session.Run("region.set", {{"region", "arms"}, {"joints", {"r_elbow+"}}}).ok());
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  EXPECT_EQ(BarOn(layout, "limb r_shoulder").num_held, 4);
  EXPECT_EQ(BarOn(layout, "limb r_shoulder").num_hinges, 7);
}

TEST(DopeSheetLayout, OverlappingRegionsOfALimbShareItsHeight) {
  edit::Session session = Throw();
  ASSERT_TRUE(session.Run("region.set", {{"region", "arms"}, {"joints", {"r_wrist"}}}).ok());
  ASSERT_TRUE(
      session.Run("region.add", {{"first", 8}, {"last", 20}, {"joints", {"r_elbow"}}}).ok());
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  std::vector<Rect> rects;
  for (const RowBar& bar : layout.bars) {
    if (bar.ref.kind == BarKind::kRegion) rects.push_back(bar.rect);
  }
  ASSERT_EQ(rects.size(), 2u);
  EXPECT_LE(rects[0].bottom(), rects[1].y + 0.01f);
}

TEST(DopeSheetLayout, AHoldLiesThinOnTheRowsOfItsLimbAndJoint) {
  const edit::Session session = Throw();
  SheetState state;
  state.open = {"limb r_hip", "joint r_toe"};
  const DopeSheetLayout layout = LayOutDopeSheet(session, state, {0, 0, 700, 600}, 1.0);
  std::vector<std::string> ids;
  for (const RowBar& bar : layout.bars) {
    if (bar.ref != BarRef{BarKind::kHold, 1}) continue;
    ids.push_back(layout.rows[bar.row].id);
    EXPECT_LT(bar.rect.h, 0.6f * layout.row_rects[bar.row].h);
    EXPECT_FLOAT_EQ(bar.rect.right(), layout.frame.axis.XOf(5));
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"limb r_hip", "joint r_toe"}));
}

TEST(DopeSheetLayout, ARowGrowsWithTheBarsThatOverlapOnIt) {
  edit::Session session = Throw();
  ASSERT_TRUE(session.Run("region.set", {{"region", "arms"}, {"joints", {"r_wrist"}}}).ok());
  ASSERT_TRUE(session.Run("hold.add", {{"joint", "r_elbow"}, {"first", 8}, {"last", 20}}).ok());
  for (const double scale : {1.0, 1.5}) {
    const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, scale);
    std::vector<RowBar> bars;
    for (const RowBar& bar : layout.bars) {
      if (layout.rows[bar.row].id == "limb r_shoulder") bars.push_back(bar);
    }
    ASSERT_EQ(bars.size(), 2u);
    const Rect& row = layout.row_rects[bars[0].row];
    EXPECT_GT(row.h, layout.row_rects[bars[0].row + 1].h);
    for (const RowBar& bar : bars) EXPECT_GE(bar.rect.h, 12.0 * scale);  // room for its name
    EXPECT_LE(bars[0].rect.bottom(), bars[1].rect.y);
    EXPECT_LE(bars[1].rect.bottom(), row.bottom() - 12.0 * scale);  // and for keys below
  }
}

TEST(DopeSheetHitTest, WhereTwoSpansMeetEachHasItsEnd) {
  edit::Session session = Throw();
  ASSERT_TRUE(
      session
          .Run("placement.set", {{"kind", "pinned"}, {"pin", "r_toe"}, {"first", 15}, {"last", 30}})
          .ok());
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  const float x = layout.frame.axis.XOf(15), y = layout.row_rects[1].y + 4.0f;
  const auto hit = [&](float at) { return HitDopeSheet(layout, session, {at, y}); };
  EXPECT_EQ(hit(x - 2.0f).part, SheetPart::kBarEnd);
  EXPECT_EQ(layout.bars[hit(x - 2.0f).index].ref, (BarRef{BarKind::kPlacement, 0}));
  EXPECT_EQ(hit(x + 2.0f).part, SheetPart::kBarStart);
  EXPECT_EQ(layout.bars[hit(x + 2.0f).index].ref, (BarRef{BarKind::kPlacement, 1}));
}

TEST(DopeSheetHitTest, TellsKeysBarsAndTheirEnds) {
  const edit::Session session = Throw();
  Rect tall = kRect;  // room for all rows with keys
  tall.h += 60.0f;
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, tall, 1.0);
  const RowBar& bar = BarOn(layout, "limb r_shoulder");
  const auto part = [&](Point p) { return HitDopeSheet(layout, session, p).part; };
  EXPECT_EQ(part(Middle(bar.rect)), SheetPart::kBar);
  EXPECT_EQ(part({bar.rect.x + 1.0f, bar.rect.y + 3.0f}), SheetPart::kBarStart);
  EXPECT_EQ(part({bar.rect.right() + 2.0f, bar.rect.y + 3.0f}), SheetPart::kBarEnd);
  EXPECT_EQ(part({bar.rect.right() + 30.0f, bar.rect.y + 3.0f}), SheetPart::kTrack);
  ASSERT_FALSE(layout.keys.empty());
  for (const RowKey& key : layout.keys) EXPECT_EQ(part(key.at), SheetPart::kKey) << key.frame;
  EXPECT_EQ(part({10.0f, layout.row_rects[3].y + 4.0f}), SheetPart::kArrow);
  EXPECT_EQ(part({60.0f, layout.row_rects[3].y + 4.0f}), SheetPart::kName);
  EXPECT_EQ(part({300.0f, 105.0f}), SheetPart::kRuler);
  EXPECT_EQ(part({10.0f, 105.0f}), SheetPart::kCorner);
}

TEST(DopeSheetLayout, ARegionNamesWhatIsPainted) {
  const edit::Session session;
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  const RegionOnRows arms = RegionOn(layout, 6, 5);
  EXPECT_EQ(arms.name, "arms");
  EXPECT_EQ(arms.joints, (std::vector<std::string>{"r_shoulder+", "l_shoulder+"}));
  EXPECT_EQ(RegionOn(layout, 3, 3).joints, (std::vector<std::string>{"waist", "chest"}));
  EXPECT_EQ(RegionOn(layout, 2, 3).joints, (std::vector<std::string>{"pelvis", "waist", "chest"}));
  EXPECT_TRUE(RegionOn(layout, 0, 1).joints.empty());
}

TEST(DopeSheetLayout, RegionOverAllLimbs_IncludesTheRoot) {
  const edit::Session session;
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  const RegionOnRows limbs = RegionOn(layout, 3, 8);
  const auto names_root = [](const RegionOnRows& region) {
    return std::count(region.joints.begin(), region.joints.end(), "pelvis");
  };
  EXPECT_EQ(names_root(limbs), 0);
  const RegionOnRows body = WithRootOfWhole(limbs, session.figure());
  EXPECT_EQ(names_root(body), 1);
  EXPECT_EQ(body.name, "body");
  EXPECT_EQ(names_root(WithRootOfWhole(RegionOn(layout, 2, 8), session.figure())), 1);
  EXPECT_EQ(names_root(WithRootOfWhole(RegionOn(layout, 4, 8), session.figure())), 0);
}

TEST(DopeSheetLayout, ARegionWithTheRootLiesOnItsRow) {
  edit::Session session = Throw();
  const auto on_root = [&] {
    const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
    return std::count_if(layout.bars.begin(), layout.bars.end(), [&](const RowBar& bar) {
      return layout.rows[bar.row].id == "root" && bar.ref.kind == BarKind::kRegion;
    });
  };
  EXPECT_EQ(on_root(), 0);
  ASSERT_TRUE(
      session.Run("region.add", {{"first", 20}, {"last", 25}, {"joints", {"pelvis"}}}).ok());
  EXPECT_EQ(on_root(), 1);
}

TEST(DopeSheetLayout, AKeyOfARowStandsForThoseOfAllItsCurves) {
  const edit::Session session = Throw();
  const DopeSheetLayout layout = LayOutDopeSheet(session, {}, kRect, 1.0);
  const KeyList all = KeysIn(layout, {0.0f, 0.0f, 1000.0f, 1000.0f}, session.project());
  size_t num_keys = 0;
  for (const auto& curve : session.project().joints) num_keys += curve.value.keys.size();
  for (const auto& curve : session.project().root.curves) num_keys += curve.keys.size();
  EXPECT_EQ(all.curves.size(), 2 * num_keys);  // on the summary's row and on another
}

}  // namespace
}  // namespace hazumi::ui
