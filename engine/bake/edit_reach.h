#pragma once

#include <limits>

#include "engine/timeline/animation.h"

namespace hazumi {

// Frames of an animation whose motion an edit can reach; none at first.
class EditReach {
 public:
  static EditReach Everything();

  // A curve had these keys and has those now; true if they differ.
  bool IncludeKeys(const Keys& before, const Keys& after);
  // A region before it is edited or after, of an animation whose keys are as they are now.
  void IncludeRegion(const DynamicsRegion& region, const Animation& animation);
  // After all that: the blends of the edited animation that it reaches into.
  void IncludeBlends(const Animation& animation);

  bool is_empty() const { return first_ > last_; }
  // Frames that need not be whole, nor of the animation.
  double first() const { return first_; }
  double last() const { return last_; }

 private:
  static constexpr double kEver = std::numeric_limits<double>::infinity();

  void Include(double frame);

  double first_ = kEver, last_ = -kEver;
};

}  // namespace hazumi
