// Any text as a .kfa file: it is read or refused; what was read is written and read again as the
// same; what can be compiled is baked for some frames.

#include <cstdint>
#include <string_view>

#include "engine/bake/bake.h"
#include "engine/base/assert.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/fuzz/deadline.h"

namespace hazumi::fuzz {
namespace {

constexpr int kMostFrames = 12, kMostHinges = 16;
constexpr double kBakeSeconds = 0.02;

void CheckRoundTrip(const Project& project) {
  const std::string text = WriteProject(project);
  const Result<Project> again = ParseProject(text, "again.kfa");
  HAZUMI_DEMAND(again.ok());
  HAZUMI_DEMAND(WriteProject(again.value()) == text);
}

void BakeShortly(const Animation& animation) {
  if (animation.last_frame - animation.first_frame > kMostFrames) return;
  if (animation.figure->num_joints() > kMostHinges) return;
  const Deadline deadline(kBakeSeconds);
  BakeOptions options;
  options.cancel = deadline.flag();
  options.threads = 1;
  (void)Bake(animation, options);
}

void Run(std::string_view text) {
  const Result<Project> project = ParseProject(text, "fuzz.kfa");
  if (!project.ok()) return;
  CheckRoundTrip(project.value());
  const Result<Compiled> compiled = CompileAnimation(project.value());
  if (compiled.ok()) BakeShortly(compiled.value().animation);
}

}  // namespace
}  // namespace hazumi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  hazumi::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
