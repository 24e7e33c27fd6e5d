#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/pose/root_placement.h"
#include "engine/placement/figure_motion.h"
#include "engine/region/paper_step.h"
#include "engine/region/region_system.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Steps the joints of all regions that are active at one time, as one system: limbs on one trunk
// may feel each other.
class PaperDriver {
 public:
  // `active`: indices of Animation::regions. `figure` must outlive the driver.
  PaperDriver(const Animation& animation, const Figure& figure, std::vector<int> active);

  const std::vector<int>& active() const { return active_; }
  double step() const { return step_; }  // the smallest any of the regions asks for [s]
  bool is_free(JointIndex j) const;

  struct Failure {
    JointIndex joint;
    std::string cause;
  };
  // From the state `from` advances the free joints' entries of q and qd by dt seconds. A joint that
  // reaches a limit in this step is added to `limits`. `torques`: by JointIndex [N m]; null: none.
  std::optional<Failure> Advance(const FigureMotion& from, const RootHold& hold,
                                 const VecX* torques, double dt, DynamicsWorkspace* ws, VecX* q,
                                 VecX* qd, std::vector<JointIndex>* limits);

  // The kick of a landing on the free joints' rates: `from.root.v` is the velocity just before.
  bool ApplyLanding(const FigureMotion& from, JointIndex pin, DynamicsWorkspace* ws, VecX* qd);

  int solves_of_last_step() const { return paper_.solves(); }

 private:
  const Animation& animation_;
  std::vector<int> active_;
  double step_;
  RegionSystem system_;
  PaperStep paper_;
  PaperStepInput input_;
  VecX factors_;  // friction per 1/30 s
  VecX y_, yd_;   // free joints' angles and rates
  std::vector<char> on_limit_;
};

}  // namespace hazumi
