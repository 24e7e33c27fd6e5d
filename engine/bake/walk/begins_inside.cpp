#include "engine/bake/walk/begins_inside.h"

#include "engine/base/text.h"
#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi {

std::optional<std::string> TellOfInside(const Animation& animation, const Figure& figure,
                                        const FigureMotion& motion,
                                        const std::function<bool(const Link&)>& counts,
                                        DynamicsWorkspace* ws) {
  constexpr double kNotice = 1e-4;  // [m]
  ComputePositions(figure, motion.X_WR, motion.q, ws);
  const auto contact = NearestContact(figure, animation.scene, *ws, Vec3::Zero(), counts);
  if (!contact || contact->clearance > -kNotice) return std::nullopt;
  return "\"" + figure.links()[contact->link].name + "\" begins " +
         FormatShort(-1000.0 * contact->clearance) + " mm inside \"" +
         animation.scene[contact->object].name + "\" in frame " + FormatShort(motion.frame) +
         ": it is pushed out slowly; move it out in that frame";
}

}  // namespace hazumi
