#include "engine/bake/walk/begins_inside.h"

#include "engine/base/text.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"

namespace hazumi {

namespace {

constexpr double kDeepEnough = 1e-4;  // smallest depth that is reported [m]

std::string InsideText(const std::string& what, double clearance, const std::string& obstacle,
                       double frame, const char* begins) {
  return "\"" + what + "\" " + begins + " " + FormatShort(-1000.0 * clearance) + " mm inside \"" +
         obstacle + "\" in frame " + FormatShort(frame) +
         ": it is pushed out slowly; move it out in that frame";
}

}  // namespace

std::optional<std::string> TellOfInside(const Animation& animation, const Figure& figure,
                                        const FigureMotion& motion, const CountsContact& counts,
                                        DynamicsWorkspace* ws) {
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  const auto contact = NearestContact(figure, animation.scene, *ws, Vec3::Zero(), counts);
  if (!contact || contact->clearance > -kDeepEnough) return std::nullopt;
  return InsideText(figure.links()[contact->link].name, contact->clearance,
                    animation.scene[contact->object].name, motion.frame, "begins");
}

std::optional<std::string> TellOfInside(const Animation& animation, const HeldObject& ball,
                                        const Vec3& center, double frame) {
  const auto* sphere = std::get_if<SphereShape>(&ball.shape);
  if (!sphere) return std::nullopt;
  const SceneObject* deepest = nullptr;
  double clearance = -kDeepEnough;
  for (const SceneObject& obstacle : animation.scene) {
    const double own =
        SignedDistance(Capsule{center, center, sphere->radius}, obstacle.shape).value;
    if (own > clearance) continue;
    clearance = own;
    deepest = &obstacle;
  }
  if (!deepest) return std::nullopt;
  return InsideText(ball.name, clearance, deepest->name, frame, "is let go");
}

}  // namespace hazumi
