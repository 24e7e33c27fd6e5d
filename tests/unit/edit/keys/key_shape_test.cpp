// Tangents, easing and types of keys by operators.

#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"
#include "engine/timeline/curve_track.h"
#include "tests/unit/edit/keys/keys_of.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

// A knee with keys on 0, 5, 10, 20; those on 5 and 10 selected.
Session Knee() {
  Session session;
  SetKeys(&session, "r_knee", {{0, 0}, {5, 50}, {10, 60}, {20, 20}});
  SelectKeys(&session, "r_knee", {5, 10});
  return session;
}

std::vector<double> Angles(Session* session, const std::string& hinge) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok());
  std::vector<double> angles;
  const int j = session->figure().FindJoint(hinge)->value();
  for (const MotionFrame& frame : motion.value()->frames) angles.push_back(frame.q[j] / kDegree);
  return angles;
}

TEST(KeyShape, SayingMoreOfATangentLeavesTheCurveAsItRuns) {
  Session session = Knee();
  const std::vector<double> before = Angles(&session, "r_knee");
  for (const char* kind : {"aligned", "broken", "free_length"}) {
    Do(&session, "keys.handles", {{"kind", kind}});
    const std::vector<double> after = Angles(&session, "r_knee");
    for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-9) << kind << i;
  }
  const ProjectKey& key = KeysOf(session, "r_knee")[1];
  EXPECT_TRUE(key.rate && key.rate_in && key.length_in && key.length_out);
  Do(&session, "keys.handles", {{"kind", "fixed_length"}});
  EXPECT_FALSE(KeysOf(session, "r_knee")[1].length_in);
  EXPECT_TRUE(KeysOf(session, "r_knee")[1].rate_in);
  Do(&session, "keys.handles", {{"kind", "auto"}});
  EXPECT_FALSE(KeysOf(session, "r_knee")[1].rate_in);
  EXPECT_EQ(Angles(&session, "r_knee"), before);
}

TEST(KeyShape, OneSideOfABrokenKeyIsTurnedAlone) {
  Session session = Knee();
  Do(&session, "keys.handles", {{"kind", "broken"}});
  const std::vector<double> before = Angles(&session, "r_knee");
  Do(&session, "key.rate", {{"curve", "r_knee"}, {"frame", 5}, {"rate", -90}, {"side", "after"}});
  const std::vector<double> after = Angles(&session, "r_knee");
  for (int i = 0; i <= 5; ++i) EXPECT_NEAR(after[i], before[i], 1e-9) << i;
  EXPECT_LT(after[6], before[6] - 1.0);
  Do(&session, "key.rate",
     {{"curve", "r_knee"}, {"frame", 5}, {"rate", 30}, {"side", "before"}, {"length", 0.5}});
  const ProjectKey& key = KeysOf(session, "r_knee")[1];
  EXPECT_EQ(key.rate_in, 30.0);
  EXPECT_EQ(key.rate, -90.0);
  EXPECT_EQ(key.length_in, 0.5);
  Do(&session, "key.rate", {{"curve", "r_knee"}, {"frame", 5}, {"rate", 10}});  // both sides
  EXPECT_FALSE(KeysOf(session, "r_knee")[1].rate_in);
  EXPECT_EQ(Refused(&session, "key.rate",
                    {{"curve", "r_knee"}, {"frame", 5}, {"rate", 1}, {"length", 0.5}})
                .ToString(),
            "key.rate.side: say whose length it is: before or after");
  Refused(&session, "key.rate",
          {{"curve", "r_knee"}, {"frame", 5}, {"rate", 1}, {"side", "after"}, {"length", 0.95}});
  Refused(&session, "key.rate", {{"curve", "r_knee"}, {"frame", 5}, {"rate", 1}, {"side", "left"}});
}

TEST(KeyShape, EasedKeysMoveFromValueToValueAndAreUndone) {
  Session session = Knee();
  const std::vector<double> before = Angles(&session, "r_knee");
  Do(&session, "keys.interpolation", {{"interpolation", "back"}, {"easing", "out"}});
  const std::vector<double> after = Angles(&session, "r_knee");
  for (const int frame : {0, 5, 10, 20}) EXPECT_NEAR(after[frame], before[frame], 1e-9);
  // It goes too far by a tenth, from 50 to 60 and from 60 to 20.
  EXPECT_NEAR(*std::max_element(after.begin() + 5, after.begin() + 10), 61.0, 0.1);
  EXPECT_NEAR(*std::min_element(after.begin() + 10, after.begin() + 20), 16.0, 0.1);
  Do(&session, "keys.easing", {{"easing", "in"}});
  EXPECT_NEAR(Angles(&session, "r_knee")[11], 60.9, 0.5);  // it draws back first
  Do(&session, "edit.undo", {{"steps", 2}});
  EXPECT_EQ(Angles(&session, "r_knee"), before);
}

TEST(KeyShape, TypesMoveNothingAndAreKept) {
  Session session = Knee();
  const std::vector<double> before = Angles(&session, "r_knee");
  Do(&session, "keys.type", {{"type", "breakdown"}});
  EXPECT_EQ(KeysOf(session, "r_knee")[1].type, KeyType::kBreakdown);
  EXPECT_EQ(KeysOf(session, "r_knee")[0].type, KeyType::kKeyframe);
  EXPECT_EQ(Angles(&session, "r_knee"), before);
  Do(&session, "keys.move", {{"frames", 1}});
  EXPECT_EQ(KeysOf(session, "r_knee")[1].type, KeyType::kBreakdown);
  EXPECT_EQ(Refused(&session, "keys.type", {{"type", "pose"}}).ToString(),
            "keys.type.type: \"pose\" is none of keyframe, breakdown, extreme, jitter, "
            "moving_hold, generated");
}

// A region inside the stretch of an eased curve that carries it begins as fast as that is.
TEST(KeyShape, ARegionPaintedIntoAnEasedIntervalLeavesTheWayToIt) {
  Session session;
  SetKeys(&session, "r_shoulder_flexion", {{0, 0}, {30, 90}});
  SelectKeys(&session, "r_shoulder_flexion", {0});
  Do(&session, "keys.interpolation", {{"interpolation", "sine"}, {"easing", "in"}});
  const std::vector<double> before = Angles(&session, "r_shoulder_flexion");
  Do(&session, "region.add",
     {{"first", 20}, {"last", 28}, {"joints", {"r_shoulder_flexion"}}, {"key_start", true}});
  const std::vector<double> after = Angles(&session, "r_shoulder_flexion");
  for (int i = 0; i <= 20; ++i) EXPECT_NEAR(after[i], before[i], 1e-4) << i;
}

// The forearm swings below an upper arm that is eased. The reference has a key of a cubic on every
// eighth of a frame, on the same curve.
class EasedCarrier : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(EasedCarrier, DrivesARegionAsTheSameCurveOfManyKeysDoes) {
  const auto [kind, easing] = GetParam();
  Session session;
  SetKeys(&session, "r_shoulder_flexion", {{0, 0}, {30, 60}});
  SelectKeys(&session, "r_shoulder_flexion", {0});
  Do(&session, "keys.interpolation", {{"interpolation", kind}, {"easing", easing}});
  const Keys keys = ToKeys(session.project().joints.front().value, 1.0);
  SetKeys(&session, "r_elbow_flexion", {{0, 60}});
  Do(&session, "region.add", {{"first", 0}, {"last", 30}, {"joints", {"r_elbow+"}}});
  const std::vector<double> eased = Angles(&session, "r_elbow_flexion");
  CurveTrack track(&keys, {30, 1}, 0.0, {});
  for (int i = 0; i <= 240; ++i) {
    const double frame = i / 8.0;
    const CurveSample at = i < 240 ? track.At(frame) : track.Before(frame);
    Do(&session, "key.set",
       {{"curve", "r_shoulder_flexion"},
        {"frame", frame},
        {"value", at.value},
        {"rate", at.rate},
        {"interpolation", "cubic"}});
  }
  const std::vector<double> dense = Angles(&session, "r_elbow_flexion");
  ASSERT_GT(std::abs(dense.back() - dense.front()), 1.0);  // it swings
  for (size_t i = 0; i < eased.size(); ++i) EXPECT_NEAR(eased[i], dense[i], 0.05) << i;
}

INSTANTIATE_TEST_SUITE_P(Kinds, EasedCarrier,
                         testing::Values(std::pair("sine", "in_out"), std::pair("quintic", "out"),
                                         std::pair("elastic", "out"), std::pair("back", "in")));

TEST(RatesOf, AreTheLimitsOnBothSides) {
  Session session = Knee();
  Do(&session, "keys.interpolation", {{"interpolation", "linear"}});
  const ProjectCurve* curve = &session.project().joints.front().value;
  const std::vector<RatesOfKey> rates = RatesOf(*curve, session.project().fps);
  ASSERT_EQ(rates.size(), 4u);
  EXPECT_NEAR(rates[1].after, 10.0 / (5.0 / 30.0), 1e-9);
  EXPECT_NEAR(rates[2].before, 10.0 / (5.0 / 30.0), 1e-9);
  EXPECT_NEAR(rates[2].after, -40.0 / (10.0 / 30.0), 1e-9);
}

TEST(UndoHistory, GoesBackAndForthBySteps) {
  Session session;
  for (int i = 1; i <= 4; ++i) {
    Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5 * i}, {"value", i}});
  }
  EXPECT_EQ(session.document().undo_labels().size(), 4u);
  Do(&session, "edit.undo", {{"steps", 3}});
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 1u);
  EXPECT_EQ(session.document().redo_labels(),
            (std::vector<std::string>{"Set key", "Set key", "Set key"}));
  EXPECT_EQ(Refused(&session, "edit.undo", {{"steps", 2}}).ToString(),
            "edit.undo.steps: there are 1 to undo");
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 1u);
  Do(&session, "edit.redo", {{"steps", 2}});
  EXPECT_EQ(KeysOf(session, "r_knee").size(), 3u);
}

}  // namespace
}  // namespace hazumi::test
