// What an island was asked and answered once is not solved again, unless anything has changed.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "engine/bake/island_curves.h"
#include "engine/bake/island_solution.h"
#include "tests/unit/region/random_island.h"

namespace hazumi::test {
namespace {

// an island and what it is asked first.
struct Case {
  IslandTask task;
  IslandSolution::Tolerance tolerance = {1e-8};
  RotationState state;
  DrivenMotion driven;
  double t = 0.0, end = 0.1;
};

Case AnyCase(uint64_t seed, RootCoupling coupling) {
  auto island = RandomIsland::Of(seed, coupling);
  while (!island) island = RandomIsland::Of(seed += 1000, coupling);  // nothing was free
  const RegionLayout layout(island->model, /*balls=*/true);
  const int k = layout.num_hinges(), n = static_cast<int>(island->driven.angles.size());
  Case c{{island->model,
          island->q.array() - 0.2,
          island->q.array() + 0.2,
          {RetentionSpec{VecX::Constant(k, 0.5)}},
          RandomIsland::kGravity},
         {1e-8},
         {VecX::Zero(n), VecX::Zero(n), {}},
         island->driven};
  for (int i = 0; i < k; ++i) {
    c.state.q[layout.hinges()[i].coordinate] = island->q[i];
    c.state.qd[layout.hinges()[i].coordinate] = island->qd[i];
  }
  return c;
}

// On a root that curves move, carried by driven joints, one of its joints a ball; else the seed is
// of no use here.
Case CarriedCase() {
  for (uint64_t seed = 1;; ++seed) {
    Case c = AnyCase(seed, RootCoupling::kPrescribed);
    bool has_ball = false, has_driven = false;
    for (const ModelNode& node : c.task.model.nodes) {
      has_ball |= node.is_ball;
      has_driven |= node.role == Role::kDriven && !node.is_dynamic;
    }
    if (has_ball && has_driven) return c;
  }
}

IslandSolution SolutionOf(const Case& c, MovingBaseCache* moving_bases) {
  return {std::make_shared<const SharedIsland>(c.task), c.tolerance, moving_bases};
}

void Begin(const Case& c, const KnownLogs* known, IslandSolution* solution) {
  solution->Begin(c.t, c.end, c.state, CurvesOf(c.task.model, c.driven), known);
}

using Log = std::shared_ptr<const IslandLog>;

struct Answers {
  std::vector<VecX> samples;  // angles, then rates
  long evaluations = 0;
  Log log;
};

VecX SampleAt(double t, const Case& c, IslandSolution* solution) {
  RotationState state = c.state;
  solution->Sample(t, &state);
  VecX sample(2 * state.q.size());
  sample << state.q, state.qd;
  return sample;
}

// Step by step: two samples inside each of so many steps, then one on other curves.
Answers Walk(const Case& c, const KnownLogs* known, int steps = 4) {
  MovingBaseCache moving_bases;
  IslandSolution solution = SolutionOf(c, &moving_bases);
  Answers answers;
  const auto sample = [&](double t) { answers.samples.push_back(SampleAt(t, c, &solution)); };
  Begin(c, known, &solution);
  for (int i = 0; i < steps; ++i) {
    solution.Advance(solution.time(), c.end);
    sample(0.5 * (solution.step_start() + solution.time()));
    sample(solution.time());
  }
  DrivenMotion slower = c.driven;
  for (DrivenCurve& curve : slower.angles) curve.c[2] *= 0.5;
  solution.Drive(solution.time(), c.end, CurvesOf(c.task.model, slower));
  solution.Advance(solution.time(), c.end);
  sample(solution.time());
  answers.evaluations = solution.evaluations();
  answers.log = solution.log();
  return answers;
}

KnownLogs Knowing(const Log& log) {
  KnownLogs known;
  known.Add(IslandLogs{log});
  return known;
}

TEST(IslandSolution, AskedTheSameAgainAnswersTheSameBitsWithoutSolving) {
  for (const RootCoupling coupling : {RootCoupling::kPrescribed, RootCoupling::kFlight}) {
    for (const uint64_t seed : {1, 2, 3, 4}) {
      const Case c = AnyCase(seed, coupling);
      const KnownLogs nothing;
      const Answers first = Walk(c, &nothing);
      const KnownLogs known = Knowing(first.log);
      const Answers again = Walk(c, &known);
      EXPECT_EQ(again.samples, first.samples) << "seed " << seed;
      EXPECT_EQ(again.evaluations, first.evaluations) << "seed " << seed;
      EXPECT_EQ(again.log, first.log) << "seed " << seed;
      EXPECT_GE(first.evaluations, 50);
    }
  }
}

// The log is believed: an answer that was tampered with comes back.
TEST(IslandSolution, TakesItsAnswersFromTheLog) {
  const Case c = CarriedCase();
  const KnownLogs nothing;
  auto log = std::make_shared<IslandLog>(*Walk(c, &nothing).log);
  IslandCall& sample = (*log)[2];
  ASSERT_TRUE(std::holds_alternative<SampleIsland>(sample.request));
  std::get<IslandSamples>(sample.result).hinges[0] = 12345.0;
  const KnownLogs known = Knowing(log);
  EXPECT_EQ(Walk(c, &known).samples[0].maxCoeff(), 12345.0);
}

TEST(IslandSolution, SolvesWhatWasAskedOnceItIsAskedSomethingElse) {
  const Case c = CarriedCase();
  const KnownLogs nothing;
  const Answers longer = Walk(c, &nothing, 4), shorter = Walk(c, &nothing, 2);
  const KnownLogs known = Knowing(longer.log);
  const Answers departed = Walk(c, &known, 2);
  EXPECT_NE(departed.log, longer.log);
  EXPECT_EQ(departed.samples, shorter.samples);
  EXPECT_EQ(departed.evaluations, shorter.evaluations);
  ASSERT_EQ(departed.log->size(), shorter.log->size());
  for (size_t i = 0; i < shorter.log->size(); ++i) {
    EXPECT_TRUE(SameBits((*departed.log)[i].request, (*shorter.log)[i].request)) << i;
  }
}

TEST(IslandSolution, KeepsNoLogUnlessThereAreKnownOnes) {
  const Case c = CarriedCase();
  const KnownLogs nothing;
  EXPECT_GT(Walk(c, &nothing).log->size(), 10u);
  EXPECT_EQ(Walk(c, nullptr).log->size(), 1u);
  EXPECT_EQ(Walk(c, nullptr).samples, Walk(c, &nothing).samples);
}

TEST(IslandSolution, LooksAheadWithoutSolvingWhereALogKnows) {
  const Case c = CarriedCase();
  const std::vector<double> times = {0.02, 0.05, c.end};
  MovingBaseCache moving_bases;
  const auto look = [&](const KnownLogs& known, bool is_known, double until) {
    IslandSolution solution = SolutionOf(c, &moving_bases);
    Begin(c, &known, &solution);
    const std::vector<double> ahead = {0.02, until, c.end};
    EXPECT_EQ(solution.LookAhead(std::make_shared<const std::vector<double>>(ahead), c.end),
              is_known);
    if (!is_known) solution.SolveAhead(nullptr);
    EXPECT_EQ(solution.time(), c.end);
    const std::vector<VecX> samples = {SampleAt(0.02, c, &solution), SampleAt(c.end, c, &solution)};
    return std::pair(samples, solution.log());
  };
  const auto first = look(KnownLogs(), false, 0.05);
  const auto again = look(Knowing(first.second), true, 0.05);
  EXPECT_EQ(again.first, first.first);
  EXPECT_EQ(again.second, first.second);
  look(Knowing(first.second), false, 0.06);
}

// Whether a case is begun with the question of another one.
bool IsKnown(const Case& c, const KnownLogs& known, const Log& log) {
  MovingBaseCache moving_bases;
  IslandSolution solution = SolutionOf(c, &moving_bases);
  Begin(c, &known, &solution);
  return solution.log() == log;
}

struct Change {
  const char* what;
  std::function<void(Case*)> make;
};

void Nudge(double* value) { *value = std::nextafter(*value, 1e300); }

// The first node of the kind, which CarriedCase has.
ModelNode& FreeNode(Case* c) {
  for (ModelNode& node : c->task.model.nodes) {
    if (node.is_dynamic && node.role == Role::kFree) return node;
  }
  return c->task.model.nodes.back();
}
ModelNode& CarryingNode(Case* c) {
  for (ModelNode& node : c->task.model.nodes) {
    if (!node.is_dynamic && node.role == Role::kDriven) return node;
  }
  return c->task.model.nodes.front();
}
DrivenCurve& CarryingCurve(Case* c) {
  return c->driven.angles[static_cast<size_t>(CarryingNode(c).hinges[0].coordinate)];
}

std::vector<Change> TaskChanges() {
  return {
      {"rates", [](Case* c) { Nudge(&std::get<RetentionSpec>(c->task.forces[0]).rates[0]); }},
      {"forces", [](Case* c) { c->task.forces.clear(); }},
      {"lower", [](Case* c) { Nudge(&c->task.lower[0]); }},
      {"upper", [](Case* c) { Nudge(&c->task.upper[0]); }},
      {"gravity", [](Case* c) { Nudge(&c->task.gravity); }},
      {"step_tolerance", [](Case* c) { Nudge(&c->tolerance.step); }},
      {"solution_tolerance", [](Case* c) { Nudge(&c->tolerance.of_solution); }},
      {"R_root", [](Case* c) { Nudge(&c->task.model.R_root(2, 1)); }},
      {"coupling", [](Case* c) { c->task.model.coupling = RootCoupling::kPinned; }},
      {"pin_node", [](Case* c) { ++c->task.model.pin_node; }},
      {"p_pin", [](Case* c) { Nudge(&c->task.model.p_pin.z()); }},
      {"root_answers", [](Case* c) { c->task.model.root_answers = true; }},
      {"mass", [](Case* c) { Nudge(&c->task.model.mass); }},
      {"num_free", [](Case* c) { ++c->task.model.num_free; }},
      {"num_bodies", [](Case* c) { ++c->task.model.num_bodies; }},
      {"nodes", [](Case* c) { c->task.model.nodes.emplace_back(); }},
      {"parent", [](Case* c) { --FreeNode(c).parent; }},
      {"p_P", [](Case* c) { Nudge(&FreeNode(c).p_P.x()); }},
      {"role", [](Case* c) { c->task.model.nodes[0].role = Role::kFree; }},
      {"num_hinges", [](Case* c) { --CarryingNode(c).num_hinges; }},
      {"is_ball", [](Case* c) { FreeNode(c).is_ball = !FreeNode(c).is_ball; }},
      {"is_dynamic", [](Case* c) { CarryingNode(c).is_dynamic = true; }},
      {"body.mass", [](Case* c) { Nudge(&FreeNode(c).body.mass); }},
      {"body.com", [](Case* c) { Nudge(&FreeNode(c).body.com.y()); }},
      {"body.I_com", [](Case* c) { Nudge(&FreeNode(c).body.I_com(1, 2)); }},
      {"hinge.coordinate", [](Case* c) { ++CarryingNode(c).hinges[0].coordinate; }},
      {"hinge.axis", [](Case* c) { Nudge(&FreeNode(c).hinges[0].axis.x()); }},
      {"hinge.cardinal", [](Case* c) { FreeNode(c).hinges[0].cardinal ^= 1; }},
      {"hinge.sign", [](Case* c) { Nudge(&FreeNode(c).hinges[0].sign); }},
  };
}

std::vector<Change> MotionChanges() {
  return {
      {"t", [](Case* c) { Nudge(&c->t); }},
      {"end", [](Case* c) { Nudge(&c->end); }},
      {"q", [](Case* c) { Nudge(&c->state.q[FreeNode(c).hinges[0].coordinate]); }},
      {"qd", [](Case* c) { Nudge(&c->state.qd[FreeNode(c).hinges[0].coordinate]); }},
      {"curve.start", [](Case* c) { Nudge(&CarryingCurve(c).start); }},
      {"curve.degree", [](Case* c) { CarryingCurve(c).degree = 3; }},
      {"curve.c", [](Case* c) { Nudge(&CarryingCurve(c).c[2]); }},
      {"root_position x", [](Case* c) { Nudge(&c->driven.root_position[0].c[0]); }},
      {"root_position z", [](Case* c) { Nudge(&c->driven.root_position[2].c[2]); }},
  };
}

void ExpectUnknown(const std::vector<Change>& changes) {
  const Case c = CarriedCase();
  const KnownLogs nothing;
  const Log log = Walk(c, &nothing).log;
  const KnownLogs known = Knowing(log);
  ASSERT_TRUE(IsKnown(c, known, log));
  for (const Change& change : changes) {
    Case changed = c;
    change.make(&changed);
    EXPECT_FALSE(IsKnown(changed, known, log)) << change.what;
  }
}

TEST(IslandSolution, SolvesAnewWhenAnyMemberOfItsTaskOrModelChanges) {
  ExpectUnknown(TaskChanges());
}

TEST(IslandSolution, SolvesAnewWhenItsStateTimesOrCurvesChange) { ExpectUnknown(MotionChanges()); }

TEST(IslandSolution, IsNotSolvedAnewForWhatItDoesNotRead) {
  Case c = CarriedCase();
  const KnownLogs nothing;
  const Log log = Walk(c, &nothing).log;
  const KnownLogs known = Knowing(log);
  std::vector<char> is_read(c.driven.angles.size(), 0);
  for (const ModelNode& node : c.task.model.nodes) {
    for (int h = 0; h < node.num_hinges; ++h) is_read[node.hinges[h].coordinate] = 1;
  }
  int unread = 0;
  for (size_t i = 0; i < is_read.size(); ++i) {
    if (is_read[i]) continue;
    ++unread;
    c.driven.angles[i].c[0] += 1.0;
    c.state.q[static_cast<int>(i)] += 1.0;
  }
  EXPECT_GT(unread, 0);
  EXPECT_TRUE(IsKnown(c, known, log));
}

}  // namespace
}  // namespace hazumi::test
