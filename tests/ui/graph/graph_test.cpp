// The graph editor: how curves are laid out, and how it is used.

#include <algorithm>

#include "tests/ui/user.h"
#include "ui/panels/graph/layout.h"

namespace hazumi::test {
namespace {

using ui::Point;

class Graph : public testing::Test {
 protected:
  Graph() : user("throw.kfa") {
    user.session().set_selected_joints({"r_elbow_flexion", "r_knee"});
    user.editor().Do("view.sheet", {{"graph", true}});
    user.Wait();
  }

  ui::GraphLayout Layout() { return ui::CurrentGraph(&user.editor()); }
  ui::GraphKey Key(const std::string& curve, double frame) {
    const ui::GraphLayout layout = Layout();
    for (const ui::GraphKey& key : layout.keys) {
      if (layout.curves[key.curve].name == curve && key.frame == frame) return key;
    }
    ADD_FAILURE() << "no key of " << curve << " at " << frame;
    return {};
  }
  const ProjectKey* Stored(const std::string& hinge, double frame) {
    for (const auto& curve : user.project().joints) {
      if (curve.name != hinge) continue;
      for (const ProjectKey& key : curve.value.keys) {
        if (key.frame == frame) return &key;
      }
    }
    return nullptr;
  }

  User user;
};

TEST_F(Graph, ShowsTheCurvesOfTheSelectedJoints) {
  const ui::GraphLayout layout = Layout();
  ASSERT_EQ(layout.curves.size(), 2u);
  EXPECT_EQ(layout.curves[0].name, "r_elbow_flexion");
  EXPECT_EQ(layout.curves[1].name, "r_knee");
  // They stay when nothing is selected any more.
  user.session().set_selected_joints({});
  EXPECT_EQ(Layout().curves.size(), 2u);
}

TEST_F(Graph, CurvesRunThroughTheirKeysAndTheBakedMotion) {
  const ui::GraphLayout layout = Layout();
  const Motion& motion = *user.session().WholeMotion().value();
  const JointIndex j = *user.session().figure().FindJoint("r_elbow_flexion");
  int num_frames = 0;
  for (const auto& [frame, value] : layout.curves[0].points) {
    if (frame != std::floor(frame)) continue;
    EXPECT_NEAR(value,
                motion.frames[static_cast<int>(frame)].q[j.value()] * 180.0 / 3.14159265358979,
                1e-6);
    ++num_frames;
  }
  EXPECT_GE(num_frames, 31);
}

TEST_F(Graph, TurnsOfTheRootAddUp) {
  user.session().set_selected_joints({});
  for (const int frame : {9, 22, 27}) {
    user.editor().Do("keys.select", {{"curves", {"root.angle_z"}}, {"frames", {frame}}});
    user.editor().Do("keys.delete");
  }
  for (const auto& [frame, angle] : {std::pair(0, 0.0), {15, 200.0}, {30, 400.0}}) {
    user.editor().Do("key.set", {{"curve", "root.angle_z"},
                                 {"frame", frame},
                                 {"value", angle},
                                 {"interpolation", "linear"}});
  }
  user.editor().Do("keys.select", {{"curves", {"root.angle_z"}}, {"frames", {0}}});
  const ui::GraphLayout layout = Layout();
  ASSERT_EQ(layout.curves.size(), 1u);
  EXPECT_NEAR(layout.curves[0].points.back().second, 400.0, 1.0);
}

TEST_F(Graph, WhatARegionComputedIsToldApart) {
  const ui::GraphLayout layout = Layout();
  const ui::GraphCurve& elbow = layout.curves[0];
  for (size_t i = 0; i < elbow.is_computed.size(); ++i) {
    const double frame = 0.5 * (elbow.points[i].first + elbow.points[i + 1].first);
    if (frame == std::floor(frame)) continue;  // between the two sides of a frame
    EXPECT_EQ(elbow.is_computed[i] != 0, frame > 5.0 && frame < 15.0) << frame;
  }
  for (const char is_computed : layout.curves[1].is_computed) EXPECT_FALSE(is_computed);
}

TEST_F(Graph, FitsAndNormalizes) {
  const auto all_inside = [](const ui::GraphLayout& layout) {
    for (const ui::GraphKey& key : layout.keys) {
      EXPECT_GT(key.at.y, layout.frame.tracks.y);
      EXPECT_LT(key.at.y, layout.frame.tracks.bottom());
    }
  };
  all_inside(Layout());
  user.editor().Do("sheet.normalize");
  user.Wait(1);
  const ui::GraphLayout layout = Layout();
  all_inside(layout);
  for (const ui::GraphCurve& curve : layout.curves) {
    double high = -1e9;
    for (const auto& [frame, value] : curve.points) {
      high = std::max(high, (value - curve.middle) * curve.stretch);
    }
    EXPECT_NEAR(high, 1.0, 0.05) << curve.name;
  }
}

TEST_F(Graph, HomeFramesAllCurves) {
  const auto num_outside = [&] {
    const ui::GraphLayout layout = Layout();
    return std::count_if(layout.keys.begin(), layout.keys.end(), [&](const ui::GraphKey& key) {
      const ui::Rect& tracks = layout.frame.tracks;
      return key.at.x < tracks.x || key.at.x > tracks.right() || key.at.y < tracks.y ||
             key.at.y > tracks.bottom();
    });
  };
  const size_t num_keys = Layout().keys.size();
  user.MoveTo(Key("r_knee", 15).at);
  user.TurnWith(ui::kLeftControl, 12.0f);
  EXPECT_TRUE(num_outside() > 0 || Layout().keys.size() < num_keys);
  user.Press(ui::kHome);
  EXPECT_EQ(Layout().keys.size(), num_keys);
  EXPECT_EQ(num_outside(), 0);
}

TEST_F(Graph, HitTestFindsKeysAndTheirHandles) {
  const ui::GraphKey key = Key("r_knee", 15);
  EXPECT_EQ(ui::HitGraph(Layout(), key.at).part, ui::GraphPart::kKey);
  EXPECT_FALSE(key.handles);
  user.Click(key.at);
  const ui::GraphKey selected = Key("r_knee", 15);
  ASSERT_TRUE(selected.handles);
  const ui::GraphHit hit = ui::HitGraph(Layout(), (*selected.handles)[1]);
  EXPECT_EQ(hit.part, ui::GraphPart::kHandle);
  EXPECT_EQ(hit.side, 1);
  user.editor().sheet.hidden = {"r_knee"};
  EXPECT_NE(ui::HitGraph(Layout(), key.at).part, ui::GraphPart::kKey);
}

TEST_F(Graph, PullingAHandleSetsTheRateInOneStep) {
  user.Click(Key("r_knee", 15).at);
  const Point handle = (*Key("r_knee", 15).handles)[1];
  const ui::GraphLayout before = Layout();
  const ui::GraphKey key = Key("r_knee", 15);
  // ImGui's mouse stands on whole pixels.
  const Point to = {std::floor(key.at.x) + 40.0f, std::floor(key.at.y) - 30.0f};
  user.Drag(handle, to);
  ASSERT_TRUE(Stored("r_knee", 15)->rate);
  EXPECT_NEAR(*Stored("r_knee", 15)->rate, ui::RateTowards(before, key, 1, to), 0.1);
  EXPECT_GT(*Stored("r_knee", 15)->rate, 0.0);
  EXPECT_EQ(user.num_steps(), 1u);
  user.Press('Z', ui::kLeftControl);
  EXPECT_EQ(user.num_steps(), 1u);  // it can be done again
}

TEST_F(Graph, ABrokenKeysHandlesTurnByThemselves) {
  user.Click(Key("r_knee", 15).at);
  user.editor().Do("keys.handles", {{"kind", "broken"}});
  const double before = *Stored("r_knee", 15)->rate_in;
  const Point handle = (*Key("r_knee", 15).handles)[1];
  user.Drag(handle, {std::floor(handle.x) + 10.0f, std::floor(handle.y) - 30.0f});
  EXPECT_EQ(*Stored("r_knee", 15)->rate_in, before);
  EXPECT_GT(*Stored("r_knee", 15)->rate, before + 1.0);
}

TEST_F(Graph, HandlesOfFreeLengthAreAsLongAsTheyReachAndArePulledLonger) {
  user.Click(Key("r_knee", 15).at);
  user.editor().Do("keys.handles", {{"kind", "free_length"}});
  const ui::GraphKey key = Key("r_knee", 15);
  const double gap = Layout().frame.axis.px_per_frame() * key.frames_beside[1];
  const Point handle = (*key.handles)[1];
  EXPECT_NEAR(handle.x - key.at.x, gap / 3.0, 0.5);
  user.Drag(handle, {std::floor(key.at.x) + static_cast<float>(0.6 * gap), std::floor(handle.y)});
  EXPECT_NEAR(*Stored("r_knee", 15)->length_out, 0.6, 1.5 / gap + 0.01);
  EXPECT_NEAR(*Stored("r_knee", 15)->length_in, 1.0 / 3.0, 1e-12);
}

TEST_F(Graph, TheWindowOfRSetsTheTypeOfKeys) {
  const Point at = Key("r_knee", 15).at;
  user.Click(at);
  // The window opens at the mouse; where its entries are is up to the font.
  for (float dy = -160.0f; dy < 160.0f; dy += 8.0f) {
    if (Stored("r_knee", 15)->type == KeyType::kBreakdown) break;
    user.MoveTo(at);
    user.Press('R');
    user.Click({at.x + 25.0f, at.y + dy});
    if (user.session().selected_keys().empty()) user.Click(at);
  }
  EXPECT_EQ(Stored("r_knee", 15)->type, KeyType::kBreakdown);
  EXPECT_EQ(Key("r_knee", 15).type, KeyType::kBreakdown);
}

TEST_F(Graph, YAndANumberMovesValuesByExactlyThat) {
  const double before = Stored("r_knee", 15)->value;
  user.Click(Key("r_knee", 15).at);
  user.Press('G');
  user.Press('Y');
  user.Press('7');
  user.Press(ui::kEnter);
  ASSERT_TRUE(Stored("r_knee", 15));
  EXPECT_DOUBLE_EQ(Stored("r_knee", 15)->value, before + 7.0);
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(Graph, KeysAreDraggedInBothDirections) {
  const ui::GraphKey key = Key("r_knee", 15);
  const ui::GraphLayout layout = Layout();
  const float frame_px = layout.frame.axis.XOf(1) - layout.frame.axis.XOf(0);
  user.Drag(key.at, {key.at.x + 2.0f * frame_px, key.at.y - 40.0f});
  ASSERT_TRUE(Stored("r_knee", 17));
  const double up = 40.0 * (layout.values.high - layout.values.low) / layout.frame.tracks.h;
  EXPECT_NEAR(Stored("r_knee", 17)->value, key.value + up, 1e-6);
  EXPECT_EQ(user.num_steps(), 1u);
}

TEST_F(Graph, EscapeLeavesTheDocumentAsItWas) {
  const std::string before = user.text();
  const ui::GraphKey key = Key("r_knee", 15);
  user.Pull(key.at, {key.at.x + 30.0f, key.at.y - 40.0f});
  EXPECT_NE(user.text(), before);
  user.Press(ui::kEscape);
  user.Hold(0, false);
  EXPECT_EQ(user.text(), before);
}

}  // namespace
}  // namespace hazumi::test
