#include "engine/makers/fills/joint_angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/solve/turn_vector.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

using solve::RotationBy;
using solve::TurnVector;

constexpr double kSameTurn = 1e-6;   // [rad]
constexpr double kSameAngle = 1e-3;  // [rad]

// Three hinges at right angles have two triples of angles for a rotation.
bool IsWithinLimitsByOtherAngles(const FilledJoint& joint, const std::vector<double>& angles) {
  if (angles.size() != 3) return false;
  constexpr double kHalfTurn = 180.0 * kDegree;
  std::vector<double> other = {angles[0] + kHalfTurn, kHalfTurn - angles[1], angles[2] + kHalfTurn};
  const Mat3 turn = RotationOf(joint.row, angles);
  if (TurnTo(turn, joint.row, &other) > kSameTurn) return false;
  for (size_t i = 0; i < 3; ++i) {
    if (std::isfinite(joint.lower[i])) {
      other[i] = NearestTurn(other[i], 0.5 * (joint.lower[i] + joint.upper[i]));
    }
  }
  return joint.IsWithinLimits(other);
}

// Angles between two frames at which they are known. From the first on each triple is near the one
// before. Where that leads to another triple than that of the last frame, the angles change to
// those that lead back from there, between the two frames where half of the change is off least:
// near a pole of the joint.
std::optional<JointAngles> AnglesBetween(const FilledJoint& joint, int first,
                                         const std::vector<Mat3>& turns,
                                         const std::vector<double>& from,
                                         const std::vector<double>& to) {
  // Half of a change to the other triple is off by less, half of a whole turn by more [rad].
  constexpr double kMostOff = 2.0;
  constexpr double kNotSeen = 0.02;  // half of a change that needs no keys of its own [rad]
  using Angles = std::vector<double>;
  const size_t n = turns.size();
  const auto next = [&](size_t t, Angles near) {
    TurnTo(turns[t] * joint.behind.transpose(), joint.row, &near);
    return near;
  };
  std::vector<Angles> onward = {from};
  for (size_t t = 1; t < n; ++t) onward.push_back(next(t, onward.back()));
  const auto is_same = [&](const Angles& a, const Angles& b) {
    for (size_t i = 0; i < a.size(); ++i) {
      if (std::abs(a[i] - b[i]) > kSameAngle) return false;
    }
    return true;
  };
  if (is_same(onward.back(), to)) {
    onward.back() = to;
    return JointAngles{onward, {}};
  }
  std::vector<Angles> back(n);
  back[n - 1] = to;
  for (size_t t = n - 1; t-- > 0;) back[t] = next(t, back[t + 1]);
  size_t best = n;
  double least = kMostOff;
  for (size_t t = 0; t + 1 < n; ++t) {
    Angles middle = onward[t];
    for (size_t i = 0; i < middle.size(); ++i) middle[i] = 0.5 * (middle[i] + back[t + 1][i]);
    const Vec3 half = 0.5 * TurnVector(turns[t].transpose() * turns[t + 1]);
    const Mat3 expected = turns[t] * RotationBy(half);
    const double off = TurnVector(expected.transpose() * joint.TurnOf(middle)).norm();
    if (!(off < least)) continue;
    least = off;
    best = t;
  }
  if (best == n) return std::nullopt;
  JointAngles found;
  if (least > kNotSeen) {
    TripleChange change;
    change.frame = first + static_cast<int>(best);
    const Mat3 middle =
        turns[best] * RotationBy(0.5 * TurnVector(turns[best].transpose() * turns[best + 1]));
    const Mat3 in_row = middle * joint.behind.transpose();
    change.before = onward[best];
    change.after = back[best + 1];
    TurnTo(in_row, joint.row, &change.before);
    TurnTo(in_row, joint.row, &change.after);
    for (size_t i = 0; i < from.size(); ++i) {
      change.rate_before.push_back(2.0 * (change.before[i] - onward[best][i]));
      change.rate_after.push_back(2.0 * (back[best + 1][i] - change.after[i]));
    }
    found.changes.push_back(std::move(change));
  }
  std::copy(onward.begin(), onward.begin() + static_cast<long>(best) + 1, back.begin());
  found.by_frame = std::move(back);
  return found;
}

}  // namespace

bool StopAtLimits(FilledJoint* joint, std::vector<std::vector<double>>* angles) {
  constexpr double kOff = 1e-3;  // how far a turn may be off before it counts as stopped [rad]
  bool any = false;
  for (size_t t = 0; t < angles->size(); ++t) {
    const int frame = joint->first + static_cast<int>(t);
    std::vector<double>& now = (*angles)[t];
    if (joint->IsKnown(frame) || joint->IsWithinLimits(now)) continue;
    if (IsWithinLimitsByOtherAngles(*joint, now)) continue;
    const Mat3 turn = RotationOf(joint->row, now);
    HingeRow row = joint->row;
    double left = 0.0;
    // Hinges that reach a limit stay on it, and the others turn as far as they can.
    for (size_t round = 0; round < row.size() && !joint->IsWithinLimits(now); ++round) {
      for (size_t i = 0; i < row.size(); ++i) {
        const double within = std::clamp(now[i], joint->lower[i], joint->upper[i]);
        row[i].is_fixed |= within != now[i];
        now[i] = within;
      }
      left = TurnTo(turn, row, &now);
    }
    for (size_t i = 0; i < row.size(); ++i) {
      now[i] = std::clamp(now[i], joint->lower[i], joint->upper[i]);
    }
    if (left < kOff) continue;
    joint->at_limit[frame] = now;
    joint->is_known[t] = 1;
    any = true;
  }
  return any;
}

std::optional<JointAngles> AnglesOfTurns(const FilledJoint& joint, const JointTurns& motion,
                                         FrameRate rate) {
  const size_t n = joint.row.size();
  std::vector<std::vector<double>> curves;
  for (size_t i = 0; i < n; ++i) {
    curves.push_back(SampleCurve(*joint.keys_of[i], joint.rest[i], joint.first, joint.last, rate));
  }
  const auto known = [&](size_t t) {
    const auto stopped = joint.at_limit.find(joint.first + static_cast<int>(t));
    if (stopped != joint.at_limit.end()) return stopped->second;
    std::vector<double> angles(n);
    for (size_t i = 0; i < n; ++i) angles[i] = curves[i][t];
    return angles;
  };
  JointAngles all{{known(0)}, {}};
  size_t before = 0;
  for (size_t t = 1; t < joint.is_known.size(); ++t) {
    if (!joint.IsKnown(joint.first + static_cast<int>(t))) continue;
    const std::vector<Mat3> turns(motion.turns.begin() + static_cast<long>(before) + 1,
                                  motion.turns.begin() + static_cast<long>(t) + 2);
    auto between = AnglesBetween(joint, joint.first + static_cast<int>(before), turns,
                                 known(before), known(t));
    if (!between) return std::nullopt;
    all.by_frame.insert(all.by_frame.end(), between->by_frame.begin() + 1, between->by_frame.end());
    all.changes.insert(all.changes.end(), between->changes.begin(), between->changes.end());
    before = t;
  }
  return all;
}

}  // namespace hazumi::makers
