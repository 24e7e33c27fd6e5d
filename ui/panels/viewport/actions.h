#pragma once

#include <string>
#include <vector>

#include "ui/panels/commands/actions.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What the viewport's keys do beside the document.
Result<Done> FrameSelected(Editor* editor);
Result<Done> FrameAll(Editor* editor);
// Once for each document: its whole motion comes into view, or a new project as it is by default,
// and all its frames.
void FrameNewDocument(Editor* editor);
Result<Done> LookThroughCamera(Editor* editor);
// The project gets a camera that looks as the view does.
Result<Done> SetCameraToView(Editor* editor);
// Each frame; what the mouse does on the viewport, which is the item drawn last.
void ActOnViewport(Editor* editor, const Rect& rect);

// A box of the scene or a held object instead of whatever is selected; an invalid id: none.
void SelectObject(Editor* editor, ItemId object);
// If the operator put one into the scene, this one is, and no joints are.
void SelectAdded(Editor* editor, const std::string& id);
// Null if none is.
const ProjectHeldObject* SelectedHeldObject(const Editor& editor);
// Returns the name of the selected object, of the scene or held; empty if none is selected.
std::string NameOfSelectedObject(const Editor& editor);

// For the list in commands/actions.cpp.
std::vector<Action> ObjectActions();

}  // namespace hazumi::ui
