#pragma once

#include <optional>
#include <vector>

#include "engine/bake/pose/curve_set.h"
#include "engine/bake/pose/known_holds.h"
#include "engine/base/result.h"
#include "engine/timeline/animation.h"

namespace hazumi {

class Recorder;

// The holds that act at present, and what was asked of any hold before.
class ActiveHolds {
 public:
  static constexpr double kReachTolerance = 1e-4;  // of holds that keys just do not reach [m]

  // All of it must outlive them; of holds just within reach a warning is written.
  ActiveHolds(const Animation& animation, const Figure& figure, Recorder* recorder)
      : animation_(animation), figure_(figure), recorder_(recorder) {}

  // A hold that began: of Animation::holds, and what it keeps where.
  struct Begun {
    size_t index;
    HoldTarget target;
    bool operator==(const Begun&) const = default;
  };
  // Goes on with these.
  void Resume(const std::vector<Begun>& begun);
  std::vector<Begun> begun() const;

  bool empty() const { return holds_.empty(); }
  // It keeps the joint where the workspace has it.
  void Begin(size_t index, const DynamicsWorkspace& ws);
  // Lets go of those whose last frame it is.
  void EndAt(int frame);

  // What a hold moves.
  struct Moved {
    size_t index;
    int last_frame;
    const std::vector<JointIndex>& joints;
  };
  std::vector<Moved> moved() const;

  // Sets the joints that holds move. `motion` is keyed but for that; the root turns as the angles
  // say. An error where one is out of reach by more than the tolerance [m].
  std::optional<Error> Solve(const RootAngles& root, Side side, double tolerance,
                             FigureMotion* motion);

 private:
  struct Hold {
    size_t index;
    HoldSolver solver;
    HoldTarget target;
    bool is_warned_of = false;  // since it was resumed
  };
  using Place = KnownHolds::Place;

  std::optional<Error> SolveHold(const Place& place, double tolerance, const PoseOf<Jet>& X_WR,
                                 Hold* hold, std::vector<Jet>* q);
  Error OutOfReach(size_t index, double frame, double distance) const;
  void WarnOfReach(Hold* hold);

  const Animation& animation_;
  const Figure& figure_;
  Recorder* recorder_;
  std::vector<Hold> holds_;
  KnownHolds known_;
};

}  // namespace hazumi
