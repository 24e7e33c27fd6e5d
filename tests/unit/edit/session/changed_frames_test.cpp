#include <gtest/gtest.h>

#include "ui/edit/document/change.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {
namespace {

using edit::ChangedFrames;
using edit::FrameSpan;
using edit::Json;
using Spans = std::vector<FrameSpan>;

// What an operator changes.
Spans After(edit::Session* session, const char* id, const Json& parameters) {
  const Project before = session->project();
  EXPECT_TRUE(session->Run(id, parameters).ok());
  return ChangedFrames(before, session->project());
}

TEST(ChangedFrames, AreThoseOfTheKeysThatCameWentOrChanged) {
  edit::Session session;
  const auto set = [&](double frame, double value) {
    return After(&session, "key.set", {{"curve", "r_knee"}, {"frame", frame}, {"value", value}});
  };
  EXPECT_EQ(set(4, 10), (Spans{{4, 4}}));
  EXPECT_EQ(set(9, 10), (Spans{{9, 9}}));
  EXPECT_EQ(set(4, 20), (Spans{{4, 4}}));
  EXPECT_EQ(After(&session, "key.move", {{"curve", "r_knee"}, {"frame", 4}, {"to", 6}}),
            (Spans{{4, 4}, {6, 6}}));
}

TEST(ChangedFrames, AreThePartThatABarGainsOrLosesElseTheWholeOfIt) {
  edit::Session session;
  EXPECT_EQ(After(&session, "region.add",
                  {{"name", "swing"}, {"first", 5}, {"last", 15}, {"joints", {"r_elbow"}}}),
            (Spans{{5, 15}}));
  EXPECT_EQ(After(&session, "region.set", {{"region", "swing"}, {"last", 20}}), (Spans{{15, 20}}));
  EXPECT_EQ(After(&session, "region.friction", {{"region", "swing"}, {"factor", 0.5}}),
            (Spans{{5, 20}}));
  EXPECT_EQ(After(&session, "marker.add", {{"frame", 7}}), (Spans{{7, 7}}));
  EXPECT_EQ(After(&session, "marker.move", {{"index", 0}, {"to", 8}}), (Spans{{7, 7}, {8, 8}}));
}

TEST(ChangedFrames, AreNoneOfWhatHasNoFrame) {
  edit::Session session;
  EXPECT_EQ(After(&session, "project.rename", {{"name", "other"}}), Spans());
  EXPECT_EQ(After(&session, "scene.gravity", {{"gravity", 1.62}}), Spans());
}

}  // namespace
}  // namespace hazumi::test
