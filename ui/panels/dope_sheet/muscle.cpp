#include "ui/panels/dope_sheet/muscle.h"

#include <algorithm>

#include "engine/base/filled.h"
#include "engine/project/checks/joint_names.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

Muscle KindOf(const ProjectRegion& region, int drive) {
  if (drive < 0) return Muscle::kLoose;
  switch (region.drives[drive].kind) {
    case DriveKind::kTorque:
      return Muscle::kTorque;
    case DriveKind::kSpring:
      return Muscle::kSpring;
    case DriveKind::kKeys:
      break;
  }
  return Muscle::kKeys;
}

}  // namespace

double RowMuscle::fill() const {
  return spring < 0 ? 0.0 : std::clamp(strength.value_or(1.0), 0.0, 1.0);
}

std::vector<int> DrivesByJoint(const ProjectRegion& region, const Figure& figure) {
  std::vector<int> drives(static_cast<size_t>(figure.num_joints()), -1);
  for (size_t d = 0; d < region.drives.size(); ++d) {
    const std::vector<bool> driven = JointsOf(region.drives[d].joints, figure);
    for (size_t j = 0; j < driven.size(); ++j) {
      if (driven[j]) drives[j] = static_cast<int>(d);
    }
  }
  return drives;
}

RowMuscle MuscleOf(const ProjectRegion& region, const std::vector<int>& drives_by_joint,
                   const std::vector<JointIndex>& hinges) {
  RowMuscle muscle;
  for (size_t i = 0; i < hinges.size(); ++i) {
    const int drive = drives_by_joint[hinges[i].value()];
    const Muscle kind = KindOf(region, drive);
    if (i == 0) muscle.kind = kind;
    if (muscle.kind != kind) muscle.kind = Muscle::kMixed;
    if (kind != Muscle::kSpring || muscle.spring >= 0) continue;
    const ProjectDrive& spring = region.drives[drive];
    // What keys say is not dragged.
    if (!spring.strength_over_time.keys.empty()) continue;
    if (spring.max_torque_n_m && !spring.strength) continue;
    muscle.spring = drive;
    muscle.strength = spring.strength;
  }
  return muscle;
}

std::string PercentText(double share) { return Filled("%.0f %%", 100.0 * share); }

std::string TextOf(const RowMuscle& muscle) {
  switch (muscle.kind) {
    case Muscle::kLoose:
      return Tr("limp");
    case Muscle::kTorque:
      return Tr("torque");
    case Muscle::kSpring:
      break;
    case Muscle::kKeys:
      return Tr("keys");
    case Muscle::kMixed:
      return Tr("several kinds of muscle");
  }
  if (!muscle.strength) return Tr("spring");
  return std::string(Tr("spring")) + ", " + PercentText(*muscle.strength);
}

}  // namespace hazumi::ui
