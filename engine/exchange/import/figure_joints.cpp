// Limits: of a body's hinges those of the human, and beyond a clip that goes farther; what people
// cannot turn is fixed unless the clip turns it. Of others as far as the clip, and somewhat beyond.
// Strength: the human's, by mass times height.

#include "engine/exchange/import/figure_joints.h"

#include <algorithm>
#include <numbers>

#include "engine/exchange/import/import_names.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr double kMargin = 15.0 * kDegree;        // beyond the clip
constexpr double kUnknown = 45.0 * kDegree;       // about rest, where no clip and no body tells
constexpr double kFree = 4.0 * std::numbers::pi;  // beyond the clip, without limits

class JointMaker {
 public:
  JointMaker(const Skeleton& skeleton, const FigurePlan& plan,
             const std::vector<std::vector<LinkSpec>>& links, const WorldFrame& world,
             ImportLimits limits)
      : skeleton_(skeleton), plan_(plan), links_(links), limits_(limits) {
    double mass = 0.0;
    for (const auto& of_bone : links) {
      for (const LinkSpec& link : of_bone) mass += link.mass.value_or(0.0);
    }
    strength_ = StrengthOf(mass, world.height);
  }

  std::vector<JointSpec> Make(ImportReport* report) const {
    const auto has_place = [](const KeptBone& bone) { return bone.place != BodyPlace(); };
    const bool is_body = std::any_of(skeleton_.bones.begin(), skeleton_.bones.end(), has_place);
    std::vector<JointSpec> joints;
    for (size_t k = 1; k < plan_.joints.size(); ++k) {
      joints.push_back(JointOf(k));
      if (is_body) joints.back().body = skeleton_.bones[k].place;
    }
    for (size_t k = 1; k < plan_.joints.size(); ++k) {
      if (!IsLegWithoutFoot(k)) continue;
      joints.push_back(EndOf(k));
      report->facts.push_back("the leg " + Quoted(plan_.joints[k].name) +
                              " has no foot: it stands on its end");
    }
    return joints;
  }

 private:
  JointSpec JointOf(size_t k) const {
    const PlannedJoint& planned = plan_.joints[k];
    JointSpec joint;
    joint.name = planned.name;
    joint.parent = plan_.joints[planned.parent].name;
    joint.offset = planned.offset;
    joint.orientation = planned.orientation;
    for (int h = 0; h < planned.num_hinges; ++h) joint.hinges.push_back(HingeOf(planned, h));
    joint.links = links_[k];
    return joint;
  }

  static AngleRange RangeOf(const PlannedJoint& joint, int h) {
    AngleRange range = {joint.rest[h], joint.rest[h]};
    if (joint.body && !joint.angles.empty()) range = {joint.angles[0][h], joint.angles[0][h]};
    for (const Vec3& angles : joint.angles) {
      range.low = std::min(range.low, angles[h]);
      range.high = std::max(range.high, angles[h]);
    }
    return range;
  }

  HingeSpec HingeOf(const PlannedJoint& joint, int h) const {
    HingeSpec hinge;
    const AngleRange range = RangeOf(joint, h);
    if (joint.body) {
      hinge = HingeOfBody((*joint.body)[static_cast<size_t>(h)], joint.frame, range, strength_);
    } else {
      hinge.name = joint.HingeName(h).substr(joint.name.size() + 1);
      const double more = plan_.has_clip ? kMargin : kUnknown;
      hinge.axis = Vec3::Unit(joint.axes[h]);
      hinge.lower = range.low - more;
      hinge.upper = range.high + more;
    }
    if (limits_ == ImportLimits::kNone) {
      hinge.lower = range.low - kFree;
      hinge.upper = range.high + kFree;
    }
    hinge.rest = std::clamp(joint.rest[h], hinge.lower, hinge.upper);
    return hinge;
  }

  bool IsLegWithoutFoot(size_t k) const {
    const BodyPlace place = skeleton_.bones[k].place;
    if (place.role != BodyRole::kShin || links_[k].empty()) return false;
    return std::none_of(skeleton_.bones.begin(), skeleton_.bones.end(), [&](const KeptBone& bone) {
      return bone.place == BodyPlace{BodyRole::kFoot, place.side};
    });
  }

  JointSpec EndOf(size_t k) const {
    JointSpec foot;
    foot.name = plan_.joints[k].name + "_foot";
    while (IsTaken(foot.name)) foot.name += "_end";
    foot.parent = plan_.joints[k].name;
    foot.offset = links_[k].front().to;
    foot.body = BodyPlace{BodyRole::kFoot, skeleton_.bones[k].place.side};
    HingeSpec hinge;
    hinge.axis = plan_.joints[k].frame.col(1);
    foot.hinges.push_back(hinge);
    return foot;
  }

  bool IsTaken(const std::string& name) const {
    return std::any_of(plan_.joints.begin(), plan_.joints.end(),
                       [&](const PlannedJoint& joint) { return joint.name == name; });
  }

  const Skeleton& skeleton_;
  const FigurePlan& plan_;
  const std::vector<std::vector<LinkSpec>>& links_;
  ImportLimits limits_;
  double strength_ = 1.0;  // factor of torques
};

}  // namespace

std::vector<JointSpec> JointsOf(const Skeleton& skeleton, const FigurePlan& plan,
                                const std::vector<std::vector<LinkSpec>>& links,
                                const WorldFrame& world, ImportLimits limits,
                                ImportReport* report) {
  return JointMaker(skeleton, plan, links, world, limits).Make(report);
}

}  // namespace hazumi
