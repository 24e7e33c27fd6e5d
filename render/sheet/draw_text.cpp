// A letter is a few strokes, each a chain of segments. How much of a pixel a stroke covers is taken
// from the distance d of the pixel's centre to the nearest segment, half the stroke's width w:
//   coverage = clamp(w + 1/2 - d, 0, 1)

#include "render/sheet/draw_text.h"

#include <algorithm>
#include <cmath>

#include "render/text/text_mesh.h"

namespace hazumi::render {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kStrokeOfCap = 0.065;  // half a stroke's width, of the height of capitals
constexpr double kThinnest = 0.45;      // [px]

double DistanceTo(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (a + share * d - p).norm();
}

std::uint8_t Mixed(std::uint8_t under, float over, double coverage) {
  return static_cast<std::uint8_t>(std::lround(under + (255.0 * over - under) * coverage));
}

void Mix(const SrgbColor& color, double coverage, std::uint8_t* pixel) {
  pixel[0] = Mixed(pixel[0], color.r, coverage);
  pixel[1] = Mixed(pixel[1], color.g, coverage);
  pixel[2] = Mixed(pixel[2], color.b, coverage);
  pixel[3] = 255;
}

std::uint8_t* PixelAt(int x, int y, Image* image) {
  return &image->rgba[(static_cast<size_t>(y) * static_cast<size_t>(image->width) +
                       static_cast<size_t>(x)) *
                      4];
}

// Of the part of a text's picture that can be seen, how much of each pixel is covered.
class Coverage {
 public:
  Coverage(double x, double y, double width, double cap_height, const Image& image)
      : left_(std::clamp(static_cast<int>(x - cap_height), 0, image.width)),
        right_(std::clamp(static_cast<int>(x + width + cap_height), left_, image.width)),
        top_(std::clamp(static_cast<int>(y - 1.6 * cap_height), 0, image.height)),
        bottom_(std::clamp(static_cast<int>(y + cap_height), top_, image.height)),
        covered_(static_cast<size_t>(right_ - left_) * static_cast<size_t>(bottom_ - top_)) {}

  void AddSegment(const Vec2& a, const Vec2& b, double half_width) {
    const double reach = half_width + 1.0;
    const int x0 = std::clamp(static_cast<int>(std::min(a.x(), b.x()) - reach), left_, right_);
    const int x1 = std::clamp(static_cast<int>(std::max(a.x(), b.x()) + reach) + 1, left_, right_);
    const int y0 = std::clamp(static_cast<int>(std::min(a.y(), b.y()) - reach), top_, bottom_);
    const int y1 = std::clamp(static_cast<int>(std::max(a.y(), b.y()) + reach) + 1, top_, bottom_);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const double d = DistanceTo(a, b, Vec2(x + 0.5, y + 0.5));
        float& covered = At(x, y);
        covered = std::max(covered, static_cast<float>(std::clamp(half_width + 0.5 - d, 0.0, 1.0)));
      }
    }
  }

  void MixInto(const SrgbColor& color, Image* image) {
    for (int y = top_; y < bottom_; ++y) {
      for (int x = left_; x < right_; ++x) {
        if (At(x, y) > 0.0f) Mix(color, At(x, y) * color.a, PixelAt(x, y, image));
      }
    }
  }

 private:
  float& At(int x, int y) {
    return covered_[static_cast<size_t>(y - top_) * static_cast<size_t>(right_ - left_) +
                    static_cast<size_t>(x - left_)];
  }

  int left_, right_, top_, bottom_;
  std::vector<float> covered_;
};

}  // namespace

void DrawText(std::string_view utf8, double x, double y, double cap_height, const SrgbColor& color,
              Image* image) {
  Coverage coverage(x, y, TextWidth(utf8, cap_height), cap_height, *image);
  const double half_width = std::max(kThinnest, kStrokeOfCap * cap_height);
  for (const TextStroke& stroke : LayOutText(utf8, cap_height)) {
    for (size_t i = 0; i < stroke.size(); ++i) {
      const Vec2& from = stroke[i > 0 ? i - 1 : 0];
      coverage.AddSegment({x + from.x(), y - from.y()}, {x + stroke[i].x(), y - stroke[i].y()},
                          half_width);
    }
  }
  coverage.MixInto(color, image);
}

void FillRectangle(int x, int y, int width, int height, const SrgbColor& color, Image* image) {
  for (int row = std::max(y, 0); row < std::min(y + height, image->height); ++row) {
    for (int column = std::max(x, 0); column < std::min(x + width, image->width); ++column) {
      Mix(color, color.a, PixelAt(column, row, image));
    }
  }
}

void CopyInto(const Image& from, int x, int y, Image* image) {
  const int left = std::max(x, 0), right = std::min(x + from.width, image->width);
  if (left >= right) return;
  for (int row = std::max(y, 0); row < std::min(y + from.height, image->height); ++row) {
    const size_t start = (static_cast<size_t>(row - y) * static_cast<size_t>(from.width) +
                          static_cast<size_t>(left - x)) *
                         4;
    std::copy_n(&from.rgba[start], static_cast<size_t>(right - left) * 4,
                PixelAt(left, row, image));
  }
}

}  // namespace hazumi::render
