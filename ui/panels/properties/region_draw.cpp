// The region that is shown: what is given of it, and what became of it.

#include <algorithm>
#include <cmath>

#include "engine/base/filled.h"
#include "engine/project/checks/joint_names.h"
#include "engine/spatial/degrees.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/dope_sheet/bar_tools.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/text/quantity_text.h"

namespace hazumi::ui {

namespace {

void ChooseRegion(Editor* editor, const std::string& shown) {
  const std::vector<ProjectRegion>& regions = editor->session().project().regions;
  std::vector<std::string> names;
  names.reserve(regions.size());
  for (const ProjectRegion& region : regions) names.push_back(region.name);
  DrawChoice(editor, "region", Tr("Region"), names, shown, [&](const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    editor->side.region = regions[at].identity.id;
  });
}

// From the current frame on, of the selected joints.
void DrawAdd(Editor* editor) {
  if (!DrawButton(LabelOf("region.add"), HelpOf("region.add"))) return;
  edit::Session& session = editor->session();
  constexpr int kFrames = 10;
  const int frame = static_cast<int>(std::lround(session.frame()));
  const int last = std::min(frame + kFrames, session.project().frames.last);
  if (editor->Do("region.add", {{"first", frame},
                                {"last", last},
                                {"key_start", true},
                                {"contacts", TouchesWhenMade(session.project())}})) {
    editor->side.region = session.project().regions.back().identity.id;
  }
}

void Set(Editor* editor, const std::string& region, const Json& change) {
  SetBy(editor, "region.set", {{"region", region}})(change, "");
}

// What a region says that no section below draws.
void DrawFields(Editor* editor, const ProjectRegion& region) {
  DrawFieldRows(editor, region,
                {"joints", "friction", "method", "step", "tolerance", "contacts", "contacts_self",
                 "limit_tangents", "mute"},
                SetBy(editor, "region.set", {{"region", region.name}}));
}

// A joint that a click takes out. In lines as wide as the panel.
bool DrawChip(const std::string& joint) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const std::string label = joint + "  ×";
  const float width = ImGui::CalcTextSize(label.c_str()).x + 2.0f * style.FramePadding.x;
  const float right = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
  const float edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (right < edge) ImGui::SameLine();
  const bool is_clicked = ImGui::Button((label + "##chip").c_str());
  Tooltip(Tr("Takes the joint out of the region."));
  return is_clicked;
}

void DrawJoints(Editor* editor, const ProjectRegion& region) {
  if (!DrawHeading(Tr("Joints"))) return;
  const std::vector<std::string> names = NamesOf(region.joints);
  ImGui::Dummy({ImGui::GetContentRegionAvail().x, 0.0f});
  for (const std::string& joint : names) {
    if (!DrawChip(joint)) continue;
    editor->Do("region.remove_joints", {{"region", region.name}, {"joints", Json::array({joint})}});
    return;
  }
  if (DrawButton(Tr("Add selected"), Tr("Adds the selected joints, or the root, to the region."),
                 2)) {
    editor->Do("region.add_joints", {{"region", region.name}});
    return;
  }
  ImGui::SameLine();
  if (DrawButton(Tr("Take out selected"), Tr("Takes the selected joints, or the root, out of it."),
                 2)) {
    editor->Do("region.remove_joints", {{"region", region.name}});
  }
}

void DrawFactor(Editor* editor, const ProjectRegion& region, const std::string& joint,
                double factor) {
  NumberField field{"friction " + joint, joint.empty() ? Tr("All joints") : joint, factor, "%.3f"};
  field.lower = 0.0;
  field.upper = 1.0;
  field.is_slider = true;
  DrawNumber(editor, field, [&](double value, const std::string& drag) {
    Json change = {{"region", region.name}, {"factor", value}, {"drag", drag}};
    if (!joint.empty()) change["joint"] = joint;
    editor->Do("region.friction", change);
  });
  Tooltip(FrictionInWords(factor));
}

// All joints, those with a factor of their own, and the one that is selected.
void DrawFriction(Editor* editor, const ProjectRegion& region) {
  if (!DrawHeading(Tr("Friction: speed left"))) return;
  const ProjectFriction friction = region.friction;
  DrawFactor(editor, region, "", friction.default_factor);
  for (const auto& [joint, factor] : friction.joints) DrawFactor(editor, region, joint, factor);
  const edit::Session& session = editor->session();
  const Figure& figure = session.figure();
  const auto active = ActiveJoint(figure, session.selected_joints(), editor->side.active);
  if (!active || !JointsOf(region, figure)[figure.group(*active).first.value()]) return;
  const std::string& joint = figure.group(*active).name;
  const auto is_own = [&](const auto& entry) { return entry.name == joint; };
  if (std::any_of(friction.joints.begin(), friction.joints.end(), is_own)) {
    const std::string remove = std::string(Tr("No friction of its own")) + ": " + joint;
    if (!DrawButton(remove.c_str(), Tr("The selected joint has that of all joints again."))) return;
    editor->Do("region.friction", {{"region", region.name}, {"joint", joint}});
    return;
  }
  const std::string label = std::string(Tr("Own friction")) + ": " + joint;
  if (!DrawButton(label.c_str(), Tr("Gives the selected joint a friction of its own."))) return;
  editor->Do("region.friction",
             {{"region", region.name}, {"joint", joint}, {"factor", friction.default_factor}});
}

// Where the region says nothing of its own, as the project has it.
void DrawMethod(Editor* editor, const ProjectRegion& region) {
  if (!DrawHeading(Tr("Method"))) return;
  const ProjectSolver& solver = editor->session().project().solver;
  const bool is_exact = region.method.value_or(solver.method) == Method::kExact;
  std::vector<std::string> rows = {"method", is_exact ? "tolerance" : "step"};
  if (is_exact || region.contacts.scene) rows.emplace_back("contacts");
  if (is_exact || region.contacts.self) rows.emplace_back("contacts_self");
  rows.insert(rows.end(), {"limit_tangents", "mute"});
  DrawRowsOf(rows, editor, region, SetBy(editor, "region.set", {{"region", region.name}}),
             InsteadBy(solver));
  if (!region.method && !region.tolerance_deg && !region.step_s) return;
  if (DrawButton(Tr("As the project"),
                 Tr("Method, tolerance and step are those of the project again."))) {
    Set(editor, region.name, {{"as_project", true}});
  }
}

// Rates with which the joints are let go: of the key on the first frame, else what they have there.
void DrawStartRates(Editor* editor, const ProjectRegion& region, size_t index) {
  if (!DrawHeading(Tr("Start rates"), false)) return;
  edit::Session& session = editor->session();
  const Result<const Motion*> motion = session.MotionTo(region.first_frame);
  if (!motion.ok()) return DrawNote(motion.error().ToString());
  const size_t start = region.first_frame - session.project().frames.first;
  if (start >= motion.value()->frames.size()) return;
  const VecX rates = motion.value()->frames[start].after.qd;
  const std::vector<JointIndex> joints = session.animation()->regions[index].joints;
  for (const JointIndex j : joints) {
    const std::string hinge = session.figure().joint(j).name;
    DrawNumber(editor, {"start " + hinge, hinge, rates[j.value()] / kDegree, "%.0f°/s", 2.0},
               [&](double value, const std::string& drag) {
                 editor->Do(
                     "region.start_rate",
                     {{"region", region.name}, {"joint", hinge}, {"rate", value}, {"drag", drag}});
               });
  }
}

void DrawEnergy(Editor* editor, const EnergyBalance& energy) {
  const auto row = [&](const std::string& label, double joules) {
    DrawFact(editor, Tr(label.c_str()), Filled("%.3f J", joules));
  };
  row("Kinetic energy", energy.kinetic_end - energy.kinetic_start);
  row("Potential energy", energy.potential_end - energy.potential_start);
  for (const EnergyBalance::Work& work : energy.laws) row("By " + work.law, work.joules);
  row("By limits", energy.limits);
  row("By impacts of contacts", energy.impacts);
  row("By keyed joints", energy.keyed);
  row("Unexplained", energy.residual());
}

void DrawReport(Editor* editor, const ProjectRegion& region) {
  if (!DrawHeading(Tr("Report"))) return;
  const Result<const Motion*> motion = editor->session().WholeMotion();
  if (!motion.ok()) return DrawNote(motion.error().ToString());
  const auto& reports = motion.value()->regions;
  const auto report = std::find_if(reports.begin(), reports.end(),
                                   [&](const RegionReport& r) { return r.name == region.name; });
  if (report == reports.end()) return;
  DrawFact(editor, Tr("Solved"), ModelText(*report));
  DrawFact(editor, Tr("Evaluations"), std::to_string(report->evaluations));
  DrawFact(editor, Tr("Time"), Filled("%.0f µs", report->microseconds));
  if (report->method == Method::kExact) {
    DrawFact(editor, Tr("Error"), Filled("%.2g°", report->error_estimate / kDegree));
    if (const auto from = report->OneOfSeveralFrom()) {
      DrawFact(editor, Tr("One of several from"), Filled("F%.1f", *from));
    }
  }
  if (report->energy) DrawEnergy(editor, *report->energy);
}

void DrawDeeds(Editor* editor, const ProjectRegion& region) {
  const int frame = static_cast<int>(std::lround(editor->session().frame()));
  const std::string name = region.name;
  if (DrawButton(Tr("Split here"), HelpOf("region.split"), 3)) {
    editor->Do("region.split", {{"region", name}, {"frame", frame}});
    return;
  }
  ImGui::SameLine();
  if (DrawButton(Tr("To keys"), HelpOf("region.to_keys"), 3)) {
    editor->Do("region.to_keys", {{"region", name}});
    return;
  }
  ImGui::SameLine();
  if (DrawButton(Tr("Remove"), HelpOf("region.remove"), 3)) {
    editor->Do("region.remove", {{"region", name}});
  }
}

}  // namespace

void DrawRegionSection(Editor* editor) {
  edit::Session& session = editor->session();
  const auto index = ShownRegion(session.project(), editor->side.region, session.frame());
  if (!index) {
    DrawNote(Tr("There are no dynamics regions. Select joints and add one."));
    return DrawAdd(editor);
  }
  // A copy: what is done below may change the list.
  const ProjectRegion region = session.project().regions[*index];
  ChooseRegion(editor, region.name);
  DrawAdd(editor);
  DrawFields(editor, region);
  DrawJoints(editor, region);
  DrawFriction(editor, region);
  DrawDrives(editor, region);
  DrawMethod(editor, region);
  const bool is_there = session.animation() && *index < session.animation()->regions.size();
  if (is_there) DrawStartRates(editor, region, *index);
  DrawReport(editor, region);
  DrawDeeds(editor, region);
}

}  // namespace hazumi::ui
