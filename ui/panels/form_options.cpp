#include "ui/panels/form_options.h"

#include <algorithm>
#include <cctype>

#include "ui/edit/root_curves.h"
#include "ui/panels/limbs.h"

namespace hazumi::ui {

namespace {

using edit::Thing;

// "keyed": "Keyed".
std::string WithCapital(std::string word) {
  word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
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

std::vector<FormOption> Curves(const Figure& figure) {
  std::vector<FormOption> options = Joints(figure, false, true);
  for (const char* name : edit::kRootCurveNames) options.push_back({name, name, "Root"});
  return options;
}

template <typename T>
std::vector<FormOption> NamesIn(const std::vector<T>& list) {
  std::vector<FormOption> options;
  options.reserve(list.size());
  for (const T& entry : list) options.push_back({entry.name, entry.name, ""});
  return options;
}

std::vector<FormOption> Markers(const Project& project) {
  std::vector<FormOption> options;
  for (const ProjectMarker& marker : project.markers) {
    options.push_back({std::to_string(options.size()),
                       marker.name + " (" + std::to_string(marker.frame) + ")", ""});
  }
  return options;
}

template <typename Span>
FormOption Numbered(size_t number, const std::string& what, const Span& span) {
  const std::string frames =
      std::to_string(span.first_frame) + " - " + std::to_string(span.last_frame);
  return {std::to_string(number), what + " (" + frames + ")", ""};
}

std::vector<FormOption> Placements(const Project& project) {
  std::vector<FormOption> options;
  for (const ProjectPlacement& span : project.placements) {
    std::string what = NameOf(span.kind);
    if (!span.pin.empty()) what += " " + span.pin;
    options.push_back(Numbered(options.size(), what, span));
  }
  return options;
}

std::vector<FormOption> Holds(const Project& project) {
  std::vector<FormOption> options;
  for (const ProjectHold& hold : project.holds) {
    options.push_back(Numbered(options.size(), hold.joint, hold));
  }
  return options;
}

std::string Lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
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
    case Thing::kCurve:
      return Curves(session.figure());
    case Thing::kRegion:
      return NamesIn(project.regions);
    case Thing::kObject:
      return NamesIn(project.scene.objects);
    case Thing::kLink:
      return NamesIn(session.figure().links());
    case Thing::kMarker:
      return Markers(project);
    case Thing::kPlacement:
      return Placements(project);
    case Thing::kHold:
      return Holds(project);
    case Thing::kColor:
    case Thing::kShare:
    case Thing::kAny:
      break;
  }
  return Words(info.offer);
}

std::vector<FormOption> Filtered(const std::vector<FormOption>& options, const std::string& typed) {
  std::vector<FormOption> kept;
  for (const FormOption& option : options) {
    if (Lower(option.label).find(Lower(typed)) != std::string::npos) kept.push_back(option);
  }
  return kept;
}

}  // namespace hazumi::ui
