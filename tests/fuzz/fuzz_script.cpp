// Any text as a script of operators, each tried whatever became of those before it, on a small
// project. The document stays one whose file can be read, and all can be undone.

#include <cstdint>
#include <string_view>

#include "engine/base/assert.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/fuzz/small_project.h"
#include "ui/edit/script.h"

namespace hazumi::fuzz {
namespace {

constexpr int kMostSteps = 30, kMostFrames = 60;
constexpr double kPatience = 0.02;  // [s] for a motion

// Files are left alone. What makes motions long is left out: nothing here is about how long they
// take.
bool IsTooMuch(const edit::Session& session, const std::string& id) {
  const ProjectFrames& frames = session.project().frames;
  return id.starts_with("file.") || id == "solver.set" || frames.last - frames.first > kMostFrames;
}

void Run(std::string_view text) {
  static const Project small = ParseProject(kSmallProject, "small.kfa").value();
  static edit::Session session;
  session.Replace(small, "");
  session.set_patience(kPatience);
  int num_steps = 0;
  const auto run = [&](const std::string& id, const edit::Json& parameters) -> Result<Done> {
    if (++num_steps > kMostSteps) return Error{ErrorCode::kSchema, "", "", "enough"};
    if (!IsTooMuch(session, id)) (void)session.Run(id, parameters);
    return Done();
  };
  (void)edit::RunScript(text, "fuzz.json", run);
  session.StopBaking();
  if (session.document().num_steps() == 0) return;
  HAZUMI_DEMAND(ParseProject(WriteProject(session.project()), "again.kfa").ok());
  session.document().EndMerge();
  while (session.document().Undo()) {
  }
  HAZUMI_DEMAND(WriteProject(session.project()) == WriteProject(small));
}

}  // namespace
}  // namespace hazumi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  hazumi::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
