// The joint that is shown: its angles, rates, limits and links; or the root.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/text.h"
#include "engine/body/figure_body.h"
#include "engine/figure/figure_builder.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"
#include "ui/edit/operators/keys/at_frame.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/text/role_text.h"

namespace hazumi::ui {

namespace {

const ProjectCurve* CurveOf(const std::string& hinge, const Project& project) {
  for (const auto& [name, curve] : project.joints) {
    if (name == hinge) return &curve;
  }
  return nullptr;
}

const ProjectKey* KeyAt(const ProjectCurve* curve, double frame) {
  if (!curve) return nullptr;
  const auto key = std::find_if(curve->keys.begin(), curve->keys.end(),
                                [&](const ProjectKey& k) { return k.frame == frame; });
  return key == curve->keys.end() ? nullptr : &*key;
}

// What is known of a hinge at the current frame.
struct HingeNow {
  JointIndex index;
  std::string name, label;
  const Joint* joint;
  double angle_deg = 0.0, rate_deg_s = 0.0;
  std::optional<ProjectKey> key;  // on the frame
  FieldState state = FieldState::kPlain;
};

std::vector<HingeNow> HingesOf(Editor* editor, const JointGroup& group) {
  edit::Session& session = editor->session();
  const Result<const MotionFrame*> now = session.ShownFrame();
  std::vector<HingeNow> hinges;
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    HingeNow hinge;
    hinge.index = JointIndex(j);
    hinge.joint = &session.figure().joint(hinge.index);
    hinge.name = hinge.label = hinge.joint->name;
    if (hinge.name.starts_with(group.name + "_")) {
      hinge.label = hinge.name.substr(group.name.size() + 1);
    }
    const ProjectCurve* curve = CurveOf(hinge.name, session.project());
    if (const ProjectKey* key = KeyAt(curve, session.frame())) hinge.key = *key;
    if (now.ok()) {
      hinge.angle_deg = now.value()->q[j] / kDegree;
      hinge.rate_deg_s = now.value()->after.qd[j] / kDegree;
      const bool is_computed = edit::IsSwung(*session.animation(), hinge.index, session.frame());
      hinge.state = StateOfField(curve, session.frame(), hinge.angle_deg, is_computed);
    }
    hinges.push_back(std::move(hinge));
  }
  return hinges;
}

void ToggleKey(Editor* editor, const std::string& curve, bool has_key) {
  if (has_key) {
    editor->Do("key.delete", {{"curve", curve}, {"frame", editor->session().frame()}});
  } else {
    editor->Do("key.insert", {{"curves", Json::array({curve})}});
  }
}

// Says that an angle was not taken as it was wanted; takes that back once one is.
void TellLimit(const HingeNow& hinge, double wanted_deg, Editor* editor) {
  const double lower = ShortestDegrees(hinge.joint->lower),
               upper = ShortestDegrees(hinge.joint->upper);
  constexpr double kEpsilon = 1e-6;
  const std::string about = hinge.name + ": ";
  if (wanted_deg >= lower - kEpsilon && wanted_deg <= upper + kEpsilon) {
    if (editor->message.text.starts_with(about)) editor->Say("");
    return;
  }
  char text[200];
  std::snprintf(text, sizeof text, Tr("%s° is beyond its limit, %s° is set"),
                FormatShort(wanted_deg).c_str(),
                FormatShort(std::clamp(wanted_deg, lower, upper)).c_str());
  editor->Say(about + text);
}

void DrawAngles(Editor* editor, const std::vector<HingeNow>& hinges) {
  for (const HingeNow& hinge : hinges) {
    NumberField field{"angle " + hinge.name, Tr(hinge.label.c_str()), hinge.angle_deg, "%.1f°",
                      0.5};
    field.state = hinge.state;
    field.has_key_button = true;
    const bool toggles = DrawNumber(editor, field, [&](double value, const std::string& drag) {
      if (editor->Do("pose.rotate", {{"joint", hinge.name}, {"to", value}, {"drag", drag}})) {
        TellLimit(hinge, value, editor);
      }
    });
    if (toggles) ToggleKey(editor, hinge.name, hinge.key.has_value());
  }
}

// Of the hinges that have a key on the frame.
void DrawRates(Editor* editor, const std::vector<HingeNow>& hinges) {
  const auto has_key = [](const HingeNow& hinge) { return hinge.key.has_value(); };
  if (std::none_of(hinges.begin(), hinges.end(), has_key)) return;
  if (!DrawHeading(Tr("Rates"), false)) return;
  for (const HingeNow& hinge : hinges) {
    if (!hinge.key) continue;
    const bool is_given = hinge.key->rate.has_value();
    NumberField field{"rate " + hinge.name, Tr(hinge.label.c_str()),
                      is_given ? *hinge.key->rate : hinge.rate_deg_s, "%.0f°/s", 2.0};
    field.state = is_given ? FieldState::kKeyed : FieldState::kPlain;
    DrawNumber(editor, field, [&](double value, const std::string& drag) {
      editor->Do("key.rate", {{"curve", hinge.name},
                              {"frame", editor->session().frame()},
                              {"rate", value},
                              {"drag", drag}});
    });
  }
}

void DrawEmbed(Editor* editor) {
  if (editor->session().project().figure.file.empty()) return;
  DrawNote(Tr("The figure is a file of its own. Embed it to change limits and links."));
  if (DrawButton(LabelOf("figure.embed"), HelpOf("figure.embed"))) editor->Do("figure.embed");
}

void DrawLimits(Editor* editor, const std::vector<HingeNow>& hinges) {
  if (!DrawHeading(Tr("Limits"), false)) return;
  DrawEmbed(editor);
  for (const HingeNow& hinge : hinges) {
    const auto draw = [&](const char* which, const std::string& label, double value) {
      DrawNumber(editor, {which + hinge.name, label, ShortestDegrees(value), "%.1f°", 0.5},
                 [&](double wanted, const std::string& drag) {
                   editor->Do("figure.joint_limits",
                              {{"joint", hinge.name}, {which, wanted}, {"drag", drag}});
                 });
    };
    draw("lower", std::string(Tr(hinge.label.c_str())) + "  " + Tr("min"), hinge.joint->lower);
    draw("upper", Tr("max"), hinge.joint->upper);
  }
}

// A mass that a link has by its density: of the cylinder between its ends.
double MassOf(const LinkSpec& link) {
  if (link.mass) return *link.mass;
  const double area = std::numbers::pi * link.radius * link.radius;
  return link.density.value_or(0.0) * area * (link.to - link.from).norm();
}

void DrawLink(Editor* editor, const LinkSpec& link) {
  const auto submit = [&](const char* what) {
    return [editor, what, name = link.name](double value, const std::string& drag) {
      editor->Do("figure.link", {{"link", name}, {what, value}, {"drag", drag}});
    };
  };
  DrawNumber(editor, {"mass " + link.name, link.name, MassOf(link), "%.3f kg", 0.01},
             submit("mass"));
  DrawNumber(editor, {"radius " + link.name, Tr("radius"), link.radius, "%.3f m", 0.001},
             submit("radius"));
}

void DrawLinks(Editor* editor, const std::string& joint) {
  if (!DrawHeading(Tr("Links"), false)) return;
  DrawEmbed(editor);
  const FigureSpec spec = WithMirroredTwins(editor->session().project().figure.spec);
  if (joint == spec.root_name) {
    for (const LinkSpec& link : spec.root_links) DrawLink(editor, link);
  }
  for (const JointSpec& owner : spec.joints) {
    if (owner.name != joint) continue;
    for (const LinkSpec& link : owner.links) DrawLink(editor, link);
  }
}

// What the joint is in the body.
void DrawRole(Editor* editor, GroupIndex joint) {
  const edit::Session& session = editor->session();
  const JointGroup& group = session.figure().group(joint);
  std::vector<std::string> texts;
  for (const BodyPlace& place : AllPlaces()) texts.push_back(TextOf(place));
  const BodyPlace now = FigureBody(session.figure()).PlaceOf(joint);
  DrawChoice(editor, "role", Tr("Role"), texts, TextOf(now), [&](const std::string& text) {
    for (const BodyPlace& place : AllPlaces()) {
      if (TextOf(place) != text) continue;
      editor->Do(
          "figure.role",
          {{"joint", group.name}, {"role", NameOf(place.role)}, {"side", NameOf(place.side)}});
    }
  });
}

void DrawJoint(Editor* editor, const JointGroup& group) {
  const std::vector<HingeNow> hinges = HingesOf(editor, group);
  ImGui::PushID(group.name.c_str());
  if (DrawHeading((group.name + "##joint").c_str())) DrawAngles(editor, hinges);
  DrawRates(editor, hinges);
  DrawLimits(editor, hinges);
  DrawLinks(editor, group.name);
  if (DrawHeading(Tr("Part of the body"), false)) {
    DrawEmbed(editor);
    DrawRole(editor, editor->session().figure().joint(group.first).group);
  }
  ImGui::PopID();
}

void KeyRoot(Editor* editor, const char* curve, double value, const std::string& drag) {
  editor->Do(
      "key.set",
      {{"curve", curve}, {"frame", editor->session().frame()}, {"value", value}, {"drag", drag}});
}

// Where a placement says where the root is, its position is posed by the legs.
void DrawRoot(Editor* editor) {
  edit::Session& session = editor->session();
  const Result<const MotionFrame*> now = session.ShownFrame();
  if (!now.ok()) return DrawNote(now.error().ToString());
  const auto values = RootValues(now.value()->X_WR, session.project().root, session.frame());
  const auto& names = kRootCurveNames;
  const double frame = session.frame();
  const bool is_placed = edit::IsPlaced(*session.animation(), frame);
  const char* labels[] = {"Position  X", "Y", "Z", "Rotation  Z", "Y", "X"};
  for (int i = 0; i < kNumRootCurves; ++i) {
    const ProjectCurve& curve = session.project().root.curves[i];
    const bool is_computed = is_placed && i < kRootAngleZ;
    NumberField field{names[i], Tr(labels[i]), values[i], i < 3 ? "%.3f m" : "%.1f°",
                      i < 3 ? 0.005 : 0.5};
    field.state = StateOfField(&curve, frame, values[i], is_computed);
    field.has_key_button = !is_computed;
    const auto set = [&](double value, const std::string& drag) {
      if (!is_computed) return KeyRoot(editor, names[i], value, drag);
      Vec3 to(values[0], values[1], values[2]);
      to[i] = value;
      editor->Do("root.move", {{"x", to.x()}, {"y", to.y()}, {"z", to.z()}, {"drag", drag}});
    };
    if (!DrawNumber(editor, field, set)) continue;
    KeyAt(&curve, frame) ? ToggleKey(editor, names[i], true)
                         : KeyRoot(editor, names[i], values[i], "");
  }
}

}  // namespace

void DrawPoseSection(Editor* editor) {
  edit::Session& session = editor->session();
  const Figure& figure = session.figure();
  const auto active = ActiveJoint(figure, session.selected_joints(), editor->side.active);
  const bool is_root_active = !active || editor->side.active == figure.root_name();
  if (is_root_active && session.is_root_selected()) {
    if (DrawHeading((figure.root_name() + "##root").c_str())) DrawRoot(editor);
    return DrawLinks(editor, figure.root_name());
  }
  if (!active) return DrawNote(Tr("Nothing is selected. Click a joint."));
  DrawJoint(editor, figure.group(*active));
}

}  // namespace hazumi::ui
