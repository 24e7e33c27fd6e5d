#include "engine/dynamics/workspace.h"

#include <limits>

namespace hazumi {

DynamicsWorkspace::DynamicsWorkspace(const Figure& figure)
    : bodies(figure.num_joints() + 1), tau(figure.num_joints()) {
#ifndef NDEBUG
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (BodyScratch& body : bodies) {
    body.R.setConstant(kNaN);
    for (Vec3* x :
         {&body.p, &body.axis, &body.c, &body.w, &body.v, &body.alpha, &body.a, &body.f, &body.n}) {
      x->setConstant(kNaN);
    }
  }
  tau.setConstant(kNaN);
#endif
}

}  // namespace hazumi
