#include <cstdio>

#include "tests/bench/questions.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/tables.h"
#include "tests/support/figures.h"

namespace hazumi::bench {

namespace {

constexpr double kBatchSeconds = 0.004;
constexpr int kQuestions = 16;  // asked in turn, so that nothing is remembered from the last call

const std::vector<NamedMaker> kSubjects = {
    {"mujoco", MakeMujoco},   {"hazumi", MakeHazumi}, {"hazumi_paper_way", MakeHazumiPaperWay},
    {"simbody", MakeSimbody}, {"bullet", MakeBullet}, {"dart", MakeDart}};

const std::vector<const char*> kCalls = {"inverse_dynamics", "bias", "inertia_matrix",
                                         "forward_dynamics"};

bool Ask(Subject* subject, size_t call, const Question& question, VecX* answer) {
  switch (call) {
    case 0:
      return subject->InverseDynamics(question, answer);
    case 1:
      return subject->Bias(question, answer);
    case 2:
      return subject->InertiaMatrix(question, nullptr);
    default:
      return subject->ForwardDynamics(question, answer);
  }
}

struct Timed {
  std::unique_ptr<Subject> subject;
  std::vector<LeastTime> calls{kCalls.size()};
};

void Round(const std::vector<Question>& questions, Timed* timed) {
  VecX answer(questions[0].q.size());
  for (size_t call = 0; call < kCalls.size(); ++call) {
    if (!Ask(timed->subject.get(), call, questions[0], &answer)) continue;
    timed->calls[call].Round(kBatchSeconds, [&](long i) {
      Ask(timed->subject.get(), call, questions[i % kQuestions], &answer);
      KeepAlive(answer);
    });
  }
}

void PrintModel(const Figure& figure, int rounds) {
  const std::vector<Question> questions = RandomQuestions(figure, kQuestions);
  std::vector<Timed> all;
  for (const NamedMaker& maker : kSubjects) {
    DemandAgreement(maker, figure);
    all.push_back({maker.make(figure)});
  }
  for (int round = 0; round < rounds; ++round) {
    for (Timed& timed : all) Round(questions, &timed);
  }
  for (size_t call = 0; call < kCalls.size(); ++call) {
    for (size_t i = 0; i < all.size(); ++i) {
      const double us = all[i].calls[call].microseconds();
      if (!std::isfinite(us)) continue;
      std::printf("%s,%s,%s,%.4g,%.3g\n", kSubjects[i].name.c_str(), figure.name().c_str(),
                  kCalls[call], us, us / all[0].calls[call].microseconds());
    }
  }
}

}  // namespace

void PrintCalls(int rounds) {
  std::puts("subject,model,call,microseconds,ratio_to_mujoco");
  PrintModel(test::Human37(), rounds);
  PrintModel(test::Arm7(), rounds);
}

}  // namespace hazumi::bench
