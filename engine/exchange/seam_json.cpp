#include <nlohmann/json.hpp>

#include "engine/analysis/seam_report.h"
#include "engine/exchange/motion_text.h"
#include "engine/exchange/units.h"

namespace hazumi {

std::string SeamToJson(const Animation& animation, const Seam& seam) {
  using Json = nlohmann::ordered_json;
  const bool is_root = !seam.joint.is_valid();
  Json json = {{"frame", seam.frame},
               {"of", NameOf(seam.of)},
               {"index", seam.index},
               {"begins", seam.begins},
               {"joint", is_root ? Json(nullptr) : Json(animation.figure->joint(seam.joint).name)}};
  if (is_root) {
    json["position_m"] = seam.distance;
    json["velocity_m_s"] = seam.speed;
    json["acceleration_m_s2"] = seam.push;
  }
  json["angle_deg"] = Degrees(seam.angle);
  json["rate_deg_s"] = Degrees(seam.rate);
  json["acceleration_deg_s2"] = Degrees(seam.acceleration);
  if (seam.mend != SeamMend::kNothing) json["mend"] = MendText(seam.mend);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hazumi
