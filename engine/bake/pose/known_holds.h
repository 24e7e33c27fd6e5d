#pragma once

#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/members.h"
#include "engine/placement/hold_solver.h"

namespace hazumi {

// What a hold is asked to solve; its answer depends on nothing else.
struct HoldRequest {
  PoseOf<Jet> X_WR;
  HoldTarget target;
  std::vector<Jet> chain;  // as HoldSolver::ChainOf
  double tolerance = 0.0;  // [m]
};
inline auto MembersOf(const HoldRequest& request) {
  const auto& [X_WR, target, chain, tolerance] = request;
  return std::tie(X_WR, target, chain, tolerance);
}

struct HoldResult {
  double distance = 0.0;    // as HoldSolution [m]
  std::vector<Jet> joints;  // as HoldSolver::joints
};

// What holds were asked and what came of it, by hold, frame and side: after an edit most of them
// are asked for the same again.
class KnownHolds {
 public:
  using Place = std::tuple<size_t, double, bool>;  // index of the hold, frame, whether before it

  // Null if something else was asked there, or nothing.
  const HoldResult* Find(const Place& place, const HoldRequest& request) const {
    const auto known = calls_.find(place);
    const bool is_same = known != calls_.end() && SameBits(known->second.request, request);
    return is_same ? &known->second.result : nullptr;
  }

  const HoldResult* Keep(const Place& place, HoldRequest request, HoldResult result) {
    if (calls_.size() >= kMost) calls_.clear();
    Call& call = calls_[place];
    call = {std::move(request), std::move(result)};
    return &call.result;
  }

 private:
  static constexpr size_t kMost = 10000;  // about 10 MB
  struct Call {
    HoldRequest request;
    HoldResult result;
  };
  std::map<Place, Call> calls_;
};

}  // namespace hazumi
