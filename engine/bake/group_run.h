#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "engine/bake/attachment_cache.h"
#include "engine/bake/group_numbers.h"
#include "engine/passive/exact_solver.h"

namespace hazumi {

// The solution of one group at work: it answers one question after the other, the same ones always
// in the same way.
class GroupRun {
 public:
  // `attachments` must outlive it.
  GroupRun(const GroupTask& task, AttachmentCache* attachments);

  // Gives up where `cancel` is set; the answer is of no use then.
  Numbers Answer(const Numbers& question, const std::atomic<bool>* cancel);

  // So far.
  long evaluations() const { return dynamics_.evaluations(); }
  long steps() const { return solver_.steps(); }

 private:
  using Instant = std::chrono::steady_clock::time_point;

  void Begin(const double* arguments);
  void Drive(const double* arguments);
  void Attach(double t, double end);
  Numbers Advance(double t, double end);
  Numbers AdvanceAhead(const Numbers& question, const std::atomic<bool>* cancel);
  Numbers Progress(Instant since, const std::optional<ExactFailure>& stuck);
  Numbers Sample(double t);

  double gravity_;
  AttachmentCache* attachments_;
  size_t num_curves_ = 0;  // read by the model, which numbers them itself
  DrivenMotion driven_;
  RegionDynamics dynamics_;
  ExactSolver solver_;
};

}  // namespace hazumi
