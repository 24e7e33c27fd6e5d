#pragma once

// Quantities in words, in the language of the interface: friction and flights.

#include <optional>
#include <string>

#include "engine/analysis/problems/problems.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

// Describes a factor of friction, the share of speed that is left after 1/30 s, as it looks: when
// half of the speed is gone, and how much is left after a second.
std::string FrictionInWords(double factor);

// What a flight is, in the language of the interface: "0.58 s, 9.92 m/s² (9.48 – 10.4)", which is
// the range of 95 % confidence.
std::string FlightText(const Flight& flight, double frame_time);
// Sentence about a wrong time or length, in the language of the interface.
inline std::string AlarmText(const TimeScale& time) { return hazumi::AlarmText(time, Tr); }
// Why they say nothing; empty if they do, or if there are none.
std::string UndecidedText(const TimeScale& time);
// Of the button that sets it; empty if there is none.
std::string RepairText(const TimeScale& time);

}  // namespace hazumi::ui
