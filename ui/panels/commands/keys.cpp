#include "ui/panels/commands/keys.h"

namespace hazumi::ui {

namespace {

std::string NameOfKey(int key) {
  switch (key) {
    case kSpace:
      return "Space";
    case kComma:
      return ",";
    case kPeriod:
      return ".";
    case kEscape:
      return "Esc";
    case kEnter:
      return "Enter";
    case kTab:
      return "Tab";
    case kBackspace:
      return "Backspace";
    case kDelete:
      return "Del";
    case kRight:
      return "Right";
    case kLeft:
      return "Left";
    case kDown:
      return "Down";
    case kUp:
      return "Up";
    case kPageUp:
      return "PageUp";
    case kPageDown:
      return "PageDown";
    case kHome:
      return "Home";
    case kEnd:
      return "End";
    case kPadPeriod:
      return "Pad .";
    case kPadEnter:
      return "Pad Enter";
    default:
      break;
  }
  if (key >= kF1 && key <= kF12) return "F" + std::to_string(key - kF1 + 1);
  if (key >= kPad0 && key < kPad0 + 10) return "Pad " + std::to_string(key - kPad0);
  return std::string(1, static_cast<char>(key));
}

}  // namespace

std::string NameOf(const Chord& chord) {
  if (chord.key == kNoKey) return "";
  std::string name;
  if (chord.ctrl) name += "Ctrl+";
  if (chord.alt) name += "Alt+";
  if (chord.shift) name += "Shift+";
  return name + NameOfKey(chord.key);
}

}  // namespace hazumi::ui
