#pragma once

#include <algorithm>

namespace hazumi {

// What solving a motion took, by what it was spent on. Counted and never measured, so that it is
// the same on every machine; in evaluations of the accelerations of one body.
struct Work {
  enum class On { kMotion, kSearches, kLimits, kContacts };

  double motion = 0.0;    // accelerations
  double searches = 0.0;  // for what touches
  double limits = 0.0;    // which hinges their limits hold
  double contacts = 0.0;  // what pushes and what slides

  double total() const { return motion + searches + limits + contacts; }
  On largest() const {
    const double most = std::max({motion, searches, limits, contacts});
    if (most == motion) return On::kMotion;
    if (most == searches) return On::kSearches;
    return most == limits ? On::kLimits : On::kContacts;
  }
  Work& operator+=(const Work& more) {
    motion += more.motion;
    searches += more.searches;
    limits += more.limits;
    contacts += more.contacts;
    return *this;
  }
};
inline Work operator*(double times, const Work& work) {
  return {times * work.motion, times * work.searches, times * work.limits, times * work.contacts};
}

}  // namespace hazumi
