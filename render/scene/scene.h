#pragma once

#include <memory>
#include <vector>

#include "engine/picture/image.h"
#include "engine/spatial/types.h"
#include "render/scene/camera.h"
#include "render/scene/color.h"
#include "render/scene/marks.h"
#include "render/scene/skinned.h"
#include "render/scene/solids.h"

namespace hazumi::render {

// A picture in the scene, lit by nothing: a plane, seen from both sides, or behind everything.
struct PicturePlane {
  std::shared_ptr<const Image> image;
  double opacity = 1.0;
  bool is_background = false;  // as large as the view holds it whole
  // The lower left corner of the plane, and its edges from there [m].
  Vec3 corner = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitZ();
};

enum class GroundLook { kGrid, kChecker };

// A floor z = height that fades into the horizon. Colours are those seen in full light.
struct Ground {
  bool visible = true;
  double height = 0.0;  // [m]
  GroundLook look = GroundLook::kGrid;
  SrgbColor floor = FromHex(0xb7bcc2);
  SrgbColor pattern = FromHex(0x9aa1a9);  // grid lines, or the other checker squares
};

// The light around: seen as the background and felt as ambient light.
struct Sky {
  SrgbColor zenith = FromHex(0x8793a1);
  SrgbColor horizon = FromHex(0xd3d7db);
};

// All that is in a picture. Knows neither documents nor GL. World: z up, right-handed, metres.
struct Scene {
  Camera camera;
  Vec3 to_light{-0.45, -0.55, 1.0};  // towards the key light; any length, z > 0
  Sky sky;
  Ground ground;
  std::vector<TaperedCapsule> capsules;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<BoxShape> boxes;
  std::vector<SkinnedFigure> skins;
  std::vector<PicturePlane> pictures;
  std::vector<Polyline> polylines;
  std::vector<Marker> markers;
  std::vector<Caption> captions;
};

}  // namespace hazumi::render
