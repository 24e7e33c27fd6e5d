#include <cstdio>

#include "tests/bench/growing_figures.h"
#include "tests/bench/questions.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/tables.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

constexpr double kBatchSeconds = 0.005;
constexpr int kQuestions = 4;
constexpr int kLargestToCheck = 50;  // joints

struct Method {
  NamedMaker maker;
  int largest_chain, largest_tree;  // joints, beyond which it is not feasible
};

// MuJoCo's reader refuses deeper nests of bodies; DART builds its skeletons in quadratic time.
const std::vector<Method> kMethods = {{{"hazumi_paper_way", MakeHazumiPaperWay}, 500, 500},
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

// A figure with every method that can have it.
class Contest {
 public:
  Contest(const char* shape, Figure figure, int Method::*largest);

  void Round();
  void Print() const;

 private:
  const char* shape_;
  std::unique_ptr<const Figure> figure_;  // stays where the subjects look for it
  std::vector<Question> questions_;
  std::vector<Timed> methods_;
  VecX qdd_;
};

Contest::Contest(const char* shape, Figure figure, int Method::*largest)
    : shape_(shape),
      figure_(std::make_unique<Figure>(std::move(figure))),
      questions_(RandomQuestions(*figure_, kQuestions)),
      qdd_(figure_->num_joints()) {
  for (const Method& method : kMethods) {
    if (figure_->num_joints() > method.*largest) continue;
    if (figure_->num_joints() <= kLargestToCheck) DemandAgreement(method.maker, *figure_);
    methods_.push_back({method.maker.name, method.maker.make(*figure_), {}});
  }
}

void Contest::Round() {
  for (Timed& timed : methods_) {
    timed.subject->ForwardDynamics(questions_[0], &qdd_);  // fetches its memory; not timed
    timed.time.Round(kBatchSeconds, [&](long i) {
      timed.subject->ForwardDynamics(questions_[i % kQuestions], &qdd_);
      KeepAlive(qdd_);
    });
  }
}

void Contest::Print() const {
  for (const Timed& timed : methods_) {
    std::printf("%s,%s,%d,%.4g\n", timed.name.c_str(), shape_, figure_->num_joints(),
                timed.time.microseconds());
  }
}

}  // namespace

// The rounds go over all figures, so that a burst of other work on the machine spoils none of them.
void PrintScaling(int rounds) {
  std::vector<Contest> all;
  for (const int joints : {1, 2, 5, 10, 20, 50, 90, 200, 500, 1000, 2000, 5000, 10000}) {
    all.emplace_back("chain", Chain(joints), &Method::largest_chain);
    all.emplace_back("tree", BinaryTree(joints), &Method::largest_tree);
  }
  all.emplace_back("arm7", test::Arm7(), &Method::largest_chain);
  all.emplace_back("human37", test::Human37(), &Method::largest_tree);
  for (int round = 0; round < rounds; ++round) {
    for (Contest& contest : all) contest.Round();
  }
  std::puts("method,shape,joints,microseconds");
  for (const Contest& contest : all) contest.Print();
  PrintRegionScaling(rounds);
}

}  // namespace hazumi::bench
