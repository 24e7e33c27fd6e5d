#include "ui/panels/problems/support_problem.h"

#include "ui/panels/text/catalogue.h"
#include "ui/panels/text/filled.h"

namespace hazumi::ui {

namespace {

std::string WhatText(const MissingSupport& missing, const std::string& edge) {
  const double cm = 100.0 * missing.distance;
  switch (missing.fault) {
    case SupportFault::kFloats:
      return Filled(
          Tr("nothing carries the figure, %.0f N are missing. Bring it to the ground, pin "
             "what stands, or let gravity place it."),
          missing.force);
    case SupportFault::kPulled:
      return Filled(Tr("the ground would have to pull the figure down by %.0f N. Slow the drop "
                       "down, or let it leave the ground."),
                    missing.force);
    case SupportFault::kSlides:
      return Filled(Tr("the ground would have to push sideways, by %.0f N harder than friction "
                       "can. Move more slowly, or put the feet further out."),
                    missing.force);
    case SupportFault::kTips:
      return Filled(Tr("the centre of mass is %.1f cm beyond %s, and nothing keeps the figure from "
                       "falling over (%.0f N m). Move the weight back, or step there."),
                    cm, edge.c_str(), missing.moment);
    case SupportFault::kPushedOff:
      return Filled(Tr("the ground would have to push %.1f cm beyond %s (%.0f N m are missing). "
                       "Move more slowly, or step there."),
                    cm, edge.c_str(), missing.moment);
    case SupportFault::kTurned:
      return Filled(Tr("what touches cannot turn the figure so (%.0f N m are missing). Turn more "
                       "slowly, or give it more to stand on."),
                    missing.moment);
    case SupportFault::kTurnsInAir:
      return Filled(Tr("in the air nothing can turn the figure so (%.0f N m are missing). Let the "
                       "root turn evenly until it lands."),
                    missing.moment);
  }
  return "";
}

}  // namespace

Problem SupportProblem(const MissingSupport& missing, const Figure& figure) {
  const std::string edge = missing.joint.is_valid()
                               ? figure.group(figure.joint(missing.joint).group).name
                               : figure.root_name();
  Problem problem;
  problem.text =
      Filled(Tr("Frames %d to %d, most at %d: "), missing.first, missing.last, missing.worst) +
      WhatText(missing, edge);
  problem.frame = missing.worst;
  return problem;
}

}  // namespace hazumi::ui
