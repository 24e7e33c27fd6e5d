// What the bars of regions show of muscle, and how strong it is by the mouse.

#include "tests/ui/dope_sheet/dope_sheet_user.h"

namespace hazumi::test {
namespace {

using edit::Json;
using ui::Muscle;

class MuscleBars : public DopeSheet {
 protected:
  MuscleBars() {
    user.editor().sheet.open = {"limb r_shoulder", "joint r_wrist"};
    Add("spring", {"r_shoulder"});
    Add("torque", {"r_elbow"});
    Add("keys", {"r_wrist_flexion"});
    user.Wait(1);
  }
  void Add(const char* kind, const Json& joints) {
    const Json parameters = {{"region", arms().name}, {"kind", kind}, {"joints", joints}};
    ASSERT_TRUE(user.editor().Do("drive.add", parameters)) << user.editor().message.text;
  }
  void SetStrength(double share) {
    const Json parameters = {{"region", arms().name}, {"number", 0}, {"strength", share}};
    ASSERT_TRUE(user.editor().Do("drive.set", parameters)) << user.editor().message.text;
    user.Wait(1);
  }
  ui::RowBar BarOn(const std::string& row) {
    const ui::DopeSheetLayout layout = Layout();
    for (const ui::RowBar& bar : layout.bars) {
      if (layout.rows[bar.row].id == row && bar.ref.kind == ui::BarKind::kRegion) return bar;
    }
    ADD_FAILURE() << "no bar on " << row;
    return {};
  }
  Muscle On(const std::string& row) { return BarOn(row).muscle.kind; }
  // On the upper edge of the muscle of the limb's bar.
  Point Edge() {
    const ui::Rect strip = ui::StripOf(BarOn("limb r_shoulder"));
    return {strip.x + 0.6f * strip.w, strip.y + 0.5f};
  }
  std::optional<double> strength() { return arms().drives[0].strength; }
};

TEST_F(MuscleBars, EachRowSaysWhatMovesItsJoints) {
  EXPECT_EQ(On("joint r_shoulder"), Muscle::kSpring);
  EXPECT_EQ(On("joint r_elbow"), Muscle::kTorque);
  EXPECT_EQ(On("joint r_wrist"), Muscle::kMixed);
  EXPECT_EQ(On("r_wrist_flexion"), Muscle::kKeys);
  EXPECT_EQ(On("limb r_shoulder"), Muscle::kMixed);
  EXPECT_EQ(On("limb l_shoulder"), Muscle::kLoose);
  EXPECT_EQ(ui::TextOf(BarOn("joint r_shoulder").muscle), "spring");
  EXPECT_EQ(ui::TextOf(BarOn("limb l_shoulder").muscle), "limp");
}

TEST_F(MuscleBars, TheStripIsAsHighAsTheSpringIsStrong) {
  const auto share = [&](const char* row) {
    const ui::RowBar bar = BarOn(row);
    return ui::StripOf(bar).h / bar.rect.h;
  };
  EXPECT_FLOAT_EQ(share("limb r_shoulder"), 1.0f);  // no limit
  EXPECT_EQ(share("limb l_shoulder"), 0.0f);
  EXPECT_EQ(share("joint r_elbow"), 0.0f);
  SetStrength(0.25);
  EXPECT_FLOAT_EQ(share("limb r_shoulder"), 0.25f);
  EXPECT_FLOAT_EQ(share("joint r_shoulder"), 0.25f);
  EXPECT_EQ(ui::TextOf(BarOn("joint r_shoulder").muscle), "spring, 25 %");
  SetStrength(3.0);
  EXPECT_FLOAT_EQ(share("limb r_shoulder"), 1.0f);
}

TEST_F(MuscleBars, OneThatIsMutedOrLimitedInNewtonMetresHasNoStrip) {
  const Json limit = {{"region", arms().name}, {"number", 0}, {"max_torque", 20.0}};
  ASSERT_TRUE(user.editor().Do("drive.set", limit));
  EXPECT_EQ(BarOn("limb r_shoulder").muscle.spring, -1);
  EXPECT_EQ(On("joint r_shoulder"), Muscle::kSpring);
  ASSERT_TRUE(user.editor().Do("region.set", {{"region", arms().name}, {"mute", true}}));
  EXPECT_EQ(BarOn("limb r_shoulder").muscle.kind, Muscle::kLoose);
}

TEST_F(MuscleBars, PullingItsEdgeIsOneStepThatEscapeAndUndoTakeBack) {
  SetStrength(0.5);
  const size_t steps = user.num_steps();
  const Point edge = Edge();
  EXPECT_EQ(ui::HitDopeSheet(Layout(), user.session(), edge).part, ui::SheetPart::kBarStrength);
  user.Pull(edge, {edge.x, edge.y - 20.0f});
  EXPECT_NEAR(strength().value_or(-1.0), 0.7, 1e-12);
  EXPECT_NE(user.editor().tool_hint().find("70 %"), std::string::npos);
  user.MoveTo({edge.x, edge.y + 300.0f});
  EXPECT_EQ(strength(), 0.0);
  user.MoveTo({edge.x, edge.y + 20.0f});
  user.Hold(0, false);
  EXPECT_NEAR(strength().value_or(-1.0), 0.3, 1e-12);
  EXPECT_EQ(user.num_steps(), steps + 1);
  EXPECT_EQ(arms().first_frame, 5);
  EXPECT_TRUE(user.session().WholeMotion().ok());
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(strength(), 0.5);
  user.Pass(1.0);  // or it is a double click
  user.Pull(Edge(), {edge.x, edge.y - 30.0f});
  EXPECT_NE(strength(), 0.5);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(strength(), 0.5);
}

// A click chooses the bar and changes nothing; below and above the edge the bar is moved as ever.
TEST_F(MuscleBars, AClickOnTheEdgeChangesNothing) {
  SetStrength(0.5);
  const std::string before = user.text();
  user.Click(Edge());
  EXPECT_EQ(user.text(), before);
  EXPECT_EQ(user.editor().sheet.bar, (ui::BarId{ui::BarKind::kRegion, arms().identity.id}));
  const Point below = {Edge().x, Edge().y + 6.0f};
  EXPECT_EQ(ui::HitDopeSheet(Layout(), user.session(), below).part, ui::SheetPart::kBar);
}

}  // namespace
}  // namespace hazumi::test
