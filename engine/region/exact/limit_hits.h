#pragma once

#include <utility>
#include <vector>

namespace hazumi {

// Hits of one limit that follow each other more closely than this are told as one [s]: two joints
// that press on their limits in turn hit them thousands of times.
constexpr double kChatterGap = 1.0 / 30.0;

// A hinge that reached a limit, `count` times from `time` to `last_time` [s].
struct LimitHit {
  double time, last_time;
  long count;
  int hinge;  // free hinge
};

// What was hit since it was last told.
class LimitHits {
 public:
  explicit LimitHits(int num_hinges) : last_(num_hinges, -1) {}

  void Add(int hinge, double time) {
    int& last = last_[hinge];
    if (last >= 0 && time - hits_[last].last_time < kChatterGap) {
      ++hits_[last].count;
      hits_[last].last_time = time;
      return;
    }
    last = static_cast<int>(hits_.size());
    hits_.push_back({time, time, 1, hinge});
  }

  std::vector<LimitHit> Take() {
    for (const LimitHit& hit : hits_) last_[hit.hinge] = -1;
    return std::exchange(hits_, {});
  }

 private:
  std::vector<LimitHit> hits_;
  std::vector<int> last_;  // by hinge: its latest in hits_; -1: none
};

}  // namespace hazumi
