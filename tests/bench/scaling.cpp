#include <cstdio>

#include "tests/bench/growing_figures.h"
#include "tests/bench/questions.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/tables.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

constexpr double kBatchSeconds = 0.002;
constexpr int kQuestions = 4;
constexpr int kLargestToCheck = 50;  // joints

struct Method {
  NamedMaker maker;
  int largest_chain, largest_tree;  // joints, beyond which it is not feasible
};

// MuJoCo's reader refuses deeper nests of bodies; DART builds its skeletons in quadratic time.
const std::vector<Method> kMethods = {{{"hazumi_paper_way", MakeHazumiPaperWay}, 500, 500},
                                      {{"hazumi_composite", MakeHazumiComposite}, 1000, 1000},
                                      {{"hazumi_articulated", MakeHazumi}, 10000, 10000},
                                      {{"mujoco", MakeMujoco}, 90, 2000},
                                      {{"simbody", MakeSimbody}, 10000, 10000},
                                      {{"bullet", MakeBullet}, 10000, 10000},
                                      {{"dart", MakeDart}, 1000, 1000}};

struct Timed {
  std::string name;
  std::unique_ptr<Subject> subject;
  LeastTime time;
};

void PrintFigure(const Figure& figure, const char* shape, int Method::*largest, int rounds) {
  const int joints = figure.num_joints();
  const std::vector<Question> questions = RandomQuestions(figure, kQuestions);
  std::vector<Timed> all;
  for (const Method& method : kMethods) {
    if (joints > method.*largest) continue;
    if (joints <= kLargestToCheck) DemandAgreement(method.maker, figure);
    all.push_back({method.maker.name, method.maker.make(figure), {}});
  }
  VecX qdd(joints);
  for (int round = 0; round < rounds; ++round) {
    for (Timed& timed : all) {
      timed.time.Round(kBatchSeconds, [&](long i) {
        timed.subject->ForwardDynamics(questions[i % kQuestions], &qdd);
        KeepAlive(qdd);
      });
    }
  }
  for (const Timed& timed : all) {
    std::printf("%s,%s,%d,%.4g\n", timed.name.c_str(), shape, joints, timed.time.microseconds());
  }
}

}  // namespace

void PrintScaling(int rounds) {
  std::puts("method,shape,joints,microseconds");
  for (const int joints : {1, 2, 5, 10, 20, 50, 90, 200, 500, 1000, 2000, 5000, 10000}) {
    PrintFigure(Chain(joints), "chain", &Method::largest_chain, rounds);
    PrintFigure(BinaryTree(joints), "tree", &Method::largest_tree, rounds);
  }
  PrintFigure(test::Arm7(), "arm7", &Method::largest_chain, rounds);
  PrintFigure(test::Human37(), "human37", &Method::largest_tree, rounds);
}

}  // namespace hazumi::bench
