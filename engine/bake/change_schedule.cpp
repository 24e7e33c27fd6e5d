#include "engine/bake/change_schedule.h"

#include <algorithm>
#include <cmath>

#include "engine/bake/pose/held_objects.h"

namespace hazumi {
namespace {

bool MovesNothing(const DynamicsRegion& region) { return region.moves_nothing(); }
template <typename Span>
bool MovesNothing(const Span&) {
  return false;
}

}  // namespace

ChangeSchedule::ChangeSchedule(const Animation& animation) : animation_(animation) {
  FindEdges();
  num_keys_.assign(is_edge_.size(), 0);
  for (const Keys& keys : animation_.joint_keys) AddKeys(keys);
  for (const Keys& keys : animation_.root_keys) AddKeys(keys);
}

void ChangeSchedule::RegionsChanged() { FindEdges(); }

void ChangeSchedule::FindEdges() {
  const auto mark = [this](int frame) {
    if (animation_.first_frame <= frame && frame <= animation_.last_frame) {
      is_edge_[Index(frame)] = 1;
    }
  };
  const auto mark_ends = [&](const auto& spans, ItemsByFrame* from, ItemsByFrame* until) {
    for (size_t i = 0; i < spans.size(); ++i) {
      if (MovesNothing(spans[i])) continue;
      mark(spans[i].first_frame);
      mark(spans[i].last_frame);
      if (from) from->Add(spans[i].first_frame, i);
      if (until) until->Add(spans[i].last_frame, i);
    }
  };
  is_edge_.assign(Index(animation_.last_frame) + 1, 0);
  const auto lists = {&regions_from_, &regions_until_, &holds_from_,       &hand_overs_,
                      &forces_from_,  &forces_until_,  &constraints_from_, &constraints_until_};
  for (ItemsByFrame* list : lists) *list = ItemsByFrame();
  mark(animation_.last_frame);
  mark_ends(animation_.regions, &regions_from_, &regions_until_);
  mark_ends(animation_.placements, nullptr, nullptr);
  mark_ends(animation_.holds, &holds_from_, nullptr);
  mark_ends(animation_.forces, &forces_from_, &forces_until_);
  mark_ends(animation_.constraints, &constraints_from_, &constraints_until_);
  for (size_t i = 0; i < animation_.held_objects.size(); ++i) {
    std::optional<int> last;
    const auto add = [&](int frame) {
      if (frame == last) return;
      last = frame;
      mark(frame);
      hand_overs_.Add(frame, i);
    };
    // Who had it before the animation begins hands nothing over in it.
    const std::vector<Holder>& holders = animation_.held_objects[i].holders;
    const int at_first = HolderAtFirst(animation_.held_objects[i], animation_.first_frame);
    for (size_t k = static_cast<size_t>(std::max(at_first, 0)); k < holders.size(); ++k) {
      const int first = animation_.first_frame;
      if (holders[k].first_frame > first) add(holders[k].first_frame);
      if (holders[k].last_frame && *holders[k].last_frame >= first) add(*holders[k].last_frame);
    }
  }
  for (ItemsByFrame* list : lists) list->Sort();
}

void ChangeSchedule::CountKeys(const Keys& keys, int by) {
  for (const Key& key : keys) {
    const bool is_inside =
        animation_.first_frame <= key.frame && key.frame <= animation_.last_frame;
    if (!is_inside || key.frame != std::floor(key.frame)) continue;
    num_keys_[Index(static_cast<int>(key.frame))] += by;
  }
}

bool ChangeSchedule::HasRegionFrom(int frame, JointIndex j) const {
  const auto starts = RegionsFrom(frame);
  return std::any_of(starts.begin(), starts.end(), [&](const ItemsByFrame::Entry& start) {
    const DynamicsRegion& region = animation_.regions[start.second];
    return std::binary_search(region.joints.begin(), region.joints.end(), j);
  });
}

std::vector<PlacementSpan>::const_iterator ChangeSchedule::FirstPlacementFrom(int frame) const {
  return std::partition_point(animation_.placements.begin(), animation_.placements.end(),
                              [&](const PlacementSpan& s) { return s.first_frame < frame; });
}

const PlacementSpan* ChangeSchedule::PlacementFrom(int frame) const {
  const auto next = FirstPlacementFrom(frame);
  return next != animation_.placements.end() && next->first_frame == frame ? &*next : nullptr;
}

int ChangeSchedule::PlacementAt(int frame) const {
  const auto& spans = animation_.placements;
  auto span = FirstPlacementFrom(frame);
  const bool begins = span != spans.end() && span->first_frame == frame;
  if (!begins && span != spans.begin()) --span;
  return static_cast<int>(span - spans.begin());
}

}  // namespace hazumi
