#include "ui/panels/commands/keys.h"

#include <cstring>
#include <utility>

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
  const bool is_printed = key > kSpace && key < 97;
  return is_printed ? std::string(1, static_cast<char>(key)) : "";
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

std::optional<Chord> ChordNamed(const std::string& name) {
  Chord chord;
  std::string rest = name;
  const auto take = [&rest](const char* prefix) {
    const bool has = rest.starts_with(prefix);
    if (has) rest.erase(0, std::strlen(prefix));
    return has;
  };
  chord.ctrl = take("Ctrl+");
  chord.alt = take("Alt+");
  chord.shift = take("Shift+");
  for (chord.key = kSpace; chord.key < kLeftShift; ++chord.key) {
    if (NameOfKey(chord.key) == rest && !rest.empty()) return chord;
  }
  return std::nullopt;
}

namespace {

constexpr std::pair<Place, const char*> kPlaces[] = {
    {Place::kAnywhere, "anywhere"}, {Place::kViewport, "viewport"}, {Place::kSheet, "sheet"}};

}  // namespace

const char* NameOf(Place place) {
  for (const auto& [known, name] : kPlaces) {
    if (known == place) return name;
  }
  return "";
}

std::optional<Place> PlaceNamed(const std::string& name) {
  for (const auto& [place, known] : kPlaces) {
    if (name == known) return place;
  }
  return std::nullopt;
}

}  // namespace hazumi::ui
