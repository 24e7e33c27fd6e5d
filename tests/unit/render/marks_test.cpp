#include <gtest/gtest.h>

#include "engine/base/utf8.h"
#include "render/mesh/ground_occlusion.h"
#include "render/mesh/mark_mesh.h"
#include "render/scene/bounds.h"
#include "render/text/text_mesh.h"

namespace hazumi::render {
namespace {

constexpr PictureSize kSize{100, 100};

double LengthOf(const std::vector<std::vector<Vec3>>& lines) {
  double length = 0.0;
  for (const auto& line : lines) {
    for (size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  }
  return length;
}

TEST(Dashes, CoverEveryOtherStretch) {
  const auto dashes = SplitIntoDashes({{0, 0, 0}, {0.25, 0, 0}, {0.95, 0, 0}}, 0.1);
  ASSERT_EQ(dashes.size(), 5u);
  EXPECT_NEAR(LengthOf(dashes), 0.5, 1e-9);
  EXPECT_NEAR(dashes[1].front().x(), 0.2, 1e-9);
}

TEST(Dashes, OfLengthZeroLeaveTheLineWhole) {
  EXPECT_EQ(SplitIntoDashes({{0, 0, 0}, {1, 0, 0}}, 0.0).size(), 1u);
}

TEST(Projector, CutsALineThatGoesBehindTheViewer) {
  const Camera camera{.eye = {0, 0, 0}, .target = {1, 0, 0}};
  const Projector projector(camera, kSize);
  const auto pieces = projector.ProjectLine({{2, 0, 0}, {-2, 0.1, 0}, {2, 0.2, 0}});
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(pieces[0][0].px.x(), 50.0, 1e-9);
  EXPECT_NEAR(pieces[0][0].px.y(), 50.0, 1e-9);
  EXPECT_TRUE(projector.ProjectLine({{-1, 0, 0}, {-2, 0, 0}}).empty());
}

TEST(Projector, PutsWhatIsHigherHigherUp) {
  const Projector projector({.eye = {0, -3, 1}, .target = {0, 0, 1}}, kSize);
  const auto line = projector.ProjectLine({{0, 0, 1}, {0.1, 0, 1}, {0, 0, 1.1}})[0];
  EXPECT_GT(line[1].px.x(), line[0].px.x());
  EXPECT_GT(line[2].px.y(), line[0].px.y());
}

TEST(Stroke, HasItsWidthAndAPixelToSmooth) {
  FlatMesh mesh;
  AppendStroke({{{20, 50}, 0}, {{80, 50}, 0}}, {4.0, {}}, kSize, mesh);
  ASSERT_EQ(mesh.size(), 6u);
  for (const FlatVertex& v : mesh) EXPECT_NEAR(std::abs(v.y) * 50.0, 3.0, 1e-4);
}

TEST(Stroke, OfASinglePointIsNothing) {
  FlatMesh mesh;
  AppendStroke({{{20, 50}, 0}, {{20.1, 50}, 0}}, {4.0, {}}, kSize, mesh);
  EXPECT_TRUE(mesh.empty());
}

TEST(Text, EveryPrintableAsciiSignHasAGlyph) {
  const auto unknown = LayOutText("\x01", 9.0);
  for (char c = '!'; c <= '~'; ++c) {
    const auto strokes = LayOutText(std::string(1, c), 9.0);
    EXPECT_FALSE(strokes.empty()) << c;
    EXPECT_NE(strokes, unknown) << c;
  }
}

TEST(Text, StaysWithinItsWidthAndHeight) {
  for (const auto& stroke : LayOutText("Hazumi 0123456789", 9.0)) {
    for (const auto& p : stroke) {
      EXPECT_GE(p.x(), 0.0);
      EXPECT_LE(p.x(), TextWidth("Hazumi 0123456789", 9.0) + 1e-9);
      EXPECT_GE(p.y(), 0.0);
      EXPECT_LE(p.y(), 9.0);
    }
  }
}

TEST(Utf8, BadBytesBecomeReplacementSigns) {
  EXPECT_EQ(DecodeUtf8("a\xc2\xb0"), U"a\u00b0");
  EXPECT_EQ(DecodeUtf8("\xe5\xbc\xbe"), U"弾");
  EXPECT_EQ(DecodeUtf8("\xff"
                       "b\xe5"),
            U"\ufffd"
            U"b\ufffd");
}

TEST(GroundOcclusion, IsThatOfASphereInClosedForm) {
  Scene scene;
  scene.ellipsoids.push_back(Sphere({0, 0, 0.5}, 0.2, {}));
  GroundRect rect;
  rect.Include({0, 0}, 2.0);
  const GroundOcclusion occlusion = OccludeGround(scene, rect);
  const int middle = GroundOcclusion::kSize / 2;
  const double x = 4.0 * 0.5 / GroundOcclusion::kSize;  // of the texel next to the centre
  const double covered = 0.04 * 0.5 / std::pow(2.0 * x * x + 0.25, 1.5);
  EXPECT_NEAR(occlusion.openness[middle * GroundOcclusion::kSize + middle] / 255.0, 1.0 - covered,
              1.0 / 255.0);
  EXPECT_EQ(occlusion.openness[0], 255);
}

TEST(ShadedGround, HoldsTheShadowOfAHighSphere) {
  const GroundRect rect = ShadedGround({{{0, 0, 2}, 0.1}}, {-1, 0, 1}, 0.0);
  EXPECT_GE(rect.max.x(), 2.0 + 0.1 * std::sqrt(2.0) - 1e-9);
  EXPECT_LE(rect.min.x(), -0.1);
  EXPECT_TRUE(ShadedGround({}, {0, 0, 1}, 0.0).is_empty());
}

}  // namespace
}  // namespace hazumi::render
