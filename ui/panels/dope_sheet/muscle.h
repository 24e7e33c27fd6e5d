#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/project/project.h"

namespace hazumi::ui {

// With how much muscle a region moves the joints of a row.
enum class Muscle { kLoose, kTorque, kSpring, kKeys, kMixed };

struct RowMuscle {
  Muscle kind = Muscle::kLoose;
  // The first spring that moves one of them and is not limited in N m, by number of the region's
  // drives; -1: none.
  int spring = -1;
  std::optional<double> strength = {};  // of that: a share; none: as strong as it takes

  // How full of muscle the row's bar is, from 0 to 1.
  double fill() const;
};

// The drives of a region by joint, -1 where it is limp.
std::vector<int> DrivesByJoint(const ProjectRegion& region, const Figure& figure);
// Of some hinges, which the region has.
RowMuscle MuscleOf(const ProjectRegion& region, const std::vector<int>& drives_by_joint,
                   const std::vector<JointIndex>& hinges);

// "spring, 40 % of strength"
std::string TextOf(const RowMuscle& muscle);
// "40 %"
std::string PercentText(double share);

}  // namespace hazumi::ui
