#include <algorithm>
#include <cctype>

#include "engine/base/text.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/curves.h"
#include "engine/project/items.h"
#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/forms/offers.h"
#include "ui/panels/outliner/limbs.h"
#include "ui/panels/sheet/drag.h"

namespace hazumi::ui {

namespace {

// "keyed": "Keyed".
std::string WithCapital(std::string word) {
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

std::vector<FormOption> Words(const edit::Offer& offer) {
  std::vector<FormOption> options;
  for (const std::string& word : edit::WordsOf(offer)) {
    options.push_back({word, WithCapital(word), ""});
  }
  return options;
}

std::vector<FormOption> Joints(const Figure& figure, bool with_joints, bool with_hinges) {
  std::vector<FormOption> options;
  for (const Limb& limb : LimbsOf(figure)) {
    for (const GroupIndex joint : limb.joints) {
      const std::string& name = figure.group(joint).name;
      if (with_joints) options.push_back({name, name, limb.name});
      if (!with_hinges) continue;
      for (const JointIndex hinge : HingesOf(figure, joint)) {
        const std::string& own = figure.joint(hinge).name;
        if (!with_joints || own != name) options.push_back({own, own, limb.name});
      }
    }
  }
  return options;
}

std::vector<FormOption> JointsAndRoot(const Figure& figure) {
  std::vector<FormOption> options = Joints(figure, true, false);
  const std::string root = NameOfRoot(figure);
  if (!root.empty()) options.insert(options.begin(), {root, root, "Root"});
  return options;
}

std::vector<FormOption> Curves(const Figure& figure) {
  std::vector<FormOption> options = Joints(figure, false, true);
  for (const char* name : kRootCurveNames) options.push_back({name, name, "Root"});
  return options;
}

template <typename T>
std::vector<FormOption> NamesIn(const std::vector<T>& list) {
  std::vector<FormOption> options;
  options.reserve(list.size());
  for (const T& entry : list) options.push_back({entry.name, entry.name, ""});
  return options;
}

// Lists markers and spans by their numbers: names of markers need not differ, spans have none.
std::vector<FormOption> NamesIn(const std::vector<ProjectMarker>& markers) {
  std::vector<FormOption> options;
  options.reserve(markers.size());
  for (const ProjectMarker& marker : markers) {
    options.push_back({std::to_string(options.size()),
                       marker.name + " (" + std::to_string(marker.frame) + ")", ""});
  }
  return options;
}
template <typename T>
requires requires(T span) { TitleOf(span); }
std::vector<FormOption> NamesIn(const std::vector<T>& spans) {
  std::vector<FormOption> options;
  options.reserve(spans.size());
  for (const T& span : spans) {
    options.push_back({std::to_string(options.size()),
                       TitleOf(span) + " (" + SpanText(span.first_frame, span.last_frame) + ")",
                       ""});
  }
  return options;
}

// Items of the kind that a parameter names; none if it names another thing.
std::vector<FormOption> Items(Thing thing, const Project& project) {
  std::vector<FormOption> options;
  ForEachItemList(
      [&](auto kind, const auto& items) {
        if (kind.kThing == thing) options = NamesIn(items);
      },
      project);
  return options;
}

}  // namespace

std::vector<FormOption> OptionsOf(const edit::ParameterInfo& info, const edit::Session& session) {
  const Project& project = session.project();
  switch (info.offer.thing) {
    case Thing::kJoint:
      return Joints(session.figure(), true, false);
    case Thing::kHinge:
      return Joints(session.figure(), false, true);
    case Thing::kJointOrHinge:
      return Joints(session.figure(), true, true);
    case Thing::kJointOrRoot:
      return JointsAndRoot(session.figure());
    case Thing::kCurve:
      return Curves(session.figure());
    case Thing::kLink:
      return NamesIn(session.figure().links());
    case Thing::kSelectionSet:
      return NamesIn(project.selection_sets);
    case Thing::kSceneOrHeldObject: {
      std::vector<FormOption> objects = NamesIn(project.scene.objects);
      for (FormOption& held : NamesIn(project.held_objects)) objects.push_back(std::move(held));
      return objects;
    }
    default:
      break;
  }
  std::vector<FormOption> items = Items(info.offer.thing, project);
  return items.empty() ? Words(info.offer) : items;
}

std::vector<FormOption> Filtered(const std::vector<FormOption>& options, const std::string& typed) {
  std::vector<FormOption> kept;
  for (const FormOption& option : options) {
    if (LowerCase(option.label).find(LowerCase(typed)) != std::string::npos) kept.push_back(option);
  }
  return kept;
}

}  // namespace hazumi::ui
