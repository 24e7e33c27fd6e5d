#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The texture with the picture of the cell that is looked at, read when it is first asked for; 0:
// it has none. One that cannot be read is said once.
unsigned PictureOfCell(Editor* editor);
// Width over height of the first picture, as all are; 0: there is none that can be read.
double AspectOfPictures(const SweptFolder& swept);
// Takes it away.
void DropPicture(Editor* editor);

}  // namespace hazumi::ui
