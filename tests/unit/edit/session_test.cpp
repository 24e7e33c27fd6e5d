// Who observes a session, and where a session keeps what is no document.

#include "ui/edit/session.h"

#include "tests/unit/edit/sessions.h"
#include "ui/edit/script.h"
#include "ui/edit/state_folder.h"

namespace hazumi::test {
namespace {

using edit::ScriptRecorder;
using edit::Session;

TEST(SessionObservers, AreToldAsLongAsTheyAreThere) {
  Session session;
  const ScriptRecorder first(&session);
  {
    const ScriptRecorder second(&session);
    Do(&session, "project.rename", {{"name", "a"}});
    EXPECT_EQ(second.text(), first.text());
  }
  Do(&session, "project.rename", {{"name", "b"}});
  EXPECT_NE(first.text().find("\"b\""), std::string::npos);
}

TEST(SessionObservers, AreToldBeforeAndAfter) {
  Session session;
  std::string told;
  const auto observer = session.Observe(
      {.before = [&] { told += "<" + session.project().name; },
       .after = [&](const std::string& id,
                    const edit::Json&) { told += ">" + id + session.project().name; }});
  Do(&session, "project.rename", {{"name", "a"}});
  EXPECT_FALSE(session.Run("edit.redo").ok());
  EXPECT_EQ(told, "<" + Session().project().name + ">project.renamea<a");
}

TEST(StateFolder, FollowsTheEnvironment) {
  const auto folder = [](const char* state, const char* home) {
    const auto found = edit::StateFolder(
        [&](const char* name) { return std::string(name) == "HOME" ? home : state; });
    return found.ok() ? found.value() : found.error().place;
  };
  EXPECT_EQ(folder("/state", "/home/me"), "/state/hazumi");
  EXPECT_EQ(folder(nullptr, "/home/me"), "/home/me/.local/state/hazumi");
  EXPECT_EQ(folder("", "/home/me"), "/home/me/.local/state/hazumi");
  EXPECT_EQ(folder("not/absolute", "/home/me"), "/home/me/.local/state/hazumi");
  EXPECT_EQ(folder(nullptr, nullptr), "XDG_STATE_HOME");
}

}  // namespace
}  // namespace hazumi::test
