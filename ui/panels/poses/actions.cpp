#include "ui/panels/poses/actions.h"

#include <algorithm>
#include <set>

#include "engine/base/filled.h"
#include "engine/body/figure_body.h"
#include "engine/project/edits/placements.h"
#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/keys/at_frame.h"
#include "ui/edit/operators/pose/posing.h"

namespace hazumi::ui {

namespace {

using edit::Parameters;

constexpr double kHumanStands = 0.9024;  // root of the human that comes with Hazumi [m]

// Height of the highest level plane of the scene; 0 without one [m].
double GroundOf(const Project& project) {
  std::optional<double> ground;
  for (const ProjectSceneObject& object : project.scene.objects) {
    const auto* plane = std::get_if<ProjectPlane>(&object.shape);
    if (!plane || plane->normal != Vec3::UnitZ()) continue;
    ground = std::max(ground.value_or(plane->offset_m), plane->offset_m);
  }
  return ground.value_or(0.0);
}

// Without where it stands and where it looks; where a placement says how high it is, that neither.
// `share`: of its height.
edit::Pose RootPart(const SavedRoot& root, double share, edit::Session* session) {
  edit::Pose pose = {{kRootCurveNames[kRootAngleY], root.angle_y_deg},
                     {kRootCurveNames[kRootAngleX], root.angle_x_deg}};
  const Animation* animation = session->animation();
  if (animation && !edit::IsPlaced(*animation, session->frame())) {
    pose.push_back({kRootCurveNames[kRootZ], GroundOf(session->project()) + share * root.height_m});
  }
  return pose;
}

// A pose of the human on a figure with other hinges: by what the hinges do.
edit::Pose BodyPart(const SavedPose& pose, edit::Session* session) {
  const Figure& figure = session->figure();
  const FigureBody body(figure);
  edit::Pose part;
  for (const Named<double>& angle : pose.human.empty() ? pose.joints : pose.human) {
    for (const HingeShare& share : body.HingesFor(angle.name)) {
      const std::string& name = figure.joint(share.hinge).name;
      const double angle_here = share.share * angle.value;
      const auto known = std::find_if(
          part.begin(), part.end(), [&](const Named<double>& other) { return other.name == name; });
      if (known == part.end()) {
        part.push_back({name, angle_here});
      } else {
        known->value += angle_here;
      }
    }
  }
  if (part.empty() || !pose.root) return part;
  const double share = StandingHeight(figure) / pose.root->standing_height_m.value_or(kHumanStands);
  const edit::Pose root = RootPart(*pose.root, share, session);
  part.insert(part.begin(), root.begin(), root.end());
  return part;
}

// What the figure has of a pose: by the names of its hinges if it has most of them, else by what
// they do. What it has not goes to `unknown`.
edit::Pose KnownPart(const SavedPose& pose, edit::Session* session,
                     std::vector<std::string>* unknown) {
  edit::Pose known;
  if (pose.root) known = RootPart(*pose.root, 1.0, session);
  for (const Named<double>& angle : pose.joints) {
    if (session->figure().FindJoint(angle.name)) {
      known.push_back(angle);
    } else {
      unknown->push_back(angle.name);
    }
  }
  if (2 * unknown->size() <= pose.joints.size()) return known;
  edit::Pose by_role = BodyPart(pose, session);
  if (by_role.empty()) return known;
  unknown->clear();
  return by_role;
}

bool IsSelected(const std::string& curve, const edit::Session& session) {
  const std::set<std::string>& selected = session.selected_joints();
  if (selected.empty()) return true;
  return RootCurveNamed(curve) ? session.is_root_selected() : selected.contains(curve);
}

// A root that has no mirror plane along an axis is left as it is: its image would stand elsewhere.
Result<edit::Pose> Mirrored(const edit::Pose& pose, edit::Session* session) {
  Result<edit::Pose> flipped = edit::Flipped(pose, session);
  if (!flipped.ok()) return flipped;
  edit::Pose kept = std::move(flipped).value();
  std::erase_if(kept, [&](const Named<double>& angle) {
    const auto is_same = [&](const Named<double>& other) { return other.name == angle.name; };
    return RootCurveNamed(angle.name) && std::none_of(pose.begin(), pose.end(), is_same);
  });
  return kept;
}

// A few of them, and how many more there are.
std::string Listed(const std::vector<std::string>& names) {
  constexpr size_t kMost = 4;
  std::string text;
  for (size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += (text.empty() ? "" : ", ") + names[i];
  }
  if (names.size() <= kMost) return text;
  return text + " and " + std::to_string(names.size() - kMost) + " more";
}

Result<SavedPose> PoseNamed(const std::string& name, PoseLibrary* library) {
  const std::optional<Error> error = library->Refresh();
  if (const SavedPose* pose = library->Find(name)) return *pose;
  if (error) return *error;
  return Refusal("name", "there is no pose \"" + name + "\" in the library");
}

Result<Done> ApplyPose(Editor* editor, const Parameters& p) {
  const Result<SavedPose> pose = PoseNamed(p.text("name"), &editor->poses.library);
  if (!pose.ok()) return pose.error();
  const Result<PoseOnFigure> on = OnFigure(pose.value(), p.yes("flipped"), &editor->session());
  if (!on.ok()) return on.error();
  Json blend = {{"curves", on.value().curves},
                {"values", on.value().values},
                {"share", p.number("share", 1.0)}};
  if (p.has("drag")) blend["drag"] = p.text("drag");
  Result<Done> done = editor->Invoke("pose.blend", blend);
  if (done.ok() && !on.value().unknown.empty()) {
    editor->Say(Filled(Tr("Left alone, as the figure does not have them: %s"),
                       Listed(on.value().unknown).c_str()));
  }
  return done;
}

// Adds what the human would have, unless the figure has the human's hinges.
void AddHuman(const Figure& figure, SavedPose* pose) {
  VecX q = VecX::Zero(figure.num_joints());
  std::set<JointIndex> has;
  for (const Named<double>& angle : pose->joints) {
    const std::optional<JointIndex> joint = figure.FindJoint(angle.name);
    if (!joint) continue;
    q[joint->value()] = angle.value;
    has.insert(*joint);
  }
  const FigureBody body(figure);
  bool is_human = true;
  for (const auto& [name, angle] : body.HumanAngles(q)) {
    const std::vector<HingeShare> shares = body.HingesFor(name);
    const bool is_known = std::any_of(shares.begin(), shares.end(), [&](const HingeShare& share) {
      return has.contains(share.hinge);
    });
    if (!is_known) continue;
    is_human = is_human && figure.FindJoint(name).has_value();
    pose->human.push_back({name, angle});
  }
  if (is_human) {
    pose->human.clear();
  } else if (pose->root) {
    pose->root->standing_height_m = StandingHeight(figure);
  }
}

Result<Done> SavePose(Editor* editor, const Parameters& p) {
  edit::Session& session = editor->session();
  SavedPose pose;
  pose.name = p.text("name");
  for (const std::string& curve : edit::PosedCurves(session)) {
    if (!session.figure().FindJoint(curve)) continue;
    const Result<double> angle = session.ValueNow(curve);
    if (!angle.ok()) return angle.error();
    pose.joints.push_back({curve, angle.value()});
  }
  if (session.selected_joints().empty() || session.is_root_selected()) {
    const Result<const MotionFrame*> now = session.FrameNow();
    if (!now.ok()) return now.error();
    const auto values = RootValues(now.value()->X_WR, session.project().root, session.frame());
    const double height = values[kRootZ] - GroundOf(session.project());
    pose.root = SavedRoot{height, values[kRootAngleY], values[kRootAngleX], {}, {}};
  }
  AddHuman(session.figure(), &pose);
  Result<Done> saved = editor->poses.library.Save(std::move(pose), p.yes("replace"));
  if (saved.ok()) editor->Say(Filled(Tr("The pose \"%s\" is kept."), p.text("name").c_str()));
  return saved;
}

Result<Done> RenamePose(Editor* editor, const Parameters& p) {
  return editor->poses.library.Rename(p.text("name"), p.text("to"));
}

Result<Done> RemovePose(Editor* editor, const Parameters& p) {
  return editor->poses.library.Remove(p.text("name"));
}

edit::ParameterInfo ShareParameter() {
  edit::ParameterInfo share = {"share", edit::ParameterKind::kNumber, false,
                               "how far from the present pose to it; not given: 1"};
  share.range = kShare;
  return share;
}

}  // namespace

Result<PoseOnFigure> OnFigure(const SavedPose& pose, bool is_flipped, edit::Session* session) {
  PoseOnFigure on;
  edit::Pose known = KnownPart(pose, session, &on.unknown);
  if (!pose.joints.empty() && on.unknown.size() == pose.joints.size()) {
    return Refusal("name", "the figure has none of the joints of \"" + pose.name + "\" (" +
                               Listed(on.unknown) + "); it was made for another figure");
  }
  if (is_flipped) {
    Result<edit::Pose> mirrored = Mirrored(known, session);
    if (!mirrored.ok()) return mirrored.error();
    known = std::move(mirrored).value();
  }
  for (const Named<double>& angle : known) {
    if (!IsSelected(angle.name, *session)) continue;
    on.curves.push_back(angle.name);
    on.values.push_back(angle.value);
  }
  if (!on.curves.empty()) return on;
  return Refusal("", "\"" + pose.name +
                         "\" has nothing of what is selected; select other joints, "
                         "or none for all of it");
}

std::vector<Action> PoseLibraryActions() {
  using enum edit::ParameterKind;
  const edit::ParameterInfo name = {"name", kText, true, "of a pose"};
  return {
      {"pose.save",
       "Save pose",
       "Keeps the angles of the selected joints, or of all with the root's height and lean, for"
       " any project.",
       {{"name", kText, true, "its name"},
        {"replace", kYesNo, false, "true: a pose of this name is replaced"}},
       SavePose},
      {"pose.apply",
       "Apply pose",
       "Keys a pose of the library, of the selected joints or of all.",
       {name, ShareParameter(), {"flipped", kYesNo, false, "true: left for right"}, edit::kDrag},
       ApplyPose},
      {"pose.rename",
       "Rename pose",
       "Gives a pose of your own another name.",
       {name, {"to", kText, true, "its new name"}},
       RenamePose},
      {"pose.remove",
       "Remove pose",
       "Takes a pose of your own out of the library; projects stay as they are.",
       {name},
       RemovePose},
      {"tool.breakdown",
       "Breakdown",
       "Blends between the keys before and after with the mouse, or by typed percent.",
       {},
       [](Editor* editor, const Parameters&) {
         return TakeShareTool(editor, "pose.breakdown", Json::object());
       }},
      {"tool.relax",
       "Relax pose",
       "Brings the pose nearer to the line between its keys with the mouse.",
       {},
       [](Editor* editor, const Parameters&) {
         return TakeShareTool(editor, "pose.relax", Json::object());
       }},
      {"tool.push",
       "Push pose",
       "Takes the pose away from the line between its keys with the mouse.",
       {},
       [](Editor* editor, const Parameters&) {
         return TakeShareTool(editor, "pose.push", Json::object());
       }},
      {"pose.live_mirror",
       "Live mirror",
       "What is posed on one side is posed on the other too, as its mirror image, or not.",
       {{"on", kYesNo, false, "not given: the other way round"}},
       [](Editor* editor, const Parameters& p) -> Result<Done> {
         editor->mirrors_poses = p.yes("on", !editor->mirrors_poses);
         return Done();
       }}};
}

}  // namespace hazumi::ui
