#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

std::string MarkersOf(const Session& session) {
  std::string text;
  for (const ProjectMarker& marker : session.project().markers) {
    text += marker.name + "@" + std::to_string(marker.frame) + " ";
  }
  return text;
}

TEST(TimeOperators, MarkersAreAddedMovedRenamedAndRemoved) {
  Session session;
  Do(&session, "time.frame", {{"frame", 12}});
  Do(&session, "marker.add");
  Do(&session, "marker.add", {{"frame", 3}, {"name", "throw"}});
  EXPECT_EQ(MarkersOf(session), "F_12@12 throw@3 ");
  for (const int to : {11, 10}) {
    Do(&session, "marker.move", {{"index", 0}, {"to", to}, {"drag", "1"}});
  }
  Do(&session, "marker.rename", {{"index", 0}, {"name", "catch"}});
  EXPECT_EQ(MarkersOf(session), "catch@10 throw@3 ");
  Do(&session, "marker.remove", {{"index", 1}});
  EXPECT_EQ(MarkersOf(session), "catch@10 ");
  EXPECT_EQ(session.document().num_steps(), 5u);
  while (session.document().Undo()) {
  }
  EXPECT_EQ(MarkersOf(session), "");
}

TEST(TimeOperators, ThePreviewRangeIsSetAndTakenBack) {
  Session session;
  Do(&session, "time.preview", {{"first", 10}});
  ASSERT_TRUE(session.project().preview);
  EXPECT_EQ(session.project().preview->first, 10);
  EXPECT_EQ(session.project().preview->last, 30);
  Do(&session, "time.preview", {{"last", 20}});
  EXPECT_EQ(session.project().preview->first, 10);
  Do(&session, "time.preview", {{"off", true}});
  EXPECT_FALSE(session.project().preview);
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().preview->last, 20);
}

TEST(TimeOperators, AnotherFrameRateMayKeepTheShapeOfCurves) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 0}, {"value", 10}, {"rate", 30}});
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 20}, {"value", 40}});
  Do(&session, "key.set", {{"curve", "root.x"}, {"frame", 0}, {"value", 0}, {"rate", 0.5}});
  Do(&session, "key.set", {{"curve", "root.x"}, {"frame", 20}, {"value", 1}});
  Do(&session, "time.frame", {{"frame", 7}});
  const auto knee = [&] { return session.ValueNow("r_knee").value(); };
  const auto x = [&] { return session.ValueNow("root.x").value(); };
  const double knee_at_30 = knee(), x_at_30 = x();
  Do(&session, "time.rate", {{"num", 120}});
  EXPECT_GT(std::abs(knee() - knee_at_30), 0.5);
  Do(&session, "edit.undo");
  Do(&session, "time.rate", {{"num", 120}, {"keep_shape", true}});
  EXPECT_NEAR(knee(), knee_at_30, 1e-9);
  EXPECT_NEAR(x(), x_at_30, 1e-9);
}

TEST(TimeOperators, SayWhatIsWrong) {
  Session session;
  Do(&session, "marker.add");
  const auto refused = [&](const char* id, const Json& parameters) {
    return Refused(&session, id, parameters).ToString();
  };
  EXPECT_EQ(refused("marker.remove", {{"index", 1}}),
            "marker.remove.index: there is no such marker; there are 1");
  EXPECT_EQ(refused("marker.rename", {{"index", 0}, {"name", ""}}),
            "marker.rename.markers[0].name: must not be empty");
  EXPECT_EQ(refused("time.preview", {{"first", 31}}),
            "time.preview.first: must not come after last, 30");
  EXPECT_EQ(refused("time.preview", Json::object()),
            "time.preview.off: or first or last must be given");
  EXPECT_EQ(refused("time.preview", {{"first", 1}, {"off", true}}),
            "time.preview.off: goes without first and last");
}

}  // namespace
}  // namespace hazumi::test
