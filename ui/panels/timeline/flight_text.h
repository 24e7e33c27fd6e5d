#pragma once

#include <optional>
#include <string>

#include "engine/analysis/flights.h"

namespace hazumi::ui {

// What a flight is, in the language of the interface: "0.58 s, 9.92 m/s² (9.48 – 10.4)", which is
// the range of 95 % confidence.
std::string FlightText(const Flight& flight, double frame_time);
// What the flights say of time and lengths, a sentence; empty if nothing is wrong.
std::string AlarmText(const TimeScale& time);
// Why they say nothing; empty if they do, or if there are none.
std::string UndecidedText(const TimeScale& time);
// The common frame rate that the clip should be played at [1/s]; none if no such is near, or if it
// is lengths that are wrong.
std::optional<int> RateToSet(const TimeScale& time);
// Of the button that sets it; empty if there is none.
std::string RepairText(const TimeScale& time);

}  // namespace hazumi::ui
