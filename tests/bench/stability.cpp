// What a second of swing without friction costs at the edge of stability, over two slices of the
// problems: evaluations of the equations of motion at the coarsest setting that survives.

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "engine/spatial/degrees.h"
#include "engine/timeline/animation.h"
#include "tests/bench/coarsest_setting.h"
#include "tests/bench/step_method.h"
#include "tests/bench/tables.h"
#include "tests/support/arm7_cases.h"
#include "tests/support/energy.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"

namespace hazumi::bench {

namespace {

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

Knob StepOf(const StepMethod& method, const Start& start) {
  const auto evaluations = [&](double step) -> std::optional<long> {
    const int steps = static_cast<int>(std::ceil(1.0 / step));
    if (!start.Accepts(method.energy_after_a_second(start.q, start.qd, steps))) return {};
    return static_cast<long>(steps) * method.evaluations_per_step;
  };
  return {0.1, 1e-5, evaluations};
}

// The error of a step that `exact` allows itself. All its evaluations count, also those of steps
// that it takes back.
Knob ToleranceOf(const Start& start) {
  const auto evaluations = [&](double tolerance) -> std::optional<long> {
    const test::Course course = test::SwingExactly({start.arm, start.q, start.qd, 1.0}, tolerance);
    const double energy =
        course.finished ? test::EnergyOf(start.arm, course.q, course.qd, test::kArmCaseGravity)
                        : std::numeric_limits<double>::quiet_NaN();
    if (!start.Accepts(energy)) return {};
    return course.evaluations;
  };
  return {1.0, 1e-12, evaluations};
}

// Where in a slice.
struct Cell {
  const char* slice;
  double x, y;
};

void PrintRow(const Cell& cell, const std::string& method, const Knob& knob,
              std::optional<double> setting) {
  std::printf("%s,%s,%.4g,%.4g,", cell.slice, method.c_str(), cell.x, cell.y);
  const std::optional<long> evaluations = setting ? knob.evaluations(*setting) : std::nullopt;
  if (evaluations) {
    std::printf("%.3g,%ld\n", *setting, *evaluations);
  } else {
    std::printf(",\n");
  }
}

void PrintCell(const Cell& cell, const Start& start) {
  const Knob tolerance = ToleranceOf(start);
  PrintRow(cell, "hazumi_exact", tolerance, CoarsestSetting(tolerance));
  // A tenth of a region's for each step, as the bake gives it.
  PrintRow(cell, "hazumi_exact_new_file", tolerance, 0.1 * SolverSettings().tolerance);
  for (const auto& methods : {PaperStepMethods(start.arm), MujocoStepMethods(start.arm)}) {
    for (const StepMethod& method : methods) {
      const Knob step = StepOf(method, start);
      PrintRow(cell, method.name, step, CoarsestSetting(step));
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
      PrintCell({"speed x mass ratio", speed, ratio},
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
      PrintCell({"speed x distance from the singular pose", speed, distance_deg},
                {arm, q, RatesAt(speed, c)});
    }
  }
}

}  // namespace

void PrintStability(int /*rounds*/) {
  std::puts("slice,method,x,y,setting,evaluations");
  PrintMassRatios();
  PrintPoleDistances();
}

}  // namespace hazumi::bench
