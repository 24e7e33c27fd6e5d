#include "tests/property/random_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/project/figure_file.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

namespace {

FigureSpec ShippedHuman() {
  return LoadFigure(HAZUMI_SOURCE_DIR "/assets/figures/human.json").value();
}

}  // namespace

FigureSpec RandomFigureSpec(bool has_limits, Random* random) {
  const bool is_human = random->Chance(1.0 / 3.0);
  FigureSpec spec = is_human ? ShippedHuman() : RandomTreeSpec(random);
  for (JointSpec& joint : spec.joints) {
    for (HingeSpec& hinge : joint.hinges) {
      if (is_human && has_limits) continue;
      hinge.lower = has_limits ? -random->Uniform(0.3, 3.0) : -1000.0;
      hinge.upper = has_limits ? random->Uniform(0.3, 3.0) : 1000.0;
    }
  }
  return spec;
}

Figure RandomFigure(bool has_limits, Random* random) {
  return Build(RandomFigureSpec(has_limits, random));
}

void ChooseJoints(const Figure& figure, Random* random, DynamicsRegion* region) {
  constexpr size_t kMost = 14;
  std::vector<char> chosen(figure.num_joints(), 0);
  const int wanted = random->Integer(1, 2);
  for (int count = 0; count < wanted;) {
    const auto& groups = figure.groups();
    const JointGroup& group = groups[random->Integer(0, static_cast<int>(groups.size()) - 1)];
    const bool beyond = random->Chance(0.7);
    const int first = group.first.value();
    const int end = beyond ? figure.joint(group.first).subtree_end.value() : first + group.size;
    if (static_cast<size_t>(end - first) > kMost / 2) continue;
    std::fill(chosen.begin() + first, chosen.begin() + end, 1);
    ++count;
  }
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (chosen[j]) region->joints.emplace_back(j);
  }
}

void ChooseFriction(Random* random, DynamicsRegion* region) {
  const double equal = random->Chance(0.5) ? 1.0 : random->Uniform(0.3, 1.0);
  const bool is_equal = random->Chance(0.7);
  for (size_t i = 0; i < region->joints.size(); ++i) {
    const double own = random->Chance(0.1) ? 0.0 : random->Uniform(0.3, 1.0);
    region->friction.push_back(is_equal ? equal : own);
  }
}

void ChooseKeys(const DynamicsRegion& region, Random* random, Animation* animation) {
  const Figure& figure = *animation->figure;
  const VecX q = RandomAngles(figure, random);
  const double most_rate = random->Uniform(1.0, 15.0);  // [rad/s]
  for (int j = 0; j < figure.num_joints(); ++j) {
    const Joint& joint = figure.joints()[j];
    const double start = std::clamp(q[j], 0.95 * joint.lower, 0.95 * joint.upper);
    Keys& keys = animation->joint_keys[j];
    keys = {{0, start, random->Uniform(-most_rate, most_rate), Interpolation::kCubic}};
    const bool is_free =
        std::binary_search(region.joints.begin(), region.joints.end(), JointIndex(j));
    if (is_free) continue;
    keys[0].rate = random->Uniform(-3.0, 3.0);
    if (random->Chance(0.5)) keys[0] = {0, start, {}, Interpolation::kHold};
    for (const double frame : {9.0, 20.5, 30.0}) {
      keys.push_back({frame, start + random->Uniform(-0.5, 0.5), {}, Interpolation::kCubic});
    }
  }
}

void ChooseRoot(Random* random, DynamicsRegion* region, Animation* animation) {
  for (int i = 0; i < kNumRootCurves; ++i) {
    const double rate = random->Uniform(-3.0, 3.0);
    animation->root_keys[i] = {{0, random->Uniform(-0.5, 0.5), rate, Interpolation::kCubic},
                               {30, random->Uniform(-0.5, 0.5), {}, Interpolation::kCubic}};
  }
  const int kind = random->Integer(0, 2);
  if (kind == 1) {
    const int groups = static_cast<int>(animation->figure->groups().size());
    animation->placements.push_back(
        {PlacementKind::kPinned, 0, 30, GroupIndex(random->Integer(0, groups - 1)), {}});
  }
  if (kind == 2) AddGravity(animation, 0, 30);
  region->root = kind > 0 && random->Chance(0.4);
}

namespace {

Mat3 Turn(const Vec3& axis, double angle) {
  return AxisRotation<double>(axis, std::sin(angle), std::cos(angle));
}

Mat3 RotationOf(const Figure& figure, const JointGroup& group, const VecX& q) {
  Mat3 R = Mat3::Identity();
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    R = R * figure.joints()[j].X_PJ.R * Turn(figure.joints()[j].axis, q[j]);
  }
  return R;
}

double AngleBetween(const Mat3& a, const Mat3& b) {
  return Eigen::AngleAxisd(Mat3(a.transpose() * b)).angle();
}

// By group: three, if all its hinges move.
std::vector<int> FreeHinges(const Figure& figure, const DynamicsRegion& region) {
  std::vector<int> count(figure.groups().size(), 0);
  for (size_t i = 0; i < region.joints.size(); ++i) {
    if (region.friction[i] > 0.0) ++count[figure.joint(region.joints[i]).group.value()];
  }
  return count;
}

}  // namespace

Animation RandomRegion(uint64_t seed, bool has_limits) {
  Random random(seed);
  Animation animation = Still(RandomFigure(has_limits, &random));
  animation.solver.method = Method::kExact;
  DynamicsRegion region;
  region.name = "region";
  region.method = Method::kExact;
  region.last_frame = random.Integer(5, 30);
  animation.last_frame = region.last_frame;
  ChooseJoints(*animation.figure, &random, &region);
  ChooseFriction(&random, &region);
  ChooseKeys(region, &random, &animation);
  ChooseRoot(&random, &region, &animation);
  animation.regions.push_back(region);
  return animation;
}

double LargestError(const Animation& animation, const Motion& motion, const Motion& reference,
                    size_t index, double until) {
  const Figure& figure = *animation.figure;
  const DynamicsRegion& region = animation.regions[index];
  const std::vector<int> free = FreeHinges(figure, region);
  double worst = 0.0;
  for (size_t f = 0; f < motion.frames.size(); ++f) {
    if (motion.frames[f].frame > until) break;
    const VecX& q = motion.frames[f].before.q;
    const VecX& other = reference.frames[f].before.q;
    for (const JointIndex j : region.joints) {
      const JointGroup& group = figure.group(figure.joint(j).group);
      const bool is_ball = free[figure.joint(j).group.value()] == 3;
      const double error =
          is_ball ? AngleBetween(RotationOf(figure, group, q), RotationOf(figure, group, other))
                  : std::abs(q[j.value()] - other[j.value()]);
      worst = std::max(worst, error);
    }
    if (!region.root) continue;
    worst = std::max(
        worst, AngleBetween(motion.frames[f].before.X_WR.R, reference.frames[f].before.X_WR.R));
  }
  return worst;
}

}  // namespace hazumi::test
