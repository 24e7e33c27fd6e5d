#pragma once

#include <memory>
#include <optional>

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/graph/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// How the selected keys are moved.
struct MoveKeysOptions {
  bool duplicates = false;       // copies of them
  bool by_button = false;        // as long as the left button is held
  double value_per_px = 0.0;     // upwards, in the graph; 0: time only
  std::optional<KeyList> click;  // selected alone if the mouse never moves
};
std::unique_ptr<Tool> MakeMoveKeys(Editor* editor, Point start, MoveKeysOptions options);

// Stretches the selected keys about the current frame.
std::unique_ptr<Tool> MakeScaleKeys(Editor* editor, Point start);

// Selects the keys in a rectangle. Not held: it waits for the button.
std::unique_ptr<Tool> MakeBoxSelect(Editor* editor, Point start, bool by_button);

// A handle of the graph follows the mouse and sets the rate of its key.
std::unique_ptr<Tool> MakeDragHandle(Editor* editor, Point start, const GraphKey& key, int side,
                                     const std::string& curve);

// Runs "keys.select".
void SelectKeys(Editor* editor, const KeyList& keys, const char* mode);
// The keys whose marks lie in a rectangle of the dope sheet or the graph editor, as shown.
KeyList ShownKeysIn(Editor* editor, const Rect& box);

}  // namespace hazumi::ui
