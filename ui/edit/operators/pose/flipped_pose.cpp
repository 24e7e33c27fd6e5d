#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "engine/figure/pose_mirror.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/euler_angles.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/pose/posing.h"

namespace hazumi::edit {

namespace {

class Flipping {
 public:
  Flipping(const Pose& pose, Session* session)
      : pose_(pose), session_(session), figure_(session->figure()), mirror_(figure_) {}

  Result<Pose> Flip() {
    for (const Named<double>& entry : pose_) {
      const Result<Done> done = Add(entry);
      if (!done.ok()) return done.error();
    }
    return std::move(flipped_);
  }

 private:
  Result<Done> Add(const Named<double>& entry) {
    if (const auto of_root = RootCurveNamed(entry.name)) return AddOfRoot(entry, *of_root);
    const auto hinge = figure_.FindJoint(entry.name);
    if (!hinge) {
      flipped_.push_back(entry);
      return Done();
    }
    const GroupIndex joint = figure_.joint(*hinge).group;
    const auto signs = mirror_.SignsOf(joint);
    if (!signs) return AddWhole(joint);
    const auto place = static_cast<size_t>(hinge->value() - figure_.group(joint).first.value());
    flipped_.push_back({HingesOf(mirror_.sides().OtherSideOf(joint))[place],
                        (*signs)[place] < 0.0 ? -entry.value : entry.value});
    return Done();
  }

  std::vector<std::string> HingesOf(GroupIndex joint) const {
    const JointGroup& group = figure_.group(joint);
    std::vector<std::string> hinges;
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      hinges.push_back(figure_.joints()[j].name);
    }
    return hinges;
  }

  // What was not copied is as it is now.
  Result<double> ValueOf(const std::string& curve) {
    const auto copied = std::find_if(pose_.begin(), pose_.end(),
                                     [&](const auto& entry) { return entry.name == curve; });
    if (copied != pose_.end()) return copied->value;
    return session_->ValueNow(curve);
  }

  // A joint by its rotation, once.
  Result<Done> AddWhole(GroupIndex joint) {
    if (!is_whole_.insert(joint.value()).second) return Done();
    std::vector<double> angles, before;
    for (const std::string& hinge : HingesOf(joint)) {
      const Result<double> angle = ValueOf(hinge);
      if (!angle.ok()) return angle.error();
      angles.push_back(angle.value() * kDegree);
    }
    const std::vector<std::string> others = HingesOf(mirror_.sides().OtherSideOf(joint));
    for (const std::string& hinge : others) {
      const Result<double> angle = session_->ValueNow(hinge);
      if (!angle.ok()) return angle.error();
      before.push_back(angle.value() * kDegree);
    }
    const MirroredJoint mirrored = mirror_.Mirrored(joint, angles, before);
    for (size_t i = 0; i < others.size(); ++i) {
      flipped_.push_back({others[i], WithoutRoundOff(mirrored.angles[i] / kDegree)});
    }
    return Done();
  }

  Result<Done> AddOfRoot(const Named<double>& entry, int curve) {
    if (const auto signs = mirror_.SignsOfRoot()) {
      const double sign = (*signs)[static_cast<size_t>(curve)];
      flipped_.push_back({entry.name, sign < 0.0 ? -entry.value : entry.value});
      return Done();
    }
    if (is_root_done_) return Done();
    is_root_done_ = true;
    return AddWholeRoot();
  }

  Result<Done> AddWholeRoot() {
    std::array<double, kNumRootCurves> values = {};
    for (int i = 0; i < kNumRootCurves; ++i) {
      const Result<double> value = ValueOf(kRootCurveNames[i]);
      if (!value.ok()) return value.error();
      values[static_cast<size_t>(i)] = value.value();
    }
    const Vec3 angles =
        kDegree * Vec3(values[kRootAngleZ], values[kRootAngleY], values[kRootAngleX]);
    const hazumi::Pose X_WR = {EulerRotation({2, 1, 0}, angles),
                               Vec3(values[kRootX], values[kRootY], values[kRootZ])};
    const auto mirrored =
        RootValues(mirror_.Mirrored(X_WR), session_->project().root, session_->frame());
    for (int i = 0; i < kNumRootCurves; ++i) {
      flipped_.push_back({kRootCurveNames[i], mirrored[static_cast<size_t>(i)]});
    }
    return Done();
  }

  const Pose& pose_;
  Session* session_;
  const Figure& figure_;
  PoseMirror mirror_;
  Pose flipped_;
  std::set<int> is_whole_;  // joints that were added by their rotation
  bool is_root_done_ = false;
};

}  // namespace

Result<Pose> Flipped(const Pose& pose, Session* session) { return Flipping(pose, session).Flip(); }

Result<Pose> PoseOfSides(Pose pose, const Parameters& p, Session* session) {
  if (!p.yes("mirror")) return pose;
  const Result<Pose> flipped = Flipped(pose, session);
  if (!flipped.ok()) return flipped.error();
  std::set<std::string> posed;
  for (const Named<double>& angle : pose) posed.insert(angle.name);
  for (const Named<double>& angle : flipped.value()) {
    if (posed.insert(angle.name).second) pose.push_back(angle);
  }
  return pose;
}

}  // namespace hazumi::edit
