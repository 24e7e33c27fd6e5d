#pragma once

#include <string>
#include <vector>

#include "engine/analysis/flights.h"

namespace hazumi {

// The analysis in words, a line each; what belongs together begins with one word and goes on
// indented. Frames are those of the clip.
std::vector<std::string> FlightReport(const FlightAnalysis& analysis);

// What the clip's units of time and length must be, as a sentence: "this clip plays at 1/4 speed:
// its frame time is probably 1/120 s, not 1/30 s". Empty where there is nothing to judge by.
std::string TimeSentence(const TimeScale& time);

// What gravity says of a unit of length that was guessed; empty if it was stated or if there is
// nothing to judge by.
std::string LengthSentence(const TimeScale& time);

}  // namespace hazumi
