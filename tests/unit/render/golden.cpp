#include "golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "png_file.h"
#include "render/image/png.h"

namespace hazumi::render {
namespace {

namespace fs = std::filesystem;
constexpr int kBlock = 8;

int PixelDifference(const Image& a, const Image& b, int x, int y) {
  const size_t at = (static_cast<size_t>(y) * a.width + x) * 4;
  int worst = 0;
  for (size_t k = at; k < at + 3; ++k) worst = std::max(worst, std::abs(a.rgba[k] - b.rgba[k]));
  return worst;
}

double BlockMean(const Image& a, const Image& b, int x0, int y0) {
  const int x1 = std::min(x0 + kBlock, a.width), y1 = std::min(y0 + kBlock, a.height);
  int sum = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) sum += PixelDifference(a, b, x, y);
  }
  return double(sum) / ((x1 - x0) * (y1 - y0));
}

// Differences, five times as strong.
Image DifferenceImage(const Image& a, const Image& b) {
  Image image(a.width, a.height);
  for (size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = static_cast<std::uint8_t>(std::min(5 * std::abs(a.rgba[i] - b.rgba[i]), 255));
  }
  return image;
}

std::string LeaveEvidence(const Image& image, const Image& golden, const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / "hazumi_golden";
  fs::create_directories(folder);
  const bool written =
      WritePng(folder / (name + ".new.png"), image, {}).ok() &&
      WritePng(folder / (name + ".ref.png"), golden, {}).ok() &&
      WritePng(folder / (name + ".diff.png"), DifferenceImage(image, golden), {}).ok();
  return (written ? "see " : "could not write to ") + (folder / name).string() +
         ".{new,ref,diff}.png; if the new picture is right, run this test again with "
         "HAZUMI_UPDATE_GOLDENS=1";
}

}  // namespace

ImageDifference Compare(const Image& a, const Image& b) {
  ImageDifference result;
  const double one = 1.0 / (double(a.width) * a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const int off = PixelDifference(a, b, x, y);
      if (off > 0) result.differing += one;
      if (off > 8) result.far_off += one;
      if (x % kBlock > 0 || y % kBlock > 0) continue;
      result.worst_block_mean = std::max(result.worst_block_mean, BlockMean(a, b, x, y));
    }
  }
  return result;
}

bool IsCloseEnough(const ImageDifference& d) {
  return d.far_off <= 0.0002 && d.differing <= 0.005 && d.worst_block_mean <= 1.0;
}

void ExpectMatchesGolden(const Image& image, const std::string& name) {
  const fs::path path = fs::path(HAZUMI_SOURCE_DIR) / "tests" / "golden" / (name + ".png");
  const char* update = std::getenv("HAZUMI_UPDATE_GOLDENS");
  if (update != nullptr && std::string(update) == "1") {
    ASSERT_TRUE(WritePng(path, image, {}).ok());
    return;
  }
  const Result<Image> golden = ReadPng(path);
  ASSERT_TRUE(golden.ok()) << golden.error().ToString();
  ASSERT_EQ(golden.value().width, image.width);
  ASSERT_EQ(golden.value().height, image.height);
  const ImageDifference d = Compare(image, golden.value());
  if (IsCloseEnough(d)) return;
  ADD_FAILURE() << name << ": " << 100.0 * d.differing << " % of the pixels differ, "
                << 100.0 * d.far_off << " % by more than 8, worst block " << d.worst_block_mean
                << "; " << LeaveEvidence(image, golden.value(), name);
}

}  // namespace hazumi::render
