// Reads any text as a file of poses. An accepted file must be equal after writing and reading it
// again.

#include <cstdint>
#include <string_view>

#include "engine/base/assert.h"
#include "engine/project/pose_file.h"

namespace hazumi::fuzz {
namespace {

void Run(std::string_view text) {
  const Result<PoseFile> file = ParsePoses(text, "fuzz.json");
  if (!file.ok()) return;
  const std::string written = WritePoses(file.value());
  const Result<PoseFile> again = ParsePoses(written, "again.json");
  HAZUMI_DEMAND(again.ok());
  HAZUMI_DEMAND(WritePoses(again.value()) == written);
}

}  // namespace
}  // namespace hazumi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  hazumi::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
