#include "engine/project/checks/constraint_checks.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "engine/base/named.h"
#include "engine/project/checks/animation_checks.h"
#include "engine/project/checks/driven_frames.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/json/did_you_mean.h"

namespace hazumi {

namespace {

void CheckObjectName(const std::string& name, const Project& project, const Site& site) {
  const auto& objects = project.scene.objects;
  const auto& held = project.held_objects;
  const bool stands = HasNamed(objects, name), is_held = HasNamed(held, name);
  if (stands && is_held) return site.Report(Check::kAmbiguousObject, {Quoted(name)});
  if (stands || is_held) return;
  std::vector<std::string> names;
  names.reserve(objects.size());
  for (const ProjectSceneObject& object : objects) names.push_back(object.name);
  for (const ProjectHeldObject& object : held) names.push_back(object.name);
  site.Report(Check::kUnknownObject,
              {Quoted(name), names.empty() ? "there are none" : Suggestion(name, names)});
}

void CheckEndNames(const ProjectConstraintEnd& end, const Project& project, const Site& site) {
  if (!end.joint.empty() && !end.object.empty()) {
    return site.Report(Check::kJointAndObject, {Quoted(end.joint), Quoted(end.object)});
  }
  if (!end.object.empty()) CheckObjectName(end.object, project, site.Field("object"));
}

bool HasDuring(const Holder& holder, Span span) {
  return holder.first_frame <= span.first &&
         (!holder.last_frame || *holder.last_frame >= span.last);
}

// "r_wrist" in frames 0 to 9, and so on, of those who have it in some of the frames.
std::string HoldersDuring(const HeldObject& object, Span span, const Animation& animation) {
  std::string text;
  for (const Holder& holder : object.holders) {
    const Span all = {animation.first_frame, animation.last_frame};
    const Span has = Common(all, {holder.first_frame, holder.last_frame.value_or(all.last)});
    if (Common(has, span).is_empty()) continue;
    text += (text.empty() ? "" : ", ") + Quoted(animation.figure->group(holder.joint).name) +
            " in frames " + Text(has.first) + " to " + Text(has.last);
  }
  return text;
}

bool AreOfOneBody(const ConstraintEnd& a, const ConstraintEnd& b) {
  return !a.is_in_world && !b.is_in_world && a.joint == b.joint;
}

std::string NameOfEnd(const ConstraintEnd& end, const Figure& figure) {
  if (end.is_in_world) return "the world";
  return Quoted(end.joint ? figure.group(*end.joint).name : figure.root_name());
}

// Whether a region may move what an end is fixed to.
bool MayMove(const DynamicsRegion& region, const ConstraintEnd& end, Span span,
             const Animation& animation) {
  return !end.is_in_world && MayMove(region, end.joint, span, animation);
}

bool MayMove(const DynamicsRegion& region, const Constraint& constraint,
             const Animation& animation) {
  return MayMove(region, constraint.a, SpanOf(constraint), animation) ||
         MayMove(region, constraint.b, SpanOf(constraint), animation);
}

// Names of the ends that could be moved: "a" or "b".
std::string MovedOf(const Constraint& constraint, const Figure& figure) {
  const bool has_two = !constraint.a.is_in_world && !constraint.b.is_in_world;
  const ConstraintEnd& own = constraint.a.is_in_world ? constraint.b : constraint.a;
  return NameOfEnd(own, figure) + (has_two ? " or " + NameOfEnd(constraint.b, figure) : "");
}

void CheckConstraint(const Constraint& constraint, const std::string& place,
                     const Animation& animation, FirstError* errors) {
  const int first = animation.first_frame, last = animation.last_frame;
  const Span span = SpanOf(constraint);
  errors->Require(span.first >= first && span.last <= last, Check::kOutsideFrames, place,
                  {Text(span.first), Text(span.last), Text(first), Text(last)});
  if (AreOfOneBody(constraint.a, constraint.b)) {
    errors->Report(Check::kConstraintOnOneBody, place,
                   {NameOfEnd(constraint.a, *animation.figure)});
  }
  errors->Require(!constraint.a.is_in_world || !constraint.b.is_in_world, Check::kConstraintInWorld,
                  place);
  for (const DynamicsRegion& region : animation.regions) {
    const Span both = Common(SpanOf(region), span);
    if (region.method == Method::kExact || region.moves_nothing() || both.is_empty()) continue;
    errors->Report(
        Check::kConstraintInPaper, place,
        {Quoted(constraint.name), Text(both.first), Text(both.last), Quoted(region.name)});
  }
}

}  // namespace

void CheckConstraintNames(const Project& project, const Site& site) {
  for (size_t i = 0; i < project.constraints.size(); ++i) {
    const ProjectConstraint& constraint = project.constraints[i];
    CheckEndNames(constraint.a, project, site.Item(i).Field("a"));
    CheckEndNames(constraint.b, project, site.Item(i).Field("b"));
  }
}

const Holder* HolderDuring(const HeldObject& object, Span span, const Animation& animation,
                           const Site& site) {
  const auto holder = std::find_if(object.holders.begin(), object.holders.end(),
                                   [&](const Holder& each) { return HasDuring(each, span); });
  if (holder != object.holders.end()) return &*holder;
  const std::string holders = HoldersDuring(object, span, animation);
  if (holders.empty()) {
    site.Report(Check::kObjectNotHeld, {Quoted(object.name), Text(span.first), Text(span.last)});
  } else {
    site.Report(Check::kObjectChangesHands,
                {Quoted(object.name), Text(span.first), Text(span.last), holders});
  }
  return nullptr;
}

void CheckConstraints(const Animation& animation, FirstError* errors) {
  for (size_t i = 0; i < animation.constraints.size() && errors->ok(); ++i) {
    CheckConstraint(animation.constraints[i], At("constraints", i), animation, errors);
  }
}

bool IsFelt(const Constraint& constraint, const Animation& animation) {
  return std::any_of(
      animation.regions.begin(), animation.regions.end(),
      [&](const DynamicsRegion& region) { return MayMove(region, constraint, animation); });
}

std::optional<int> OutlastsFrom(const Constraint& constraint, const Animation& animation) {
  std::optional<int> last;
  for (const DynamicsRegion& region : animation.regions) {
    if (!MayMove(region, constraint, animation)) continue;
    last = std::max(last.value_or(region.last_frame), region.last_frame);
  }
  return last && *last < constraint.last_frame ? last : std::nullopt;
}

std::vector<OutlastingConstraint> FindOutlasting(const Animation& animation) {
  std::vector<OutlastingConstraint> outlasting;
  for (size_t i = 0; i < animation.constraints.size(); ++i) {
    const std::optional<int> from = OutlastsFrom(animation.constraints[i], animation);
    if (from) outlasting.push_back({static_cast<int>(i), *from});
  }
  return outlasting;
}

void WarnAboutConstraints(const Animation& animation, std::vector<Warning>* warnings) {
  for (size_t i = 0; i < animation.constraints.size(); ++i) {
    const Constraint& constraint = animation.constraints[i];
    const std::string name = Quoted(constraint.name), what = MovedOf(constraint, *animation.figure),
                      last = Text(constraint.last_frame), place = At("constraints", i);
    if (!IsFelt(constraint, animation)) {
      warnings->push_back({place, MessageOf(Check::kConstraintFeltByNone,
                                            {name, what, Text(constraint.first_frame), last})});
    } else if (const auto from = OutlastsFrom(constraint, animation)) {
      warnings->push_back(
          {place,
           MessageOf(Check::kConstraintOutlasts, {Text(*from), what, name, last, Text(*from)}),
           *from});
    }
  }
}

}  // namespace hazumi
