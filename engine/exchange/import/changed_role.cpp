// B are a bone's axes in the root's frame at rest, S its body axes there (body_axes.h), and p its
// parent. As at import (joint_plan.cpp):
//   A = B^T S,   orientation = A_p A^T,   E = A_p^T R A,
// with R the joint's turn in its parent's frame, which stays. A joint that has hinges of a body
// tells its A by their axes. With a key's rates r of the old hinges at angles q, the new rates are
//   (a(q + h r) - a(q - h r)) / 2 h,   a(q) the new angles.

#include "engine/exchange/import/changed_role.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "engine/base/text.h"
#include "engine/body/body_axes.h"
#include "engine/body/figure_body.h"
#include "engine/exchange/import/body_hinges.h"
#include "engine/exchange/import/import_names.h"
#include "engine/figure/figure_builder.h"
#include "engine/figure/sides.h"
#include "engine/project/compile.h"
#include "engine/project/edits/entries.h"
#include "engine/project/figure_editor.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/euler_angles.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

namespace {

constexpr double kStep = 1e-5;      // [s], of differences
constexpr double kSameRate = 1e-6;  // [rad/s]

using HingeAngles = std::array<double, 3>;

// The turn of a joint in its parent's frame, by its hinges as they are written.
Mat3 TurnOf(const JointSpec& joint, const HingeAngles& q) {
  Eigen::Quaterniond turn(joint.orientation);
  for (size_t h = 0; h < joint.hinges.size(); ++h) {
    turn = turn * Eigen::AngleAxisd(q[h], joint.hinges[h].axis.normalized());
  }
  return turn.toRotationMatrix();
}

// How a joint's turn becomes the angles of the hinges of a body.
struct BodyTurn {
  Mat3 A_p = Mat3::Identity(), A = Mat3::Identity();
  BodyHinges hinges;

  Vec3 AnglesNear(const Mat3& R, const Vec3& previous) const {
    EulerAxes axes = {};
    Vec3 signs;
    for (size_t h = 0; h < 3; ++h) {
      axes[h] = hinges[h].axis;
      signs[static_cast<Eigen::Index>(h)] = hinges[h].sign;
    }
    const Vec3 near = signs.cwiseProduct(previous);
    return signs.cwiseProduct(EulerAnglesNear(A_p.transpose() * R * A, axes, near));
  }
};

class RoleChange {
 public:
  RoleChange(const Figure& figure, GroupIndex joint, BodyPlace place, Project* project)
      : figure_(figure), body_(figure), joint_(joint), project_(*project) {
    for (size_t g = 0; g < figure.groups().size(); ++g) {
      const GroupIndex group(static_cast<int>(g));
      places_.push_back(body_.PlaceOf(group));
      if (IsSingle(place.role) && places_.back() == place) places_.back() = BodyPlace();
    }
    places_[static_cast<size_t>(joint.value())] = place;
    FindAxes();
  }

  Result<Done> Make() {
    for (size_t g = 0; g < places_.size(); ++g) {
      JointSpec& spec = changed_.emplace_back(SpecOf(g));
      spec.body = places_[g];
      const bool hangs_on_it = ParentOf(g) == static_cast<size_t>(joint_.value()) + 1;
      if (g != static_cast<size_t>(joint_.value()) && !(hangs_on_it && HasBodyHinges(g))) continue;
      if (body_.HasFourLegs()) continue;  // whose hinges are their file's
      if (auto hinges = BodyHingesOf(places_[g], PartOfRow(places_, g))) Turn(g, *hinges, &spec);
    }
    return ReplaceHinges(changed_, &project_.figure);
  }

 private:
  const JointSpec& SpecOf(size_t g) const {
    const std::string& name = figure_.groups()[g].name;
    return *std::find_if(project_.figure.spec.joints.begin(), project_.figure.spec.joints.end(),
                         [&](const JointSpec& joint) { return joint.name == name; });
  }

  // The body that a joint hangs on, as an index of a joint plus one; 0: the root.
  size_t ParentOf(size_t g) const {
    const JointIndex parent = figure_.joint(figure_.groups()[g].first).parent;
    return parent.is_valid() ? static_cast<size_t>(figure_.joint(parent).group.value()) + 1 : 0;
  }

  // Whether its hinges are those that the part of a body has that it was so far.
  bool HasBodyHinges(size_t g) const {
    const auto hinges = BodyHingesOf(body_.PlaceOf(GroupIndex(static_cast<int>(g))), {});
    const JointSpec& spec = SpecOf(g);
    if (!hinges || spec.hinges.size() != 3) return false;
    for (size_t h = 0; h < 3; ++h) {
      if (spec.hinges[h].name != (*hinges)[h].name) return false;
    }
    return true;
  }

  // Finds the axes of all bodies, the root's first.
  void FindAxes() {
    std::vector<RestBone> bones(1);
    bones[0].place = {BodyRole::kHips, BodySide::kMiddle};
    for (size_t g = 0; g < places_.size(); ++g) {
      const JointSpec& spec = SpecOf(g);
      HingeAngles rest = {};
      for (size_t h = 0; h < spec.hinges.size(); ++h) rest[h] = spec.hinges[h].rest;
      RestBone bone = {places_[g], static_cast<int>(ParentOf(g)), {}, {}};
      bone.X_R = bones[ParentOf(g)].X_R * Pose{TurnOf(spec, rest), spec.offset};
      if (!spec.links.empty()) bone.end = bone.X_R * spec.links.front().to;
      bones.push_back(bone);
    }
    const std::vector<Mat3> S = BodyAxesOf(bones);
    for (size_t b = 0; b < bones.size(); ++b) A_.push_back(bones[b].X_R.R.transpose() * S[b]);
    for (size_t g = 0; g < places_.size(); ++g) {
      if (GroupIndex(static_cast<int>(g)) != joint_ && HasBodyHinges(g)) A_[g + 1] = WrittenAxes(g);
    }
    for (const RestBone& bone : bones) height_ = std::max(height_, bone.X_R.p.z());
    height_ += StandingHeight(figure_);
  }

  Mat3 WrittenAxes(size_t g) const {
    const BodyHinges hinges = *BodyHingesOf(body_.PlaceOf(GroupIndex(static_cast<int>(g))), {});
    Mat3 A;
    for (size_t h = 0; h < 3; ++h) {
      A.col(hinges[h].axis) = hinges[h].sign * SpecOf(g).hinges[h].axis.normalized();
    }
    return A;
  }

  // Gives the joint these hinges, with the limits that its keys need.
  void Turn(size_t g, const BodyHinges& hinges, JointSpec* spec) {
    const JointSpec before = SpecOf(g);
    const BodyTurn turn = {A_[ParentOf(g)], A_[g + 1], hinges};
    HingeAngles rest = {};
    for (size_t h = 0; h < before.hinges.size(); ++h) rest[h] = before.hinges[h].rest;
    const Vec3 new_rest = turn.AnglesNear(TurnOf(before, rest), Vec3::Zero());
    const std::array<ProjectCurve, 3> curves = CurvesOf(before, turn, new_rest);
    spec->orientation = turn.A_p * turn.A.transpose();
    spec->hinges.clear();
    for (size_t h = 0; h < 3; ++h) {
      AngleRange range = {new_rest[static_cast<Eigen::Index>(h)],
                          new_rest[static_cast<Eigen::Index>(h)]};
      if (!curves[h].keys.empty()) {
        const auto [low, high] = std::minmax_element(
            curves[h].keys.begin(), curves[h].keys.end(),
            [](const ProjectKey& a, const ProjectKey& b) { return a.value < b.value; });
        range = {low->value * kDegree, high->value * kDegree};
      }
      HingeSpec hinge =
          HingeOfBody(hinges[h], turn.A, range, StrengthOf(figure_.total_mass(), height_));
      hinge.rest = std::clamp(new_rest[static_cast<Eigen::Index>(h)], hinge.lower, hinge.upper);
      spec->hinges.push_back(std::move(hinge));
    }
    ReplaceCurves(before, *spec, curves);
  }

  void ReplaceCurves(const JointSpec& before, const JointSpec& after,
                     const std::array<ProjectCurve, 3>& curves) {
    std::erase_if(project_.joints, [&](const Named<ProjectCurve>& curve) {
      return std::any_of(before.hinges.begin(), before.hinges.end(), [&](const HingeSpec& hinge) {
        return before.NameOf(hinge) == curve.name;
      });
    });
    for (size_t h = 0; h < 3; ++h) {
      if (curves[h].keys.empty()) continue;
      project_.joints.push_back({after.NameOf(after.hinges[h]), curves[h]});
    }
  }

  const ProjectCurve* CurveNamed(const std::string& hinge) const {
    for (const Named<ProjectCurve>& curve : project_.joints) {
      if (curve.name == hinge) return &curve.value;
    }
    return nullptr;
  }

  // Keys of the new hinges wherever an old one has a key.
  std::array<ProjectCurve, 3> CurvesOf(const JointSpec& before, const BodyTurn& turn,
                                       Vec3 previous) const {
    const FrameRate rate = {project_.fps.num, project_.fps.den};
    std::vector<Keys> keys(before.hinges.size());
    std::map<double, ProjectKey> frames;  // with the kind of a key that is there
    for (size_t h = 0; h < keys.size(); ++h) {
      const ProjectCurve* curve = CurveNamed(before.NameOf(before.hinges[h]));
      if (!curve) continue;
      keys[h] = ToKeys(*curve, kDegree);
      for (const ProjectKey& key : curve->keys) frames.try_emplace(key.frame, key);
    }
    std::vector<CurveTrack> tracks;
    for (size_t h = 0; h < keys.size(); ++h) {
      tracks.emplace_back(&keys[h], rate, before.hinges[h].rest, std::vector<double>());
    }
    std::array<ProjectCurve, 3> curves;
    for (const auto& [frame, like] : frames) {
      HingeAngles q = {}, arriving = {}, leaving = {};
      for (size_t h = 0; h < tracks.size(); ++h) {
        const CurveSample sample = tracks[h].At(frame);
        q[h] = sample.value;
        leaving[h] = sample.rate;
        arriving[h] = tracks[h].Before(frame).rate;
      }
      previous = turn.AnglesNear(TurnOf(before, q), previous);
      const Vec3 in = RateOf(before, turn, q, arriving, previous);
      const Vec3 out = RateOf(before, turn, q, leaving, previous);
      for (Eigen::Index h = 0; h < 3; ++h) {
        ProjectKey key;
        key.frame = frame;
        key.value = previous[h] / kDegree;
        key.interpolation = like.interpolation;
        key.easing = like.easing;
        key.type = like.type;
        if (frames.size() > 1) key.rate = out[h] / kDegree;
        if (frames.size() > 1 && std::abs(in[h] - out[h]) > kSameRate) {
          key.rate_in = in[h] / kDegree;
        }
        curves[static_cast<size_t>(h)].keys.push_back(key);
      }
    }
    return curves;
  }

  static Vec3 RateOf(const JointSpec& before, const BodyTurn& turn, const HingeAngles& q,
                     const HingeAngles& rates, const Vec3& near) {
    HingeAngles earlier = q, later = q;
    for (size_t h = 0; h < 3; ++h) {
      earlier[h] -= kStep * rates[h];
      later[h] += kStep * rates[h];
    }
    return (turn.AnglesNear(TurnOf(before, later), near) -
            turn.AnglesNear(TurnOf(before, earlier), near)) /
           (2.0 * kStep);
  }

  const Figure& figure_;
  const FigureBody body_;
  const GroupIndex joint_;
  Project& project_;
  std::vector<BodyPlace> places_;  // by joint
  std::vector<Mat3> A_;            // by body, the root's first
  std::vector<JointSpec> changed_;
  double height_ = 0.0;  // [m]
};

}  // namespace

Result<Done> ChangeRole(const std::string& joint, BodyPlace place, Project* project) {
  if (project->figure.spec.mirror) {
    return Refusal("joint",
                   "the figure's one side is written as the mirror image of the other: "
                   "its joints' names tell their roles");
  }
  if (NeedsSide(place.role) && place.side == BodySide::kMiddle) {
    return Refusal("side", "a " + std::string(NameOf(place.role)) + " is left or right: say which");
  }
  if (!MayHaveSide(place.role)) place.side = BodySide::kMiddle;
  const Result<Figure> figure = BuildFigure(project->figure.spec);
  if (!figure.ok()) return figure.error();
  const std::optional<GroupIndex> group = figure.value().FindGroup(joint);
  if (!group) return Refusal("joint", "the figure has no joint " + Quoted(joint));
  Project changed = *project;
  Result<Done> done = RoleChange(figure.value(), *group, place, &changed).Make();
  if (!done.ok()) return done;
  if (const Result<Compiled> compiled = CompileAnimation(changed); !compiled.ok()) {
    return compiled.error();
  }
  *project = std::move(changed);
  return done;
}

}  // namespace hazumi
