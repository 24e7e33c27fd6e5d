#include "engine/bake/walk/drive_curves.h"

#include <algorithm>

namespace hazumi {

void DriveCurves::SetRegions(const std::vector<int>& regions) {
  entries_.clear();
  for (const int r : regions) {
    for (const Drive& drive : context_.animation.regions[r].drives) {
      for (const JointIndex j : drive.joints) entries_.push_back(EntryOf(drive, j, r));
    }
  }
}

DriveCurves::Entry DriveCurves::EntryOf(const Drive& drive, JointIndex joint, int region) const {
  Entry entry{joint, &drive, region, std::nullopt, std::nullopt};
  const auto track = [this](const Keys& keys) -> std::optional<CurveTrack> {
    if (keys.empty()) return std::nullopt;
    return CurveTrack(&keys, context_.animation.rate, 0.0, {});
  };
  entry.frequency = track(drive.frequency_keys);
  entry.strength = track(drive.strength_keys);
  if (drive.kind == DriveKind::kTorque) {
    entry.own.emplace(&drive.torque, context_.animation.rate, 0.0, std::vector<double>());
  } else if (drive.target == SpringTarget::kRest) {
    entry.constant = context_.poses.figure().joint(joint).rest;
  } else if (drive.target == SpringTarget::kStart) {
    const std::vector<JointIndex>& joints = context_.animation.regions[region].joints;
    const auto i = std::lower_bound(joints.begin(), joints.end(), joint) - joints.begin();
    entry.constant = context_.starts.at(region).angles[i];
  }
  return entry;
}

}  // namespace hazumi
