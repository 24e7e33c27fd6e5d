// How long the motion of the examples takes, without starting a process or reading a file.

#include <benchmark/benchmark.h>

#include "engine/bake/bake.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"

namespace hazumi {
namespace {

Animation Load(const std::string& name) {
  const std::string path = std::string(HAZUMI_SOURCE_DIR) + "/assets/examples/" + name + ".kfa";
  const Result<Project> project = LoadProject(path);
  return CompileAnimation(project.value()).value().animation;
}

void BM_Bake(benchmark::State& state, const std::string& name) {
  const Animation animation = Load(name);
  for (auto _ : state) benchmark::DoNotOptimize(Bake(animation).value().frames.data());
}
BENCHMARK_CAPTURE(BM_Bake, throw, "throw")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_Bake, jump, "jump")->Unit(benchmark::kMicrosecond);

void BM_LoadAndCompile(benchmark::State& state, const std::string& name) {
  for (auto _ : state) benchmark::DoNotOptimize(Load(name).joint_keys.data());
}
BENCHMARK_CAPTURE(BM_LoadAndCompile, throw, "throw")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(BM_LoadAndCompile, jump, "jump")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hazumi
