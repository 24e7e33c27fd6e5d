// The project: its name, its time and what regions are solved with.

#include "ui/panels/commands/actions.h"
#include "ui/panels/properties/field_rows.h"
#include "ui/panels/properties/sections.h"

namespace hazumi::ui {

namespace {

void DrawTime(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Frames"))) return;
  DrawFieldRows(editor, project.frames, {}, SetBy(editor, "time.range"));
  DrawFieldRows(editor, project.fps, {}, [&](Json change, const std::string& drag) {
    if (!change.contains("num")) change["num"] = project.fps.num;
    if (!change.contains("den")) change["den"] = project.fps.den;
    SetBy(editor, "time.rate")(change, drag);
  });
}

void DrawPreview(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Preview range"), false)) return;
  DrawCheck(editor, "preview", Tr("Play a part"), project.preview.has_value(), [&](bool on) {
    editor->Do("time.preview", on ? Json{{"first", project.frames.first}} : Json{{"off", true}});
  });
  if (!project.preview) return;
  ImGui::PushID("preview");
  DrawFieldRows(editor, *project.preview, {}, SetBy(editor, "time.preview"));
  ImGui::PopID();
}

// Of the tolerance and the step that which the method has.
void DrawSolver(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Solver"))) return;
  const ProjectSolver& solver = project.solver;
  DrawFieldRows(editor, solver, {solver.method == Method::kExact ? "step" : "tolerance"},
                SetBy(editor, "solver.set"), InsteadBy(solver));
}

}  // namespace

void DrawProjectSection(Editor* editor) {
  const Project project = editor->session().project();
  DrawText(editor, "name", Tr("Name"), project.name, [&](const std::string& name) {
    editor->Do("project.rename", {{"name", name}});
  });
  DrawTime(editor, project);
  DrawFlights(editor);
  DrawPreview(editor, project);
  DrawSolver(editor, project);
}

}  // namespace hazumi::ui
