#pragma once

// Motions, their seams and their analysis as text: JSON and CSV.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/analysis/flights.h"
#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct MotionJsonOptions {
  // Also write how long each region took. Off by default: it differs from run to run, and two bakes
  // of one file should be equal bytes.
  bool timings = false;
  bool torques = false;  // write the torques of each frame, of analysis/effort.h
  // What makes it, for those who want to make it again; empty: not said.
  struct Maker {
    std::string program;               // with version and commit
    std::vector<std::string> options;  // that change what comes out, as on the command line
  };
  Maker made_by = {};
  bool effort = false;  // also what it asks of muscles and ground: analysis/effort.h
};

// A motion as JSON, one line a frame: metres, degrees, seconds, world axes (z up), quaternions
// w x y z. The fields are listed in README.md beside this file.
std::string MotionToJson(const Animation& animation, const Motion& motion,
                         const MotionJsonOptions& options = {});

// Of an angle that somebody stated in degrees: without what the way to radians and back changes in
// the last digits.
double StatedDegrees(double radians);

// Every term of the balance and what it leaves unexplained, by its name in JSON [J].
std::vector<std::pair<std::string, double>> TermsOf(const EnergyBalance& energy);

// A seam as a JSON object; its fields are listed in README.md beside this file.
std::string SeamToJson(const Animation& animation, const Seam& seam);

// Motion as a table, one row per frame: frame, time [s], root position [m] and quaternion (w x y
// z), CoM [m], pinned joint (or nothing), then angle [degrees] and rate [degrees/s] of every joint.
// `torques` adds the torque of every joint [N m], and the residual force [N] and moment [N m].
// `effort` adds the same torques [N m], their shares of the strength (or nothing), and the residual
// wrench. analysis/effort.h computes all of them.
std::string MotionToCsv(const Animation& animation, const Motion& motion, bool torques = false,
                        bool effort = false);

// The analysis of a motion as JSON (`hazumi-flights`, version 1): metres, seconds, frames of the
// clip. The fields are listed in README.md beside this file.
std::string FlightsToJson(const FlightAnalysis& analysis);

}  // namespace hazumi
