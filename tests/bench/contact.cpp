// The human falls from standing: what all of it costs, and how far it is at some instants from
// where the same program ends with much finer settings. Programs differ in what contact is.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/spatial/degrees.h"
#include "tests/bench/falls.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/tables.h"

namespace hazumi::bench {

namespace {

const std::vector<int> kFrames = {3, 6, 9, 12, 15, 18, 24, 30};  // looked at, 30 a second

struct TimedFall {
  const FallMethod* method;
  double setting;
  LeastTime time;
};

std::vector<FallMethod> AllFalls(const Animation& fall) {
  std::vector<FallMethod> all = HazumiFalls(fall);
  for (FallMethod& method : MujocoFalls(fall)) all.push_back(std::move(method));
  return all;
}

// Bent, its joints away from their limits and turning, and above the floor.
Animation HumanInTheAir() {
  Animation flight = HumanAboutToFall(1.0);
  flight.root_keys[kRootZ][0].value += 1.0;
  for (int j = 0; j < flight.figure->num_joints(); ++j) {
    const Joint& joint = flight.figure->joints()[j];
    const double rate = j % 2 == 0 ? 1.0 : -1.0;  // [rad/s]
    flight.joint_keys[j] = {{0, 0.5 * (joint.lower + joint.upper), rate, Interpolation::kHold}};
  }
  return flight;
}

// Without contact, limits and friction both programs have one model. Ends the program if after
// 0.1 s in the air they differ by more than 1e-9 rad.
void DemandThatFlightsAgree() {
  const Animation flight = HumanInTheAir();
  const std::vector<FallMethod> all = AllFalls(flight);
  const MotionLimit ours = all[0].states(1e-11, {3})[0];
  const MotionLimit theirs = all.back().states(1e-4, {3})[0];  // by MuJoCo's RK4
  const double moved = AngleBetween(*flight.figure, ours, StartOfFall(flight));
  const double apart = AngleBetween(*flight.figure, ours, theirs);
  if (moved > 0.05 && apart <= 1e-9) return;
  std::fprintf(stderr, "flights of the human, %.3g rad long, differ by %.3g rad\n", moved, apart);
  std::exit(1);
}

void PrintErrors(const Figure& figure, const std::vector<MotionLimit>& states,
                 const std::vector<MotionLimit>& reference) {
  for (size_t i = 0; i < kFrames.size(); ++i) {
    const bool known = i < states.size() && i < reference.size();
    std::printf(",%.3g", known ? AngleBetween(figure, states[i], reference[i]) : HUGE_VAL);
  }
}

// Each program's own reference, of its first method, and how far it is from a slightly coarser one.
std::vector<MotionLimit> PrintReference(const Animation& fall, const FallMethod& method) {
  const std::vector<MotionLimit> reference = method.states(method.finest, kFrames);
  const std::string program = method.name.substr(0, method.name.find('_'));
  std::printf("%g,reference_%s,%s,%.3g,,,,,,", fall.regions[0].friction[0], program.c_str(),
              method.unit.c_str(), method.finest);
  std::printf(",%.3g", reference.back().X_WR.p.z());
  PrintErrors(*fall.figure, method.states(method.nearly, kFrames), reference);
  std::putchar('\n');
  return reference;
}

void PrintFall(double friction, int rounds) {
  const Animation fall = HumanAboutToFall(friction);
  const std::vector<FallMethod> methods = AllFalls(fall);
  std::vector<TimedFall> timed;
  for (const FallMethod& method : methods) {
    for (const double setting : method.settings) timed.push_back({&method, setting, {}});
  }
  for (int round = 0; round < rounds; ++round) {
    for (TimedFall& run : timed) {
      run.time.Round(0.0, [&](long) { KeepAlive(run.method->fall(run.setting)); });
    }
  }
  const std::vector<MotionLimit> ours = PrintReference(fall, methods[0]);
  const std::vector<MotionLimit> theirs = PrintReference(fall, methods[1]);
  for (const TimedFall& run : timed) {
    const FallMethod& method = *run.method;
    const FallAccount account = method.account(run.setting);
    std::printf("%g,%s,%s,%.4g,%d,%.4g,%.3g,%.3g,%.4g,%.3g,", friction, method.name.c_str(),
                method.unit.c_str(), run.setting, std::abs(run.setting / method.usual - 1.0) < 1e-3,
                account.finished ? run.time.microseconds() : HUGE_VAL, 1e3 * account.depth,
                account.unaccounted, account.lost, account.time_stepping_from);
    PrintErrors(*fall.figure, method.states(run.setting, kFrames),
                &method == &methods[0] ? ours : theirs);
    std::putchar('\n');
    std::fflush(stdout);
  }
}

}  // namespace

void PrintContact(int rounds) {
  DemandThatFlightsAgree();
  std::printf(
      "friction,method,unit,setting,is_usual,microseconds,depth_mm,unaccounted_j,lost_j,"
      "time_stepping_from_s,root_m");
  for (const int frame : kFrames) std::printf(",error_rad_at_%.1f_s", frame / 30.0);
  std::putchar('\n');
  for (const double friction : {1.0, 0.8}) PrintFall(friction, rounds);
}

}  // namespace hazumi::bench
