#pragma once

#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/members.h"
#include "engine/region/moving_base.h"

namespace hazumi {

// Everything that the motion of the node which carries an island depends on, from t to `end` [s].
struct Carrier {
  double t = 0.0, end = 0.0;
  double gravity = 0.0;          // along -z [m/s^2]
  int node = 0;                  // of the chain
  std::vector<ModelNode> chain;  // the nodes that move it, with their own curves' numbers
  DrivenMotion curves;
  Mat3 R_root = Mat3::Identity();
  RootCoupling coupling = RootCoupling::kPrescribed;
  int pin_node = -1;
  Vec3 p_pin = Vec3::Zero();
};
inline auto MembersOf(const Carrier& carrier) {
  const auto& [t, end, gravity, node, chain, curves, R_root, coupling, pin_node, p_pin] = carrier;
  return std::tie(t, end, gravity, node, chain, curves, R_root, coupling, pin_node, p_pin);
}

// Of a model, whose nodes before first_moved move the others.
Carrier CarrierOf(const RegionModel& model, int first_moved, double gravity,
                  const DrivenMotion& curves, double t, double end);

// The latest fits of moving bases: islands that hang on one node, and solutions of one island,
// share them. Any thread may ask.
class MovingBaseCache {
 public:
  // `fit`: makes it if it is not there.
  template <typename Fit>
  std::shared_ptr<const MovingBase> Get(Carrier carrier, Fit&& fit) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
      if (SameBits(entry.carrier, carrier)) return entry.moving_base;
    }
    if (entries_.size() == kMost) entries_.erase(entries_.begin());
    entries_.push_back({std::move(carrier), fit()});
    return entries_.back().moving_base;
  }

 private:
  static constexpr size_t kMost = 8;
  struct Entry {
    Carrier carrier;
    std::shared_ptr<const MovingBase> moving_base;
  };
  std::mutex mutex_;
  std::vector<Entry> entries_;  // the oldest first
};

}  // namespace hazumi
