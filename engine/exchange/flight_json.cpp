#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/analysis/flights.h"
#include "engine/exchange/motion_text.h"

namespace hazumi {

namespace {

using Json = nlohmann::ordered_json;

Json AsJson(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Without an upper end: null there.
Json AsJson(const Range& range) {
  return {range.low, std::isfinite(range.high) ? Json(range.high) : Json(nullptr)};
}

Json AsJson(const AngularMomentumDrift& drift) {
  return {{"mean_kg_m2_s", AsJson(drift.mean)},
          {"change_kg_m2_s", AsJson(drift.change)},
          {"relative_change", drift.relative}};
}

Json AsJson(const Flight& flight, double frame_time) {
  Json json = {{"take_off", flight.take_off},
               {"apex", flight.apex},
               {"landing", flight.landing},
               {"begins_before_clip", flight.begins_before_clip},
               {"ends_after_clip", flight.ends_after_clip},
               {"duration_s", flight.duration_frames() * frame_time},
               {"gravity_m_s2", flight.parabola.gravity},
               {"gravity_error_m_s2", flight.gravity.StandardError()},
               {"gravity_interval_m_s2", AsJson(flight.gravity.Interval())},
               {"residual_rms_m", flight.parabola.rms},
               {"velocity_m_s", AsJson(flight.v_take_off)},
               {"horizontal_speed_m_s", flight.horizontal_speed},
               {"rise_m", flight.rise},
               {"apex_m", AsJson(flight.parabola.apex)}};
  if (flight.angular_momentum) json["angular_momentum"] = AsJson(*flight.angular_momentum);
  return json;
}

const char* NameOf(TimeVerdict verdict) {
  switch (verdict) {
    case TimeVerdict::kUnknown:
      return "unknown";
    case TimeVerdict::kTrue:
      return "true";
    case TimeVerdict::kWrongFrameTime:
      return "wrong_frame_time";
    case TimeVerdict::kWrongLength:
      return "wrong_length";
  }
  return "unknown";
}

Json AsJson(const TimeScale& time) {
  Json json = {{"verdict", NameOf(time.verdict)}, {"frame_time_s", time.frame_time}};
  if (!(time.gravity > 0.0)) return json;  // there is no flight
  json["gravity_m_s2"] = time.gravity;
  json["gravity_error_m_s2"] = time.gravity_error;
  json["gravity_interval_m_s2"] = AsJson(time.gravity_range);
  json["true_gravity_m_s2"] = time.true_gravity;
  json["speed"] = time.speed;
  json["speed_interval"] = AsJson(SpeedRange(time));
  json["true_frame_time_s"] = time.true_frame_time;
  json["true_frame_time_interval_s"] = AsJson(FrameTimeRange(time));
  json["nearest_fps"] = time.frame_rate ? Json(*time.frame_rate) : Json(nullptr);
  json["length_factor"] = time.length_factor;
  json["length_factor_interval"] = AsJson(LengthFactorRange(time));
  json["length_known"] = time.scale_known;
  json["sentence"] = TimeSentence(time);
  return json;
}

Json AsJson(const FootSkate& skate) {
  Json slides = Json::array();
  for (const FootSlide& slide : skate.slides) {
    slides.push_back(
        {{"first", slide.first}, {"last", slide.last}, {"distance_m", slide.distance}});
  }
  return {{"foot", skate.foot},
          {"distance_m", skate.distance},
          {"time_low_s", skate.time_low},
          {"frames", skate.frames},
          {"slides", slides}};
}

}  // namespace

std::string FlightsToJson(const FlightAnalysis& analysis) {
  Json flights = Json::array(), skates = Json::array();
  for (const Flight& flight : analysis.flights) {
    flights.push_back(AsJson(flight, analysis.time.frame_time));
  }
  for (const FootSkate& skate : analysis.skates) skates.push_back(AsJson(skate));
  const Json json = {{"format", "hazumi-flights"},
                     {"version", 1},
                     {"flights", flights},
                     {"time", AsJson(analysis.time)},
                     {"skate", skates}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hazumi
