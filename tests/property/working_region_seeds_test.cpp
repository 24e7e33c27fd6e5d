// Working regions, by their seeds, which are hard in one way each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/bake/bake.h"
#include "engine/spatial/degrees.h"
#include "tests/property/working_region_trials.h"

namespace hazumi::test {
namespace {

void ExpectClose(int seed) {
  const Trial trial = Try(RandomWorkingRegion(static_cast<uint64_t>(seed)).animation);
  EXPECT_EQ(trial.outcome, Outcome::kCompared) << "seed " << seed << ": " << trial.message;
  EXPECT_LT(trial.error, kTolerance) << "seed " << seed;
  EXPECT_LT(trial.apart, kTolerance) << "seed " << seed;
}

// Ball joints that limits lead straight through a pole, whose middle axis points the other way from
// there on for torques too.
TEST(WorkingRegion, GoesOnBeyondAPole) {
  Trials trials;
  for (const int seed : {134, 275, 652}) trials.Add(seed);
  trials.Expect();
}

// An outer hinge of a ball joint has to let go of its limit within half a millisecond before the
// joint passes a pole, between the usual looks into a step.
TEST(WorkingRegion, LetsGoNextToAPole) {
  Trials trials;
  trials.Add(940000431);
  trials.Expect();
}

// Hinges that an impact pushes off their limits and that are back at once: the others feel what
// stops them, or are off by what no estimate shows.
TEST(WorkingRegion, KeepsMomentumWhereHingesFallBack) {
  for (const int seed : {940000439, 940000509, 940000746, 970000045}) ExpectClose(seed);
}

// Some thirty hinges that meet their limits one after the other, in less than 1/30 s.
TEST(WorkingRegion, DoesNotStopHingesThatOnlyPassTheirLimits) {
  for (const int seed : {980000685, 982000032, 982000150}) ExpectClose(seed);
}

// A hinge that has just been let go when another one is struck, which throws it off its limit.
TEST(WorkingRegion, LimitsDoNotPullAgainstAnImpact) { ExpectClose(986000191); }

// A hinge that a pole has thrown out of its limits, whose limit follows it in until it turns.
TEST(WorkingRegion, HoldsHingesThatAreOutsideWhereTheyTurn) { ExpectClose(986000411); }

// A hinge that is back at its limit slowly, just where a step ends.
TEST(WorkingRegion, HitsALimitWhereverAStepEnds) {
  for (const int seed : {987000012, 990000157}) ExpectClose(seed);
}

// Vibration so fast that the solution is no nearer to the truth than to the control solution.
TEST(WorkingRegion, TakesFinerStepsFromHalfTheToleranceOn) { ExpectClose(995000661); }

// Motion so sensitive that errors of 1e-7 degrees are enough, where ends of curves decide the
// steps: the control solution takes the same ones.
TEST(WorkingRegion, EstimatesErrorsOfStepsThatEndsDecide) { ExpectClose(990000058); }

// A figure that rolls over its pinned joint, and comes away from the ground for 2 ms.
TEST(WorkingRegion, TakesOffBriefly) { ExpectClose(991000070); }

// A figure whose pin has to pull while it sinks: until a link that swings past is its lowest one
// for less than a millisecond; while what a contact of its region holds sinks by rounding; and from
// 2 ms after its pin begins to.
TEST(WorkingRegion, TakesOffWhereAnyLinkRises) {
  for (const int seed : {997000250, 996000737, 998000047}) ExpectClose(seed);
}

// A sliding point that leaves the ground, where friction wedges it: an impact would stop it however
// slowly it approached, as rounding lets it.
TEST(WorkingRegion, LeavesTheGroundWithoutAnImpact) { ExpectClose(992000293); }

// A figure that took off from inside an obstacle, and that a jump of its keys takes out of it.
TEST(WorkingRegion, LandsWhereItTookOffFromInside) { ExpectClose(993000339); }

// A pinned figure that nothing moves: its pin's force is rounding, by which it took off or did not.
TEST(WorkingRegion, StaysOnAPinWithoutForce) { ExpectClose(994000734); }

// A joint that its muscles pull with all they can turns back: their strength has a kink there.
TEST(WorkingRegion, KeepsItsToleranceWhereStrengthHasAKink) { ExpectClose(994000788); }

// Such a hinge whirls round a pole, and seems to turn again and again.
TEST(WorkingRegion, PassesAPoleOutsideItsLimits) { ExpectClose(989000391); }

void ExpectWarning(int seed, const char* words) {
  Animation animation = RandomWorkingRegion(static_cast<uint64_t>(seed)).animation;
  animation.solver.tolerance = kTolerance * kDegree;
  const Result<Motion> motion = Bake(animation);
  ASSERT_TRUE(motion.ok());
  const auto says = [&](const Warning& warning) {
    return warning.message.find(words) != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(motion.value().warnings.begin(), motion.value().warnings.end(), says));
}

// Steps a million times as fine as the first ones do no better.
TEST(WorkingRegion, SaysWhereTheFinestStepsDoNotHelp) {
  ExpectWarning(987000688, "finer steps do not help");
}

// Steps that fine take too much work, so that nothing confirms the estimate.
TEST(WorkingRegion, SaysWhereFinerStepsCannotBeSolved) {
  ExpectWarning(993000620, "finer steps cannot be solved");
}

// A figure in flight that a contact of its region holds, next to where another point lands: a
// landing comes first, however deep the first point is held.
TEST(WorkingRegion, LandsBesideAContactThatHoldsIt) { ExpectClose(988000778); }

// Friction wedges a body against the ground so that no push is enough: the motion is unknown from
// there on.
TEST(WorkingRegion, SaysWhereAnImpactHasNoSolution) {
  constexpr double kWedged = 21.1705;  // [frame]
  const Result<Motion> motion = Bake(RandomWorkingRegion(982000230).animation);
  ASSERT_TRUE(motion.ok());
  ASSERT_TRUE(motion.value().regions[0].branches_from.has_value());
  EXPECT_NEAR(*motion.value().regions[0].branches_from, kWedged, 1e-3);
}

// A foot that landed and is pinned: a contact straight below its pin might push with anything, and
// stop the foot by friction.
TEST(WorkingRegion, HasNoFrictionStraightBelowAPin) { ExpectClose(980000057); }

// The force of a pin between two events that are 2e-12 s apart, which is rounding.
TEST(WorkingRegion, StandsBetweenTwoEvents) { ExpectClose(980000747); }

// A step that blows up, whose error has a square that is no number.
TEST(WorkingRegion, TakesNoStepThatBlowsUp) {
  const Trial trial = Try(RandomWorkingRegion(980000112).animation);
  EXPECT_NE(trial.outcome, Outcome::kFailed) << trial.message;
}

// A hinge that a constraint holds at its limit, too, and that moves by rounding alone.
TEST(WorkingRegion, IsNotLedRoundInCirclesByAHingeThatAConstraintHolds) { ExpectClose(981000299); }

// Nothing moves, nothing presses the limits, and steps grow from one to the next: they stay finite,
// and limits do not let go of what they need not hold.
TEST(WorkingRegion, RestsAtLimitsThatNothingPresses) { ExpectClose(981000445); }

// A hinge that leaves its limit for less than rounding and comes back: it meets it once.
TEST(WorkingRegion, ComesBackToALimitThatItHardlyLeft) {
  for (const int seed : {982000532, 984000078, 984001601}) ExpectClose(seed);
}

// A figure that takes off 0.01 ms after it has landed.
TEST(WorkingRegion, TakesOffAsSoonAsItHasLanded) { ExpectClose(984000492); }

// A figure that took off 0.1 m deep inside the ground, and is outside by 3 mm between two steps:
// from then on it may land.
TEST(WorkingRegion, LandsOnceItHasBeenOutside) {
  constexpr double kLanding = 14.546;  // [frame]
  const Animation animation = RandomWorkingRegion(984000229).animation;
  const Result<Motion> motion = Bake(animation);
  ASSERT_TRUE(motion.ok());
  const std::vector<MotionEvent>& events = motion.value().events;
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [&](const MotionEvent& event) {
    return event.kind == EventKind::kLanding &&
           std::abs(animation.rate.FrameAt(event.time) - kLanding) < 1e-3;
  }));
}

// The rules of the solver's version hold for a region without contacts, too.
TEST(WorkingRegion, LooksForNoReleaseNextToAPoleInVersionOne) {
  Animation animation = RandomWorkingRegion(940000431).animation;
  ASSERT_FALSE(animation.regions[0].touches_scene || animation.regions[0].touches_self);
  const Result<Motion> two = Bake(animation);
  animation.solver.version = 1;
  const Result<Motion> one = Bake(animation);
  ASSERT_TRUE(one.ok() && two.ok());
  EXPECT_GT(FurthestApart(animation, one.value(), two.value(), HUGE_VAL), 10.0);  // [deg]
}

// Finer steps do not help, or only show that what stays of the coarser ones was off by more than
// they estimated.
TEST(WorkingRegion, SaysWhereAnEstimateWasTooSmall) {
  const Trial trial = Try(RandomWorkingRegion(997000623).animation);
  EXPECT_GT(trial.error, kTolerance);
  EXPECT_TRUE(trial.is_reported);
}

// Constraints and contacts that have no hold but for rounding, as limits hold the joints that they
// could move.
TEST(WorkingRegion, GoesOnWhereConstraintsAndContactsHaveNoHold) {
  Trials trials;
  for (const int seed : {17, 18, 20, 48, 160}) trials.Add(seed);
  trials.Expect();
}

// A capsule that slides off an edge of a box by the edge's end.
TEST(WorkingRegion, LetsGoWhereAnEdgeEnds) {
  Trials trials;
  trials.Add(65);
  trials.Expect();
}

// A pin whose figure would sink if it took off; landings at next to no speed; take-offs from within
// the ground; a limb that contacts hold while the figure takes off. All of these were decided by
// rounding.
TEST(WorkingRegion, TakesOffAndLandsAtTheRightTime) {
  Trials trials;
  for (const int seed : {900004, 900452, 900500, 900519, 900843}) trials.Add(seed);
  trials.Expect();
}

// Friction that turns, and a limb that constraints hold straight, between the stages of a step. Its
// error estimate did not show it; the account of energy did.
TEST(WorkingRegion, ClosesItsAccountWhereFrictionTurnsWithinAStep) {
  Trials trials;
  for (const int seed : {900051, 900057, 900196, 900440, 900466}) trials.Add(seed);
  trials.Expect();
}

// Errors that the control solution makes as well, so that no estimate shows them. The first: at an
// event the push of a lone contact was 0 but for rounding, and it pulled from there to the end of
// the step. The second and, with finer steps, the third: a flying figure landed on a foot that a
// contact of the region held, as that sank by the error of the solution.
TEST(WorkingRegion, NeitherPullsNorLandsByContactsThatHardlyPush) {
  Trials trials;
  for (const int seed : {930501128, 930501516, 940000031}) trials.Add(seed);
  trials.Expect();
}

// A pin holds what would sink at once; a take-off takes some time.
TEST(WorkingRegion, DoesNotTakeOffAndLandInOneInstant) {
  constexpr double kInstant = 1e-9;  // [s]
  const Result<Motion> motion = Bake(RandomWorkingRegion(900004).animation);
  ASSERT_TRUE(motion.ok());
  double took_off = -1.0;
  int landings = 0;
  for (const MotionEvent& event : motion.value().events) {
    if (event.kind == EventKind::kTakeOff) took_off = event.time;
    if (event.kind != EventKind::kLanding) continue;
    ++landings;
    EXPECT_GT(event.time - took_off, kInstant) << "at " << event.time << " s";
  }
  EXPECT_GE(landings, 3);
}

// Limits that push each other off in turn, whose hits come faster and faster; a contact that lets
// go while a constraint yields; limits that let go in flight or of a carrier that is moved, where
// it is told from a moment later which of them do.
TEST(WorkingRegion, KeepsItsToleranceWhereHitsAndReleasesCrowd) {
  Trials trials;
  for (const int seed : {143, 164, 56, 276}) trials.Add(seed);
  trials.Expect();
}

}  // namespace
}  // namespace hazumi::test
