#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/project/item_id.h"
#include "engine/spatial/types.h"
#include "render/scene/camera.h"
#include "render/scene/color.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// What the viewport shows beside the figure, and how the figure looks.
struct ViewportOverlays {
  bool skin = true;  // of a figure that has one; else its capsules
  bool paths = true;
  bool ghosts = false;
  int ghost_every = 5;                        // frames, counted from the current one
  int ghosts_before = 15, ghosts_after = 15;  // frames
  bool ghosts_at_keys = false;                // on frames with a key alone
  bool keyed = false;                         // where a region moves joints, the pose of their keys
  int reach = 90;      // frames before and after the current one that paths show
  bool marks = true;   // pin, contact, centre of mass
  bool tint = true;    // joints moved by a region
  bool limits = true;  // arcs of the selected joints
  bool shadow = true;
  bool forces = true;   // constraints, and what acts from outside
  bool effort = false;  // colours of what is asked of muscles
  bool operator==(const ViewportOverlays&) const = default;
};

// An orbiting camera: looks at `target` from an azimuth (0: from +x, counter-clockwise from above)
// and a height above the horizon [rad].
struct OrbitCamera {
  Vec3 target{0.0, 0.0, 0.9};
  double azimuth = -1.15, elevation = 0.25, distance = 4.2;
  bool is_orthographic = false;  // seen from so far away that nothing gets smaller
  bool operator==(const OrbitCamera&) const = default;
};
render::Camera CameraOf(const OrbitCamera& orbit);

// Everything that the picture of the scene depends on. While it stays, so does the picture.
struct PictureKey {
  long document = -1, revision = -1;  // of the session
  int frame = 0;
  OrbitCamera camera;
  bool through_project_camera = false;
  ViewportOverlays overlays;
  int width = 0, height = 0;  // [px]
  std::set<std::string> selected_joints;
  bool has_film = false;           // the reference has been read
  bool is_being_computed = false;  // the motion: what is seen is as it was before
  long effort = 0;                 // number of what is known of it, if it is shown
  bool operator==(const PictureKey&) const = default;
};

// Where a path is at each frame [m].
struct PathTicks {
  render::SrgbColor color;
  std::vector<Vec3> points;
};

// The picture drawn last, and for what.
struct ShownPicture {
  PictureKey key;
  unsigned texture = 0;
  std::vector<PathTicks> ticks;
};

// Part of a goal's mark, which can be dragged.
struct GoalPart {
  std::string goal;
  bool is_top = false;  // of the arc, else the place
  Vec3 at;              // [m]
};

// A mouse button that went down on the viewport and has not come up yet.
struct ViewportPress {
  Point at;
  std::string handle;      // the joint or root whose handle is under it; empty: none
  bool on_gizmo = false;   // a ring or the end of a limit is
  bool on_swivel = false;  // the handle that turns a limb about its own axis is
  ItemId object;           // under it
  std::optional<GoalPart> goal;
};

// Small windows that the right button opens: what can be done with what is under the mouse. And
// what can be added, by its key.
enum class ViewportPopup { kNone, kJoint, kRoot, kObject, kNothing, kAdd };

// What a tool acts on, told beside the mouse.
struct AimedSpot {
  Vec3 at = Vec3::Zero();  // world [m]
  std::string text;        // what comes of it, or why it cannot be
  bool is_trouble = false;
  std::optional<Vec3> from = {};  // a line is drawn from there
};

struct ViewportState {
  OrbitCamera camera;
  bool through_project_camera = false;
  long framed_document = 0;  // of the session: what the camera was set up for
  ViewportOverlays overlays;
  Rect rect;  // where it was drawn last [px]
  std::optional<ShownPicture> shown;
  long pictures_drawn = 0;
  ItemId selected_object;    // a box of the scene or a held object; invalid: none
  std::string active_hinge;  // whose limits are shown, if its joint is selected
  std::optional<ViewportPress> press;
  std::optional<AimedSpot> aimed;              // by the tool in hand
  std::optional<Rect> box;                     // of a box selection
  ViewportPopup popup = ViewportPopup::kNone;  // to be opened
  bool had_tool = false;  // when it was drawn last: what the mouse does then is the tool's
  long drags = 0;         // so far: each has a name of its own
};

}  // namespace hazumi::ui
