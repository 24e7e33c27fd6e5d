#include "render/text/text_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/utf8.h"
#include "render/text/glyphs.h"

namespace hazumi::render {
namespace {

using Vec2 = Eigen::Vector2d;
constexpr int kRoundings = 3;
constexpr double kMarginPx = 14.0;   // from the picture's edge to a panel
constexpr int kGap = 2;              // after a letter, part of its advance
constexpr int kSpacing = 1;          // between letters, on the glyphs' grid
constexpr double kLineHeight = 2.6;  // in cap heights
constexpr double kWeight = 0.135;    // stroke width in cap heights
constexpr double kPadding = 0.62;    // of the panel around the letters, in cap heights
constexpr SrgbColor kPanel = FromHex(0x1d232a, 0.62f);

double Coordinate(char c) { return c >= 'a' ? c - 'a' + 10 : c - '0'; }

// Chaikin's corner cutting: the limit is a quadratic B-spline.
TextStroke CutCorners(const TextStroke& p, bool closed) {
  TextStroke cut;
  if (!closed) cut.push_back(p.front());
  for (size_t i = 0; i + (closed ? 0 : 1) < p.size(); ++i) {
    const Vec2& next = p[(i + 1) % p.size()];
    const bool first = !closed && i == 0, last = !closed && i + 2 == p.size();
    if (!first) cut.push_back(0.75 * p[i] + 0.25 * next);
    if (!last) cut.push_back(0.25 * p[i] + 0.75 * next);
  }
  if (!closed) cut.push_back(p.back());
  return cut;
}

TextStroke ReadStroke(std::string_view word) {
  const char kind = word.front();
  const bool closed = kind == 'o', curved = closed || kind == '~';
  if (curved) word.remove_prefix(1);
  TextStroke points;
  for (size_t i = 0; i + 1 < word.size(); i += 2) {
    points.emplace_back(Coordinate(word[i]), Coordinate(word[i + 1]) - kBaseline);
  }
  for (int i = 0; curved && i < kRoundings; ++i) points = CutCorners(points, closed);
  if (closed) points.insert(points.end(), {points[0], points[1]});
  return points;
}

void AppendGlyph(const Glyph& glyph, const Vec2& origin, double unit,
                 std::vector<TextStroke>& strokes) {
  std::string_view rest = glyph.strokes;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(' '), rest.size());
    TextStroke stroke = ReadStroke(rest.substr(0, end));
    for (Vec2& p : stroke) p = origin + unit * p;
    strokes.push_back(std::move(stroke));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

double PaddingOf(const Caption& c) { return std::round(kPadding * c.cap_height_px); }

Vec2 BaselineStart(const Caption& c, double lines_before_px, PictureSize size) {
  const bool right = c.corner == Corner::kTopRight || c.corner == Corner::kBottomRight;
  const bool top = c.corner == Corner::kTopLeft || c.corner == Corner::kTopRight;
  const double margin = kMarginPx + PaddingOf(c);
  const double x = right ? size.width - margin - TextWidth(c.text, c.cap_height_px) : margin;
  const double y =
      top ? size.height - margin - c.cap_height_px - lines_before_px : margin + lines_before_px;
  return {std::round(x) + 0.5, std::round(y) + 0.5};
}

void AppendStrokes(const std::vector<TextStroke>& strokes, const Vec2& start, const Stroke& look,
                   PictureSize size, FlatMesh& mesh) {
  for (const TextStroke& stroke : strokes) {
    std::vector<ScreenPoint> points;
    for (const Vec2& p : stroke) points.push_back({start + p, 0.0});
    AppendStroke(points, look, size, mesh);
  }
}

// Edges lie between pixels and are sharp without smoothing.
void AppendPanel(const Caption& c, const Vec2& start, PictureSize size, FlatMesh& mesh) {
  const double pad = PaddingOf(c);
  const double x0 = std::floor(start.x()) - pad, y0 = std::floor(start.y()) - pad;
  const double x1 = std::ceil(start.x() + TextWidth(c.text, c.cap_height_px)) + pad;
  const double y1 = std::ceil(start.y() + c.cap_height_px) + pad;
  AppendFill({{{x0, y0}}, {{x1, y0}}, {{x1, y1}}, {{x0, y1}}}, kPanel, size, mesh);
}

void AppendCaption(const Caption& c, double lines_before_px, PictureSize size, FlatMesh& mesh) {
  const Vec2 start = BaselineStart(c, lines_before_px, size);
  AppendPanel(c, start, size, mesh);
  AppendStrokes(LayOutText(c.text, c.cap_height_px), start, {kWeight * c.cap_height_px, c.color},
                size, mesh);
}

}  // namespace

std::vector<TextStroke> LayOutText(std::string_view utf8, double cap_height_px) {
  const double unit = cap_height_px / kCapHeight;
  std::vector<TextStroke> strokes;
  double x = 0.0;
  for (const char32_t code : DecodeUtf8(utf8)) {
    const Glyph& glyph = FindGlyph(code);
    AppendGlyph(glyph, {x, 0.0}, unit, strokes);
    x += (glyph.advance + kSpacing) * unit;
  }
  return strokes;
}

double TextWidth(std::string_view utf8, double cap_height_px) {
  int advance = -kSpacing - kGap;
  for (const char32_t code : DecodeUtf8(utf8)) advance += FindGlyph(code).advance + kSpacing;
  return std::max(advance, 0) * cap_height_px / kCapHeight;
}

FlatMesh BuildCaptions(const std::vector<Caption>& captions, PictureSize size) {
  FlatMesh mesh;
  std::array<double, 4> used_px{};
  for (const Caption& c : captions) {
    double& used = used_px[static_cast<size_t>(c.corner)];
    AppendCaption(c, used, size, mesh);
    used += kLineHeight * c.cap_height_px;
  }
  return mesh;
}

}  // namespace hazumi::render
