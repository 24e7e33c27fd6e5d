#pragma once

#include <algorithm>

namespace hazumi {

// Cost of solving a motion, by kind. Work is counted, not timed, so that it is equal on every
// machine. Unit: evaluations of the accelerations of one body.
struct Work {
  enum class On { kMotion, kSearches, kLimits, kContacts, kLandings };

  double motion = 0.0;    // accelerations
  double searches = 0.0;  // contact detection
  double limits = 0.0;    // finding active limits
  double contacts = 0.0;  // contact forces and friction
  double landings = 0.0;  // take-offs and landings of a placement by gravity

  double total() const { return motion + searches + limits + contacts + landings; }
  On largest() const {
    const double most = std::max({motion, searches, limits, contacts, landings});
    if (most == motion) return On::kMotion;
    if (most == searches) return On::kSearches;
    if (most == limits) return On::kLimits;
    return most == contacts ? On::kContacts : On::kLandings;
  }
  Work& operator+=(const Work& more) {
    motion += more.motion;
    searches += more.searches;
    limits += more.limits;
    contacts += more.contacts;
    landings += more.landings;
    return *this;
  }
};
inline Work operator*(double times, const Work& work) {
  return {times * work.motion, times * work.searches, times * work.limits, times * work.contacts,
          times * work.landings};
}

}  // namespace hazumi
