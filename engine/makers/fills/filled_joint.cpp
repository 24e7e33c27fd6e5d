#include "engine/makers/fills/filled_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/base/text.h"
#include "engine/makers/fills/generated_keys.h"
#include "engine/matrix/eigen_system.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/solve/turn_vector.h"
#include "engine/timeline/curve_track.h"

namespace hazumi::makers {

namespace {

using solve::RotationBy;
using solve::TurnAxis;
using solve::TurnVector;

void AddHinges(GroupIndex group, const Animation& animation, FilledJoint* joint) {
  const Figure& figure = *animation.figure;
  const JointGroup& all = figure.group(group);
  Mat3 to_hinge = Mat3::Identity();
  for (int j = all.first.value(); j <= all.last().value(); ++j) {
    const Joint& hinge = figure.joint(JointIndex(j));
    to_hinge = to_hinge * hinge.X_PJ.R;
    joint->row.push_back({to_hinge * hinge.axis, hinge.is_fixed()});
    joint->curves.push_back(hinge.name);
    joint->keys_of.push_back(&animation.joint_keys[static_cast<size_t>(j)]);
    joint->rest.push_back(hinge.rest);
    joint->lower.push_back(hinge.lower);
    joint->upper.push_back(hinge.upper);
  }
  joint->behind = to_hinge;
}

void AddRootAngles(const Animation& animation, FilledJoint* joint) {
  for (int i = 0; i < 3; ++i) {
    const int curve = kRootAngleZ + i;
    joint->row.push_back({Vec3::Unit(2 - i), false});
    joint->curves.push_back(kRootCurveNames[curve]);
    joint->keys_of.push_back(&animation.root_keys[curve]);
    joint->rest.push_back(0.0);
    joint->lower.push_back(-std::numeric_limits<double>::infinity());
    joint->upper.push_back(std::numeric_limits<double>::infinity());
  }
}

bool IsConstant(const Keys& keys) {
  return std::all_of(keys.begin(), keys.end(), [&](const Key& key) {
    return key.value == keys.front().value && !key.rate && !key.rate_in;
  });
}
// Axis of hinge i as seen behind the row, its fixed hinges where they are.
Vec3 AxisBehind(const FilledJoint& joint, size_t i) {
  Mat3 after = Mat3::Identity();
  for (size_t k = i + 1; k < joint.row.size(); ++k) {
    if (joint.row[k].is_fixed) after = after * RotationBy(joint.rest[k] * joint.row[k].axis);
  }
  return (after * joint.behind).transpose() * joint.row[i].axis;
}
// Axis of hinge i as seen before the row.
Vec3 AxisBefore(const FilledJoint& joint, size_t i) {
  Mat3 before = Mat3::Identity();
  for (size_t k = 0; k < i; ++k) {
    if (joint.row[k].is_fixed) before = before * RotationBy(joint.rest[k] * joint.row[k].axis);
  }
  return before * joint.row[i].axis;
}

std::vector<TurnAxis> AxesOfHinges(const FilledJoint& joint) {
  std::vector<size_t> movable;
  for (size_t i = 0; i < joint.row.size(); ++i) {
    if (!joint.row[i].is_fixed) movable.push_back(i);
  }
  if (movable.empty()) return {};
  if (movable.size() == 1) return {{AxisBehind(joint, movable[0]), false}};
  if (movable.size() == 2) {
    return {{AxisBefore(joint, movable[0]), true}, {AxisBehind(joint, movable[1]), false}};
  }
  return {{Vec3::UnitX(), false}, {Vec3::UnitY(), false}, {Vec3::UnitZ(), false}};
}

// Rates that keys of the joint state on a frame, where the motion arrives as it leaves. A hinge's
// rate is the part of the joint's velocity along the dual of its axis.
void AddRates(const FilledJoint& joint, int frame, const std::vector<double>& angles,
              const Mat3& turn, std::vector<solve::GivenRate>* rates) {
  const size_t n = joint.row.size();
  for (size_t i = 0; i < n; ++i) {
    const auto key = std::lower_bound(joint.keys_of[i]->begin(), joint.keys_of[i]->end(), frame,
                                      [](const Key& k, int f) { return k.frame < f; });
    if (key == joint.keys_of[i]->end() || key->frame != frame) continue;
    if (!key->rate || joint.row[i].is_fixed) continue;
    if (key->rate_in && *key->rate_in != *key->rate) continue;
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3> axes(3, n);
    Mat3 before = Mat3::Identity();
    for (size_t k = 0; k < n; ++k) {
      axes.col(static_cast<Eigen::Index>(k)) = turn.transpose() * (before * joint.row[k].axis);
      before = before * RotationBy(angles[k] * joint.row[k].axis);
    }
    const MatX gram = axes.transpose() * axes;
    constexpr double kPole = 1e-3;  // nearer to one the hinges' rates are not the joint's
    const EigenSystem system = EigenSystemOf(gram);
    if (system.values[0] < kPole) continue;
    VecX unit = VecX::Zero(static_cast<Eigen::Index>(n));
    unit[static_cast<Eigen::Index>(i)] = 1.0;
    const VecX weights = system.vectors * (system.values.cwiseInverse().asDiagonal() *
                                           (system.vectors.transpose() * unit));
    rates->push_back({frame - joint.first + 1, 0, axes * weights, *key->rate});
  }
}

// Keeps a ball joint on one axis if its keys turn it about that axis alone, and still if its keys
// are equal.
void StayOnOneAxis(const FilledJoint& joint, JointTurns* found) {
  std::vector<Mat3>& turns = found->turns;
  const int first = joint.first - 1;
  const Mat3 from = turns[1];
  Mat3 spread = Mat3::Zero();
  for (size_t t = 1; t + 1 < turns.size(); ++t) {
    if (!joint.IsKeyed(first + static_cast<int>(t))) continue;
    const Vec3 v = TurnVector(from.transpose() * turns[t]);
    spread += v * v.transpose();
  }
  const EigenSystem system = EigenSystemOf(spread);
  constexpr double kNothing = 1e-12, kAside = 1e-4;  // [rad^2], and of the largest
  const bool stays = system.values[2] < kNothing;
  if (!stays && system.values[1] >= kAside * system.values[2] + kNothing) return;
  const Vec3 axis = system.vectors.col(2);
  found->axes.clear();
  if (!stays) found->axes.push_back({axis, false});
  for (size_t t = 0; t < turns.size(); ++t) {
    if (joint.IsKnown(first + static_cast<int>(t))) continue;
    const double angle = stays ? 0.0 : axis.dot(TurnVector(from.transpose() * turns[t]));
    turns[t] = from * RotationBy(angle * axis);
  }
}

}  // namespace

std::vector<double> SampleCurve(const Keys& keys, double rest, int first, int last,
                                FrameRate rate) {
  CurveTrack track(&keys, rate, rest, {});
  std::vector<double> values;
  for (int f = first; f <= last; ++f) values.push_back(track.At(f).value);
  return values;
}

Result<std::optional<FilledJoint>> FilledJointOf(std::optional<GroupIndex> group,
                                                 const ProjectFill& fill,
                                                 const Animation& animation) {
  FilledJoint joint;
  joint.group = group;
  if (group) {
    AddHinges(*group, animation, &joint);
  } else {
    AddRootAngles(animation, &joint);
  }
  const int begin = std::max(fill.first_frame, animation.first_frame);
  const int end = std::min(fill.last_frame, animation.last_frame);
  joint.first = begin;
  joint.last = end;
  joint.has_steps.assign(joint.row.size(), 0);
  std::set<int> frames;
  bool any = false;
  for (size_t i = 0; i < joint.row.size(); ++i) {
    std::set<int> own;
    for (const Key& key : *joint.keys_of[i]) {
      joint.lower[i] = std::min(joint.lower[i], key.value);
      joint.upper[i] = std::max(joint.upper[i], key.value);
      if (key.frame < begin || key.frame > end) continue;
      if (key.frame != std::round(key.frame)) {
        return Refusal("", "the key of \"" + joint.curves[i] + "\" at frame " +
                               FormatShort(key.frame) +
                               " lies between frames, where fills have none; move it onto one");
      }
      own.insert(static_cast<int>(key.frame));
    }
    if (joint.row[i].is_fixed || joint.keys_of[i]->empty() || IsConstant(*joint.keys_of[i])) {
      frames.merge(own);
      continue;
    }
    if (own.size() < 2) return std::optional<FilledJoint>();
    joint.first = std::max(joint.first, *own.begin());
    joint.last = std::min(joint.last, *own.rbegin());
    frames.merge(own);
    any = true;
  }
  if (!any || joint.first >= joint.last) return std::optional<FilledJoint>();
  std::erase_if(frames, [&](int f) { return f < joint.first || f > joint.last; });
  joint.is_known.assign(joint.last - joint.first + 1, 0);
  for (const int frame : frames) joint.is_known[static_cast<size_t>(frame - joint.first)] = 1;
  joint.is_free_before = joint.is_free_after = fill.ends == FillEnds::kFree;
  joint.is_known.front() = joint.is_known.back() = 1;
  for (size_t i = 0; i < joint.keys_of.size(); ++i) {
    const Keys* keys = joint.keys_of[i];
    for (size_t k = 0; k < keys->size(); ++k) {
      const Key& key = (*keys)[k];
      joint.is_free_before &= key.frame > joint.first || (key.frame == joint.first && !key.rate);
      joint.is_free_after &= key.frame < joint.last || (key.frame == joint.last && !key.rate);
      if (k + 1 == keys->size() || MayBeFilled(key.interpolation)) continue;
      const int from = std::max(joint.first, static_cast<int>(std::ceil(key.frame)));
      const int to = std::min(joint.last, static_cast<int>(std::floor((*keys)[k + 1].frame)));
      if (from < to) joint.has_steps[i] = 1;
      for (int f = from; f <= to; ++f) joint.is_known[static_cast<size_t>(f - joint.first)] = 1;
    }
  }
  return std::optional(std::move(joint));
}

std::vector<double> SampleAround(const Keys& keys, double rest, int first, int last,
                                 FrameRate rate) {
  std::vector<double> values = SampleCurve(keys, rest, first - 1, last + 1, rate);
  const double step = rate.seconds_per_frame();
  for (const Key& key : keys) {
    if (key.frame == first && &key == &keys.front() && key.rate) {
      values.front() = key.value - step * *key.rate;
    }
    if (key.frame == last && &key == &keys.back() && (key.rate_in || key.rate)) {
      values.back() = key.value + step * key.rate_in.value_or(key.rate.value_or(0.0));
    }
  }
  return values;
}

JointTurns TurnsOfCurves(const FilledJoint& joint, FrameRate rate) {
  std::vector<std::vector<double>> values;
  for (size_t i = 0; i < joint.row.size(); ++i) {
    values.push_back(SampleAround(*joint.keys_of[i], joint.rest[i], joint.first, joint.last, rate));
  }
  JointTurns found;
  found.axes = AxesOfHinges(joint);
  std::vector<double> angles(joint.row.size());
  for (size_t t = 0; t < values[0].size(); ++t) {
    const int frame = joint.first - 1 + static_cast<int>(t);
    for (size_t i = 0; i < angles.size(); ++i) angles[i] = values[i][t];
    const auto stopped = joint.at_limit.find(frame);
    found.turns.push_back(joint.TurnOf(stopped == joint.at_limit.end() ? angles : stopped->second));
    if (frame > joint.first && frame < joint.last) {
      AddRates(joint, frame, angles, found.turns.back(), &found.rates);
    }
  }
  if (found.axes.size() == 3) StayOnOneAxis(joint, &found);
  // Rates across the only axis are dropped, and all rates of a joint that stays still.
  std::erase_if(found.rates, [&](const solve::GivenRate& given) {
    if (found.axes.size() > 1) return false;
    return found.axes.empty() || std::abs(found.axes[0].axis.dot(given.along.normalized())) < 0.99;
  });
  return found;
}

}  // namespace hazumi::makers
