#include <cstdio>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/terminal.h"
#include "engine/analysis/flights.h"
#include "engine/analysis/motion_series.h"
#include "engine/exchange/motion_text.h"

namespace hazumi {

int RunFlight(const Options& options) {
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  const auto& [project, animation, motion, warnings] = baked.value();
  MotionSeries series = SeriesOf(*animation.figure, motion);
  series.scale_known = !project.size_is_guessed;
  const FlightAnalysis analysis = AnalyseFlights(series, animation.gravity);
  PrintWarnings(options.files[0], warnings);
  if (options.json) {
    std::fputs(FlightsToJson(analysis).c_str(), stdout);
    return kExitOk;
  }
  for (const std::string& line : FlightReport(analysis)) PrintLine(stdout, "%s", line.c_str());
  return kExitOk;
}

}  // namespace hazumi
