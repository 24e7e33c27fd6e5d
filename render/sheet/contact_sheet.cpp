#include "render/sheet/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "render/sheet/draw_text.h"
#include "render/text/text_mesh.h"

namespace hazumi::render {

namespace {

constexpr SrgbColor kPaper = FromHex(0xf4f4f2), kInk = FromHex(0x22262a), kPale = FromHex(0x6a7075);
constexpr SrgbColor kLight = FromHex(0xffffff);
constexpr double kCap = 8.0, kTitleCap = 11.0;  // height of capitals [px]
constexpr int kTileGap = 2, kMargin = 14, kLine = 20;

double WidestOf(const std::vector<std::string>& texts) {
  double widest = 0.0;
  for (const std::string& text : texts) widest = std::max(widest, TextWidth(text, kCap));
  return widest;
}

// Where the parts of a panel lie, from its upper left corner [px].
struct PanelLayout {
  int left = 0, top = 0;  // of the first tile
  int width = 0, height = 0;
};

PanelLayout LayOut(const SheetPanel& panel, const Sheet& sheet) {
  PanelLayout layout;
  const int rows = (static_cast<int>(panel.tiles.size()) + panel.columns - 1) / panel.columns;
  if (!panel.row_labels.empty()) {
    layout.left = static_cast<int>(std::ceil(WidestOf(panel.row_labels))) + 8;
  }
  if (!panel.title.empty()) layout.top += kLine;
  if (!panel.row_axis.empty() || !panel.column_axis.empty()) layout.top += kLine;
  if (!panel.column_labels.empty()) layout.top += kLine;
  const int table = panel.columns * (sheet.tile_width + kTileGap) - kTileGap;
  const double words =
      std::max({TextWidth(panel.title, kTitleCap), TextWidth(panel.column_axis, kCap) + layout.left,
                TextWidth(panel.row_axis, kCap)});
  layout.width = std::max(layout.left + table, static_cast<int>(std::ceil(words)));
  layout.height = layout.top + rows * (sheet.tile_height + kTileGap) - kTileGap;
  return layout;
}

void DrawTile(const SheetTile& tile, int x, int y, const Sheet& sheet, Image* image) {
  FillRectangle(x, y, sheet.tile_width, sheet.tile_height, tile.color, image);
  const double words = TextWidth(tile.caption, kCap);
  if (tile.picture) {
    CopyInto(*tile.picture, x, y, image);
    const int plate = static_cast<int>(words) + 8;
    FillRectangle(x, y + sheet.tile_height - 17, plate, 17, tile.color, image);
  }
  if (tile.caption.empty() || words > sheet.tile_width - 4) return;
  const bool is_dark = 0.3 * tile.color.r + 0.59 * tile.color.g + 0.11 * tile.color.b < 0.55;
  DrawText(tile.caption, x + 4, y + sheet.tile_height - 5, kCap, is_dark ? kLight : kInk, image);
}

// What names the columns, and on the line above it what names the rows.
void DrawLabels(const SheetPanel& panel, const PanelLayout& layout, int x, int y,
                const Sheet& sheet, Image* image) {
  int line = y - 6;
  if (!panel.title.empty()) DrawText(panel.title, x, line += kLine, kTitleCap, kInk, image);
  if (!panel.row_axis.empty() || !panel.column_axis.empty()) {
    line += kLine;
    const std::string down = panel.row_axis.empty() ? "" : "down: " + panel.row_axis;
    const std::string across = panel.column_axis.empty() ? "" : "across: " + panel.column_axis;
    DrawText(across + (across.empty() || down.empty() ? "" : "; ") + down, x, line, kCap, kPale,
             image);
  }
  for (size_t i = 0; i < panel.column_labels.size(); ++i) {
    DrawText(panel.column_labels[i],
             x + layout.left + static_cast<int>(i) * (sheet.tile_width + kTileGap) + 2,
             line + kLine, kCap, kInk, image);
  }
  for (size_t i = 0; i < panel.row_labels.size(); ++i) {
    const int row = y + layout.top + static_cast<int>(i) * (sheet.tile_height + kTileGap);
    DrawText(panel.row_labels[i], x, row + (sheet.tile_height + kCap) / 2, kCap, kInk, image);
  }
}

void DrawPanel(const SheetPanel& panel, const PanelLayout& layout, int x, int y, const Sheet& sheet,
               Image* image) {
  DrawLabels(panel, layout, x, y, sheet, image);
  for (size_t i = 0; i < panel.tiles.size(); ++i) {
    const int column = static_cast<int>(i) % panel.columns;
    const int row = static_cast<int>(i) / panel.columns;
    DrawTile(panel.tiles[i], x + layout.left + column * (sheet.tile_width + kTileGap),
             y + layout.top + row * (sheet.tile_height + kTileGap), sheet, image);
  }
}

}  // namespace

Result<Image> DrawSheet(const Sheet& sheet) {
  std::vector<PanelLayout> layouts;
  int width = 0, height = 0;
  for (const SheetPanel& panel : sheet.panels) {
    layouts.push_back(LayOut(panel, sheet));
    width = std::max(width, layouts.back().width + kMargin);
    height = std::max(height, layouts.back().height + kMargin);
  }
  const int count = static_cast<int>(sheet.panels.size());
  // Panels side by side: as many as make it about square.
  const double wanted = std::sqrt(static_cast<double>(count) * height / std::max(width, 1));
  const int across = std::clamp(static_cast<int>(std::lround(wanted)), 1, std::max(count, 1));
  const int down = (count + across - 1) / across;
  const int head = (sheet.note.empty() ? 1 : 2) * kLine + kMargin;
  const double words = std::max(TextWidth(sheet.title, kTitleCap), TextWidth(sheet.note, kCap));
  const double total_width = std::max(across * static_cast<double>(width), words) + 2 * kMargin;
  const double total_height = down * static_cast<double>(height) + head + kMargin;
  if (total_width * total_height > kMostSheetPixels) {
    return Error{ErrorCode::kSemantics, "", "",
                 "the sheet would have more than 64 million pixels: make the pictures smaller"};
  }
  Image image(static_cast<int>(total_width), static_cast<int>(total_height));
  FillRectangle(0, 0, image.width, image.height, kPaper, &image);
  DrawText(sheet.title, kMargin, kLine + 2, kTitleCap, kInk, &image);
  DrawText(sheet.note, kMargin, 2 * kLine + 2, kCap, kPale, &image);
  for (int i = 0; i < count; ++i) {
    DrawPanel(sheet.panels[static_cast<size_t>(i)], layouts[static_cast<size_t>(i)],
              kMargin + i % across * width, head + i / across * height, sheet, &image);
  }
  return image;
}

}  // namespace hazumi::render
