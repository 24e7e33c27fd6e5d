#pragma once

#include <optional>
#include <vector>

#include "engine/passive/exact/active_limits.h"
#include "engine/passive/exact/contact_search.h"
#include "engine/passive/exact/exact_step.h"
#include "engine/passive/exact/frozen_contacts.h"
#include "engine/passive/exact/hit_search.h"
#include "engine/passive/exact/kink_search.h"
#include "engine/passive/exact/release_search.h"

namespace hazumi {

// The passive motion of one island of free joints in continuous time [METHOD 2.1], with its error
// under control: steps of order 8 whose size follows the error (ExactStep), ball joints as
// quaternions, limits found inside the steps (HitSearch), hit inelastically (ActiveLimits) and let
// go when they would have to pull (ReleaseSearch).
//
// Between Advance and the next one the solver is "in" the accepted step: Sample looks inside it.
class ExactSolver {
 public:
  // `dynamics` must outlive the solver. `lower`, `upper`: limits by free hinge [rad].
  ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper);
  ExactSolver(const ExactSolver&) = delete;
  ExactSolver& operator=(const ExactSolver&) = delete;

  // As ExactStep.
  void SetTolerance(double radians) { step_.SetTolerance(radians); }
  void SetLongestStep(double seconds) { step_.SetLongestStep(seconds); }

  // Begins at these angles and rates of the free hinges. A hinge that is outside its limits has a
  // limit where it is until it has come inside.
  void Start(double t, const VecX& q, const VecX& qd, const OuterMotion& outer = {});
  // Goes on from the end of the step with driven curves (or locks, or masses) that have changed.
  void Restart();
  // A pin that moved with v_pin [m/s] was stopped dead: the hinges feel the impulse.
  void FeelPin(const Vec3& v_pin);

  // Advances by one step, at most to `end`. The step ends early where a limit is hit or released,
  // which the next step handles at its beginning. Where the curves hold for longer
  // (DrivenMotion::holds_until), the length of the step does not depend on `end`, and the step is
  // cut there.
  std::optional<ExactFailure> Advance(double end);

  double step_start() const { return step_.start_time(); }
  double time() const { return step_.time(); }
  // Angles and rates of the free hinges at t in [step_start, time]; at `time` itself from the left.
  void Sample(double t, VecX* q, VecX* qd, Gaps gaps = Gaps::kClosed) {
    step_.Sample(t, q, qd, gaps);
  }
  // Of the centre of mass at the same time, if the fall is solved along (RegionDynamics).
  const OuterMotion& SampledOuter() const { return dynamics_->outer(); }
  // At `time`, before impacts.
  const VecX& q() const { return step_.now().q; }
  const VecX& qd() const { return step_.now().qd; }
  // Energy and powers at t in [step_start, time], from the left.
  EnergyFlow Energy(double t) { return step_.Energy(t); }
  // As ExactStep has them; what limits hold has none.
  Vec3 Accelerations(double t, VecX* qd, VecX* qdd) { return step_.Accelerations(t, qd, qdd); }
  // At the same t, after it: as RegionDynamics.
  std::vector<SpentDrive> SpentDrives(double t) { return step_.SpentDrives(t); }

  // Breaks since the last call.
  std::vector<ConstraintBreak> TakeBreaks() { return dynamics_->constraints().TakeBreaks(); }

  // Hits since the last call.
  std::vector<LimitHit> TakeHits() { return log_.TakeHits(); }
  // Touch-downs since the last call.
  std::vector<TouchDown> TakeTouches() { return log_.TakeTouches(); }
  // Events since the last call.
  std::vector<EventMark> TakeMarks() { return log_.TakeMarks(); }
  // Work of impacts since the last call.
  ImpactWork TakeImpactWork() { return log_.TakeWork(); }
  long steps() const { return steps_; }
  // When contacts came too fast for the first time: from there on motions that begin nearly the
  // same end differently, however well they are solved.
  std::optional<double> frozen_from() const { return frozen_from_; }

 private:
  // What happens at `time`, before the next step.
  enum class Next { kGoOn, kGoOnFromCut, kEvent };

  void MakeEventHappen();
  bool has_implicit_springs() const {
    return dynamics_->has_implicit_springs() && dynamics_->contacts().is_possible();
  }
  bool may_freeze() const { return has_implicit_springs() || dynamics_->contacts().any_closed(); }
  bool Crawls();
  void Freeze();
  void Thaw();
  std::optional<ExactFailure> TryToAdvance(double end);
  std::optional<ExactFailure> Take(double end);
  std::optional<ExactFailure> AdvanceFrozen(double end);
  void CutAt(double end);
  std::optional<ExactFailure> TakeToFirstContactChange(double end);
  bool HasLargeDefect();
  void Resolve(Vec3 v_pin);
  bool BreakOverloaded();
  bool FindBreak();
  void FindHits();

  RegionDynamics* dynamics_;
  LimitRange range_;
  ExactStep step_;
  ActiveLimits held_;
  HitSearch hit_search_;
  ReleaseSearch release_search_;
  ContactSearch contact_search_;
  KinkSearch kink_search_;
  FrozenContacts frozen_;
  ImpactLog log_;
  Next next_ = Next::kGoOn;
  int breaks_next_ = -1;  // a constraint that is overloaded at `time`
  // Contacts are frozen until then [s]; none: they are not. When they were the first time.
  std::optional<double> frozen_until_, frozen_from_;
  double crawl_start_ = 0.0;  // [s], and the steps up to there
  long crawl_steps_ = 0;
  bool follows_event_ = false;  // the step begins with rates or forces that have jumped
  double first_start_ = 0.0;    // [s]
  long steps_ = 0;
};

}  // namespace hazumi
