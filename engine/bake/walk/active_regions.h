#pragma once

#include <map>
#include <vector>

#include "engine/bake/handover/region_start.h"
#include "engine/bake/island_request.h"
#include "engine/bake/pose/root_placement.h"
#include "engine/bake/rotation_state.h"
#include "engine/bake/walk/held_together.h"
#include "engine/bake/walk/own_pairs.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// The exact regions that are active at the same time: which coordinates of the figure they free,
// and what acts on those. Stays the same while they are active.
class ActiveRegions {
 public:
  // `indices`: of Animation::regions; `starts`: of those with springs. The animation and the figure
  // must outlive this object.
  ActiveRegions(const Animation& animation, const Figure& figure, std::vector<int> indices,
                const std::map<int, RegionStart>& starts);

  const std::vector<int>& indices() const { return indices_; }
  size_t size() const { return indices_.size(); }
  const DynamicsRegion& region(size_t place) const { return animation_.regions[indices_[place]]; }
  const Animation& animation() const { return animation_; }
  const Figure& figure() const { return figure_; }
  int num_coordinates() const { return static_cast<int>(place_of_.size()); }

  bool is_free(Coordinate c) const { return place_of_[c] >= 0; }
  // Returns whether a free coordinate keeps its angle.
  bool is_frozen(Coordinate c) const;
  // Place in indices() of the region that frees the coordinate.
  size_t PlaceOf(Coordinate c) const {
    HAZUMI_ASSERT(is_free(c));
    return static_cast<size_t>(place_of_[c]);
  }
  // Index in Animation::regions of the region that frees the joint.
  int RegionOf(JointIndex j) const { return indices_[PlaceOf(j.value())]; }
  double ToleranceOf(size_t place) const;  // [rad]

  bool has_drives() const { return !drives_.empty(); }
  bool has_contacts() const { return has_contacts_; }
  // Returns whether contacts place the root, where a placement by gravity leaves it to them.
  bool places_root() const;
  // Returns whether the links of a joint touch things in the scene.
  bool Touches(JointIndex j) const;
  // Pairs of links that collide with each other, one of which is moved by a region with
  // `touches_self`.
  const std::vector<LinkPair>& own_pairs() const { return own_pairs_; }

  // Returns which coordinates move, and how. `driven`: the curves of the others.
  ModelRequest RequestFor(const RotationState& state, const RootHold& hold,
                          const DrivenMotion& driven) const;
  // The same with what is tied: by the constraints `acting`, by contacts, by loose objects.
  ModelRequest RequestWithTies(const RotationState& state, const RootHold& hold,
                               const DrivenMotion& driven, const std::vector<int>& acting) const;
  // Circumstances of islands that begin at the same time.
  struct Circumstances {
    double t = 0.0;                         // at which outer forces are looked up [s]
    bool has_ties = false;                  // of the request
    const std::vector<int>& acting;         // constraints
    const std::vector<LooseObject>& loose;  // objects that fly
  };
  struct Island {
    IslandTask task;
    IslandConstraints held;  // constraints of the task
  };
  Island IslandFor(RegionModel model, const Circumstances& at) const;
  // Smallest tolerance of the regions that move a model, and the part of it that one step may take
  // [rad].
  double StepToleranceFor(const RegionModel& model) const;

 private:
  void ListOwnPairs();
  const DynamicsRegion* Carrying(JointIndex j) const;
  void AddDrives(IslandTask* task) const;

  const Animation& animation_;
  const Figure& figure_;
  std::vector<int> indices_;
  std::vector<int> place_of_;         // by Coordinate: place in indices_; -1: not free
  std::vector<double> friction_;      // by Coordinate: factor per 1/30 s
  std::vector<const Drive*> drives_;  // by Coordinate; empty if there are none
  std::vector<Spring> springs_;       // of the drives that are springs
  bool has_contacts_ = false;
  std::vector<LinkPair> own_pairs_;
};

}  // namespace hazumi
