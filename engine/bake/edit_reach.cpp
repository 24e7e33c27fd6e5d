// A curve between two keys depends on those two and on the tangents there, a tangent on the keys
// before and behind it, and all that on whether a region or a blend takes over there.

#include "engine/bake/edit_reach.h"

#include <algorithm>
#include <iterator>

namespace hazumi {

namespace {

// First key of the run that leads to key `i`, or just that key.
size_t FirstOfRun(const Keys& keys, size_t i) {
  while (i > 0 && IsOfRun(keys[i - 1].interpolation)) --i;
  return i;
}
// Frame of the last key of the run that goes on from key `i`, or just that key's.
double EndOfRun(const Keys& keys, std::ptrdiff_t i) {
  size_t last = static_cast<size_t>(i);
  while (last + 1 < keys.size() && IsOfRun(keys[last].interpolation)) ++last;
  return keys[last].frame;
}

}  // namespace

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
  const size_t differs = static_cast<size_t>(old_first - before.begin());
  const size_t tangent = differs == 0 ? 0 : FirstOfRun(before, differs - 1);
  Include(tangent == 0 ? -kEver : before[tangent - 1].frame);
  const auto [old_last, new_last] =
      std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend());
  if (old_last != before.rend()) Include(EndOfRun(before, old_last.base() - before.begin() - 1));
  if (new_last != after.rend()) Include(EndOfRun(after, new_last.base() - after.begin() - 1));
  return true;
}

void EditReach::IncludeRegion(const DynamicsRegion& region, const Animation& animation) {
  Include(region.last_frame);
  // The curves arrive at the first frame with other tangents.
  const auto include_arrival = [&](const Keys& keys) {
    const auto is_before = [](const Key& key, double frame) { return key.frame < frame; };
    const auto key = std::lower_bound(keys.begin(), keys.end(), region.first_frame, is_before);
    const size_t first = FirstOfRun(keys, static_cast<size_t>(key - keys.begin()));
    Include(first == 0 ? -kEver : keys[first - 1].frame);
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
