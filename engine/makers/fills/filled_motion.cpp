#include "engine/makers/fills/filled_motion.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "engine/bake/bake.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/fills/limb_fill.h"
#include "engine/project/checks/joint_names.h"
#include "engine/solve/fill_solver.h"

namespace hazumi::makers {

namespace {

// Spline of a joint through its keys.
JointTurns SplineOf(const FilledJoint& joint, FrameRate rate) {
  JointTurns found = TurnsOfCurves(joint, rate);
  solve::Chain chain;
  chain.step = rate.seconds_per_frame();
  chain.joints = {{Vec3::Zero(), found.axes}};
  const int first = joint.first - (joint.is_free_before ? 0 : 1);
  const int last = joint.last + (joint.is_free_after ? 0 : 1);
  for (solve::GivenRate given : found.rates) {
    given.frame += joint.first - 1 - first;
    chain.rates.push_back(given);
  }
  solve::Turns turns;
  for (int f = first; f <= last; ++f) {
    chain.carrier.push_back({});
    chain.is_known.push_back({joint.IsKnown(f) ? char{1} : char{0}});
    turns.push_back({found.At(f, joint)});
  }
  chain.has_end_rates = !joint.is_free_before && !joint.is_free_after;
  solve::SolveSpline(chain, &turns);
  for (int f = first; f <= last; ++f) found.At(f, joint) = turns[static_cast<size_t>(f - first)][0];
  return found;
}

class MotionFiller {
 public:
  MotionFiller(const ProjectFill& fill, const Animation& animation, const Motion& motion)
      : fill_(fill),
        animation_(animation),
        motion_(motion),
        figure_(*animation.figure),
        filled_(animation, motion) {}

  Result<FilledMotion> Fill(const std::atomic<bool>* cancel) {
    if (std::optional<Error> error = FindJoints()) return *error;
    FillRootPlace();
    turns_.resize(found_.joints.size());
    std::vector<size_t> all(found_.joints.size());
    std::iota(all.begin(), all.end(), size_t{0});
    WithinLimits(all, [] {});
    for (const Limb& limb : LimbsOf(figure_)) {
      if (cancel && cancel->load(std::memory_order_relaxed)) {
        return Error{ErrorCode::kInterrupted, "", "", "interrupted"};
      }
      FillPartOf(limb);
    }
    Measure();
    return std::move(found_);
  }

 private:
  std::optional<Error> Add(std::optional<GroupIndex> group) {
    Result<std::optional<FilledJoint>> joint = FilledJointOf(group, fill_, animation_);
    if (!joint.ok()) return joint.error();
    if (joint.value()) {
      found_.joints.push_back({*std::move(joint.value()), std::nullopt});
    } else if (group) {
      const JointGroup& all = figure_.group(*group);
      for (int j = all.first.value(); j <= all.last().value(); ++j) {
        const Keys& keys = animation_.joint_keys[static_cast<size_t>(j)];
        const bool moves = std::any_of(keys.begin(), keys.end(), [&](const Key& key) {
          return key.value != keys.front().value;
        });
        if (moves) found_.unfilled.push_back(figure_.joint(JointIndex(j)).name);
      }
    }
    return std::nullopt;
  }

  std::optional<Error> FindJoints() {
    is_root_filled_ = NameRoot(fill_.joints, figure_);
    if (is_root_filled_) {
      if (std::optional<Error> error = Add(std::nullopt)) return error;
    }
    const std::vector<bool> hinges = JointsOf(fill_.joints, figure_);
    for (int g = 0; g < static_cast<int>(figure_.groups().size()); ++g) {
      const JointGroup& group = figure_.group(GroupIndex(g));
      bool any = false;
      for (int j = group.first.value(); j <= group.last().value(); ++j) {
        any |= hinges[static_cast<size_t>(j)];
      }
      if (!any) continue;
      if (std::optional<Error> error = Add(GroupIndex(g))) return error;
    }
    return std::nullopt;
  }

  void FillRootPlace() {
    if (!is_root_filled_) return;
    for (int i = kRootX; i <= kRootZ; ++i) {
      FilledPlace& place = found_.places[static_cast<size_t>(i)];
      place = FilledPlaceOf(animation_.root_keys[static_cast<size_t>(i)], fill_, animation_);
      for (size_t t = 0; t < place.values.size(); ++t) {
        const int frame = place.first + static_cast<int>(t);
        if (IsKeyed(frame, animation_)) filled_.at(frame).X_WR.p[i] = place.values[t];
      }
    }
  }

  // Fills joints by their splines and then by `improve`, until none goes beyond its limits: where
  // one did it is stopped, and the rest is found anew.
  template <typename Improve>
  void WithinLimits(const std::vector<size_t>& joints, Improve improve) {
    constexpr int kMostRounds = 6;
    bool is_beyond = true;
    for (int round = 0; round < kMostRounds && is_beyond; ++round) {
      for (const size_t i : joints) {
        turns_[i] = SplineOf(found_.joints[i].joint, animation_.rate);
      }
      improve();
      is_beyond = false;
      for (const size_t i : joints) {
        FilledAngles& filled = found_.joints[i];
        filled.angles = AnglesOfTurns(filled.joint, turns_[i], animation_.rate);
        if (!filled.angles) continue;
        is_beyond |= StopAtLimits(&filled.joint, &filled.angles->by_frame);
        filled_.Take(filled.joint, *filled.angles);
      }
    }
  }

  void FillPartOf(const Limb& limb) {
    LimbSplines splines;
    std::vector<size_t> joints;
    size_t begin = limb.size(), end = 0;
    for (size_t i = 0; i < found_.joints.size(); ++i) {
      const FilledAngles& joint = found_.joints[i];
      if (!joint.joint.group || !joint.angles) continue;
      const auto at = std::find(limb.begin(), limb.end(), *joint.joint.group);
      if (at == limb.end()) continue;
      splines[*at] = {&joint.joint, &turns_[i]};
      joints.push_back(i);
      begin = std::min(begin, static_cast<size_t>(at - limb.begin()));
      end = std::max(end, static_cast<size_t>(at - limb.begin()) + 1);
    }
    if (splines.empty()) return;
    for (const size_t i : joints) found_.joints[i].joint.ForgetLimits();
    const std::vector<GroupIndex> part(limb.begin() + static_cast<long>(begin),
                                       limb.begin() + static_cast<long>(end));
    WithinLimits(joints, [&] { FillLimb(part, splines, fill_, animation_, &filled_); });
  }

  // Finds the joint that the fill moves farthest.
  void Measure() {
    DynamicsWorkspace before(figure_);
    for (const MotionFrame& frame : motion_.frames) {
      ComputePositions(figure_, frame.X_WR, frame.q, &before);
      const DynamicsWorkspace& now = filled_.Bodies(frame.frame);
      for (const JointGroup& group : figure_.groups()) {
        const double off = (now.body(group.last()).p - before.body(group.last()).p).norm();
        if (off <= found_.farthest) continue;
        found_.farthest = off;
        found_.farthest_joint = group.name;
        found_.farthest_frame = frame.frame;
      }
    }
  }

  const ProjectFill& fill_;
  const Animation& animation_;
  const Motion& motion_;
  const Figure& figure_;
  FilledFigure filled_;
  bool is_root_filled_ = false;
  FilledMotion found_;
  std::vector<JointTurns> turns_;  // of found_.joints
};

}  // namespace

Result<FilledMotion> FillMotion(const ProjectFill& fill, const Animation& animation,
                                const std::atomic<bool>* cancel) {
  // Regions are left out: a fill interpolates keys, and a bake applies its regions afterwards.
  Animation keyed = animation;
  keyed.regions.clear();
  keyed.forces.clear();
  keyed.constraints.clear();
  BakeOptions options;
  options.cancel = cancel;
  options.threads = 1;
  const Result<Motion> motion = Bake(keyed, options);
  if (!motion.ok()) return motion.error();
  return MotionFiller(fill, keyed, motion.value()).Fill(cancel);
}

}  // namespace hazumi::makers
