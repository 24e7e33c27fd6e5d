// What is wrong with the motion, each with the way there and its cures.

#include "engine/base/text.h"
#include "ui/panels/commands/actions.h"
#include "ui/panels/problems/problems.h"
#include "ui/panels/properties/fields.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/window/status_line.h"

namespace hazumi::ui {

namespace {

// A copy: a button may change the list.
void DrawProblem(Editor* editor, const Problem problem) {
  ImGui::PushStyleColor(ImGuiCol_Text,
                        ToIm4(problem.is_error ? colors::kSinking : colors::kChanged));
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(problem.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  const std::string there =
      std::string(Tr("Go to frame")) + " " + FormatShort(problem.frame) + "##there";
  if (DrawButton(there.c_str(), Tr("Shows the frame, and selects what it is about."))) {
    GoTo(problem, editor);
  }
  for (const Cure& cure : problem.cures) {
    const std::string& label = cure.label.empty() ? LabelOf(cure.operator_id) : cure.label;
    if (DrawButton(label.c_str(), HelpOf(cure.operator_id.c_str()))) Apply(cure, editor);
  }
  ImGui::Spacing();
}

}  // namespace

void DrawProblemsSection(Editor* editor) {
  const std::vector<Problem> problems = ProblemsOf(editor);
  if (!DrawHeading(Tr("Problems"))) return;
  if (problems.empty()) {
    const bool is_busy =
        !BakingText(*editor).empty() || editor->flights.is_busy() || !editor->ground.is_done();
    return DrawNote(is_busy ? Tr("Still looking...") : Tr("No problems are known."));
  }
  int number = 0;
  for (const Problem& problem : problems) {
    ImGui::PushID(number++);
    DrawProblem(editor, problem);
    ImGui::PopID();
  }
}

}  // namespace hazumi::ui
