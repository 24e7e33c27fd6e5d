#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/base/text.h"
#include "engine/project/items.h"
#include "engine/spatial/degrees.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/regions.h"
#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/forms/offers.h"
#include "ui/panels/outliner/limbs.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::ui {

namespace {

using edit::Json;
using edit::ParameterInfo;
using edit::ParameterKind;

// At the end of the animation there is nothing behind the current frame.
Json Frame(const std::string& name, const edit::Session& session) {
  const ProjectFrames& all = session.project().frames;
  const double now = std::round(session.frame());
  if (name == "frame") return now;
  if (name == "first" || name == "to_first") return now < all.last ? now : all.first;
  if (name == "last" || name == "to_last") return all.last;
  return Json();
}

// Suggested friction of a region of the selected joints.
double FrictionOfSelected(const edit::Session& session) {
  ProjectRegion region;
  region.contacts.scene = TouchesWhenMade(session.project());
  for (const std::string& name : edit::SelectedNames(session)) {
    region.joints.push_back({name, false, {}});
  }
  return edit::StartFriction(region, session.figure());
}

// What the project has now, of operators that change it.
Json Present(const std::string& id, const std::string& name, const Project& project) {
  if (id == "scene.gravity") return project.scene.gravity_m_s2;
  if (id == "time.rate") return name == "num" ? Json(project.fps.num) : Json(project.fps.den);
  if (id == "time.range") return name == "first" ? project.frames.first : project.frames.last;
  if (id == "project.rename") return project.name;
  if (id == "solver.set" && name == "method") return NameOf(project.solver.method);
  if (id == "region.add" && name == "contacts") return TouchesWhenMade(project);
  if (id.starts_with("object.add_") && name == "name")
    return FreeObjectName(id.substr(11), project);
  if (id.starts_with("object.add_") && name == "color") return kDefaultObjectColor;
  if (id == "object.add_box" && name.starts_with("size_")) return 1.0;
  if (id == "object.add_box" && name.size() == 1) return name == "z" ? 0.5 : 0.0;  // on the ground
  return Json();
}

// Of the joints at the ends of limbs, the one nearest to the ground.
Json LowestFoot(edit::Session* session) {
  const std::optional<PosedFigure> posed = PoseNow(session);
  if (!posed) return Json();
  const Figure& figure = session->figure();
  std::optional<GroupIndex> lowest;
  for (const Limb& limb : LimbsOf(figure)) {
    if (!limb.is_end) continue;
    const GroupIndex end = limb.joints.back();
    const double height = posed->CenterOf(end).z();
    if (!lowest || height < posed->CenterOf(*lowest).z() - 1e-6) lowest = end;
  }
  return lowest ? Json(figure.group(*lowest).name) : Json();
}

Json SelectedHinge(const edit::Session& session) {
  for (const Joint& joint : session.figure().joints()) {
    if (session.selected_joints().contains(joint.name)) return joint.name;
  }
  return Json();
}

// A hinge of the region that the form suggests: a selected one, else its first.
Json StartingHinge(edit::Session* session) {
  const auto shown = ShownRegion(session->project(), ItemId(), session->frame());
  const Animation* animation = session->animation();
  if (!shown || !animation) return Json();
  const std::vector<JointIndex>& hinges = animation->regions[*shown].joints;
  const auto name_of = [&](JointIndex j) { return session->figure().joint(j).name; };
  for (const JointIndex j : hinges) {
    if (session->selected_joints().contains(name_of(j))) return name_of(j);
  }
  return hinges.empty() ? Json() : Json(name_of(hinges.front()));
}

Json SelectedLink(const edit::Session& session) {
  const std::vector<GroupIndex> joints = SelectedJoints(session);
  for (const Link& link : session.figure().links()) {
    if (joints.empty() || !link.joint.is_valid()) continue;
    if (session.figure().joint(link.joint).group == joints.front()) return link.name;
  }
  return Json();
}

Json SuggestedJoint(const ParameterInfo& info, edit::Session* session) {
  if (info.kind == ParameterKind::kNames) {
    return WithSelected({}, session->figure(), session->selected_joints());
  }
  const std::vector<GroupIndex> joints = SelectedJoints(*session);
  if (std::string(info.name) == "b_joint") {  // the other end
    return joints.size() > 1 ? Json(session->figure().group(joints[1]).name) : Json();
  }
  if (!joints.empty()) return session->figure().group(joints.front()).name;
  return std::string(info.name) == "pin" ? LowestFoot(session) : Json();
}

// Name of the item of a kind that was made last; the first number of items without names.
template <typename Item>
Json LikelyItem(const std::vector<Item>& items) {
  if (items.empty()) return Json();
  if constexpr (HasUniqueName<Item>) return items.back().name;
  return 0;
}
Json LikelyItem(Thing thing, const Project& project) {
  Json item;
  ForEachItemList(
      [&](auto kind, const auto& items) {
        if (kind.kThing == thing) item = LikelyItem(items);
      },
      project);
  return item;
}

Json Named(const ParameterInfo& info, edit::Session* session) {
  const Project& project = session->project();
  switch (info.offer.thing) {
    case Thing::kJoint:
    case Thing::kJointOrHinge:
      return SuggestedJoint(info, session);
    case Thing::kJointOrRoot:
      if (info.kind == ParameterKind::kText) return SuggestedJoint(info, session);
      return edit::SelectedNames(*session);
    case Thing::kHinge:
    case Thing::kCurve:
      return info.kind == ParameterKind::kText ? SelectedHinge(*session) : Json();
    case Thing::kRegion: {
      const auto shown = ShownRegion(project, ItemId(), session->frame());
      return shown ? Json(project.regions[*shown].name) : Json();
    }
    case Thing::kSceneOrHeldObject: {
      if (!info.is_required) return Json();
      if (!project.scene.objects.empty()) return project.scene.objects.back().name;
      return project.held_objects.empty() ? Json() : Json(project.held_objects.back().name);
    }
    case Thing::kSelectionSet:
      return project.selection_sets.empty() ? Json() : Json(project.selection_sets.back().name);
    case Thing::kLink:
      return SelectedLink(*session);
    default:
      break;
  }
  if (Json item = LikelyItem(info.offer.thing, project); !item.is_null()) return item;
  const std::vector<std::string> words = edit::WordsOf(info.offer);
  return words.empty() || !info.is_required ? Json() : Json(words.front());
}

std::string OfHinge(const hazumi::Joint& hinge, const std::string& name) {
  if (name == "lower") return FormatShort(hinge.lower / kDegree);
  return name == "upper" ? FormatShort(hinge.upper / kDegree) : "";
}

// The entry of a list that a form changes, by its name or number; null: none.
template <typename T>
const T* Chosen(const std::vector<T>& list, const std::string& subject) {
  if constexpr (HasUniqueName<T>) {
    for (const T& item : list) {
      if (item.name == subject) return &item;
    }
    return nullptr;
  } else {
    const size_t index = std::strtoul(subject.c_str(), nullptr, 10);
    return subject.empty() || index >= list.size() ? nullptr : &list[index];
  }
}

// What the item that a form changes says now.
Json Present(const FormState& form, const std::string& name, const Project& project) {
  Json present;
  ForEachItemList(
      [&](auto kind, const auto& items) {
        if (form.id != kind.kSet) return;
        const auto* item = Chosen(items, form.fields.front().text);
        if (item) present = edit::FieldValue(*item, name);
      },
      project);
  return present;
}

// A box that is put into the scene: half a metre high, on the ground, a step ahead of the figure.
Json BoxAhead(const std::string& id, const std::string& name, edit::Session* session) {
  constexpr double kAhead = 1.2, kSize = 0.5;  // [m]
  if (id != "object.add_box") return Json();
  if (name.starts_with("size_")) return kSize;
  if (name == "z") return 0.5 * kSize;
  const bool is_x = name == "x", is_place = is_x || name == "y";
  const Result<const MotionFrame*> now = session->FrameNow();
  if (!is_place || !now.ok()) return Json();
  const hazumi::Pose& X_WR = now.value()->X_WR;
  const Vec3 ahead = X_WR.p + kAhead * (X_WR.R * Vec3::UnitX());
  return std::round(10.0 * (is_x ? ahead.x() : ahead.y())) / 10.0 + 0.0;
}

}  // namespace

std::string PresentValue(const FormState& form, const std::string& name,
                         const edit::Session& session) {
  const Json present = Present(form, name, session.project());
  if (!present.is_null()) return TextOf(present);
  const std::string& subject = form.fields.front().text;
  const auto hinge = session.figure().FindJoint(subject);
  if (form.id != "figure.joint_limits" || !hinge) return "";
  return OfHinge(session.figure().joint(*hinge), name);
}

Json Suggestion(const std::string& id, const ParameterInfo& info, edit::Session* session) {
  if (Json ahead = BoxAhead(id, info.name, session); !ahead.is_null()) return ahead;
  if (id == "region.add" && std::string(info.name) == "friction") {
    return FrictionOfSelected(*session);
  }
  Json present = Present(id, info.name, session->project());
  if (!present.is_null()) return present;
  if (id == "region.start_rate" && info.offer.thing == Thing::kHinge) return StartingHinge(session);
  const Json frame = Frame(info.name, *session);
  // A pin after a landing is left to gravity unless it is chosen.
  if (std::string(info.name) == "landing_pin") return Json();
  return frame.is_null() ? Named(info, session) : frame;
}

}  // namespace hazumi::ui
