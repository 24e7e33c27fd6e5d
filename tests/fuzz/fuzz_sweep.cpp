// Reads any text as a sweep file. An accepted file must be equal after writing and reading it
// again.

#include <cstdint>
#include <string_view>

#include "engine/base/assert.h"
#include "engine/sweep/sweep_plan.h"

namespace hazumi::fuzz {
namespace {

void Run(std::string_view text) {
  const Result<SweepPlan> plan = ParseSweep(text, "fuzz.json");
  if (!plan.ok()) return;
  const std::string written = WriteSweep(plan.value());
  const Result<SweepPlan> again = ParseSweep(written, "again.json");
  HAZUMI_DEMAND(again.ok());
  HAZUMI_DEMAND(WriteSweep(again.value()) == written);
}

}  // namespace
}  // namespace hazumi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  hazumi::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
