#include "engine/makers/fills/filled_place.h"

#include <algorithm>
#include <cmath>

#include "engine/makers/fills/filled_joint.h"
#include "engine/makers/fills/generated_keys.h"
#include "engine/solve/band_system.h"

namespace hazumi::makers {

namespace {

// Rate that a key states, per frame.
struct PlaceRate {
  int index;
  double per_frame;
};

// Natural cubic through the keys of a curve, frame by frame: least squares of the second
// differences.
void SmoothPlace(const std::vector<char>& is_known, const std::vector<PlaceRate>& rates,
                 std::vector<double>* values) {
  const int n = static_cast<int>(values->size());
  if (n < 3) return;
  solve::BandSystem system(n, 3);
  for (int t = 1; t + 1 < n; ++t) {
    const size_t at = static_cast<size_t>(t);
    MatX J(1, 3);
    J << 1.0, -2.0, 1.0;
    VecX r = VecX::Constant(1, (*values)[at - 1] - 2.0 * (*values)[at] + (*values)[at + 1]);
    for (int s = -1; s <= 1; ++s) {
      if (is_known[t + s]) J(0, s + 1) = 0.0;
    }
    system.Add(t - 1, J, r);
  }
  for (const PlaceRate& rate : rates) {
    constexpr double kWeight = 100.0;  // of a rate against second differences
    const size_t at = static_cast<size_t>(rate.index);
    MatX J(1, 3);
    J << (is_known[at - 1] ? 0.0 : -0.5 * kWeight), 0.0, (is_known[at + 1] ? 0.0 : 0.5 * kWeight);
    const double now = 0.5 * ((*values)[at + 1] - (*values)[at - 1]);
    system.Add(rate.index - 1, J, VecX::Constant(1, kWeight * (now - rate.per_frame)));
  }
  VecX x;
  if (!system.Solve(0.0, &x)) return;
  for (int t = 0; t < n; ++t) (*values)[static_cast<size_t>(t)] += x[t];
}

}  // namespace

FilledPlace FilledPlaceOf(const Keys& keys, const ProjectFill& fill, const Animation& animation) {
  const int begin = std::max(fill.first_frame, animation.first_frame);
  const int end = std::min(fill.last_frame, animation.last_frame);
  int first = end, last = begin;
  for (const Key& key : keys) {
    if (key.frame < begin || key.frame > end) continue;
    first = std::min(first, static_cast<int>(std::ceil(key.frame)));
    last = std::max(last, static_cast<int>(std::floor(key.frame)));
  }
  if (last <= first) return {};
  std::vector<double> values = SampleAround(keys, 0.0, first, last, animation.rate);
  std::vector<char> is_known(values.size(), 0);
  bool is_free_before = fill.ends == FillEnds::kFree, is_free_after = is_free_before;
  std::vector<PlaceRate> rates;
  for (size_t k = 0; k < keys.size(); ++k) {
    const Key& key = keys[k];
    is_free_before &= key.frame > first || (key.frame == first && !key.rate);
    is_free_after &= key.frame < last || (key.frame == last && !key.rate);
    const bool is_filled = MayBeFilled(key.interpolation) || k + 1 == keys.size();
    const double to = is_filled ? key.frame : keys[k + 1].frame;
    if (to < first || key.frame > last) continue;
    for (int f = std::max(first, static_cast<int>(std::floor(key.frame)));
         f <= std::min(last, static_cast<int>(std::ceil(to))); ++f) {
      is_known[f - first + 1] = 1;
    }
    const bool is_inside =
        key.frame > first && key.frame < last && key.frame == std::floor(key.frame);
    if (!is_inside || !key.rate || (key.rate_in && *key.rate_in != *key.rate)) continue;
    rates.push_back(
        {static_cast<int>(key.frame) - first + 1, *key.rate * animation.rate.seconds_per_frame()});
  }
  is_known[1] = is_known[values.size() - 2] = 1;
  is_known.front() = !is_free_before;
  is_known.back() = !is_free_after;
  SmoothPlace(is_known, rates, &values);
  return {first, {values.begin() + 1, values.end() - 1}};
}

}  // namespace hazumi::makers
