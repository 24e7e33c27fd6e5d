// Any text as a figure file: what is read can be built, written, and read again.

#include <cstdint>
#include <string_view>

#include "engine/base/assert.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/figure_file.h"

namespace hazumi::fuzz {
namespace {

void Run(std::string_view text) {
  const Result<FigureSpec> spec = ParseFigure(text, "fuzz.json");
  if (!spec.ok()) return;
  const Result<Figure> figure = BuildFigure(spec.value());
  HAZUMI_DEMAND(figure.ok());
  const Result<FigureSpec> again = ParseFigure(FigureText(spec.value()), "again.json");
  HAZUMI_DEMAND(again.ok());
  HAZUMI_DEMAND(BuildFigure(again.value()).value().num_joints() == figure.value().num_joints());
}

}  // namespace
}  // namespace hazumi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  hazumi::fuzz::Run({reinterpret_cast<const char*>(data), size});
  return 0;
}
