#pragma once

#include "render/scene/camera.h"
#include "ui/panels/geometry.h"

namespace hazumi::ui {

// What the viewport shows beside the figure.
struct ViewportOverlays {
  bool paths = true;
  bool ghosts = false;
  int ghost_every = 5;  // frames
  bool marks = true;    // pin, contact, centre of mass
  bool tint = true;     // joints moved by a region
  bool limits = true;   // arcs of the selected joints
  bool shadow = true;
  bool operator==(const ViewportOverlays&) const = default;
};

// An orbiting camera: looks at `target` from an azimuth (0: from +x, counter-clockwise from above)
// and a height above the horizon [rad].
struct OrbitCamera {
  Vec3 target{0.0, 0.0, 0.9};
  double azimuth = -0.85, elevation = 0.25, distance = 4.2;
  bool is_orthographic = false;  // seen from so far away that nothing gets smaller
  bool operator==(const OrbitCamera&) const = default;
};
render::Camera CameraOf(const OrbitCamera& orbit);

struct ViewportState {
  OrbitCamera camera;
  bool through_project_camera = false;
  ViewportOverlays overlays;
  Rect rect;  // where it was drawn last [px]
};

}  // namespace hazumi::ui
