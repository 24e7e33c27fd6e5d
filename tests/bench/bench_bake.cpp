// How long an animator waits for the motion, error estimates included, without starting a process
// or reading a file. Names are those of the rows of edit.csv: case/what. On as many threads as the
// machine has, unless the name says on one.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include "engine/analysis/effort.h"
#include "engine/bake/incremental_bake.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/data_folder.h"
#include "tests/support/long_timeline.h"
#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi {
namespace {

Animation Load(const std::string& name) {
  const std::string path = std::string(HAZUMI_SOURCE_DIR) + "/assets/examples/" + name + ".kfa";
  const Result<Project> project = LoadProject(path);
  return CompileAnimation(project.value()).value().animation;
}

template <typename Action>
void Register(const std::string& name, Action action) {
  benchmark::RegisterBenchmark(name.c_str(), action)->Unit(benchmark::kMicrosecond);
}

constexpr int kThreads[] = {1, 0};  // 0: all that there are

std::string On(int threads) { return threads == 1 ? " on one thread" : ""; }

void RegisterBake(const std::string& name, const Animation& animation) {
  for (const int threads : kThreads) {
    Register(name + "/bake" + On(threads), [=](benchmark::State& state) {
      BakeOptions options;
      options.threads = threads;
      for (auto _ : state) benchmark::DoNotOptimize(Bake(animation, options).value().frames.data());
    });
  }
}

void RegisterLoad(const std::string& name) {
  Register(name + "/load and compile", [name](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Load(name).joint_keys.data());
  });
}

// One key goes up and down by a hundredth of a radian; the motion is asked for up to `frame`.
void RegisterEdit(const std::string& name, const Animation& animation, const char* joint,
                  double key_frame, int frame, const std::string& what, int threads = 0) {
  Register(name + "/" + what + On(threads), [=](benchmark::State& state) {
    Animation edited = animation;
    BakeOptions options;
    options.threads = threads;
    IncrementalBake bake(edited, options);
    if (bake.Finish()) return state.SkipWithError("it cannot be baked");
    double step = 0.01;
    for (auto _ : state) {
      for (Key& key : test::KeysOf(&edited, joint)) {
        if (key.frame == key_frame) key.value += step;
      }
      step = -step;
      bake.Update(edited);
      if (bake.BakeTo(frame)) return state.SkipWithError("it cannot be baked");
    }
  });
}

// Seconds that the motion takes after a key has moved: the least of several times.
double LeastSeconds(const Animation& animation, Key* key, const Animation& edited,
                    const BakeOptions& options) {
  using Clock = std::chrono::steady_clock;
  IncrementalBake bake(animation, options);
  bake.Finish();
  double step = 0.01, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 40; ++i, step = -step) {
    key->value += step;
    const Clock::time_point start = Clock::now();
    bake.Update(edited);
    bake.Finish();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
  return least;
}

// Each key of an animation is moved; what counts is the one that takes longest.
void RegisterSlowestEdit(const std::string& name, const Animation& animation, int threads) {
  const auto slowest = [=](benchmark::State& state) {
    BakeOptions options;
    options.threads = threads;
    for (auto _ : state) {
      Animation edited = animation;
      double most = 0.0;
      const auto move_each = [&](Keys* keys) {
        for (Key& key : *keys) {
          most = std::max(most, LeastSeconds(animation, &key, edited, options));
        }
      };
      for (Keys& keys : edited.joint_keys) move_each(&keys);
      for (Keys& keys : edited.root_keys) move_each(&keys);
      state.SetIterationTime(most);
    }
  };
  benchmark::RegisterBenchmark((name + "/move any key, the slowest" + On(threads)).c_str(), slowest)
      ->Unit(benchmark::kMicrosecond)
      ->UseManualTime()
      ->Iterations(1);
}

void RegisterEdits() {
  const Animation animation = Load("throw");
  const auto edit = [&](const char* joint, double frame, const std::string& what) {
    for (const int threads : kThreads) {
      RegisterEdit("throw", animation, joint, frame, 30, what, threads);
    }
  };
  edit("neck_flexion", 5, "move a key of the neck");
  edit("l_elbow_flexion", 30, "move a key of the left elbow after the region");
  edit("l_elbow_flexion", 5, "move a key of the left elbow where the region begins");
  edit("r_elbow_flexion", 5, "move a key of the right elbow where the region begins");
  edit("chest_flexion", 15, "move a key of the chest in the region");
  for (const int threads : kThreads) RegisterSlowestEdit("throw", animation, threads);
}

// One of the regions lies between frames 5010 and 5020; at 5100 the other foot is pinned.
void RegisterLongEdits() {
  const std::string name = "10000 frames and 100 regions";
  const Animation animation = test::LongTimeline(10000, 100);
  RegisterBake("100 frames and 1 region", test::LongTimeline(100, 1));
  RegisterBake("1000 frames and 10 regions", test::LongTimeline(1000, 10));
  RegisterBake(name, animation);
  const auto edit = [&](const char* joint, int key_frame, int frame, const std::string& what) {
    RegisterEdit(name, animation, joint, key_frame, frame, what);
  };
  edit("neck_flexion", 5010, 10000, "move a key of the neck");
  edit("l_elbow_flexion", 5010, 10000, "move a key of an elbow where a region begins");
  edit("chest_flexion", 5020, 10000, "move a key of the chest in a region");
  edit("l_knee", 5100, 5110, "move a key of the pinned leg and show the next frames");
  edit("l_knee", 5100, 10000, "move a key of the pinned leg and show the last frame");
}

// What an animator waits for who gives regions muscle, holds and ground.
void RegisterWorking() {
  const double new_file = 0.01 * kDegree;
  Animation springs = Load("throw");
  DynamicsRegion& arms = springs.regions[0];
  Drive drive;
  drive.kind = DriveKind::kSpring;
  drive.joints = arms.joints;
  drive.frequency = 2.5;
  drive.damping_ratio = 0.7;
  arms.drives = {drive};
  RegisterBake("throw with springs on both arms", springs);

  Animation bar = test::HandsOnBar();
  bar.last_frame = 60;
  for (DynamicsRegion& region : bar.regions) region.last_frame = 60;
  for (Constraint& grip : bar.constraints) grip.last_frame = 60;
  bar.solver.tolerance = new_file;
  RegisterBake("both hands on a bar for two seconds", bar);

  // Falls from standing, two seconds: 0.1 degrees up to the first impact.
  Animation fall = test::LooseHuman(60, 0.9024);
  fall.root_keys[4][0].rate = 0.3;
  fall.solver.tolerance = 0.1 * kDegree;
  RegisterBake("fall of a human from standing", fall);
}

// A human whose joints all sway, with a key on each of 300 frames, as a capture has.
Animation Capture() {
  constexpr int kFrames = 300;
  Animation animation = Load("jump");
  animation.placements.clear();
  animation.first_frame = 0;
  animation.last_frame = kFrames;
  for (int j = 0; j < animation.figure->num_joints(); ++j) {
    Keys& keys = animation.joint_keys[j];
    const double middle = keys.empty() ? 0.0 : keys[0].value;
    keys.clear();
    for (int frame = 0; frame <= kFrames; ++frame) {
      keys.push_back({static_cast<double>(frame), middle + 0.1 * std::sin(0.05 * frame + j), {}});
    }
  }
  return animation;
}

void TimeEffort(const Animation& animation, benchmark::State* state) {
  const Motion motion = Bake(animation).value();
  for (auto _ : *state) benchmark::DoNotOptimize(EffortOf(animation, motion).frames.data());
  state->counters["frames"] = static_cast<double>(motion.frames.size());
}

// Of the captures beside the repository.
Animation CapturedWalk(const std::string& clip) {
  const Character character = ReadCharacter(test::DataPath(clip)).value();
  return CompileAnimation(ImportProject(character, {}).value().project).value().animation;
}

void RegisterEffort() {
  Register("a capture of 300 frames/effort",
           [](benchmark::State& state) { TimeEffort(Capture(), &state); });
  const std::string name = "a captured walk/effort", clip = "other/cmu_mb_02_01_walk.bvh";
  if (const std::string missing = test::MissingData(clip); !missing.empty()) {
    std::fprintf(stderr, "%s is skipped: %s\n", name.c_str(), missing.c_str());
    return;
  }
  Register(name, [clip](benchmark::State& state) { TimeEffort(CapturedWalk(clip), &state); });
}

}  // namespace
}  // namespace hazumi

int main(int argc, char** argv) {
  for (const char* name : {"throw", "jump"}) {
    hazumi::RegisterBake(name, hazumi::Load(name));
    hazumi::RegisterLoad(name);
  }
  hazumi::RegisterWorking();
  hazumi::RegisterEffort();
  hazumi::RegisterEdits();
  hazumi::RegisterLongEdits();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
