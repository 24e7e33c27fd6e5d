#include <algorithm>

#include "render/mesh/mark_mesh.h"

namespace hazumi::render {
namespace {

constexpr size_t kMostDashes = 20000;

// Walks along a line and writes what lies in the dashes.
class DashWriter {
 public:
  explicit DashWriter(double dash_m) : dash_m_(dash_m), left_m_(dash_m) {}

  void Start(const Vec3& p) { dashes_.push_back({p}); }

  void Advance(const Vec3& from, const Vec3& to) {
    const double length = (to - from).norm();
    double done = 0.0;
    while (length - done > left_m_ && dashes_.size() < kMostDashes) {
      done += left_m_;
      Toggle(from + done / length * (to - from));
    }
    left_m_ -= length - done;
    if (drawing_) dashes_.back().push_back(to);
  }

  std::vector<std::vector<Vec3>> Take() { return std::move(dashes_); }

 private:
  void Toggle(const Vec3& p) {
    if (drawing_) dashes_.back().push_back(p);
    if (!drawing_) dashes_.push_back({p});
    drawing_ = !drawing_;
    left_m_ = dash_m_;
  }

  double dash_m_, left_m_;
  bool drawing_ = true;
  std::vector<std::vector<Vec3>> dashes_;
};

}  // namespace

std::vector<std::vector<Vec3>> SplitIntoDashes(const std::vector<Vec3>& points, double dash_m) {
  if (dash_m <= 0.0 || points.size() < 2) return {points};
  DashWriter writer(dash_m);
  writer.Start(points[0]);
  for (size_t i = 1; i < points.size(); ++i) writer.Advance(points[i - 1], points[i]);
  return writer.Take();
}

}  // namespace hazumi::render
