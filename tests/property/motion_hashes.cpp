// Hashes of baked motions, for scripts/same_motion. Prints a line for each: its name, a hash of all
// bits of the motion, and one of its reports, events and warnings.
//   motion_hashes VERSION FILE.kfa ...
//   motion_hashes VERSION --captures FILE.bvh ...   captured motion, a limb of it limp for a third
//   motion_hashes VERSION --working FIRST COUNT     random regions in which something acts
//   motion_hashes VERSION --falls FIRST COUNT       random falls, every second one meets balls
// VERSION: of the solver, for all; 0: what each file says, and the latest for random motions.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/bake/bake.h"
#if __has_include("engine/exchange/bvh/bvh_file.h")
#include "engine/exchange/bvh/bvh_file.h"
#else  // of older commits
#include "engine/exchange/bvh/bvh_read.h"
#endif
#include "engine/exchange/import/import_project.h"
#include "engine/project/compile.h"
#include "engine/project/project_reader.h"
#include "tests/property/random_fall.h"
#include "tests/property/random_working_region.h"

namespace hazumi::test {
namespace {

class Hash {
 public:
  void Add(const void* bytes, size_t count) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (size_t i = 0; i < count; ++i) sum_ = (sum_ ^ at[i]) * 1099511628211u;
  }
  void Add(double number) { Add(&number, sizeof number); }
  void Add(const std::string& text) { Add(text.data(), text.size() + 1); }
  template <typename Derived>
  void Add(const Eigen::PlainObjectBase<Derived>& numbers) {
    for (Eigen::Index i = 0; i < numbers.size(); ++i) Add(numbers.data()[i]);
  }
  void Add(const Pose& pose) {
    Add(pose.R);
    Add(pose.p);
  }
  void Add(const MotionLimit& limit) {
    Add(limit.q);
    Add(limit.qd);
    Add(limit.X_WR);
    Add(limit.root_w);
    Add(limit.root_v);
  }
  void Add(const MotionFrame& frame) {
    Add(frame.q);
    Add(frame.X_WR);
    Add(frame.before);
    Add(frame.after);
    Add(frame.com);
    for (const ObjectPose& object : frame.objects) Add(object.X_WO);
    if (frame.acceleration) {
      Add(frame.acceleration->qdd);
      Add(frame.acceleration->root_alpha);
      Add(frame.acceleration->root_a);
    }
    for (const double force : frame.constraint_forces) Add(force);
    for (const Wrench& push : frame.constraint_pushes) {
      Add(push.force);
      Add(push.moment);
    }
    for (const ContactPush& push : frame.contacts.pushes) {
      Add(push.p);
      Add(push.force);
    }
  }
  void Add(const RegionReport& report) {
    for (const int number : {report.steps, report.evaluations}) Add(static_cast<double>(number));
    Add(report.error_estimate);
    Add(report.estimated_until.value_or(-1.0));
    Add(report.branches_from.value_or(-1.0));
    if (!report.energy) return;
    const EnergyBalance& energy = *report.energy;
    for (const double joules :
         {energy.kinetic_start, energy.kinetic_end, energy.potential_start, energy.potential_end,
          energy.limits, energy.impacts, energy.keyed}) {
      Add(joules);
    }
    for (const EnergyBalance::Work& work : energy.laws) {
      Add(work.law);
      Add(work.joules);
    }
  }
  unsigned long long sum() const { return sum_; }

 private:
  uint64_t sum_ = 14695981039346656037u;
};

int solver_version = 0;

void Print(const std::string& name, Animation animation) {
  if (solver_version > 0) animation.solver.version = solver_version;
  BakeOptions options;
  options.energy = options.seams = options.accelerations = true;
  options.threads = 1;
  options.most_work = 2e6;
  const Result<Motion> motion = Bake(animation, options);
  Hash frames, reports;
  if (motion.ok()) {
    for (const MotionFrame& frame : motion.value().frames) frames.Add(frame);
    for (const MotionEvent& event : motion.value().events) {
      for (const double number : {event.time, event.last_time, 1.0 * event.count}) {
        reports.Add(number);
      }
      for (const std::string& text : {event.joint, event.link, event.on}) reports.Add(text);
    }
    for (const RegionReport& report : motion.value().regions) reports.Add(report);
    for (const Warning& warning : motion.value().warnings) reports.Add(warning.message);
  } else {
    reports.Add(motion.error().message);
  }
  std::printf("%s %016llx %016llx\n", name.c_str(), frames.sum(), reports.sum());
  std::fflush(stdout);
}

Animation FallOf(int seed) {
  const auto number = static_cast<uint64_t>(seed);
  Animation animation = RandomFall(number, static_cast<Terrain>(seed % 3));
  if (seed % 2 == 1) DropBalls(number, &animation);
  return animation;
}

// Up to nine hinges of the longest chain of a figure, from its end.
std::vector<JointRef> EndOfLongestChain(const Figure& figure) {
  int deepest = 0, most = 0;
  for (int j = 0; j < figure.num_joints(); ++j) {
    int depth = 0;
    for (JointIndex at(j); at.is_valid(); at = figure.joint(at).parent) ++depth;
    if (depth > most) deepest = j;
    most = std::max(most, depth);
  }
  std::vector<JointRef> joints;
  for (JointIndex at(deepest); at.is_valid() && joints.size() < 9; at = figure.joint(at).parent) {
    joints.push_back({figure.joint(at).name, false, {}});
  }
  return joints;
}

// The project of a capture whose longest chain is limp for its middle third.
Result<Project> CaptureWithRegion(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const Result<Character> character = ReadBvh(text, file);
  if (!character.ok()) return character.error();
  Result<Imported> imported = ImportProject(character.value(), {});
  if (!imported.ok()) return imported.error();
  Project& project = imported.value().project;
  const Result<Compiled> compiled = CompileAnimation(project);
  if (!compiled.ok()) return compiled.error();
  const Animation& animation = compiled.value().animation;
  const int length = animation.last_frame - animation.first_frame;
  ProjectRegion region;
  region.name = "limp";
  region.first_frame = animation.first_frame + length / 3;
  region.last_frame = animation.first_frame + 2 * length / 3;
  region.joints = EndOfLongestChain(*animation.figure);
  region.friction.default_factor = 0.95;
  if (length >= 3) project.regions.push_back(std::move(region));
  return std::move(project);
}

void PrintProject(const std::string& name, const Result<Project>& project) {
  const Result<Compiled> compiled =
      project.ok() ? CompileAnimation(project.value()) : Result<Compiled>(project.error());
  if (compiled.ok()) return Print(name, compiled.value().animation);
  std::printf("%s cannot be read\n", name.c_str());
}

int Run(int argc, char** argv) {
  if (argc < 2) return 2;
  solver_version = std::atoi(argv[1]);
  --argc;
  ++argv;
  if (argc > 1 && std::string(argv[1]) == "--captures") {
    for (int i = 2; i < argc; ++i) PrintProject(argv[i], CaptureWithRegion(argv[i]));
    return 0;
  }
  const std::string kind = argc == 4 ? argv[1] : "";
  if (kind == "--working" || kind == "--falls") {
    const int first = std::atoi(argv[2]), end = first + std::atoi(argv[3]);
    for (int seed = first; seed < end; ++seed) {
      Print(kind.substr(2) + " " + std::to_string(seed),
            kind == "--falls" ? FallOf(seed)
                              : RandomWorkingRegion(static_cast<uint64_t>(seed)).animation);
    }
    return 0;
  }
  for (int i = 1; i < argc; ++i) PrintProject(argv[i], LoadProject(argv[i]));
  return 0;
}

}  // namespace
}  // namespace hazumi::test

int main(int argc, char** argv) { return hazumi::test::Run(argc, argv); }
