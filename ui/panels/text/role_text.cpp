#include "ui/panels/text/role_text.h"

#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

constexpr const char* kLabels[kNumBodyRoles] = {
    "nothing", "hips", "spine",  "neck",   "head",  "clavicle",      "upper arm",
    "forearm", "hand", "finger", "thigh",  "shin",  "foot",          "toe",
    "tail",    "wing", "ear",    "weapon", "twist", "cloth or hair", "helper"};

}  // namespace

std::string TextOf(BodyPlace place) {
  std::string role = Tr(kLabels[static_cast<int>(place.role)]);
  if (place.role == BodyRole::kNone || place.side == BodySide::kMiddle) return role;
  return std::string(Tr(place.side == BodySide::kLeft ? "left " : "right ")) + role;
}

std::vector<BodyPlace> AllPlaces() {
  std::vector<BodyPlace> places;
  for (int i = 0; i < kNumBodyRoles; ++i) {
    const auto role = static_cast<BodyRole>(i);
    if (!NeedsSide(role)) places.push_back({role, BodySide::kMiddle});
    if (!MayHaveSide(role)) continue;
    places.push_back({role, BodySide::kLeft});
    places.push_back({role, BodySide::kRight});
  }
  return places;
}

}  // namespace hazumi::ui
