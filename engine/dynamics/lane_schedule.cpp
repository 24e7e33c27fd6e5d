#include <algorithm>
#include <queue>
#include <tuple>

#include "engine/dynamics/lane_bodies.h"

// Which bodies are computed together. List scheduling by the longest chain that still hangs on a
// body gives the fewest steps for a tree; among equals, those whose parent has just been done, so
// that they find its motion in their own lane.

namespace hazumi {

namespace {

// Of each body: the bodies on the longest chain from it outwards, itself included.
std::vector<int> HeightsOf(const std::vector<LaneBody>& bodies) {
  std::vector<int> heights(bodies.size(), 1);
  for (int b = static_cast<int>(bodies.size()) - 1; b >= 0; --b) {
    const int parent = bodies[b].parent;
    if (parent >= 0) heights[parent] = std::max(heights[parent], heights[b] + 1);
  }
  return heights;
}

std::vector<std::vector<int>> ChildLists(const std::vector<LaneBody>& bodies) {
  std::vector<std::vector<int>> children(bodies.size());
  for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
    if (bodies[b].parent >= 0) children[bodies[b].parent].push_back(b);
  }
  return children;
}

class Scheduler {
 public:
  Scheduler(int width, std::vector<LaneBody>* bodies)
      : width_(width),
        bodies_(*bodies),
        heights_(HeightsOf(*bodies)),
        children_(ChildLists(*bodies)) {}

  int Run() {
    for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) {
      if (bodies_[b].parent < 0) ready_.push(Ready(b));
    }
    for (; !ready_.empty(); ++step_) {
      const std::vector<int> chosen = Choose();
      AssignLanes(chosen);
      for (const int b : chosen) {
        for (const int child : children_[b]) ready_.push(Ready(child));
      }
    }
    return step_;
  }

 private:
  using Entry = std::tuple<int, int, int>;  // height, step it became ready, minus its index
  Entry Ready(int b) const { return {heights_[b], step_, -b}; }

  std::vector<int> Choose() {
    std::vector<int> chosen;
    while (!ready_.empty() && static_cast<int>(chosen.size()) < width_) {
      chosen.push_back(-std::get<2>(ready_.top()));
      ready_.pop();
    }
    return chosen;
  }

  void AssignLanes(const std::vector<int>& chosen) {
    std::array<bool, kMaxLanes> taken = {};
    std::vector<int> others;
    for (const int b : chosen) {
      const int parent = bodies_[b].parent;
      const bool follows = parent >= 0 && bodies_[parent].step == step_ - 1;
      if (follows && !taken[bodies_[parent].lane]) {
        Place(b, bodies_[parent].lane, &taken);
      } else {
        others.push_back(b);
      }
    }
    int lane = 0;
    for (const int b : others) {
      while (taken[lane]) ++lane;
      Place(b, lane, &taken);
    }
  }

  void Place(int b, int lane, std::array<bool, kMaxLanes>* taken) {
    bodies_[b].step = step_;
    bodies_[b].lane = lane;
    (*taken)[lane] = true;
  }

  const int width_;
  std::vector<LaneBody>& bodies_;
  const std::vector<int> heights_;
  const std::vector<std::vector<int>> children_;
  std::priority_queue<Entry> ready_;
  int step_ = 0;
};

}  // namespace

int ScheduleBodies(int width, std::vector<LaneBody>* bodies) {
  return Scheduler(width, bodies).Run();
}

}  // namespace hazumi
