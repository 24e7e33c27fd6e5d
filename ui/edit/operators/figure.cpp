// The figure. What is mirrored is edited on both sides.

#include <set>

#include "engine/exchange/import/changed_role.h"
#include "engine/figure/figure_bone.h"
#include "engine/makers/aims/aims.h"
#include "engine/makers/fills/fills.h"
#include "engine/project/enum_names.h"
#include "engine/project/figure_editor.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

Result<Done> Edit(Session* session, const char* label, const std::string& drag,
                  const std::function<Result<Done>(ProjectFigure*)>& edit) {
  return session->Edit(
      label, [&](Project* project) { return edit(&project->figure); }, drag);
}

Result<Done> SetLimits(Session* session, const Parameters& p) {
  return Edit(session, "Set joint limits", p.text("drag"), [&](ProjectFigure* figure) {
    return SetHingeLimits(p.text("joint"), p.maybe_number("lower"), p.maybe_number("upper"),
                          figure);
  });
}

Result<Done> SetLink(Session* session, const Parameters& p) {
  if (p.number("mass") < 0.0) return Refusal("mass", "must not be negative");
  if (p.has("radius") && p.number("radius") <= 0.0) {
    return Refusal("radius", "must be greater than 0");
  }
  return Edit(session, "Change link", p.text("drag"), [&](ProjectFigure* figure) {
    return ChangeLink(p.text("link"), {p.maybe_number("mass"), p.maybe_number("radius")}, figure);
  });
}

// By name of each selected hinge or root: its joint.
std::vector<std::pair<std::string, std::string>> SelectedByJoint(const Session& session) {
  const Figure& figure = session.figure();
  std::vector<std::pair<std::string, std::string>> selected;
  for (const std::string& name : session.selected_joints()) {
    const auto hinge = figure.FindJoint(name);
    selected.emplace_back(name, hinge ? figure.group(figure.joint(*hinge).group).name : name);
  }
  return selected;
}

// Joints stay selected whose hinges have other names now.
void SelectAgain(const std::vector<std::pair<std::string, std::string>>& selected,
                 Session* session) {
  const Figure& figure = session->figure();
  std::set<std::string> names;
  for (const auto& [name, joint] : selected) {
    const auto group = figure.FindGroup(joint);
    if (figure.FindJoint(name) || !group) {
      names.insert(name);
      continue;
    }
    const JointGroup& hinges = figure.group(*group);
    for (int j = hinges.first.value(); j <= hinges.last().value(); ++j) {
      names.insert(figure.joint(JointIndex(j)).name);
    }
  }
  session->set_selected_joints(std::move(names));
}

Result<Done> SetRole(Session* session, const Parameters& p) {
  BodyPlace place;
  for (const auto& role : EnumNames<BodyRole>::kNames) {
    if (p.text("role") == role.name) place.role = role.value;
  }
  for (const auto& side : EnumNames<BodySide>::kNames) {
    if (p.text("side") == side.name) place.side = side.value;
  }
  const auto selected = SelectedByJoint(*session);
  Result<Done> done = session->Edit("Change role", [&](Project* project) {
    // Fills make their keys anew, for the new hinges.
    if (!project->fills.empty()) makers::RemoveGeneratedKeys(project);
    // Torques of aims are of hinges by name, which may change: they are found anew.
    for (ProjectRegion& region : project->regions) makers::LetLoose(&region);
    return ChangeRole(p.text("joint"), place, project);
  });
  if (done.ok()) SelectAgain(selected, session);
  return done;
}

std::string FolderOf(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

Result<Done> Embed(Session* session, const Parameters&) {
  return Edit(session, "Embed figure", "", [&](ProjectFigure* figure) {
    return EmbedFigure(FolderOf(session->document().path()), figure);
  });
}

Result<Done> SetSkin(Session* session, const Parameters& p) {
  const std::string name = p.text("skin");
  ProjectSkin skin;
  for (const auto& shipped : EnumNames<ShippedSkin>::kNames) {
    if (name == shipped.name) skin.shipped = shipped.value;
  }
  if (!skin && name != "none") return Refusal("skin", "\"" + name + "\" is none of human, none");
  for (const SkinBone& bone : skin ? skin.meshes()->bones : std::vector<SkinBone>()) {
    if (FindBone(session->figure(), bone)) continue;
    return Refusal("skin", "the figure has no joint \"" + bone.joint + "\", as the skin needs");
  }
  return session->Edit("Change skin", [&](Project* project) -> Result<Done> {
    project->skin = std::move(skin);
    return Done();
  });
}

}  // namespace

std::vector<Operator> FigureOperators() {
  return {{"figure.joint_limits",
           "Set joint limits",
           "Sets how far a hinge turns; its rest angle is moved inside. Both sides of a mirrored "
           "one.",
           {{"joint", kText, true, "a hinge", Thing::kHinge},
            {"lower", kNumber, false, "degrees"},
            {"upper", kNumber, false, "degrees; as the lower one: the hinge is fixed there"},
            kDrag},
           SetLimits},
          {"figure.link",
           "Change link",
           "Sets the mass and the thickness of a link; both sides of a mirrored one.",
           {{"link", kText, true, "a link's name", Thing::kLink},
            {"mass", kNumber, false, "kilograms"},
            {"radius", kNumber, false, "of its capsule, which touches things, in metres"},
            kDrag},
           SetLink},
          {"figure.role",
           "Change role",
           "Says which part of a body a joint is. It gets the hinges and limits of that part; it "
           "and what hangs on it stay as they are at their keys.",
           {{"joint", kText, true, "a joint", Thing::kJoint},
            {"role", kText, true, "which part", WordsOf<BodyRole>()},
            {"side", kText, false, "of the body; not given: the middle", WordsOf<BodySide>()}},
           SetRole},
          {"figure.embed",
           "Embed figure",
           "Takes the figure's file into the project, where it can be changed.",
           {},
           Embed},
          {"figure.skin",
           "Change skin",
           "Puts a skin on the figure, or takes it off. Drawing only: the motion stays.",
           {{"skin", kText, true, "human, for figures with the shipped human's joints; or none",
             "human none"}},
           SetSkin}};
}

}  // namespace hazumi::edit
