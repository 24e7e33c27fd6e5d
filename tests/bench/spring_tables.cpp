// An arm on springs beside other programs: what a swing costs for a given error, and what a second
// costs at the edge of stability.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "engine/base/text.h"
#include "engine/timeline/animation.h"
#include "tests/bench/coarsest_setting.h"
#include "tests/bench/springs.h"
#include "tests/bench/swing_table.h"
#include "tests/bench/tables.h"

namespace hazumi::bench {

namespace {

constexpr double kSeconds = 0.333;  // of the swing that is timed
constexpr double kDampingRatio = 0.7;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double LargestDifference(const VecX& a, const VecX& b) {
  const double largest = (a - b).cwiseAbs().maxCoeff();
  return std::isfinite(largest) ? largest : kInfinity;
}

std::vector<SpringMethod> MethodsOf(const std::vector<SpringProgram>& programs) {
  std::vector<SpringMethod> all;
  for (const SpringProgram& program : programs) {
    all.insert(all.end(), program.methods.begin(), program.methods.end());
  }
  return all;
}

const SpringMethod& Named(const std::vector<SpringMethod>& methods, const std::string& name) {
  return *std::find_if(methods.begin(), methods.end(),
                       [&](const SpringMethod& method) { return method.name == name; });
}

// As the table of swings has it.
SwingMethod AsSwing(const SpringMethod& method, int num_joints) {
  const auto run = method.run;
  const auto set_up = method.set_up;
  return {method.name,
          method.unit,
          method.settings,
          [](const SwingCase&) { return true; },
          [run, num_joints](const SwingCase& c, double setting) {
            const SpringRun at_end = run(c.seconds, setting);
            return at_end.finished ? at_end.q : VecX(VecX::Constant(num_joints, kInfinity));
          },
          [set_up](const SwingCase&) { set_up(); }};
}

void PrintSwingOnSprings(double frequency, int rounds) {
  const SpringArm arm = MakeSpringArm(frequency, kDampingRatio);
  const std::vector<SpringProgram> programs = SpringPrograms(arm);
  const std::vector<SpringMethod> methods = MethodsOf(programs);
  // What two programs agree on is known to their difference.
  const VecX end = Named(methods, "hazumi_exact").run(kSeconds, 1e-14).q;
  const VecX again = Named(methods, "mujoco_rk4").run(kSeconds, kSeconds / 30000).q;
  SwingCase c;
  c.name = "springs_" + FormatNumber(frequency) + "_hz";
  c.seconds = kSeconds;
  c.error = [end](const VecX& q) { return LargestDifference(q, end); };
  c.reference_error = std::max(1e-13, LargestDifference(again, end));
  std::vector<SwingMethod> swings;
  for (const SpringMethod& method : methods) {
    swings.push_back(AsSwing(method, arm.figure.num_joints()));
  }
  PrintSwings(c, swings, rounds);
  std::fflush(stdout);
}

// Survival of a second: without damping the energy is kept, to within a factor of 2; with damping,
// where it goes down to nearly nothing, it is not more than twice what it was.
Knob KnobOf(const SpringMethod& method, const SpringArm& arm, bool is_damped) {
  const double before = arm.EnergyAbove(arm.q, arm.qd);
  const auto evaluations = [=, &method, &arm](double setting) -> std::optional<long> {
    const SpringRun run = method.run(1.0, setting);
    if (!run.finished) return {};
    const double ratio = arm.EnergyAbove(run.q, run.qd) / before;
    const bool survives = ratio <= 2.0 && (is_damped || ratio >= 0.5);  // false for NaN
    return survives ? std::optional<long>(run.evaluations) : std::nullopt;
  };
  return {method.coarsest, method.finest, evaluations};
}

void PrintEdge(double damping_ratio, const std::string& name, double frequency, const Knob& knob,
               bool has_steps, std::optional<double> setting) {
  std::printf("%g,%s,%g,", damping_ratio, name.c_str(), frequency);
  const std::optional<long> evaluations = setting ? knob.evaluations(*setting) : std::nullopt;
  if (evaluations) {
    std::printf(has_steps ? "%.3g,,%ld\n" : ",%.3g,%ld\n", *setting, *evaluations);
  } else {
    std::printf(",,\n");
  }
  std::fflush(stdout);
}

void PrintEdges(double damping_ratio, double frequency) {
  constexpr double kMostOfARegion = 30.0;  // [Hz]
  const SpringArm arm = MakeSpringArm(frequency, damping_ratio);
  const std::vector<SpringProgram> programs = SpringPrograms(arm);
  for (const SpringMethod& method : MethodsOf(programs)) {
    const bool ours = method.name == "hazumi_exact";
    if (ours && frequency > kMostOfARegion) continue;
    const Knob knob = KnobOf(method, arm, damping_ratio > 0.0);
    PrintEdge(damping_ratio, method.name, frequency, knob, method.has_steps, CoarsestSetting(knob));
    if (!ours) continue;
    // A tenth of a region's for each step, as `stability` has it.
    PrintEdge(damping_ratio, "hazumi_exact_new_file", frequency, knob, false,
              0.1 * SolverSettings().tolerance);
  }
}

}  // namespace

void PrintSprings(int rounds) {
  std::puts(kSwingColumns);
  for (const double frequency : {2.5, 15.0}) PrintSwingOnSprings(frequency, rounds);
}

void PrintSpringStability(int /*rounds*/) {
  std::puts("damping_ratio,method,frequency_hz,step_s,tolerance,evaluations");
  for (const double damping_ratio : {0.0, kDampingRatio}) {
    for (const double frequency : {1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100}) {
      PrintEdges(damping_ratio, frequency);
    }
  }
}

}  // namespace hazumi::bench
