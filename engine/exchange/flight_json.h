#pragma once

#include <string>

#include "engine/analysis/flights.h"

namespace hazumi {

// The analysis of a motion as JSON (`hazumi-flights`, version 1): metres, seconds, frames of the
// clip. The fields are listed in README.md beside this file.
std::string FlightsToJson(const FlightAnalysis& analysis);

}  // namespace hazumi
