#include "engine/makers/throws/arm_swing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/text.h"
#include "engine/figure/strength.h"
#include "engine/makers/aims/aimed_limb.h"
#include "engine/makers/aims/aimed_paths.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kClear = 0.02;                  // of what stands around the arm [m]
constexpr double kBeyondAsMuch = 1.0 * kDegree;  // beyond a limit counts as all of a strength

}  // namespace

Result<ArmSwing> SwingArm(const AimGoal& goal, const DynamicsRegion& arm,
                          const Animation& animation, const Motion& motion) {
  const Figure& figure = *animation.figure;
  const std::vector<AimedHinges> paths = PathsOf({goal}, arm, figure);
  if (paths.empty()) {
    return Error{ErrorCode::kSchema, "", "object", "no joint of the arm is free to throw"};
  }
  AimedLimb limb(paths.front(), arm, {goal}, 1.0, animation, motion);
  if (limb.out_of_reach()) {
    const double lacks = goal.place.z() - limb.release().path.from.z();
    if (goal.thrown->height && *goal.thrown->height < lacks) {
      return Error{ErrorCode::kSchema, "", "height",
                   "the spot is " + std::to_string(std::lround(100.0 * lacks)) +
                       " cm higher than the hand: give a greater height"};
    }
    return Error{ErrorCode::kSemantics, "", "x",
                 "the arm cannot throw it there: it comes down " +
                     FormatShort(100.0 * limb.out_of_reach()->distance) + " cm away at best"};
  }
  std::vector<int> rows;
  ArmSwing swing;
  for (size_t k = 0; k < paths.front().path.size(); ++k) {
    if (!paths.front().moves[k]) continue;
    swing.hinges.push_back(paths.front().path[k]);
    rows.push_back(static_cast<int>(k));
  }
  swing.frames = limb.spline_frames();
  swing.path = limb.release().path;
  const int n = static_cast<int>(rows.size()), count = static_cast<int>(swing.frames.size());
  swing.angles.resize(n, count);
  swing.rates.resize(n, count);
  // Takes the best one of several minima.
  double least = std::numeric_limits<double>::infinity();
  for (const double smoothness : {1.0, 6.0, 36.0}) {
    limb.Solve({smoothness, kClear, 0});
    const double muscle = limb.MostMuscle();
    const double strain = muscle + limb.MostBeyond() / kBeyondAsMuch;
    if (strain >= least) continue;
    least = strain;
    swing.muscle = muscle;
    for (int i = 0; i < count; ++i) {
      const int frame = swing.frames[static_cast<size_t>(i)];
      swing.angles.col(i) = limb.AnglesAt(frame)(rows);
      swing.rates.col(i) = limb.RatesAt(frame)(rows);
    }
  }
  swing.angles.rightCols(1) = limb.release().angles(rows);
  swing.rates.rightCols(1) = limb.release().rates(rows);
  return swing;
}

}  // namespace hazumi::makers
