// The question whether a file outside of the project's folder is opened.

#include "engine/project/project_files.h"
#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

// The project's sound or reference, if it is closed and nobody has answered yet; empty: neither.
std::string FileInQuestion(const Editor& editor) {
  const edit::Session& session = editor.session();
  const std::string& project = session.document().path();
  for (const std::string& file :
       {SoundPath(session.project(), project), ReferencePath(session.project(), project)}) {
    const bool is_answered = editor.dialogs.kept_closed.contains(file);
    if (!is_answered && session.media().WhyClosed(file, project)) return file;
  }
  return "";
}

}  // namespace

void AskAboutOutsideFile(Editor* editor) {
  DialogsState& dialogs = editor->dialogs;
  if (dialogs.modal != Modal::kNone || !editor->recovery.journals.empty()) return;
  dialogs.asked_outside = FileInQuestion(*editor);
  if (dialogs.asked_outside.empty()) return;
  editor->NeedGlyphs(dialogs.asked_outside);
  Open(Modal::kOutsideFile, editor);
}

// Enter and Esc keep it closed: nobody opens it by accident.
void DrawOutsideFile(Editor* editor) {
  const std::string& file = editor->dialogs.asked_outside;
  if (FileInQuestion(*editor) != file) return Close(editor);  // another document, or it was chosen
  ImGui::TextWrapped("%s", Tr("The project names a sound or reference outside of its folder:"));
  ImGui::Spacing();
  ImGui::TextWrapped("%s", file.c_str());
  ImGui::Spacing();
  ImGui::TextWrapped("%s", Tr("Open it if you know who made the project."));
  ImGui::Spacing();
  const int clicked = DrawButtons(
      *editor, {{Tr("Keep it closed"), ""},
                {Tr("Open it (O)"), Tr("Opens it, and does not ask again for this file.")}});
  const bool opens = clicked == 1 || ImGui::IsKeyPressed('O', false);
  if (!opens && clicked != 0 && !IsEscapePressed(*editor)) return;
  if (opens) {
    editor->OpenOutside(file);
  } else {
    editor->dialogs.kept_closed.insert(file);
  }
  Close(editor);
}

}  // namespace hazumi::ui
