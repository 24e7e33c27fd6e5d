#pragma once

#include <vector>

#include "engine/project/project.h"
#include "engine/timeline/frame_time.h"

namespace hazumi::edit {

// How fast a curve arrives at a key and goes on from it [curve's unit per second].
struct RatesOfKey {
  double before = 0.0, after = 0.0;
};

// Of each key, as the keys alone have it.
std::vector<RatesOfKey> RatesOf(const ProjectCurve& curve, const ProjectRate& fps);

// An interval that no key fits into without another shape, eased or with tangents of their own
// lengths, becomes cubics from frame to frame, if `frame` lies inside it.
void ToCubicsAround(double frame, const ProjectRate& fps, ProjectCurve* curve);

}  // namespace hazumi::edit
