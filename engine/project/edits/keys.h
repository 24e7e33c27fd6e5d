#pragma once

#include <cmath>
#include <vector>

#include "engine/project/project.h"

namespace hazumi {

// Rounds to 1e-9: 60 degrees come back from radians as 60, not as 59.99999999999999.
inline double WithoutRoundOff(double degrees) { return std::round(degrees * 1e9) / 1e9; }

// Returns the key on a frame, or null.
ProjectKey* KeyOn(double frame, ProjectCurve* curve);
const ProjectKey* KeyOn(double frame, const ProjectCurve& curve);
// Key on a frame, to be changed and put back, or a new one. A generated key is given to the
// animator: its tangents are automatic.
ProjectKey KeyToChange(double frame, const ProjectCurve& curve);
// Inserts a key. Replaces the key on the same frame, but for its fields that the program does not
// know.
void PutKey(const ProjectKey& key, ProjectCurve* curve);
void RemoveKeysIn(int first, int last, ProjectCurve* curve);
// Has all tangents of the key follow from its neighbours.
void SetAutomatic(ProjectKey* key);

// Rates at which a curve arrives at a key and goes on from it [curve's unit per second].
struct RatesOfKey {
  double before = 0.0, after = 0.0;
};
// Returns the rates of each key, without what else moves the figure.
std::vector<RatesOfKey> RatesOf(const ProjectCurve& curve, const ProjectRate& fps);

// Replaces the interval around `frame` by cubics from frame to frame if a key in it would change
// its shape: if it is eased, or has tangents of their own lengths.
void ToCubicsAround(double frame, const ProjectRate& fps, ProjectCurve* curve);

}  // namespace hazumi
