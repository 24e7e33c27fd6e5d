#pragma once

#include <string>
#include <vector>

#include "ui/panels/commands/actions.h"

namespace hazumi::ui {

// A box of the scene or a held object instead of whatever is selected; an invalid id: none.
void SelectObject(Editor* editor, ItemId object);
// If the operator put one into the scene, this one is, and no joints are.
void SelectAdded(Editor* editor, const std::string& id);
// Null if none is.
const ProjectHeldObject* SelectedHeldObject(const Editor& editor);
// Of either; empty if none is.
std::string NameOfSelectedObject(const Editor& editor);

// For the list in commands/actions.cpp.
std::vector<Action> ObjectActions();

}  // namespace hazumi::ui
