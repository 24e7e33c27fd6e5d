#pragma once

#include "engine/region/constraints/constraint_set.h"
#include "engine/region/contact/contact_set.h"
#include "engine/region/contact/step_forces.h"
#include "engine/region/outer_motion.h"
#include "engine/region/region_layout.h"

namespace hazumi {

// Everything about an island that stays the same between two events: with it accelerations are a
// function of time and state.
struct RegionMode {
  RegionLayout layout;        // which hinges limits lock
  ConstraintSet constraints;  // which constraints are broken
  ContactSet contacts;        // which contacts are active, sticking or sliding
  StepForces constant = {};   // forces of time stepping
  // Lower bound of the compliance of constraints (ComplianceOf): kBlocked where limits lock hinges
  // or may do so, more where contacts leave no feasible motion.
  static constexpr double kBlocked = 0.01;
  double least_compliance = kBlocked;
  PointMotion anchor = {};  // of the figure, where it is no part of the state

  bool any_rows() const { return constraints.any() || contacts.any_closed(); }
  bool any_closed() const { return constraints.any_closed() || contacts.any_closed(); }
};

}  // namespace hazumi
