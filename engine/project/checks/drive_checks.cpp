#include <algorithm>
#include <map>

#include "engine/base/text.h"
#include "engine/project/checks/animation_checks.h"
#include "engine/project/checks/document_checks.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/fields/curve_fields.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

void CheckDriveNames(const ProjectRegion& region, const Figure& figure, const Site& region_site) {
  const std::vector<bool> in_region = JointsOf(region, figure);
  std::map<int, size_t> driver;  // by joint
  for (size_t d = 0; d < region.drives.size(); ++d) {
    const Site joints = region_site.Field("drives").Item(d).Field("joints");
    for (size_t i = 0; i < region.drives[d].joints.size(); ++i) {
      const JointRef ref = Meant(region.drives[d].joints[i], figure);
      const Site place = joints.Item(i);
      const bool is_root = MeansRoot(ref.name, figure);
      // References beyond the root mean all joints; the root itself has no muscles.
      if (is_root && !ref.beyond) return place.Report(Check::kDriveOnRoot, {Quoted(ref.name)});
      if (!is_root && !ExpectJoint(ref.name, figure, place)) return;
      const std::vector<bool> meant = JointsOf({ref}, figure);
      bool any = false;
      for (size_t j = 0; j < meant.size(); ++j) {
        if (!meant[j] || !in_region[j]) continue;
        any = true;
        const auto [other, is_first] = driver.try_emplace(static_cast<int>(j), d);
        if (is_first || other->second == d) continue;
        return place.Report(Check::kDrivenTwice, {Quoted(figure.joints()[j].name),
                                                  "drives[" + std::to_string(other->second) + "]"});
      }
      if (!any) return place.Report(Check::kDriveNotInRegion, {Quoted(ref.name)});
    }
  }
}

namespace {

void CheckStaysWithin(const ProjectCurve& curve, FrameRate rate, const NumberRange& allowed,
                      const Site& site) {
  constexpr double kRounding = 1e-9;
  if (curve.keys.empty()) return;
  const CurveRange range = RangeOf(ToKeys(curve, 1.0), rate);
  const bool is_low = range.least < allowed.lower - kRounding;
  if (!is_low && range.greatest <= allowed.upper + kRounding) return;
  site.Report(Check::kDriveCurveOutside,
              {FormatShort(is_low ? range.least : range.greatest),
               FormatShort(is_low ? range.frame_of_least : range.frame_of_greatest),
               NumberText(allowed.lower), NumberText(allowed.upper)});
}

}  // namespace

void CheckDriveCurves(const ProjectDrive& drive, const ProjectRate& rate, const Site& site) {
  if (!site.errors->ok()) return;  // the rate may be none
  const FrameRate frames = {rate.num, rate.den};
  CheckStaysWithin(drive.frequency_over_time, frames, kFrequencyRange,
                   site.Field("frequency_keys"));
  CheckStaysWithin(drive.strength_over_time, frames, kStrengthRange, site.Field("strength_keys"));
}

void CheckDrives(const Animation& animation, size_t region, FirstError* errors) {
  const DynamicsRegion& own = animation.regions[region];
  const Figure& figure = *animation.figure;
  const std::string place = At("regions", region) + ".drives";
  for (const Drive& drive : own.drives) {
    const bool is_known = std::any_of(drive.joints.begin(), drive.joints.end(), [&](JointIndex j) {
      return figure.joint(j).strength.has_value();
    });
    if (IsByStrength(drive) && !is_known) {
      return errors->Report(Check::kDriveWithoutStrength, place,
                            {Quoted(figure.joint(drive.joints.front()).name)});
    }
    for (const JointIndex j : drive.joints) {
      const auto at = std::lower_bound(own.joints.begin(), own.joints.end(), j);
      if (own.friction[static_cast<size_t>(at - own.joints.begin())] == 0.0) {
        return errors->Report(Check::kDriveFrozen, place, {Quoted(figure.joint(j).name)});
      }
      if (drive.kind != DriveKind::kSpring) continue;
      const JointGroup& group = figure.group(figure.joint(j).group);
      const auto has = [](const std::vector<JointIndex>& joints, int hinge) {
        return std::binary_search(joints.begin(), joints.end(), JointIndex(hinge));
      };
      int free = 0, driven = 0;
      for (int hinge = group.first.value(); hinge <= group.last().value(); ++hinge) {
        free += has(own.joints, hinge);
        driven += has(drive.joints, hinge);
      }
      if (free == 3 && driven < 3) {
        return errors->Report(Check::kDriveSplitsBall, place,
                              {Quoted(figure.joint(j).name), Quoted(group.name)});
      }
    }
  }
}

}  // namespace hazumi
