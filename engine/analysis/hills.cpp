#include "engine/analysis/hills.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/analysis/motion_series.h"

namespace hazumi {

namespace {

// Turning points that are at least `swing` apart in height: valley, peak, valley, ... The ends of
// the clip count as valleys.
std::vector<int> TurningPoints(const std::vector<double>& c, double swing) {
  std::vector<int> points = {0};
  int low = 0, high = 0;
  bool rising = false;  // a peak is sought
  for (int i = 1; i < static_cast<int>(c.size()); ++i) {
    if (c[i] > c[high]) high = i;
    if (c[i] < c[low]) low = i;
    if (!rising && c[i] > c[low] + swing) {
      points.back() = low;
      rising = true;
      high = i;
    } else if (rising && c[i] < c[high] - swing) {
      points.insert(points.end(), {high, i});
      rising = false;
      low = i;
    }
    if (!rising) points.back() = low;
  }
  if (rising) points.insert(points.end(), {high, static_cast<int>(c.size()) - 1});
  return points;
}

std::vector<Hill> PeaksOf(const std::vector<double>& c, double swing) {
  const std::vector<int> points = TurningPoints(c, swing);
  std::vector<Hill> hills;
  for (size_t i = 2; i < points.size(); i += 2) {
    hills.push_back({points[i - 2], points[i - 1], points[i]});
  }
  return hills;
}

// The height at which the foot stands still on the way from the peak to the valley at `end`, by
// `step`, 1 or -1: level for half as long as the way was. In flight it never is: in that time it
// falls further than it fell before.
std::optional<double> PlateauBeside(const std::vector<double>& c, int peak, int end, int step,
                                    const Heights& heights) {
  for (int i = peak; i != end; i += step) {
    if (c[i] > c[peak] - heights.hill) continue;
    const int frames = std::max(kFewestFrames, std::abs(i - peak) / 2);
    if (std::abs(end - i) < frames) return std::nullopt;
    const auto from = c.begin() + (step > 0 ? i : i - frames);
    const auto [low, high] = std::minmax_element(from, from + frames + 1);
    if (*high - *low < heights.contact) return 0.5 * (*high + *low);
  }
  return std::nullopt;
}

// Hills of one flight: the valley between them is far above those outside, and no foot stands
// there.
bool BelongTogether(const std::vector<double>& c, const Hill& a, const Hill& b,
                    const Heights& heights) {
  constexpr double kHigh = 0.3;  // of the lower peak
  const double ground = std::max(c[a.left], c[b.right]);
  return c[a.right] - ground > kHigh * (std::min(c[a.peak], c[b.peak]) - ground) &&
         !PlateauBeside(c, a.peak, b.peak, 1, heights) &&
         !PlateauBeside(c, b.peak, a.peak, -1, heights);
}

// The lowest ground between `peak` and the valley at `end`: a tenth of the frames within three
// times the way down to half the height are lower. Where the clip ends before, its padding is the
// ground.
double LowestGround(const std::vector<double>& c, int peak, int end, int step) {
  const double half = 0.5 * (c[peak] + c[end]);
  int i = peak;
  while (i != end && c[i] > half) i += step;
  const int reach = 3 * std::abs(i - peak);
  const bool padding = end == 0 || end + 1 == static_cast<int>(c.size());
  if (reach >= std::abs(end - peak) && padding) return c[end];
  std::vector<double> beside;
  for (int k = 0; k <= std::min(reach, std::abs(end - peak)); ++k) {
    beside.push_back(c[peak + k * step]);
  }
  return std::max(Quantile(std::move(beside), 0.1), c[end]);
}

// Between frames i and i + step, of which the latter is the lower one: where it is at `level`.
double Crossing(const std::vector<double>& c, int i, int step, double level) {
  return i + step * (c[i] - level) / (c[i] - c[i + step]);
}

// Where a foot that falls to `contact` above the ground at `at` touches it: if it goes on as fast
// as it came from twice that height, or where it is slowed down to half of that before.
double TouchOf(const std::vector<double>& c, double at, int peak, int end, int step, double ground,
               double contact) {
  int i = static_cast<int>(step > 0 ? std::floor(at) : std::ceil(at));
  while (i != peak && c[i] < ground + 2.0 * contact) i -= step;
  if (i == peak) return at;
  const double frames = std::abs(at - Crossing(c, i, step, ground + 2.0 * contact));
  int stop = static_cast<int>(step > 0 ? std::ceil(at) : std::floor(at));
  while (stop != end && c[stop] - c[stop + step] > 0.5 * contact / frames) stop += step;
  return at + step * std::min(frames, std::abs(stop - at));
}

Edge EdgeAt(int frame, double ground) {
  return {static_cast<double>(frame), ground, static_cast<double>(frame)};
}

}  // namespace

std::vector<Hill> HillsOf(const std::vector<double>& c, const Heights& heights) {
  std::vector<Hill> merged;
  for (Hill hill : PeaksOf(c, heights.hill)) {
    while (!merged.empty() && BelongTogether(c, merged.back(), hill, heights)) {
      const Hill& before = merged.back();
      hill.left = before.left;
      if (c[before.peak] > c[hill.peak]) hill.peak = before.peak;
      merged.pop_back();
    }
    merged.push_back(hill);
  }
  return merged;
}

Edge EdgeOf(const std::vector<double>& c, int peak, int end, int step, const Heights& heights) {
  const double contact = heights.contact;
  const double lowest = LowestGround(c, peak, end, step);
  const double box = PlateauBeside(c, peak, end, step, heights).value_or(lowest);
  const double ground = box > lowest + 1.5 * contact ? box : lowest;
  if (c[peak] <= ground + contact) return EdgeAt(peak, ground);
  for (int i = peak; i != end; i += step) {
    if (c[i + step] > ground + contact) continue;
    const double at = Crossing(c, i, step, ground + contact);
    return {at, ground, TouchOf(c, at, peak, end, step, ground, contact)};
  }
  return EdgeAt(end, ground);
}

}  // namespace hazumi
