#pragma once

// Skeletons as captures have them.

#include <map>
#include <string>
#include <vector>

#include "engine/figure/figure_spec.h"
#include "engine/spatial/pose.h"
#include "tests/support/random.h"

namespace hazumi::test {

// Where a joint is in the root's frame, all angles zero, facing x [m].
struct CaptureBone {
  const char* name;
  const char* parent;
  Vec3 at;
};

inline const std::vector<CaptureBone>& CaptureBones() {
  static const std::vector<CaptureBone> bones = {
      {"Spine", "Hips", {0.0, 0.0, 0.1}},
      {"Neck", "Spine", {-0.02, 0.0, 0.5}},
      {"LHipJoint", "Hips", {0.0, 0.02, -0.02}},
      {"LeftUpLeg", "LHipJoint", {0.0, 0.1, -0.05}},
      {"LeftLeg", "LeftUpLeg", {0.02, 0.1, -0.5}},
      {"LeftFoot", "LeftLeg", {0.0, 0.11, -0.9}},
      {"LeftArm", "Spine", {0.0, 0.18, 0.45}},
      {"LeftForeArm", "LeftArm", {0.0, 0.48, 0.46}},
      {"LeftHand", "LeftForeArm", {0.01, 0.75, 0.45}},
      {"RHipJoint", "Hips", {0.0, -0.02, -0.02}},
      {"RightUpLeg", "RHipJoint", {0.0, -0.1, -0.05}},
      {"RightLeg", "RightUpLeg", {0.02, -0.1, -0.5}},
      {"RightFoot", "RightLeg", {0.0, -0.11, -0.9}},
      {"RightArm", "Spine", {0.0, -0.18, 0.45}},
      {"RightForeArm", "RightArm", {0.0, -0.48, 0.46}},
      {"RightHand", "RightForeArm", {0.01, -0.75, 0.45}}};
  return bones;
}

// A figure of these, all turned: with three hinges z, x, y a joint, which lie along the root's axes
// in every joint, as BVH has it, or, with `random`, along those of each bone's own frame.
inline FigureSpec CaptureSpec(const Mat3& turned = Mat3::Identity(), Random* random = nullptr) {
  FigureSpec spec;
  spec.name = "capture";
  spec.root_name = "Hips";
  LinkSpec rod;
  rod.name = "rod";
  rod.to = Vec3(0.0, 0.0, 0.05);
  rod.radius = 0.02;
  rod.mass = 1.0;
  spec.root_links = {rod};
  std::map<std::string, Pose> zero = {{"Hips", Pose()}};
  for (const CaptureBone& bone : CaptureBones()) {
    const Pose X_RJ = {random ? random->Rotation() : Mat3(Mat3::Identity()), turned * bone.at};
    const Pose X_PJ = zero.at(bone.parent).Inverse() * X_RJ;
    zero[bone.name] = X_RJ;
    JointSpec joint{bone.name, bone.parent, X_PJ.p, X_PJ.R, {}, {rod}};
    for (const auto& [name, axis] :
         {std::pair{"z", Vec3::UnitZ()}, {"x", Vec3::UnitX()}, {"y", Vec3::UnitY()}}) {
      joint.hinges.push_back({name, Vec3(axis), -3.0, 3.0});
    }
    spec.joints.push_back(joint);
  }
  return spec;
}

}  // namespace hazumi::test
