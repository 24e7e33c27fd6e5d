#include "tests/bench/swing_table.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "tests/bench/stopwatch.h"

namespace hazumi::bench {

std::vector<double> GeometricSettings(double first, double ratio, int count) {
  std::vector<double> settings;
  for (int i = 0; i < count; ++i) settings.push_back(first * std::pow(ratio, i));
  return settings;
}

namespace {

constexpr double kBatchSeconds = 0.0005;

struct Timed {
  const SwingMethod* method;
  double setting;
  LeastTime time;
};

struct TimedSetUp {
  const SwingMethod* method;
  LeastTime time;
};

// A case by all methods that handle it.
struct TimedCase {
  const SwingCase& c;
  std::vector<TimedSetUp> set_ups;
  std::vector<Timed> runs;

  TimedCase(const SwingCase& of, const std::vector<SwingMethod>& methods) : c(of) {
    for (const SwingMethod& method : methods) {
      if (!method.handles(c)) continue;
      set_ups.push_back({&method, {}});
      for (const double setting : method.settings) runs.push_back({&method, setting, {}});
    }
  }

  void Round() {
    for (TimedSetUp& timed : set_ups) {
      timed.time.Round(kBatchSeconds, [&](long) { timed.method->set_up(c); });
    }
    for (Timed& timed : runs) {
      timed.time.Round(kBatchSeconds,
                       [&](long) { KeepAlive(timed.method->run(c, timed.setting)); });
    }
  }

  double SetUpMicroseconds(const SwingMethod* method) const {
    for (const TimedSetUp& timed : set_ups) {
      if (timed.method == method) return timed.time.microseconds();
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
};

}  // namespace

void PrintSwings(const SwingCase& c, const std::vector<SwingMethod>& methods, int rounds) {
  TimedCase timed_case(c, methods);
  for (int round = 0; round < rounds; ++round) timed_case.Round();
  for (const Timed& timed : timed_case.runs) {
    std::printf("%s,%s,%s=%.5g,%.4g,%.3g,%.4g\n", timed.method->name.c_str(), c.name.c_str(),
                timed.method->unit.c_str(), timed.setting, timed.time.microseconds(),
                c.error(timed.method->run(c, timed.setting)),
                timed_case.SetUpMicroseconds(timed.method));
  }
  std::printf("reference,%s,,,%.2g,\n", c.name.c_str(), c.reference_error);
}

}  // namespace hazumi::bench
