#pragma once

#include <optional>
#include <string>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"
#include "ui/panels/viewport/solids.h"

namespace hazumi::ui {

// Distance along a ray to where it enters a shape [m]; none if it passes by, or begins inside.
// `X_WJ`: the frame that the look is given in.
std::optional<double> Enter(const Ray& ray, const hazumi::Look& look, const hazumi::Pose& X_WJ);
std::optional<double> Enter(const Ray& ray, const Box& box);
std::optional<double> Enter(const Ray& ray, const Ball& ball);

// What of planes and boxes a ray meets first, by index, and where, world [m]; none if it does not.
struct SceneHit {
  size_t object = 0;
  Vec3 at = Vec3::Zero();
};
std::optional<SceneHit> HitScene(const Ray& ray, const std::vector<SceneObject>& scene);
std::optional<Vec3> MeetsScene(const Ray& ray, const std::vector<SceneObject>& scene);

// What is under a point of the window.
struct ViewportHit {
  std::optional<GroupIndex> joint;
  ItemId object;  // a box of the scene or a held object; invalid: none
  bool is_root = false;
  bool is_marker = false;  // the mark of the joint or root, not its body

  bool is_anything() const { return joint || is_root || object.is_valid(); }
};

inline constexpr float kMarkerReach = 7.0f;  // of a mark, at scale 1 [px]

// The mark of the root or of a joint within reach, or else the body that is nearest to the viewer,
// or the object. A body belongs to the joint that moves it; those of hidden joints are passed
// through.
ViewportHit HitTest(const View& view, Point at, const PosedFigure& figure,
                    const std::vector<Solid>& solids, double scale);

}  // namespace hazumi::ui
