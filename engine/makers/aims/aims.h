#pragma once

// Makes goals come true: finds torques for the limp joints of a dynamics region with which its
// motion meets what a project's goals ask for.

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/figure/figure.h"
#include "engine/project/project.h"

namespace hazumi::makers {

// Distance of the baked motion from a goal.
struct GoalMissed {
  std::string goal;
  double angle = 0.0;     // largest of a pose, of `joint` [rad]
  double distance = 0.0;  // of a point [m]
  double rate = 0.0;      // of a goal that is to rest: the largest [rad/s]
  std::string joint;
};

struct AimReport {
  std::string region;
  std::vector<GoalMissed> goals;  // of the region, as the project has them
  bool is_loose = false;          // the limbs arrive by themselves, without torques
  // Largest torque on a whole frame as a share of what the hinge can give there; 0 if no strength
  // is known.
  double muscle = 0.0;
  std::string strongest;  // that hinge
  int frame = 0;
  int bakes = 0, iterations = 0;
};
struct MadeAim {
  Project project;
  AimReport report;
};

// Aims the region that moves the joints of a goal of kind pose or point at all such goals of that
// region. Torques that an
// earlier aim found are found anew; joints with other drives keep these. The report is that of one
// bake of the project it returns. `figure`: what was built of the project's figure before, or null.
// Errors: kSchema, with what to do instead, if no region moves the joints there or a key lies
// beyond a limit; kSemantics, with the distance missed, for a point out of reach and where no
// motion was found; those of CompileAnimation and of bakes.
Result<MadeAim> MakeAim(const std::string& goal, const Project& project,
                        std::shared_ptr<const Figure> figure,
                        const std::atomic<bool>* cancel = nullptr);

// The tip of a joint's limb reaches a position in a frame.
struct ReachTarget {
  std::string joint;             // the outermost one of the limb
  Vec3 position = Vec3::Zero();  // world [m]
  int frame = 0;
  std::optional<bool> rests;  // not given: as the goal that is there has it, else if it can
};

// Tip of what sticks out farthest beyond a joint, in its frame [m].
Vec3 TipOf(JointIndex joint, const Figure& figure);

// Adds a goal of kind point for the target, or moves the one that is there, and a region if none
// moves the limb in that frame; aims it. Errors: as MakeAim.
Result<MadeAim> MakeReach(const ReachTarget& target, const Project& project,
                          std::shared_ptr<const Figure> figure,
                          const std::atomic<bool>* cancel = nullptr);

// Takes away the torques that aims found for a region.
void LetLoose(ProjectRegion* region);

// The region that moves joints of a goal in its frame; null: there is none.
const ProjectRegion* RegionOf(const ProjectGoal& goal, const Figure& figure,
                              const Project& project);

}  // namespace hazumi::makers
