#include "engine/project/edits/holders.h"

#include "engine/project/edits/keys.h"

namespace hazumi {

std::vector<HolderSpan> HoldersOf(const ProjectHeldObject& object, const ProjectFrames& frames) {
  std::vector<HolderSpan> spans;
  const auto add = [&](int number, ItemId id, const std::string& joint, int first,
                       const std::optional<int>& last) {
    spans.push_back({number, id, joint, first, last.value_or(frames.last), last.has_value()});
  };
  if (!object.joint.empty()) {
    add(-1, object.identity.id, object.joint, frames.first, object.release_frame);
  }
  for (size_t i = 0; i < object.holders.size(); ++i) {
    const ProjectHolder& holder = object.holders[i];
    add(static_cast<int>(i), holder.identity.id, holder.joint, holder.first_frame,
        holder.last_frame);
  }
  return spans;
}

std::vector<std::pair<int, HolderSpan>> AllHolders(const Project& project) {
  std::vector<std::pair<int, HolderSpan>> all;
  for (size_t i = 0; i < project.held_objects.size(); ++i) {
    for (HolderSpan& span : HoldersOf(project.held_objects[i], project.frames)) {
      all.emplace_back(static_cast<int>(i), std::move(span));
    }
  }
  return all;
}

const HolderSpan* HolderAt(int frame, const std::vector<HolderSpan>& holders) {
  for (const HolderSpan& holder : holders) {
    const bool has_it = holder.first <= frame && (frame < holder.last || !holder.is_let_go);
    if (has_it) return &holder;
  }
  return nullptr;
}

std::optional<int>& EndOf(int number, ProjectHeldObject* object) {
  return number < 0 ? object->release_frame : object->holders[number].last_frame;
}

void PutPosition(const Vec3& at, double frame, ProjectHeldObject* object) {
  for (int axis = 0; axis < 3; ++axis) {
    ProjectKey key;
    key.frame = frame;
    key.value = WithoutRoundOff(at[axis]);
    PutKey(key, &object->position.curves[axis]);
  }
}

}  // namespace hazumi
