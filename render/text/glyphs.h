#pragma once

#include <string_view>

namespace hazumi::render {

// A letter of the built-in stroke font, drawn for Hazumi on a grid of small integers: baseline 3,
// height of x 9, height of capitals 12, depth of descenders 0.
//
// `strokes` are words of points, each point two characters (x, then y; 'a' is 10, 'b' 11, ...).
// A word beginning with '~' is a curve that starts and ends at its outer points and is pulled by
// the inner ones; 'o' begins a closed curve that touches the middles of its polygon's edges.
struct Glyph {
  char32_t code;
  int advance;
  std::string_view strokes;
};

inline constexpr int kBaseline = 3;
inline constexpr int kCapHeight = 9;  // above the baseline

// The glyph of a code point, or that of an unknown sign (a box).
const Glyph& FindGlyph(char32_t code);

}  // namespace hazumi::render
