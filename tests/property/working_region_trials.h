#pragma once

#include <array>
#include <string>

#include "engine/bake/motion.h"
#include "tests/property/random_working_region.h"

namespace hazumi::test {

// Working regions are baked and compared with tight references.

constexpr double kTolerance = 0.01;  // [deg]

enum class Outcome { kNone, kFailed, kRefused, kUnreferenced, kChaotic, kCompared };

struct Trial {
  Outcome outcome = Outcome::kNone;
  double error = 0.0, apart = 0.0;  // [deg]
  bool is_reported = false;         // a warning reports an error of that size
  double account = -1.0;            // what is left of it, of what changed hands; none: -1
  bool is_open = false, is_open_unsaid = false;  // the account; and no warning says it
  std::string message;
};

Trial Try(const Animation& animation);

// Largest error up to a frame [deg].
double FurthestApart(const Animation& animation, const Motion& a, const Motion& b, double until);

struct Tally {
  int cases = 0, failed = 0, refused = 0, unreferenced = 0, chaotic = 0, compared = 0, too_far = 0;
  int reported = 0;                         // beyond the tolerance, with a warning
  int accounts = 0, open = 0, unsaid = 0;   // open without a warning
  double worst = 0.0, worst_account = 0.0;  // error [deg], part of what changed hands
};

// Tallies of random working regions, by what acts. Odd ones are printed.
class Trials {
 public:
  void Add(int seed);
  void Expect() const;

 private:
  Tally all_;
  std::array<Tally, kAllActing.size()> by_acting_;
};

}  // namespace hazumi::test
