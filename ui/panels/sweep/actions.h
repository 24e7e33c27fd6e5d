#pragma once

#include "ui/panels/commands/actions.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Looking at the cells of a sweep: each gives the project its values while it is chosen, as a drag
// does, and one is kept or none.
std::vector<Action> SweepActions();
// "friction.default" of "regions[arms].friction.default": what tells columns apart.
std::string ShortName(const std::string& name);
// Closes a sweep that was opened for a document that is no longer there, and says so.
void CloseSweepOfOther(Editor* editor);
// Whether the project still has the values of the cell that was kept last.
bool HasKeptCell(const Editor& editor);

// The texture with the picture of the cell that is looked at, read when it is first asked for; 0:
// it has none. One that cannot be read is said once.
unsigned PictureOfCell(Editor* editor);
// Width over height of the first picture, as all are; 0: there is none that can be read.
double AspectOfPictures(const SweptFolder& swept);
// Takes it away.
void DropPicture(Editor* editor);

}  // namespace hazumi::ui
