// Largest steps that survive a second of swing without friction, over two slices of the problems.

#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/base/assert.h"
#include "engine/timeline/animation.h"
#include "tests/bench/step_method.h"
#include "tests/bench/tables.h"
#include "tests/support/arm7_cases.h"
#include "tests/support/energy.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"

namespace hazumi::bench {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kLongest = 0.1, kShortest = 1e-5;  // steps tried [s]

struct Start {
  const Figure& arm;
  VecX q, qd;

  // Above that of the arm hanging at rest [J].
  double Above(double energy) const {
    const VecX zero = VecX::Zero(q.size());
    return energy - test::EnergyOf(arm, zero, zero, test::kArmCaseGravity);
  }
  double energy() const { return Above(test::EnergyOf(arm, q, qd, test::kArmCaseGravity)); }
  // Survival: the energy is within a factor of 2 of what it was.
  bool Accepts(double energy_after) const {
    const double ratio = Above(energy_after) / energy();
    return ratio >= 0.5 && ratio <= 2.0;  // false for NaN
  }
};

// With a single step size chance may do it; two somewhat finer ones must survive as well.
bool Survives(const StepMethod& method, const Start& start, double step) {
  for (const double part : {1.0, 0.9, 0.8}) {
    const int steps = static_cast<int>(std::ceil(1.0 / (part * step)));
    if (!start.Accepts(method.energy_after_a_second(start.q, start.qd, steps))) return false;
  }
  return true;
}

// 0 if there is none. By decades, then by bisection to 7 %.
double LargestStep(const StepMethod& method, const Start& start) {
  double good = kLongest;
  while (!Survives(method, start, good)) {
    good *= 0.1;
    if (good < 0.99 * kShortest) return 0.0;
  }
  if (good == kLongest) return good;
  double bad = 10.0 * good;
  for (int i = 0; i < 5; ++i) {
    const double middle = std::sqrt(good * bad);
    (Survives(method, start, middle) ? good : bad) = middle;
  }
  return good;
}

// The largest that it chose by itself at the tolerance of a new file, a tenth of that for each
// step, as the bake gives it. It has to survive.
double LargestStepOfExact(const Start& start) {
  const test::Course course =
      test::SwingExactly({start.arm, start.q, start.qd, 1.0}, 0.1 * SolverSettings().tolerance);
  HAZUMI_DEMAND(course.finished);
  HAZUMI_DEMAND(
      start.Accepts(test::EnergyOf(start.arm, course.q, course.qd, test::kArmCaseGravity)));
  return course.largest_step;
}

void PrintRow(const char* slice, const std::string& method, double x, double y, double step) {
  std::printf("%s,%s,%.4g,%.4g,", slice, method.c_str(), x, y);
  if (step > 0.0) std::printf("%.3g", step);
  std::printf("\n");
}

void PrintCell(const char* slice, double x, double y, const Start& start) {
  PrintRow(slice, "hazumi_exact", x, y, LargestStepOfExact(start));
  for (const auto& methods : {PaperStepMethods(start.arm), MujocoStepMethods(start.arm)}) {
    for (const StepMethod& method : methods) {
      PrintRow(slice, method.name, x, y, LargestStep(method, start));
    }
  }
  std::fflush(stdout);
}

constexpr double kSpeeds[] = {1, 2, 5, 10, 20, 50, 100};  // of the fastest hinge [rad/s]
constexpr double kMassRatios[] = {1, 0.2, 0.05, 0.01, 0.002, 5e-4, 1e-4};
constexpr double kDistances_deg[] = {60, 10, 1, 0.1, 0.01, 1e-3, 1e-4};

VecX RatesAt(double speed, const test::ArmCase& c) {
  return c.start_rate * (speed / c.start_rate.cwiseAbs().maxCoeff());
}

// The free swing of the arm cases.
void PrintMassRatios() {
  const test::ArmCase c = test::FreeSwing();
  for (const double ratio : kMassRatios) {
    const Figure arm = test::FreeArm7(ratio);
    for (const double speed : kSpeeds) {
      PrintCell("speed x mass ratio", speed, ratio,
                {arm, c.start_deg * kDegree, RatesAt(speed, c)});
    }
  }
}

// The swing near the gimbal lock, from other distances.
void PrintPoleDistances() {
  const test::ArmCase c = test::NearGimbal();
  const Figure arm = test::FreeArm7();
  for (const double distance_deg : kDistances_deg) {
    VecX q = c.start_deg * kDegree;
    q[1] = (90.0 - distance_deg) * kDegree;
    for (const double speed : kSpeeds) {
      PrintCell("speed x distance from the singular pose", speed, distance_deg,
                {arm, q, RatesAt(speed, c)});
    }
  }
}

}  // namespace

void PrintStability(int /*rounds*/) {
  std::puts("slice,method,x,y,largest_step_s");
  PrintMassRatios();
  PrintPoleDistances();
}

}  // namespace hazumi::bench
