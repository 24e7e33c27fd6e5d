#pragma once

#include "tests/unit/edit/sessions.h"

namespace hazumi::test {

// The keys of a hinge's curve.
inline const std::vector<ProjectKey>& KeysOf(const edit::Session& session,
                                             const std::string& hinge) {
  for (const Named<ProjectCurve>& entry : session.project().joints) {
    if (entry.name == hinge) return entry.value.keys;
  }
  ADD_FAILURE() << "no curve " << hinge;
  static const std::vector<ProjectKey> none;
  return none;
}

// Frames and values of a curve's keys.
using Points = std::vector<std::pair<double, double>>;
inline Points PointsOf(const edit::Session& session, const std::string& hinge) {
  Points points;
  for (const ProjectKey& key : KeysOf(session, hinge)) points.emplace_back(key.frame, key.value);
  return points;
}

// Makes keys of a hinge.
inline void SetKeys(edit::Session* session, const std::string& hinge, const Points& points) {
  for (const auto& [frame, value] : points) {
    Do(session, "key.set", {{"curve", hinge}, {"frame", frame}, {"value", value}});
  }
}

// Selects keys of a hinge and no others.
inline void SelectKeys(edit::Session* session, const std::string& hinge,
                       const std::vector<double>& frames) {
  const std::vector<std::string> curves(frames.size(), hinge);
  Do(session, "keys.select", {{"curves", curves}, {"frames", frames}});
}

}  // namespace hazumi::test
