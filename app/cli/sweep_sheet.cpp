#include "app/cli/sweep_sheet.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/cli/cell_pictures.h"
#include "app/cli/terminal.h"
#include "engine/base/text.h"
#include "engine/picture/decode_pictures.h"
#include "engine/project/json/text_file.h"
#include "engine/project/project_files.h"
#include "engine/sweep/table_text.h"
#include "render/image/halve.h"
#include "render/image/png.h"
#include "render/sheet/contact_sheet.h"
#include "render/text/text_mesh.h"

namespace hazumi {

namespace {

using render::Sheet;
using render::SheetPanel;
using render::SheetTile;
using render::SrgbColor;

constexpr size_t kMostCellsSeen = 2500;
constexpr size_t kPicturesAtATime = 50;
constexpr double kMostPicturePixels = 40e6;
constexpr SrgbColor kFailed = render::FromHex(0x2b2b2b), kNothing = render::FromHex(0xd5d5d2);

std::optional<double> Number(const std::string& text) {
  double value = 0.0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// From dark blue over teal to yellow; brighter is more, also in grey.
SrgbColor ColorAt(double share) {
  constexpr SrgbColor kStops[] = {render::FromHex(0x2a3f73), render::FromHex(0x2f6f8e),
                                  render::FromHex(0x35a08a), render::FromHex(0x9cc75b),
                                  render::FromHex(0xf4e26a)};
  const double at = std::clamp(share, 0.0, 1.0) * 4.0;
  const auto i = std::min(static_cast<size_t>(at), size_t{3});
  const auto t = static_cast<float>(at - static_cast<double>(i));
  const SrgbColor &a = kStops[i], &b = kStops[i + 1];
  return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b)};
}

// A grid of the axes' values, or all cells in a row that is broken where it is long.
class SheetMaker {
 public:
  SheetMaker(const Sweep& sweep, const Rows& rows)
      : sweep_(sweep), rows_(rows), sizes_(AxisSizes(sweep.plan())), value_(FirstMeasure()) {}

  // `pictures`: one a cell, or none at all.
  Sheet Make(std::vector<std::optional<Image>> pictures) {
    pictures_ = std::move(pictures);
    Sheet sheet;
    sheet.title = ShownName(sweep_.project().name, sweep_.project_file());
    sheet.title += ": " + std::to_string(rows_.size() - 1) + " cells";
    sheet.note = Note();
    if (sweep_.plan().combine == SweepCombine::kGrid) {
      for (long first = 0; first < sweep_.cells(); first += CellsInPanel()) {
        sheet.panels.push_back(GridPanel(first));
      }
    } else {
      sheet.panels.push_back(ListPanel());
    }
    SetTileSize(&sheet);
    return sheet;
  }

 private:
  const std::string& At(long cell, size_t column) const {
    return rows_[static_cast<size_t>(cell) + 1][column];
  }
  size_t FirstMeasure() const { return sweep_.plan().vary.size() + 1; }
  bool HasMeasure() const { return value_ + 1 < rows_.front().size(); }

  std::string Note() {
    FindSpan();
    std::string note = "made by " + sweep_.plan().project;
    if (!HasMeasure()) return note;
    note = rows_.front()[value_];
    note += least_ <= most_
                ? ", from " + FormatShort(least_) + " (dark) to " + FormatShort(most_) + " (bright)"
                : ": none";
    return note + "; black: the cell failed; grey: there is none";
  }

  void FindSpan() {
    least_ = 1e300;
    most_ = -1e300;
    for (size_t i = 1; HasMeasure() && i < rows_.size(); ++i) {
      if (const auto number = Number(rows_[i][value_])) {
        least_ = std::min(least_, *number);
        most_ = std::max(most_, *number);
      }
    }
  }

  int Columns() const { return sizes_.back(); }
  int RowsOfPanel() const { return sizes_.size() > 1 ? sizes_[sizes_.size() - 2] : 1; }
  long CellsInPanel() const { return static_cast<long>(Columns()) * RowsOfPanel(); }

  SheetPanel GridPanel(long first) {
    const std::vector<SweepAxis>& axes = sweep_.plan().vary;
    SheetPanel panel;
    panel.columns = Columns();
    panel.column_axis = axes.back().field;
    for (int i = 0; i < panel.columns; ++i) {
      panel.column_labels.push_back(At(first + i, axes.size()));
    }
    panel.column_labels = ShortDecimals(panel.column_labels);
    if (axes.size() > 1) {
      panel.row_axis = axes[axes.size() - 2].field;
      for (int i = 0; i < RowsOfPanel(); ++i) {
        panel.row_labels.push_back(
            At(first + i * static_cast<long>(panel.columns), axes.size() - 1));
      }
      panel.row_labels = ShortDecimals(panel.row_labels);
    }
    for (size_t axis = 0; axis + 2 < axes.size(); ++axis) {
      if (sizes_[axis] == 1) continue;
      panel.title += (panel.title.empty() ? "" : ", ") + axes[axis].field + " = " +
                     ShortDecimal(At(first, axis + 1), 4);
    }
    for (long i = 0; i < CellsInPanel(); ++i) panel.tiles.push_back(TileOf(first + i, false));
    return panel;
  }

  SheetPanel ListPanel() {
    SheetPanel panel;
    const long cells = sweep_.cells();
    panel.columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(cells))));
    panel.column_axis = "cells in the order of sweep.csv, each with its number";
    for (long i = 0; i < cells; ++i) panel.tiles.push_back(TileOf(i, true));
    return panel;
  }

  SheetTile TileOf(long cell, bool is_numbered) {
    SheetTile tile;
    tile.color = At(cell, rows_.front().size() - 1).empty() ? kNothing : kFailed;
    if (is_numbered) tile.caption = std::to_string(cell);
    if (!HasMeasure() || tile.color == kFailed) return WithPicture(cell, std::move(tile));
    if (const auto number = Number(At(cell, value_))) {
      tile.color = ColorAt(most_ > least_ ? (*number - least_) / (most_ - least_) : 0.5);
      tile.caption += (is_numbered ? ": " : "") + FormatShort(*number);
    }
    return WithPicture(cell, std::move(tile));
  }

  SheetTile WithPicture(long cell, SheetTile tile) {
    if (!pictures_.empty()) tile.picture = std::move(pictures_[static_cast<size_t>(cell)]);
    return tile;
  }

  // As wide as the widest picture, or number, or what stands over a column.
  static void SetTileSize(Sheet* sheet) {
    constexpr double kCap = 8.0;
    sheet->tile_width = 24;
    sheet->tile_height = 20;
    for (const SheetPanel& panel : sheet->panels) {
      for (const std::string& label : panel.column_labels) Widen(label, kCap, sheet);
      for (const SheetTile& tile : panel.tiles) {
        Widen(tile.caption, kCap, sheet);
        if (!tile.picture) continue;
        sheet->tile_width = std::max(sheet->tile_width, tile.picture->width);
        sheet->tile_height = std::max(sheet->tile_height, tile.picture->height);
      }
    }
  }
  static void Widen(const std::string& text, double cap, Sheet* sheet) {
    const int width = static_cast<int>(std::ceil(render::TextWidth(text, cap))) + 8;
    sheet->tile_width = std::max(sheet->tile_width, width);
  }

  const Sweep& sweep_;
  const Rows& rows_;
  std::vector<int> sizes_;
  size_t value_;
  double least_ = 0.0, most_ = 0.0;
  std::vector<std::optional<Image>> pictures_;
};

// So small that all of them have room on a sheet.
Image Fitted(Image picture, size_t count) {
  while (static_cast<double>(picture.width) * picture.height * static_cast<double>(count) >
         kMostPicturePixels) {
    picture = render::Halved(picture);
  }
  return picture;
}

// Of cells from `first` to `end`; a cell that failed has none.
Result<Done> ReadPictures(const SweepStore& store, const Rows& rows, size_t first, size_t end,
                          std::vector<std::optional<Image>>* pictures) {
  std::vector<std::vector<std::uint8_t>> files;
  std::vector<size_t> cells;
  for (size_t cell = first; cell < end; ++cell) {
    if (!rows[cell + 1].back().empty()) continue;
    const Result<std::string> file =
        ReadTextFile(store.PicturePath(static_cast<long>(cell), ".png"));
    if (!file.ok()) return file.error();
    files.push_back(BytesOf(file.value()));
    cells.push_back(cell);
  }
  const std::vector<std::span<const std::uint8_t>> spans(files.begin(), files.end());
  std::vector<Result<Image>> images = DecodePictures(spans);
  for (size_t i = 0; i < cells.size(); ++i) {
    if (!images[i].ok()) {
      Error error = images[i].error();
      error.file = store.PicturePath(static_cast<long>(cells[i]), ".png");
      return error;
    }
    (*pictures)[cells[i]] = Fitted(std::move(images[i]).value(), rows.size() - 1);
  }
  return Done();
}

Result<std::vector<std::optional<Image>>> PicturesOf(const Sweep& sweep, const SweepStore& store,
                                                     const Rows& rows) {
  std::vector<std::optional<Image>> pictures;
  if (!sweep.plan().picture || sweep.plan().picture->video) return pictures;
  pictures.resize(rows.size() - 1);
  for (size_t first = 0; first < pictures.size(); first += kPicturesAtATime) {
    const size_t end = std::min(first + kPicturesAtATime, pictures.size());
    const Result<Done> read = ReadPictures(store, rows, first, end, &pictures);
    if (!read.ok()) return read.error();
  }
  return pictures;
}

}  // namespace

Result<bool> WriteSweepSheet(const Sweep& sweep, const SweepStore& store, const Rows& rows) {
  if (rows.size() - 1 > kMostCellsSeen) {
    PrintLine(stderr, "hazumi: warning: no sheet is drawn of more than %zu cells", kMostCellsSeen);
    return false;
  }
  auto pictures = PicturesOf(sweep, store, rows);
  if (!pictures.ok()) return pictures.error();
  const Result<Image> image =
      render::DrawSheet(SheetMaker(sweep, rows).Make(std::move(pictures).value()));
  if (!image.ok()) return image.error();
  const Result<Done> written = render::WritePng(store.SheetPath(), image.value(), {});
  if (!written.ok()) return written.error();
  return true;
}

}  // namespace hazumi
