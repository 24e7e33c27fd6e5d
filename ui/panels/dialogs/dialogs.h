#pragma once

#include "ui/panels/commands/actions.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Actions that open something on top of the panels.
std::vector<Action> DialogActions();

// What is refused, the status bar says.
inline void DoThen(const Then& then, Editor* editor) {
  if (then) (void)then(editor);
}

// Shows a dialog; whatever was in hand is put down.
void Open(Modal modal, Editor* editor);
void Close(Editor* editor);

// Does `then` at once, or after the user was asked what to do with unsaved changes.
Result<Done> AskToSave(Editor* editor, Then then);
// The answers: `then` is done after both, or nothing if the user cancels or saving fails.
void AnswerSave(Editor* editor);
void AnswerDiscard(Editor* editor);
void AnswerCancel(Editor* editor);
// Saves the project; asks for a name if it has none, and what to do if another program has changed
// its file. `then` is done after it was saved, or after the file's version was taken.
Result<Done> SaveThen(Editor* editor, Then then);
// The answers to that question. Saving as opens the file dialog.
void AnswerKeepMine(Editor* editor);
void AnswerTakeTheirs(Editor* editor);
void AnswerSaveAs(Editor* editor);

// Shows the file dialog; `then` is done after a project was saved.
void OpenFileDialog(Editor* editor, const FilePurpose& purpose, Then then = nullptr);
// Shows it to choose the render dialog's folder; that dialog comes back after either answer.
void OpenFolderDialog(Editor* editor);
// The same for the export dialog's file.
void OpenExportFileDialog(Editor* editor);
void OpenOntoFileDialog(Editor* editor);
void LeaveFileDialog(Editor* editor);
void GoToFolder(const std::string& folder, Editor* editor);
void ReadFolder(Editor* editor);
void SelectEntry(int entry, Editor* editor);
// Goes to the folder that the name says, or takes the file.
void ChooseFile(Editor* editor);

// Where the middle of a dialog is from the left [px]: that of the window, or beside a card that it
// would cover, if it fits there.
float MiddleOfDialog(float width, const Rect& window, const Rect& card);

// Runs an action or operator, after a form if it needs to know more.
Result<Done> RunOrAsk(Editor* editor, const std::string& id, const Json& parameters);
// Runs what the form says.
void SubmitForm(Editor* editor);

void OpenRenderDialog(Editor* editor, bool whole);
// Starts to draw what the dialog says.
void StartRender(Editor* editor);

void OpenExportDialog(Editor* editor);
void CloseExport(Editor* editor);
// Writes what the dialog says; asks before it overwrites.
void StartExport(Editor* editor);
void ConfirmExport(Editor* editor);

// Puts a project at the top of the recent ones.
void AddRecent(const std::string& path, Settings* settings);

}  // namespace hazumi::ui
