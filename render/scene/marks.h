#pragma once

#include <string>
#include <vector>

#include "engine/spatial/types.h"
#include "render/scene/color.h"

namespace hazumi::render {

// Marks explain a motion: they have no thickness in the world and receive no light.

// A line through `points` [m, world]. With dash_m > 0, dashes that long with equal gaps.
// With on_top, nothing hides it.
struct Polyline {
  std::vector<Vec3> points;
  double width_px = 2.0;
  SrgbColor color;
  double dash_m = 0.0;
  bool on_top = false;
};

enum class MarkerShape {
  kDisc,          // filled, lying flat
  kRing,          // outline, lying flat
  kCross,         // two strokes, lying flat
  kCenterOfMass,  // the quartered disc of engineering drawings, facing the viewer
};

// A flat marker lies in the plane z = center.z (lift it a few millimetres off the ground).
// `radius_m` is its size in the world; kCenterOfMass takes it as is and is always on top.
struct Marker {
  MarkerShape shape = MarkerShape::kDisc;
  Vec3 center = Vec3::Zero();
  double radius_m = 0.05;
  SrgbColor color;
  double width_px = 2.0;  // of the strokes of rings and crosses
  bool on_top = false;
};

enum class Corner { kTopLeft, kTopRight, kBottomLeft, kBottomRight };

// One line of text in a corner of the picture; captions in one corner stack away from its edge.
// UTF-8; drawn are ASCII and the signs ° × → –, anything else shows as a box.
struct Caption {
  std::string text;
  Corner corner = Corner::kTopLeft;
  double cap_height_px = 13.0;
  SrgbColor color = FromHex(0xffffff);
};

}  // namespace hazumi::render
