#pragma once

// What a sweep measures of a motion.

#include <span>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/sweep/sweep_plan.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What a quantity may be of; kNothing: of the figure as a whole.
enum class QuantityOf { kNothing, kHeldObject, kJoint, kHinge, kRegion };

struct Measured {
  const Animation& animation;
  const Motion& motion;
  int of = -1;         // index of what it is of: held object, group, joint, region; -1: of all
  double frame = 0.0;  // if the quantity is at a frame
};

struct Quantity {
  const char* name;  // with its unit: "landing_x_m"
  QuantityOf of;
  bool is_of_one;     // `of` must be given; else it may be left out: of all
  bool is_at_frame;   // a frame must be given
  bool wants_energy;  // measured with the account of energy, which takes as long again
  const char* help;   // a clause
  double (*measure)(const Measured& measured);  // NaN: there is none
};

std::span<const Quantity> AllQuantities();

// A measure, resolved.
struct SweepColumn {
  std::string name;  // of the column
  const Quantity* quantity;
  int of = -1;
  double frame = 0.0;
};

// Errors: kSchema, with the place in the sweep file: an unknown quantity or name, a frame that is
// missing, outside of the animation or not asked for, a column named twice.
Result<std::vector<SweepColumn>> ResolveMeasures(const SweepPlan& plan, const Animation& animation);

double Measure(const SweepColumn& column, const Animation& animation, const Motion& motion);

}  // namespace hazumi
