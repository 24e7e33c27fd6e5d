// The project: its name, its time and what regions are solved with.

#include "ui/panels/commands/actions.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/sections.h"

namespace hazumi::ui {

namespace {

void DrawTime(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Frames"))) return;
  DrawInteger(editor, "first", Tr("First frame"), project.frames.first,
              [&](int frame, const std::string& drag) {
                editor->Do("time.range", {{"first", frame}, {"drag", drag}});
              });
  DrawInteger(editor, "last", Tr("Last frame"), project.frames.last,
              [&](int frame, const std::string& drag) {
                editor->Do("time.range", {{"last", frame}, {"drag", drag}});
              });
  DrawInteger(
      editor, "fps", Tr("Frames"), project.fps.num, [&](int frames, const std::string& drag) {
        editor->Do("time.rate", {{"num", frames}, {"den", project.fps.den}, {"drag", drag}});
      });
  DrawInteger(
      editor, "seconds", Tr("in seconds"), project.fps.den,
      [&](int seconds, const std::string& drag) {
        editor->Do("time.rate", {{"num", project.fps.num}, {"den", seconds}, {"drag", drag}});
      });
}

void DrawPreview(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Preview range"), false)) return;
  DrawCheck(editor, "preview", Tr("Play a part"), project.preview.has_value(), [&](bool on) {
    editor->Do("time.preview", on ? Json{{"first", project.frames.first}} : Json{{"off", true}});
  });
  if (!project.preview) return;
  const auto set = [&](const char* end) {
    return [editor, end](int frame, const std::string& drag) {
      editor->Do("time.preview", {{end, frame}, {"drag", drag}});
    };
  };
  DrawInteger(editor, "preview first", Tr("First frame"), project.preview->first, set("first"));
  DrawInteger(editor, "preview last", Tr("Last frame"), project.preview->last, set("last"));
}

void DrawSolver(Editor* editor, const Project& project) {
  if (!DrawHeading(Tr("Solver"))) return;
  const ProjectSolver& solver = project.solver;
  DrawChoice(editor, "method", Tr("Method"), {"exact", "paper"}, hazumi::NameOf(solver.method),
             [&](const std::string& name) {
               editor->Do("solver.set", {{"method", name}});
             });
  if (solver.method == Method::kExact) {
    const double tolerance = solver.tolerance_deg.value_or(kDefaultToleranceDeg);
    DrawNumber(editor, {"tolerance", Tr("Tolerance"), tolerance, "%.4f°", 0.0005},
               [&](double value, const std::string& drag) {
                 editor->Do("solver.set", {{"tolerance", value}, {"drag", drag}});
               });
    return;
  }
  DrawNumber(editor, {"step", Tr("Step"), solver.step_s.value_or(kDefaultStep), "%.4f s", 0.0005},
             [&](double value, const std::string& drag) {
               editor->Do("solver.set", {{"step", value}, {"drag", drag}});
             });
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
