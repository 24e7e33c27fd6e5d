#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analysis/foot_contact.h"
#include "engine/analysis/gravity_estimate.h"
#include "engine/analysis/motion_series.h"
#include "engine/analysis/parabola.h"
#include "engine/analysis/time_scale.h"

namespace hazumi {

// Angular momentum about the CoM, which a flight keeps.
struct AngularMomentumDrift {
  Vec3 mean = Vec3::Zero();    // over the flight [kg m^2/s]
  Vec3 change = Vec3::Zero();  // from take-off to landing, of the straight line fitted [kg m^2/s]
  double relative = 0.0;       // |change| / root mean square of |L|
};

// Nothing touches the ground and the CoM is on a parabola. Frames as the clip numbers them, between
// frames where the feet's height says so.
struct Flight {
  double take_off = 0.0, landing = 0.0;  // when the last foot rises, the first comes, to 2 cm
  double apex = 0.0;                     // of the parabola
  bool begins_before_clip = false, ends_after_clip = false;  // then take_off, landing are its ends
  Parabola parabola;
  GravityEstimate gravity;         // that of the parabola, and how far it can be believed
  double rise = 0.0;               // of the CoM from take-off to the apex [m]
  Vec3 v_take_off = Vec3::Zero();  // of the CoM, of the parabola [m/s]
  double horizontal_speed = 0.0;   // [m/s]
  std::optional<AngularMomentumDrift> angular_momentum;

  double duration_frames() const { return landing - take_off; }
};

struct FlightAnalysis {
  std::vector<Flight> flights;  // in order of time
  std::vector<FootSkate> skates;
  TimeScale time;
};

// Finds the flights of a motion, whatever it takes for gravity and a second. Flights shorter than 5
// frames are not found: a parabola through 3 points says nothing. `gravity` is the true one
// [m/s^2].
FlightAnalysis AnalyseFlights(const MotionSeries& series, double gravity = 9.81);

// What flights say of the clip's time: JudgeTime of their gravities.
TimeScale TimeOf(const std::vector<Flight>& flights, double frame_time, double stature,
                 bool scale_known, double gravity);

// The flights alone, as AnalyseFlights finds them.
std::vector<Flight> FindFlights(const MotionSeries& series);

// The analysis in words, a line each; what belongs together begins with one word and goes on
// indented. Frames are those of the clip.
std::vector<std::string> FlightReport(const FlightAnalysis& analysis);

// Returns a sentence about the unit of time that gravity suggests: "this clip plays at 1/4 speed:
// its frame time is probably 1/120 s, not 1/30 s". Empty where there is nothing to judge by.
std::string TimeSentence(const TimeScale& time);

// Returns a sentence about a unit of length that was guessed, as gravity suggests it. Empty if it
// was stated or if there is nothing to judge by.
std::string LengthSentence(const TimeScale& time);

}  // namespace hazumi
