#include "tests/property/random_drives.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/dynamics/kinematics.h"
#include "tests/support/animations.h"

namespace hazumi::test {

bool IsFree(const Animation& animation, JointIndex j) {
  for (const DynamicsRegion& region : animation.regions) {
    const auto at = std::lower_bound(region.joints.begin(), region.joints.end(), j);
    if (at == region.joints.end() || *at != j) continue;
    const double friction = region.friction[static_cast<size_t>(at - region.joints.begin())];
    return friction > 0.0 && !animation.figure->joint(j).is_fixed();
  }
  return false;
}

namespace {

class DriveMaker {
 public:
  DriveMaker(Random* random, Animation* animation)
      : random_(random), animation_(animation), figure_(animation->figure.get()) {}

  void AddDrives(DynamicsRegion* region) {
    const DynamicsRegion before = *region;
    for (const JointGroup& group : figure_->groups()) {
      std::vector<JointIndex> hinges;
      for (int j = group.first.value(); j <= group.last().value(); ++j) {
        const auto& joints = before.joints;
        if (!std::binary_search(joints.begin(), joints.end(), JointIndex(j))) continue;
        if (IsFree(*animation_, JointIndex(j))) hinges.emplace_back(j);
      }
      const double kind = random_->Uniform(0.0, 1.0);
      if (static_cast<int>(hinges.size()) < group.size || kind < 0.2) continue;
      if (kind < 0.5) AddTorques(hinges, region);
      if (kind >= 0.5 && kind < 0.85) AddSpring(hinges, region);
      if (kind >= 0.85) FollowKeys(hinges, region);
    }
  }

 private:
  // Of all that a hinge carries, about its axis [kg m^2].
  double InertiaBeyond(JointIndex hinge) {
    DynamicsWorkspace ws(*figure_);
    ComputePositions(*figure_, Pose(), figure_->RestAngles(), &ws);
    const BodyScratch& at = ws.body(hinge);
    double sum = 0.0;
    for (int j = hinge.value(); j < figure_->joint(hinge).subtree_end.value(); ++j) {
      const RigidInertia& body = figure_->body(JointIndex(j));
      const BodyScratch& its = ws.body(JointIndex(j));
      const Vec3 r = (its.p + its.R * body.com - at.p).cross(at.axis);
      const Vec3 axis = its.R.transpose() * at.axis;
      sum += body.mass * r.squaredNorm() + axis.dot(body.I_com * axis);
    }
    return sum;
  }

  void AddTorques(const std::vector<JointIndex>& hinges, DynamicsRegion* region) {
    for (const JointIndex j : hinges) {
      if (hinges.size() > 1 && random_->Chance(0.2)) continue;  // limp
      const double most = InertiaBeyond(j) * random_->LogUniform(1.0, 100.0);
      constexpr Interpolation kKinds[] = {Interpolation::kCubic, Interpolation::kLinear,
                                          Interpolation::kHold, Interpolation::kSine};
      Drive drive;
      drive.joints = {j};
      for (double frame = 0.0; frame < 30.0; frame += random_->Uniform(4.0, 15.0)) {
        drive.torque.push_back(
            {frame, random_->Uniform(-most, most), {}, kKinds[random_->Integer(0, 3)]});
      }
      region->drives.push_back(std::move(drive));
    }
  }

  void AddSpring(const std::vector<JointIndex>& hinges, DynamicsRegion* region) {
    Drive drive;
    drive.kind = DriveKind::kSpring;
    drive.joints = hinges;
    drive.target = static_cast<SpringTarget>(random_->Integer(0, 2));
    drive.frequency = random_->LogUniform(0.3, 30.0);
    drive.damping_ratio = random_->Uniform(0.0, 2.0);
    drive.feed_forward = drive.target == SpringTarget::kKeys && random_->Chance(0.3);
    if (random_->Chance(0.25)) drive.frequency_keys = CurveOf(0.3, 30.0);
    const Joint& hinge = figure_->joint(hinges.front());
    if (hinge.strength && random_->Chance(0.5)) {
      drive.strength = random_->Uniform(0.02, 1.0);
      if (random_->Chance(0.4)) drive.strength_keys = CurveOf(0.02, 1.0);
    } else if (random_->Chance(0.5)) {
      drive.max_torque = InertiaBeyond(hinges.front()) * random_->LogUniform(3.0, 300.0);
    }
    if (drive.target == SpringTarget::kKeys) KeyOnwards(hinges);
    region->drives.push_back(std::move(drive));
  }

  // Stays between its keys, as all of their tangents are automatic.
  Keys CurveOf(double least, double most) {
    Keys keys;
    for (const double frame : {0.0, 12.0, 30.0}) {
      keys.push_back({frame,
                      random_->LogUniform(least, most),
                      {},
                      random_->Chance(0.5) ? Interpolation::kCubic : Interpolation::kLinear});
    }
    return keys;
  }

  void FollowKeys(const std::vector<JointIndex>& hinges, DynamicsRegion* region) {
    if (region->joints.size() == hinges.size()) return;  // the region would move nothing
    KeyOnwards(hinges);
    for (const JointIndex j : hinges) {
      const auto at = std::lower_bound(region->joints.begin(), region->joints.end(), j);
      region->friction.erase(region->friction.begin() + (at - region->joints.begin()));
      region->joints.erase(at);
      region->keyed.push_back(j);
    }
  }

  void KeyOnwards(const std::vector<JointIndex>& hinges) {
    for (const JointIndex j : hinges) {
      const Joint& joint = figure_->joint(j);
      Keys& keys = animation_->joint_keys[j.value()];
      keys.resize(1);
      keys[0].rate = random_->Uniform(-3.0, 3.0);
      for (const double frame : {9.0, 20.5, 30.0}) {
        const double value = keys[0].value + random_->Uniform(-0.5, 0.5);
        keys.push_back({frame, std::clamp(value, joint.lower, joint.upper), {}, kCubic});
      }
    }
  }

  Random* random_;
  Animation* animation_;
  const Figure* figure_;
};

}  // namespace

void AddRandomDrives(Random* random, Animation* animation) {
  DriveMaker maker(random, animation);
  for (DynamicsRegion& region : animation->regions) maker.AddDrives(&region);
}

}  // namespace hazumi::test
