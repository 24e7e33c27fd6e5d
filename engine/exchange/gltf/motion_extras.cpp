#include <nlohmann/json.hpp>

#include "engine/exchange/gltf/gltf_of_motion.h"

namespace hazumi {

namespace {

using Json = nlohmann::ordered_json;

class ExtrasWriter {
 public:
  ExtrasWriter(const Animation& animation, const Motion& motion)
      : animation_(animation), motion_(motion) {
    if (!motion.frames.empty()) start_ = motion.rate.SecondsAt(motion.frames.front().frame);
  }

  Json Write() const {
    Json json = {{"fps", motion_.rate.frames_per_second()}};
    if (!motion_.frames.empty()) {
      json["first_frame"] = motion_.frames.front().frame;
      json["last_frame"] = motion_.frames.back().frame;
    }
    json["regions"] = Json::array();
    for (const DynamicsRegion& region : animation_.regions) {
      if (!region.is_muted) json["regions"].push_back(RegionJson(region));
    }
    json["placements"] = Json::array();
    for (const PlacementSpan& span : animation_.placements)
      json["placements"].push_back(PlacementJson(span));
    json["events"] = Json::array();
    for (const MotionEvent& event : motion_.events) json["events"].push_back(EventJson(event));
    return {{"hazumi", json}};
  }

 private:
  void AddSpan(int first, int last, Json* json) const {
    (*json)["first_frame"] = first;
    (*json)["last_frame"] = last;
    (*json)["start_s"] = animation_.rate.SecondsAt(first) - start_;
    (*json)["end_s"] = animation_.rate.SecondsAt(last) - start_;
  }

  Json RegionJson(const DynamicsRegion& region) const {
    Json json = {{"name", region.name}, {"method", NameOf(region.method)}};
    AddSpan(region.first_frame, region.last_frame, &json);
    json["joints"] = Json::array();
    for (const JointIndex j : region.joints)
      json["joints"].push_back(animation_.figure->joint(j).name);
    json["friction"] = region.friction;
    json["root"] = region.root;
    return json;
  }

  Json PlacementJson(const PlacementSpan& span) const {
    Json json = {{"kind", NameOf(span.kind)}};
    AddSpan(span.first_frame, span.last_frame, &json);
    const Figure& figure = *animation_.figure;
    if (span.pin) json["pin"] = figure.group(*span.pin).name;
    if (span.landing_pin) json["landing_pin"] = figure.group(*span.landing_pin).name;
    return json;
  }

  Json EventJson(const MotionEvent& event) const {
    Json json = {{"kind", NameOf(event.kind)}, {"time_s", event.time - start_}};
    if (!event.joint.empty()) json["joint"] = event.joint;
    if (event.kind == EventKind::kTouchDown) {
      json["link"] = event.link;
      json["on"] = event.on;
    }
    if (event.count == 1) return json;
    json["count"] = event.count;
    json["last_time_s"] = event.last_time - start_;
    return json;
  }

  const Animation& animation_;
  const Motion& motion_;
  double start_ = 0.0;  // of the file, in the project's time [s]
};

}  // namespace

std::string MotionExtras(const Animation& animation, const Motion& motion) {
  return ExtrasWriter(animation, motion)
      .Write()
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace hazumi
