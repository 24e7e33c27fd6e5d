#include "ui/edit/script.h"

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::RunScript;
using edit::ScriptRecorder;
using edit::Session;

edit::ScriptRunner RunnerOf(Session* session) {
  return [session](const std::string& id, const edit::Json& p) { return session->Run(id, p); };
}

TEST(Script, DoesWhatItSays) {
  Session session;
  const Result<Done> done = RunScript(
      R"([{"op": "key.set", "curve": "r_knee", "frame": 5, "value": 40},
          {"op": "project.rename", "name": "Knee"}])",
      "script.json", RunnerOf(&session));
  ASSERT_TRUE(done.ok());
  EXPECT_EQ(session.project().name, "Knee");
  EXPECT_EQ(session.project().joints[0].value.keys[0].value, 40.0);
}

TEST(Script, StopsWhereSomethingIsWrongAndSaysWhere) {
  Session session;
  const auto error = [&](const char* text) {
    const Result<Done> done = RunScript(text, "script.json", RunnerOf(&session));
    return done.ok() ? std::string("no error") : done.error().ToString();
  };
  EXPECT_EQ(error("{"), "script.json: must be a JSON list of steps");
  EXPECT_EQ(error(R"([{"frame": 3}])"),
            "script.json: [0]: must be an object with \"op\", the id of an operator");
  EXPECT_EQ(error(R"([{"op": "project.rename", "name": "a"}, {"op": "edit.redo"}])"),
            "script.json: [1]: edit.redo: there is nothing to redo");
  EXPECT_EQ(session.project().name, "a");
  const TemporaryFolder folder;
  const std::string broken = folder / "broken.kfa";
  std::ofstream(broken) << "{";
  const std::string said = error((R"([{"op": "file.open", "path": ")" + broken + "\"}]").c_str());
  EXPECT_TRUE(said.starts_with("script.json: [0]: " + broken + ": ")) << said;
}

TEST(Script, WhatWasRecordedReplays) {
  Session session;
  const ScriptRecorder recorder(&session);
  Do(&session, "key.set", {{"curve", "r_knee"}, {"frame", 5}, {"value", 0.1}});
  Do(&session, "pose.rotate", {{"joint", "l_knee"}, {"to", 30}});
  Do(&session, "edit.undo");
  Do(&session, "region.add", {{"first", 5}, {"last", 10}, {"joints", {"r_knee"}}});
  EXPECT_FALSE(session.Run("edit.redo").ok());
  Session other;
  ASSERT_TRUE(RunScript(recorder.text(), "recorded", RunnerOf(&other)).ok()) << recorder.text();
  EXPECT_EQ(WriteProject(other.project()), WriteProject(session.project()));
}

}  // namespace
}  // namespace hazumi::test
