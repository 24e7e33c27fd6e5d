#pragma once

#include <span>
#include <vector>

#include "engine/bake/items_by_frame.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// At which frames of an animation something changes, and what. Between two of them the same
// regions, holds and placement are active, and every curve is smooth but for keys off the frames.
class ChangeSchedule {
 public:
  // The animation must outlive it; it is asked again for all that changes but by the calls below.
  explicit ChangeSchedule(const Animation& animation);

  // Regions of the animation have changed, but not their number.
  void RegionsChanged();
  // A curve of the animation is about to change its keys, or has changed them.
  void RemoveKeys(const Keys& keys) { CountKeys(keys, -1); }
  void AddKeys(const Keys& keys) { CountKeys(keys, 1); }

  // If something begins or ends at the frame, or a key lies on it.
  bool ChangesAt(int frame) const { return is_edge_[Index(frame)] || HasKeyAt(frame); }
  bool HasKeyAt(int frame) const { return num_keys_[Index(frame)] > 0; }

  // Entries (frame, index) of the animation's lists.
  std::span<const ItemsByFrame::Entry> RegionsFrom(int frame) const {
    return regions_from_.At(frame);
  }
  std::span<const ItemsByFrame::Entry> RegionsUntil(int frame) const {
    return regions_until_.At(frame);
  }
  std::span<const ItemsByFrame::Entry> HoldsFrom(int frame) const { return holds_from_.At(frame); }
  std::span<const ItemsByFrame::Entry> ForcesFrom(int frame) const {
    return forces_from_.At(frame);
  }
  // Whether a force from outside or a constraint begins or ends at the frame.
  bool ForcesChangeAt(int frame) const {
    return !forces_from_.At(frame).empty() || !forces_until_.At(frame).empty() ||
           !constraints_from_.At(frame).empty() || !constraints_until_.At(frame).empty();
  }
  std::span<const ItemsByFrame::Entry> ConstraintsFrom(int frame) const {
    return constraints_from_.At(frame);
  }
  // Held objects that are let go of or go over to a holder.
  std::span<const ItemsByFrame::Entry> HandOvers(int frame) const { return hand_overs_.At(frame); }
  // Whether a region that begins at the frame moves the joint.
  bool HasRegionFrom(int frame, JointIndex j) const;

  // The placement that begins at the frame; null if none does.
  const PlacementSpan* PlacementFrom(int frame) const;
  // The index of the placement that begins at the frame, else of the one that ends there.
  int PlacementAt(int frame) const;

 private:
  int Index(int frame) const { return frame - animation_.first_frame; }
  void FindEdges();
  void CountKeys(const Keys& keys, int by);
  std::vector<PlacementSpan>::const_iterator FirstPlacementFrom(int frame) const;

  const Animation& animation_;
  std::vector<char> is_edge_;  // by Index(frame): something begins or ends there
  std::vector<int> num_keys_;  // by Index(frame)
  ItemsByFrame regions_from_, regions_until_, holds_from_, hand_overs_;
  ItemsByFrame forces_from_, forces_until_, constraints_from_, constraints_until_;
};

}  // namespace hazumi
