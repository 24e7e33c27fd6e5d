#pragma once

#include <optional>
#include <vector>

#include "engine/bake/bake_context.h"
#include "engine/bake/handover/region_start.h"
#include "engine/region/forces/spring_drive.h"
#include "engine/timeline/curve_track.h"
#include "engine/timeline/frame_time.h"

namespace hazumi {

// What the drives of active regions read over time: torques [N m], and the angles that springs pull
// to [rad].
class DriveCurves {
 public:
  struct Entry {
    JointIndex joint;
    const Drive* drive;
    int region;                      // of Animation::regions
    std::optional<CurveTrack> own;   // not given: the joint's own,
    std::optional<double> constant;  // or this all the time
    // Of a spring, where it has keys of them.
    std::optional<CurveTrack> frequency = {}, strength = {};
    bool reads_curves() const { return frequency || strength || drive->feed_forward; }
  };

  // The context must outlive it. No region is active.
  explicit DriveCurves(BakeContext* context) : context_(*context) {}

  // From here on these are active; they have begun.
  void SetRegions(const std::vector<int>& regions);

  std::vector<Entry>& entries() { return entries_; }
  const std::vector<Entry>& entries() const { return entries_; }
  // Null: a constant.
  CurveTrack* TrackOf(Entry* entry) const {
    if (entry->constant) return nullptr;
    return entry->own ? &*entry->own : &context_.poses.curves().joint(entry->joint);
  }

 private:
  Entry EntryOf(const Drive& drive, JointIndex joint, int region) const;

  BakeContext& context_;
  std::vector<Entry> entries_;
};

// The spring that `drive` is to a joint of a region that began so.
Spring SpringOf(const Drive& drive, JointIndex joint, const DynamicsRegion& region,
                const Figure& figure, const RegionStart& start, FrameRate rate);

}  // namespace hazumi
