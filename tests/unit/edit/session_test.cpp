// Who observes a session, and where a session keeps what is no document.

#include "ui/edit/session/session.h"

#include <filesystem>

#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/recovery/state_folder.h"
#include "ui/edit/script.h"

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

// Where nobody is there to look. Work that is not done yet can be saved otherwise.
TEST(Session, SavesOnlyWhatCanBeAnimatedWhereThatIsAskedFor) {
  const TemporaryFolder folder;
  Session session;
  session.set_saves_checked(true);
  Do(&session, "file.save", {{"path", folder / "good.kfa"}});
  Do(&session, "hold.add", {{"joint", "r_toe"}, {"first", 0}, {"last", 30}});
  Do(&session, "key.set", {{"curve", "root.z"}, {"frame", 30}, {"value", 9}});
  const edit::Json bad = {{"path", folder / "bad.kfa"}};
  const Error error = Refused(&session, "file.save", bad);
  EXPECT_EQ(error.code, ErrorCode::kSemantics);
  EXPECT_EQ(error.place, "holds[0]");
  EXPECT_NE(error.message.find("out of reach"), std::string::npos) << error.message;
  EXPECT_FALSE(std::filesystem::exists(folder / "bad.kfa"));
  EXPECT_EQ(session.document().path(), folder / "good.kfa");
  session.set_saves_checked(false);
  Do(&session, "file.save", bad);
  EXPECT_TRUE(std::filesystem::exists(folder / "bad.kfa"));
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
