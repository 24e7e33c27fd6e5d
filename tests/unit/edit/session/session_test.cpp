// Who observes a session, and where a session keeps what is no document.

#include "ui/edit/session/session.h"

#include <filesystem>
#include <fstream>

#include "engine/project/project_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/recovery/recovery.h"
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

void AppendTo(const std::string& path) { std::ofstream(path, std::ios::app) << "\n"; }

TEST(Session, DoesNotSaveOverWhatAnotherProgramHasWritten) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.kfa";
  Session session;
  Do(&session, "file.save", {{"path", path}});
  Do(&session, "project.rename", {{"name", "mine"}});
  Do(&session, "file.save");  // its own is no other program's
  AppendTo(path);
  Do(&session, "project.rename", {{"name", "mine again"}});
  for (const edit::Json& where : {edit::Json::object(), edit::Json{{"path", path}},
                                  edit::Json{{"path", folder / "./a.kfa"}}}) {
    const Error error = Refused(&session, "file.save", where);
    EXPECT_TRUE(std::filesystem::equivalent(error.file, path)) << error.file;
    EXPECT_NE(error.message.find("another program has changed it"), std::string::npos);
  }
  EXPECT_EQ(LoadProject(path).value().name, "mine");
  EXPECT_FALSE(session.document().is_saved());
  Do(&session, "file.save", {{"overwrite", true}});
  EXPECT_EQ(LoadProject(path).value().name, "mine again");
  Do(&session, "project.rename", {{"name", "once more"}});
  Do(&session, "file.save");
}

TEST(Session, SavesOverWhatWasOpenedAndWhereTheFileIsGone) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.kfa";
  Session().Run("file.save", {{"path", path}}).value();
  AppendTo(path);
  Session session;
  Do(&session, "file.open", {{"path", path}});
  Do(&session, "project.rename", {{"name", "mine"}});
  Do(&session, "file.save");
  std::filesystem::remove(path);
  Do(&session, "project.rename", {{"name", "again"}});
  Do(&session, "file.save");
  EXPECT_EQ(LoadProject(path).value().name, "again");
}

TEST(Session, SaysWhatAnOperatorMadeByAddresses) {
  Session session;
  Do(&session, "marker.add", {{"frame", 3}, {"name", "hit"}});
  EXPECT_EQ(session.outcome().made, std::vector<std::string>{"markers[hit]"});
  Do(&session, "object.add_plane", {{"name", "wall"}});
  EXPECT_EQ(session.outcome().made, std::vector<std::string>{"scene.objects[wall]"});
  Do(&session, "object.set", {{"object", "wall"}, {"color", "#112233"}});
  EXPECT_TRUE(session.outcome().made.empty());
  Do(&session, "object.remove", {{"object", "wall"}});
  EXPECT_TRUE(session.outcome().made.empty());
}

}  // namespace
}  // namespace hazumi::test
