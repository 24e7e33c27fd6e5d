#pragma once

// Pictures or coloured numbers in rows and columns, with their axes labelled.

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/picture/image.h"
#include "render/scene/color.h"

namespace hazumi::render {

// A picture, or a field of one colour. The caption stands on it.
struct SheetTile {
  std::optional<Image> picture;
  SrgbColor color{0.5f, 0.5f, 0.5f};
  std::string caption;
};

// A table. There is a label for each column and row, or none at all.
struct SheetPanel {
  std::string title;
  std::string column_axis, row_axis;  // what the labels are values of
  std::vector<std::string> column_labels, row_labels;
  int columns = 1;
  std::vector<SheetTile> tiles;  // row by row; the last row may be short
};

struct Sheet {
  std::string title, note;
  std::vector<SheetPanel> panels;
  int tile_width = 0, tile_height = 0;  // [px]; pictures may be smaller
};

inline constexpr double kMostSheetPixels = 64e6;

// Panels stand side by side and below each other, so that the sheet is about as high as it is wide.
// Errors: kSemantics where it would have more than kMostSheetPixels.
Result<Image> DrawSheet(const Sheet& sheet);

}  // namespace hazumi::render
