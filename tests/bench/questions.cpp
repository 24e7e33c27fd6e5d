#include "tests/bench/questions.h"

#include <cstdio>
#include <cstdlib>

#include "tests/support/random.h"
#include "tests/support/random_tree.h"

namespace hazumi::bench {

namespace {

constexpr double kTolerance = 1e-9;
constexpr int kQuestionsToAgreeOn = 5;

double RelativeDifference(const MatX& actual, const MatX& expected, double size) {
  const double difference = (actual - expected).cwiseAbs().maxCoeff();
  return actual.allFinite() ? difference / size : HUGE_VAL;
}

double RelativeDifference(const MatX& actual, const MatX& expected) {
  return RelativeDifference(actual, expected, expected.cwiseAbs().maxCoeff());
}

void Demand(bool agree, const std::string& name, const Figure& figure, const char* call,
            double difference) {
  if (agree) return;
  std::fprintf(stderr, "%s disagrees on the %s of %s by %.3g of its size\n", name.c_str(), call,
               figure.name().c_str(), difference);
  std::exit(1);
}

}  // namespace

std::vector<Question> RandomQuestions(const Figure& figure, int count) {
  test::Random random(1);
  std::vector<Question> questions(count);
  for (Question& question : questions) {
    question.q = test::RandomAngles(figure, &random);
    question.qd = random.Vector(figure.num_joints(), 5.0);
    question.qdd = random.Vector(figure.num_joints(), 50.0);
    question.tau = random.Vector(figure.num_joints(), 50.0);
  }
  return questions;
}

void DemandAgreement(const NamedMaker& maker, const Figure& figure) {
  const int n = figure.num_joints();
  const std::unique_ptr<Subject> subject = maker.make(figure), ours = MakeHazumi(figure),
                                 dense = MakeHazumiPaperWay(figure);
  VecX actual(n), expected(n);
  MatX H_actual(n, n), H_expected(n, n);
  const auto check = [&](const char* call, double difference) {
    Demand(difference <= kTolerance, maker.name, figure, call, difference);
  };
  for (const Question& at : RandomQuestions(figure, kQuestionsToAgreeOn)) {
    ours->Bias(at, &expected);
    if (subject->Bias(at, &actual)) check("bias", RelativeDifference(actual, expected));
    ours->InverseDynamics(at, &expected);
    if (subject->InverseDynamics(at, &actual)) {
      check("inverse dynamics", RelativeDifference(actual, expected));
    }
    dense->InertiaMatrix(at, &H_expected);
    if (subject->InertiaMatrix(at, &H_actual)) {
      check("inertia matrix", RelativeDifference(H_actual, H_expected));
    }
  }
  DemandForwardAgreement(maker, figure);
}

void DemandForwardAgreement(const NamedMaker& maker, const Figure& figure) {
  DemandForwardAgreement(maker.name, maker.make(figure).get(), figure,
                         RandomQuestions(figure, kQuestionsToAgreeOn));
}

void DemandForwardAgreement(const std::string& name, Subject* subject, const Figure& figure,
                            std::vector<Question> questions) {
  const int n = figure.num_joints();
  const std::unique_ptr<Subject> ours = MakeHazumi(figure), dense = MakeHazumiPaperWay(figure);
  VecX tau(n), bias(n);
  MatX H(n, n);
  for (Question& at : questions) {
    if (!subject->ForwardDynamics(at, &at.qdd)) return;
    ours->InverseDynamics(at, &tau);
    ours->Bias(at, &bias);
    dense->InertiaMatrix(at, &H);
    const double inertial = (H.cwiseAbs() * at.qdd.cwiseAbs()).maxCoeff();
    const double size = std::max(bias.cwiseAbs().maxCoeff(), inertial);
    const double difference = RelativeDifference(tau, at.tau, size);
    Demand(difference <= kTolerance, name, figure, "forward dynamics", difference);
  }
}

}  // namespace hazumi::bench
