#pragma once

#include <optional>
#include <string>

namespace hazumi::ui {

// Keys by the numbers that GLFW gives them; letters and digits are their ASCII codes in upper case.
enum Key : int {
  kNoKey = 0,
  kSpace = 32,
  kComma = 44,
  kPeriod = 46,
  kLeftBracket = 91,
  kRightBracket = 93,
  kEscape = 256,
  kEnter = 257,
  kTab = 258,
  kBackspace = 259,
  kDelete = 261,
  kRight = 262,
  kLeft = 263,
  kDown = 264,
  kUp = 265,
  kPageUp = 266,
  kPageDown = 267,
  kHome = 268,
  kEnd = 269,
  kF1 = 290,
  kF2 = 291,
  kF3 = 292,
  kF12 = 301,
  kPad0 = 320,
  kPad1 = 321,
  kPad3 = 323,
  kPad5 = 325,
  kPad7 = 327,
  kPadPeriod = 330,
  kPadEnter = 335,
  kLeftShift = 340,
  kLeftControl = 341,
  kLeftAlt = 342,
  kLeftSuper = 343,
  kRightShift = 344,
  kRightControl = 345,
  kRightAlt = 346,
};

// A key with the modifiers that go with it.
struct Chord {
  int key = kNoKey;
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Chord&) const = default;
};

// "Ctrl+Shift+Z"; empty if there is no key.
std::string NameOf(const Chord& chord);
// And back; none if no key is called so.
std::optional<Chord> ChordNamed(const std::string& name);

// Where the mouse has to be for a key to count.
enum class Place { kAnywhere, kViewport, kSheet };
// "sheet"
const char* NameOf(Place place);
std::optional<Place> PlaceNamed(const std::string& name);

}  // namespace hazumi::ui
