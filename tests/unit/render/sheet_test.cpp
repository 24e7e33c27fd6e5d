// Texts, rectangles and pictures on a sheet: where they are seen, and nowhere else.

#include <gtest/gtest.h>

#include "render/sheet/contact_sheet.h"
#include "render/sheet/draw_text.h"
#include "render/text/text_mesh.h"

namespace hazumi::render {
namespace {

constexpr SrgbColor kRed{1.0f, 0.0f, 0.0f}, kBlack{0.0f, 0.0f, 0.0f};
constexpr double kCap = 8.0;

Image White(int width, int height) {
  Image image(width, height);
  image.rgba.assign(image.rgba.size(), 255);
  return image;
}

std::array<int, 3> ColorIn(const Image& image, int x, int y) {
  const size_t i = 4 * (static_cast<size_t>(y) * image.width + x);
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}
constexpr std::array<int, 3> kWhite = {255, 255, 255};

// The part of a picture with its upper left corner at (x, y).
Image Cropped(const Image& image, int x, int y, int width, int height) {
  Image part(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      for (size_t k = 0; k < 4; ++k) {
        part.rgba[4 * (static_cast<size_t>(row) * width + column) + k] =
            image.rgba[4 * (static_cast<size_t>(row + y) * image.width + column + x) + k];
      }
    }
  }
  return part;
}

TEST(DrawText, ChangesPixelsWhereItStandsAndNowhereElse) {
  Image image = White(120, 60);
  DrawText("Hq", 30.0, 40.0, kCap, kBlack, &image);
  const double right = 30.0 + TextWidth("Hq", kCap);
  int changed = 0, darkest = 255;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (ColorIn(image, x, y) == kWhite) continue;
      ++changed;
      darkest = std::min(darkest, ColorIn(image, x, y)[0]);
      EXPECT_TRUE(x >= 28 && x <= right + 2 && y >= 40 - kCap - 2 && y <= 40 + 5) << x << ", " << y;
    }
  }
  // The three strokes of an H alone are about 22 pixels long.
  EXPECT_GT(changed, 22);
  EXPECT_LT(darkest, 32);
  // The left stroke of the H goes up from the baseline.
  int column = 28;
  while (column < 40 && ColorIn(image, column, 36) == kWhite) ++column;
  for (int y = 34; y < 39; ++y) EXPECT_NE(ColorIn(image, column, y), kWhite) << y;
}

TEST(DrawText, MixesItsColourIntoWhatIsThere) {
  Image image(60, 20);
  FillRectangle(0, 0, 60, 20, {0.0f, 0.0f, 1.0f}, &image);
  DrawText("H", 5.0, 15.0, kCap, kRed, &image);
  int most_red = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 60; ++x) {
      const auto [red, green, blue] = ColorIn(image, x, y);
      most_red = std::max(most_red, red);
      EXPECT_EQ(green, 0);
      EXPECT_NEAR(red + blue, 255, 1);
    }
  }
  EXPECT_GT(most_red, 230);
}

TEST(DrawText, IsCutOffAtEveryEdge) {
  constexpr int kAround = 40, kWide = 30, kHigh = 14;
  for (const auto& [x, y] : {std::pair(-6.0, 10.0),
                             {22.5, 10.0},
                             {3.0, 3.0},
                             {3.0, 17.0},
                             {-100.0, 8.0},
                             {100.0, 8.0},
                             {3.0, -50.0},
                             {3.0, 80.0},
                             {-9.0, 1.0}}) {
    Image large = White(kWide + 2 * kAround, kHigh + 2 * kAround), small = White(kWide, kHigh);
    DrawText("Wave", x + kAround, y + kAround, kCap, kBlack, &large);
    DrawText("Wave", x, y, kCap, kBlack, &small);
    EXPECT_EQ(small.rgba, Cropped(large, kAround, kAround, kWide, kHigh).rgba) << x << ", " << y;
  }
}

TEST(DrawText, OfNothingChangesNothing) {
  Image image = White(20, 20);
  DrawText("", 5.0, 10.0, kCap, kBlack, &image);
  DrawText(" ", 5.0, 10.0, kCap, kBlack, &image);
  EXPECT_EQ(image.rgba, White(20, 20).rgba);
  Image empty(0, 0);
  DrawText("text", 0.0, 0.0, kCap, kBlack, &empty);
}

TEST(FillRectangle, FillsWholePixelsThatLieInThePicture) {
  for (const auto& [x, y, w, h] : {std::array{3, 2, 4, 5},
                                   {-2, -3, 5, 5},
                                   {7, 6, 9, 9},
                                   {-5, -5, 50, 50},
                                   {20, 20, 3, 3},
                                   {2, 2, 0, 4},
                                   {-9, 0, 4, 4}}) {
    Image image = White(10, 8);
    FillRectangle(x, y, w, h, kBlack, &image);
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 10; ++column) {
        const bool is_in = column >= x && column < x + w && row >= y && row < y + h;
        EXPECT_EQ(ColorIn(image, column, row) == kWhite, !is_in) << column << ", " << row;
      }
    }
  }
}

TEST(CopyInto, CopiesWhatLiesInThePicture) {
  Image from(6, 5);
  for (size_t i = 0; i < from.rgba.size(); ++i) from.rgba[i] = static_cast<std::uint8_t>(i);
  for (const auto& [x, y] : {std::pair(2, 1), {-3, -2}, {7, 6}, {-6, 0}, {10, 0}, {0, -5}}) {
    Image image = White(10, 8);
    CopyInto(from, x, y, &image);
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 10; ++column) {
        const int i = column - x, k = row - y;
        const bool is_in = i >= 0 && i < 6 && k >= 0 && k < 5;
        EXPECT_EQ(ColorIn(image, column, row), is_in ? ColorIn(from, i, k) : kWhite)
            << column << ", " << row;
      }
    }
  }
}

// A table of two by two with all that can be said of it.
Sheet Table() {
  Sheet sheet;
  sheet.title = "Throws";
  sheet.note = "dark is near";
  sheet.tile_width = 40;
  sheet.tile_height = 30;
  SheetPanel panel;
  panel.title = "one";
  panel.columns = 2;
  panel.column_axis = "friction";
  panel.row_axis = "frame";
  panel.column_labels = {"0.5", "1"};
  panel.row_labels = {"11", "12"};
  for (int i = 0; i < 4; ++i) panel.tiles.push_back({{}, {0.2f * i, 0.5f, 1.0f - 0.2f * i}, ""});
  sheet.panels = {panel};
  return sheet;
}

long CountOf(const Image& image, const std::array<int, 3>& color) {
  long count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += ColorIn(image, x, y) == color ? 1 : 0;
  }
  return count;
}

TEST(DrawSheet, ShowsEveryTileWhole) {
  const Image image = DrawSheet(Table()).value();
  for (const auto& color :
       {std::array{0, 128, 255}, {51, 128, 204}, {102, 128, 153}, {153, 128, 102}}) {
    EXPECT_EQ(CountOf(image, color), 40 * 30);
  }
}

TEST(DrawSheet, ShowsPicturesPixelByPixel) {
  Sheet sheet = Table();
  Image picture(40, 30);
  for (size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(i / 4 % 199 + 17 * (i % 4));
  }
  sheet.panels[0].tiles[3].picture = picture;
  const Image plain = DrawSheet(Table()).value(), image = DrawSheet(sheet).value();
  // Where its colour was; in the lower left corner lies the plate of its caption.
  int x = 0, y = 0;
  while (ColorIn(plain, x, y) != std::array{153, 128, 102}) {
    if (++x == plain.width) x = 0, ++y;
  }
  for (int row = 0; row < 30 - 17; ++row) {
    for (int column = 0; column < 40; ++column) {
      EXPECT_EQ(ColorIn(image, x + column, y + row), ColorIn(picture, column, row));
    }
  }
}

TEST(DrawSheet, ATextChangesItsOwnPlaceAlone) {
  Sheet captioned = Table();
  captioned.panels[0].tiles[0].caption = "7";
  const Image plain = DrawSheet(Table()).value(), image = DrawSheet(captioned).value();
  ASSERT_EQ(image.width, plain.width);
  ASSERT_EQ(image.height, plain.height);
  int changed = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (ColorIn(image, x, y) == ColorIn(plain, x, y)) continue;
      ++changed;
      EXPECT_EQ(ColorIn(plain, x, y), (std::array{0, 128, 255})) << "outside of its tile";
    }
  }
  EXPECT_GT(changed, 5);
}

TEST(DrawSheet, LeavesOutACaptionWiderThanItsTile) {
  Sheet sheet = Table();
  sheet.panels[0].tiles[0].caption = "much too long to be read on it";
  EXPECT_EQ(DrawSheet(sheet).value().rgba, DrawSheet(Table()).value().rgba);
}

TEST(DrawSheet, OfManyPanelsIsAboutSquare) {
  Sheet sheet = Table();
  for (int i = 0; i < 24; ++i) sheet.panels.push_back(sheet.panels[0]);
  const Image image = DrawSheet(sheet).value();
  EXPECT_EQ(CountOf(image, {0, 128, 255}), 25 * 40 * 30);
  const double ratio = static_cast<double>(image.width) / image.height;
  EXPECT_GT(ratio, 0.6);
  EXPECT_LT(ratio, 1.7);
}

TEST(DrawSheet, OfNothingIsPaperAndItsTitle) {
  Sheet sheet;
  sheet.title = "none";
  EXPECT_GT(DrawSheet(sheet).value().width, 20);
}

TEST(DrawSheet, TooLargeIsRefused) {
  Sheet sheet = Table();
  sheet.tile_width = sheet.tile_height = 5000;
  const Result<Image> image = DrawSheet(sheet);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().code, ErrorCode::kSemantics);
  EXPECT_EQ(image.error().message,
            "the sheet would have more than 64 million pixels: make the pictures smaller");
}

}  // namespace
}  // namespace hazumi::render
