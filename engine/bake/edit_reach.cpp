// A curve between two keys depends on those two and on the tangents there, a tangent on the keys
// before and behind it, and all that on whether a region or a blend takes over there.

#include "engine/bake/edit_reach.h"

#include <algorithm>
#include <iterator>

namespace hazumi {

EditReach EditReach::Everything() {
  EditReach reach;
  reach.Include(-kEver);
  reach.Include(kEver);
  return reach;
}

void EditReach::Include(double frame) {
  first_ = std::min(first_, frame);
  last_ = std::max(last_, frame);
}

// The tangent at the key before the first that differs looks ahead to it, so that the curve can
// differ from the one before that on. What leads to the first key may come from anywhere.
bool EditReach::IncludeKeys(const Keys& before, const Keys& after) {
  const auto [old_first, new_first] =
      std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  if (old_first == before.end() && new_first == after.end()) return false;
  const auto first = old_first - before.begin();
  Include(first < 2 ? -kEver : before[first - 2].frame);
  const auto [old_last, new_last] =
      std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend());
  if (old_last != before.rend()) Include(old_last->frame);
  if (new_last != after.rend()) Include(new_last->frame);
  return true;
}

void EditReach::IncludeRegion(const DynamicsRegion& region, const Animation& animation) {
  Include(region.last_frame);
  // The curves arrive at the first frame with other tangents.
  const auto include_arrival = [&](const Keys& keys) {
    const auto is_before = [](const Key& key, double frame) { return key.frame < frame; };
    const auto key = std::lower_bound(keys.begin(), keys.end(), region.first_frame, is_before);
    Include(key == keys.begin() ? -kEver : std::prev(key)->frame);
  };
  for (const JointIndex j : region.joints) include_arrival(animation.joint_keys[j.value()]);
  for (int c = kRootAngleZ; c < kNumRootCurves && region.root; ++c) {
    include_arrival(animation.root_keys[c]);
  }
}

// A blend leads in one piece from where its region ends to its target, beyond all keys that it
// passes over: an edit that reaches into it reaches back to its start.
void EditReach::IncludeBlends(const Animation& animation) {
  struct Blend {
    double start, end;
  };
  std::vector<Blend> blends;
  for (const DynamicsRegion& region : animation.regions) {
    const double start = region.last_frame, end = start + region.blend_frames;
    if (start < end && start < first_) blends.push_back({start, end});
  }
  // The latest first: what one reaches back to may lie in an earlier one.
  std::sort(blends.begin(), blends.end(),
            [](const Blend& a, const Blend& b) { return a.start > b.start; });
  for (const Blend& blend : blends) {
    if (blend.start < first_ && first_ < blend.end) Include(blend.start);
  }
}

}  // namespace hazumi
