#include "tests/unit/edit/keys/keys_of.h"

namespace hazumi::test {
namespace {

using edit::Session;

constexpr double kRadian = 57.29577951308232;  // [deg]

double RateAt(Session* session, int frame, const char* hinge) {
  const Motion& motion = *session->WholeMotion().value();
  return motion.frames[frame].after.qd[session->figure().FindJoint(hinge)->value()] * kRadian;
}

Session Elbow() {
  Session session;
  SetKeys(&session, "r_elbow_flexion", {{0, 30}, {10, 90}, {30, 30}});
  Do(&session, "region.add",
     {{"name", "arm"}, {"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}});
  return session;
}

TEST(StartRate, OfAKeyIsSet) {
  Session session = Elbow();
  Do(&session, "key.rate", {{"curve", "r_elbow_flexion"}, {"frame", 10}, {"rate", -45}});
  EXPECT_EQ(KeysOf(session, "r_elbow_flexion")[1].rate, -45.0);
  EXPECT_EQ(KeysOf(session, "r_elbow_flexion")[1].value, 90.0);
  EXPECT_EQ(
      Refused(&session, "key.rate", {{"curve", "r_elbow_flexion"}, {"frame", 11}, {"rate", 1}})
          .ToString(),
      "key.rate.frame: \"r_elbow_flexion\" has no key on frame 11");
}

TEST(StartRate, OfARegionIsThatOfTheKeyOnItsFirstFrame) {
  Session session = Elbow();
  const double value = session.WholeMotion()
                           .value()
                           ->frames[5]
                           .q[session.figure().FindJoint("r_elbow_flexion")->value()] *
                       kRadian;
  for (const double rate : {100.0, 200.0}) {
    Do(&session, "region.start_rate",
       {{"region", "arm"}, {"joint", "r_elbow_flexion"}, {"rate", rate}, {"drag", "1"}});
    EXPECT_NEAR(RateAt(&session, 5, "r_elbow_flexion"), rate, 1e-9);
  }
  const ProjectKey& key = KeysOf(session, "r_elbow_flexion")[1];
  EXPECT_EQ(key.frame, 5.0);
  EXPECT_NEAR(key.value, value, 1e-9);
  EXPECT_EQ(session.document().num_steps(), 5u);
  Do(&session, "edit.undo");
  EXPECT_EQ(KeysOf(session, "r_elbow_flexion").size(), 3u);
}

TEST(StartRate, OfARegionNeedsOneOfItsOwnHinges) {
  Session session = Elbow();
  const auto refused = [&](const char* region, const char* joint) {
    return Refused(&session, "region.start_rate",
                   {{"region", region}, {"joint", joint}, {"rate", 1}})
        .ToString();
  };
  EXPECT_EQ(refused("leg", "r_elbow_flexion"),
            "region.start_rate.region: there is no \"leg\"; there is \"arm\"");
  EXPECT_EQ(refused("arm", "r_knee"),
            "region.start_rate.joint: \"r_knee\" is no hinge of this region");
  Do(&session, "region.split", {{"region", "arm"}, {"frame", 10}});
  EXPECT_EQ(refused("arm 2", "r_elbow_flexion"),
            "region.start_rate.joint: \"r_elbow_flexion\" starts as fast as the region that ends "
            "there leaves it; end that one earlier");
}

}  // namespace
}  // namespace hazumi::test
