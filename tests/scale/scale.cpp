// What a project costs of which one thing grows: time and the most memory that each thing takes
// that is done with it. A process of its own for each project, so that memory is its own.
//
// usage: scale KIND COUNT FOLDER

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/project/project_writer.h"
#include "tests/support/scaled_projects.h"
#include "ui/edit/session/session.h"

namespace hazumi::test {

namespace {

constexpr double kMostSeconds = 0.3;  // of repeating what is short

[[noreturn]] void Fail(const char* stage, const std::string& why) {
  std::fprintf(stderr, "scale: %s: %s\n", stage, why.c_str());
  std::exit(1);
}

template <typename T>
T Expect(const char* stage, Result<T> result) {
  if (!result.ok()) Fail(stage, result.error().ToString());
  return std::move(result).value();
}

// What the process holds at most since the last call [MiB].
double PeakMemory() {
  std::ifstream status("/proc/self/status");
  double kibibytes = 0.0;
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") status >> kibibytes;
  }
  std::ofstream("/proc/self/clear_refs") << "5";
  return kibibytes / 1024.0;
}

class Probe {
 public:
  Probe(std::string kind, int count) : kind_(std::move(kind)), count_(count) {}

  // The least time of some calls [s]; `action(i)` for i = 0, 1, ...
  template <typename Action>
  void Measure(const char* stage, Action&& action) {
    using Clock = std::chrono::steady_clock;
    double least = std::numeric_limits<double>::infinity(), sum = 0.0;
    PeakMemory();
    for (int i = 0; i < 3 || (sum < kMostSeconds && i < 1000); ++i) {
      const Clock::time_point start = Clock::now();
      action(i);
      const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
      least = std::min(least, seconds);
      sum += seconds;
    }
    std::printf("%s,%d,%s,%.4g,%.4g\n", kind_.c_str(), count_, stage, least, PeakMemory());
    std::fflush(stdout);
  }

 private:
  std::string kind_;
  int count_;
};

void Run(const std::string& kind, int count, const std::string& folder) {
  Probe probe(kind, count);
  const ScaledProject scaled = MakeScaled(kind, count);
  const std::string path = folder + "/" + kind + ".kfa";
  probe.Measure("save", [&](int) { Expect("save", SaveProject(scaled.project, path)); });
  probe.Measure("load", [&](int) { Expect("load", LoadProject(path)); });
  probe.Measure("check", [&](int) { Expect("check", CompileAnimation(scaled.project)); });
  {
    const Compiled compiled = Expect("bake", CompileAnimation(scaled.project));
    probe.Measure("bake", [&](int) { Expect("bake", Bake(compiled.animation)); });
  }
  edit::Session session;
  session.Replace(scaled.project, "");
  Expect("edit", session.WholeMotion());
  // Another value for a key, and the motion as it is then, to its end.
  probe.Measure("edit", [&](int i) {
    const long before = session.document().revision();
    Expect("edit", session.Run("key.set", {{"curve", scaled.curve},
                                           {"frame", scaled.frame},
                                           {"value", 30.0 + i % 2}}));
    if (session.document().revision() == before) Fail("edit", "nothing changed");
    Expect("edit", session.WholeMotion());
  });
}

}  // namespace

}  // namespace hazumi::test

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: scale KIND COUNT FOLDER\n");
    return 64;
  }
  hazumi::test::Run(argv[1], std::atoi(argv[2]), argv[3]);
  return 0;
}
