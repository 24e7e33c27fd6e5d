#pragma once

#include "ui/panels/commands/menus.h"
#include "ui/panels/viewport/hit_test.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What can be done with what is under the mouse, once it is selected; nothing under it: with the
// view.
std::vector<MenuEntry> ItemsAt(const Editor& editor, const ViewportHit& hit);
// What the Add menu offers.
std::vector<MenuEntry> ItemsToAdd();
// Selects what is under the mouse, unless it is selected, and opens what can be done with it.
void OpenViewportPopup(Editor* editor, const ViewportHit& hit);
void DrawViewportPopups(Editor* editor);

}  // namespace hazumi::ui
