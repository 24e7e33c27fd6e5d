// render_demo FOLDER [FRAMES [walk|ghosts [THREADS [SAMPLES]]]]: writes the demo scene as
// FOLDER/demo_####.png and prints the time it took. For looking and measuring; not shipped.

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "demo_scene.h"
#include "render/pipeline/sequence.h"

namespace {

using namespace hazumi;
using namespace hazumi::render;

double CpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * double(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

std::string FramePath(const std::string& folder, int frame) {
  char name[32];
  std::snprintf(name, sizeof(name), "/demo_%04d.png", frame);
  return folder + name;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  const bool ghosts = argc > 3 && std::string(argv[3]) == "ghosts";
  SequenceOptions options;
  options.threads = argc > 4 ? std::atoi(argv[4]) : 2;
  options.renderer.samples = argc > 5 ? std::atoi(argv[5]) : 4;
  Sequence sequence;
  sequence.frame_count = argc > 2 ? std::atoi(argv[2]) : 1;
  sequence.scene = ghosts ? MakeGhostScene : MakeDemoScene;
  sequence.path = [&](int frame) { return FramePath(folder, frame); };
  sequence.metadata = [](int frame) {
    return std::vector<PngText>{{"Software", "Hazumi"}, {"Frame", std::to_string(frame)}};
  };
  const auto start = std::chrono::steady_clock::now();
  const Result<int> written = RenderSequence(options, sequence);
  if (!written.ok()) std::fprintf(stderr, "%s\n", written.error().ToString().c_str());
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::printf("%d frames, %.2f s wall, %.2f s CPU\n", sequence.frame_count, wall.count(),
              CpuSeconds());
  return written.ok() ? 0 : 1;
}
