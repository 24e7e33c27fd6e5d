#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "engine/project/items.h"
#include "ui/edit/document/change.h"

namespace hazumi::edit {

namespace {

using Spans = std::vector<FrameSpan>;

template <SpanItem Item>
FrameSpan SpanOf(const Item& item) {
  const int last = IsOneFrame(item) ? item.first_frame : item.last_frame;
  return {static_cast<double>(item.first_frame), static_cast<double>(last)};
}

FrameSpan SpanOf(const ProjectHolder& holder) {
  const int last = holder.last_frame.value_or(holder.first_frame);
  return {static_cast<double>(holder.first_frame), static_cast<double>(last)};
}

void AddFrame(double frame, Spans* spans) { spans->push_back({frame, frame}); }

void AddWhole(const ProjectMarker& marker, Spans* spans) { AddFrame(marker.frame, spans); }
void AddWhole(const ProjectGoal& goal, Spans* spans) { AddFrame(goal.frame, spans); }
void AddWhole(const ProjectSceneObject&, Spans*) {}  // has no frames
// An object that is never let go has no frame.
void AddWhole(const ProjectHeldObject& object, Spans* spans) {
  if (object.release_frame) AddFrame(*object.release_frame, spans);
}
template <typename Item>
void AddWhole(const Item& item, Spans* spans) {
  spans->push_back(SpanOf(item));
}

void AddBetween(double a, double b, Spans* spans) {
  if (a != b) spans->push_back({std::min(a, b), std::max(a, b)});
}

template <typename Item>
void AddDifference(const Item& before, const Item& after, Spans* spans) {
  AddWhole(before, spans);
  AddWhole(after, spans);
}
template <typename Bar>
requires requires(Bar bar) { bar.first_frame; }
void AddDifference(const Bar& before, const Bar& after, Spans* spans) {
  const FrameSpan a = SpanOf(before), b = SpanOf(after);
  AddBetween(a.first, b.first, spans);
  AddBetween(a.last, b.last, spans);
  if (a == b) spans->push_back(a);
}

void AddDifference(const ProjectHeldObject& before, const ProjectHeldObject& after, Spans* spans);

template <typename Item>
void Compare(const std::vector<Item>& before, const std::vector<Item>& after, Spans* spans) {
  for (const Item& item : before) {
    const int now = IndexOf(item.identity.id, after);
    if (now < 0) AddWhole(item, spans);
    if (now >= 0 && after[now] != item) AddDifference(item, after[now], spans);
  }
  for (const Item& item : after) {
    if (IndexOf(item.identity.id, before) < 0) AddWhole(item, spans);
  }
}

// Both lists are in order of frames.
void Compare(const ProjectCurve& before, const ProjectCurve& after, Spans* spans) {
  const auto add = [&](const ProjectKey& key) { AddFrame(key.frame, spans); };
  auto a = before.keys.begin(), b = after.keys.begin();
  while (a != before.keys.end() || b != after.keys.end()) {
    const bool is_gone = b == after.keys.end() || (a != before.keys.end() && a->frame < b->frame);
    const bool is_new = a == before.keys.end() || (b != after.keys.end() && b->frame < a->frame);
    if (is_gone) {
      add(*a++);
    } else if (is_new) {
      add(*b++);
    } else if (*a++ != *b++) {
      add(*(a - 1));
    }
  }
}

// Who has it when, and its keys; else it is another one as a whole.
void AddDifference(const ProjectHeldObject& before, const ProjectHeldObject& after, Spans* spans) {
  const size_t count = spans->size();
  if (before.release_frame != after.release_frame) {
    AddWhole(before, spans);
    AddWhole(after, spans);
  }
  Compare(before.holders, after.holders, spans);
  for (size_t axis = 0; axis < before.position.curves.size(); ++axis) {
    Compare(before.position.curves[axis], after.position.curves[axis], spans);
  }
  if (spans->size() == count) AddWhole(after, spans);
}

void CompareJoints(const Project& before, const Project& after, Spans* spans) {
  static const ProjectCurve none;
  std::map<std::string, std::pair<const ProjectCurve*, const ProjectCurve*>> pairs;
  for (const auto& [name, curve] : before.joints) pairs[name] = {&curve, &none};
  for (const auto& [name, curve] : after.joints) {
    auto& pair = pairs.try_emplace(name, &none, &none).first->second;
    pair.second = &curve;
  }
  for (const auto& [name, pair] : pairs) Compare(*pair.first, *pair.second, spans);
}

}  // namespace

std::vector<FrameSpan> ChangedFrames(const Project& before, const Project& after) {
  Spans spans;
  CompareJoints(before, after, &spans);
  for (size_t i = 0; i < before.root.curves.size(); ++i) {
    Compare(before.root.curves[i], after.root.curves[i], &spans);
  }
  ForEachItemList([&](auto, const auto& old, const auto& now) { Compare(old, now, &spans); },
                  before, after);
  return spans;
}

}  // namespace hazumi::edit
