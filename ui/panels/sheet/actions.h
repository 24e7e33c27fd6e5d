#pragma once

#include "ui/edit/parameters.h"
#include "ui/panels/window/editor.h"

// Actions of the dope sheet and the graph editor, for the list in actions.cpp.
namespace hazumi::ui::sheet {

using edit::Parameters;

// Tools for the selected keys; refused if there are none.
Result<Done> MoveKeys(Editor* editor, const Parameters&);
Result<Done> DuplicateKeys(Editor* editor, const Parameters&);
Result<Done> ScaleKeys(Editor* editor, const Parameters&);
Result<Done> BoxSelect(Editor* editor, const Parameters&);

// All keys of the rows or curves that are shown.
Result<Done> SelectAll(Editor* editor, const Parameters&);
// Takes the selected keys away; if there are none, what the bar stands for that was clicked last.
Result<Done> Delete(Editor* editor, const Parameters&);
Result<Done> Mute(Editor* editor, const Parameters&);
Result<Done> MarkRegion(Editor* editor, const Parameters&);
// Opens the small window with the name of a marker or a region.
Result<Done> Rename(Editor* editor, const Parameters&);
Result<Done> PreviewRange(Editor* editor, const Parameters&);

// "popup": interpolation, handles or key_type.
Result<Done> Open(Editor* editor, const Parameters& p);
Result<Done> OnlySelected(Editor* editor, const Parameters&);
Result<Done> FrameAll(Editor* editor, const Parameters&);
Result<Done> FrameSelected(Editor* editor, const Parameters&);

}  // namespace hazumi::ui::sheet
