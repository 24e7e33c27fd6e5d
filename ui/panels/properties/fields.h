#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/panels/properties/layout.h"
#include "ui/panels/window/editor.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// Rows of the properties: a label, a field and what happens when the field is changed. Each row has
// the identifier `id` within ImGui's stack, so that two with one label do not meet.

// A collapsible heading; its rows follow if it is true.
bool DrawHeading(const char* title, bool is_open_at_first = true);
void DrawNote(const std::string& text);  // faint, wrapped

struct NumberField {
  std::string id, label;
  double value = 0.0;
  const char* format = "%.3f";
  double speed = 0.01;              // per pixel
  double lower = 0.0, upper = 0.0;  // that the mouse reaches; equal: no limits
  bool is_slider = false;           // filled from lower to upper
  FieldState state = FieldState::kPlain;
  bool has_key_button = false;
};
// Dragged with the mouse (Shift: slowly, Esc takes it back), typed after a double click. `submit`
// takes the new value and the drag that it belongs to.
using SubmitNumber = std::function<void(double value, const std::string& drag)>;
// True if the key button was clicked.
bool DrawNumber(Editor* editor, const NumberField& field, const SubmitNumber& submit);
// Whole numbers.
void DrawInteger(Editor* editor, const std::string& id, const std::string& label, int value,
                 const std::function<void(int value, const std::string& drag)>& submit);
// x, y and z, one below the other.
void DrawVector(Editor* editor, const std::string& label, const Vec3& value, const char* format,
                const std::function<void(int axis, double value, const std::string& drag)>& submit);

using SubmitText = std::function<void(const std::string&)>;
void DrawText(Editor* editor, const std::string& id, const std::string& label,
              const std::string& value, const SubmitText& submit);
// `shown`: what the names read like.
void DrawChoice(Editor* editor, const std::string& id, const std::string& label,
                const std::vector<std::string>& names, const std::string& now,
                const SubmitText& submit);
void DrawCheck(Editor* editor, const std::string& id, const std::string& label, bool value,
               const std::function<void(bool)>& submit);
// "#rrggbb"; a click opens a picker.
void DrawColor(
    Editor* editor, const std::string& id, const std::string& label, const std::string& value,
    const std::function<void(const std::string& value, const std::string& drag)>& submit);
// A text that cannot be changed.
void DrawFact(Editor* editor, const std::string& label, const std::string& text);
// True if a button the width of the panel, or of its share, was clicked. One whose label needs more
// takes it; what then has no room beside it is a line below.
bool DrawButton(const char* label, const char* help, int share = 1);

}  // namespace hazumi::ui
