#include "engine/project/figure_file.h"

#include <Eigen/Geometry>
#include <cmath>

#include "engine/project/enum_names.h"
#include "engine/project/figure_fields.h"
#include "engine/project/json/field_writer.h"
#include "engine/project/json/json.h"
#include "engine/project/json/text_file.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

// Angles z, y, x [deg] of R = Rz Ry Rx. Where y is near a right angle z is hardly known; x follows
// from it, so that together they are right.
Vec3 AnglesOf(const Mat3& R) {
  const double z = std::atan2(R(1, 0), R(0, 0));
  const Mat3 rest = Eigen::AngleAxisd(-z, Vec3::UnitZ()).toRotationMatrix() * R;
  const double y = std::atan2(-rest(2, 0), rest(0, 0));
  const double x = std::atan2(-rest(1, 2), rest(1, 1));
  return {ShortestDegrees(z), ShortestDegrees(y), ShortestDegrees(x)};
}

Json ToJson(const Look& look) {
  Json json = {{"shape", NameOf(look.shape)}};
  if (look.shape == Look::Shape::kTaperedCapsule) {
    json["from_m"] = hazumi::ToJson(look.from);
    json["to_m"] = hazumi::ToJson(look.to);
    json["radii_m"] = Json::array({look.radius_from, look.radius_to});
  } else {
    json["center_m"] = hazumi::ToJson(look.center);
    json["half_axes_m"] = hazumi::ToJson(look.half_axes);
  }
  json["color"] = look.color;
  if (!look.mirror_color.empty()) json["mirror_color"] = look.mirror_color;
  return json;
}

Json ToJson(const LinkSurface& surface) {
  Json json = {{"area_m2", surface.area},
               {"normal", hazumi::ToJson(surface.normal)},
               {"center_m", hazumi::ToJson(surface.center)}};
  if (surface.kind == LinkSurface::Kind::kTable) {
    json["coefficients"] = {{"lift", surface.lift}, {"drag", surface.drag}};
  } else {
    json["coefficients"] = NameOf(surface.kind);
  }
  return json;
}

Json ToJson(const LinkSpec& link) {
  Json json = {{"name", link.name},
               {"from_m", hazumi::ToJson(link.from)},
               {"to_m", hazumi::ToJson(link.to)},
               {"radius_m", link.radius}};
  if (link.mass) json["mass_kg"] = *link.mass;
  if (link.density) json["density_kg_m3"] = *link.density;
  if (link.com) json["com_m"] = hazumi::ToJson(*link.com);
  if (link.inertia) {
    const Mat3& I = *link.inertia;
    json["inertia_kg_m2"] = Json::array({I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)});
  }
  for (const Look& look : link.looks) json["look"].push_back(ToJson(look));
  if (link.surface) json["surface"] = ToJson(*link.surface);
  return json;
}

Json ToJson(const std::vector<LinkSpec>& links) {
  Json list = Json::array();
  for (const LinkSpec& link : links) list.push_back(ToJson(link));
  return list;
}

Json ToJson(const StrengthCurve& curve) {
  Json json = {{"curve", NameOf(curve.form)},
               {"torque_n_m", curve.torque},
               {"best_angle_deg", ShortestDegrees(curve.best_angle)},
               {"width_deg", ShortestDegrees(curve.width)}};
  if (curve.form == StrengthCurve::Form::kBell) {
    json["fastest_deg_s"] = ShortestDegrees(curve.fastest);
    return json;
  }
  json["rate_75_deg_s"] = ShortestDegrees(curve.rate_75);
  json["rate_50_deg_s"] = ShortestDegrees(curve.rate_50);
  json["lengthening_s"] = curve.lengthening;
  return json;
}

Json ToJson(const JointStrength& strength) {
  Json json = Json::object();
  const auto put = [&](const std::string& name, const StrengthCurve& side) {
    if (side.form == StrengthCurve::Form::kConstant) {
      json[name + "_n_m"] = side.torque;
    } else {
      json[name] = ToJson(side);
    }
  };
  put("positive", strength.positive);
  put("negative", strength.negative);
  return json;
}

Json ToJson(const HingeSpec& hinge) {
  Json json = Json::object();
  if (!hinge.name.empty()) json["name"] = hinge.name;
  json["axis"] = hazumi::ToJson(hinge.axis);
  json["limits_deg"] = Json::array({ShortestDegrees(hinge.lower), ShortestDegrees(hinge.upper)});
  json["rest_deg"] = ShortestDegrees(hinge.rest);
  if (hinge.strength) json["strength"] = ToJson(*hinge.strength);
  return json;
}

Json ToJson(const JointSpec& joint) {
  Json json = {
      {"name", joint.name}, {"parent", joint.parent}, {"offset_m", hazumi::ToJson(joint.offset)}};
  if (!joint.orientation.isIdentity(0.0)) {
    json["orientation_deg"] = hazumi::ToJson(AnglesOf(joint.orientation));
  }
  if (joint.body) {
    json["role"] = NameOf(joint.body->role);
    if (joint.body->side != BodySide::kMiddle) json["side"] = NameOf(joint.body->side);
  }
  for (const HingeSpec& hinge : joint.hinges) json["hinges"].push_back(ToJson(hinge));
  if (!joint.links.empty()) json["links"] = ToJson(joint.links);
  return json;
}

}  // namespace

std::string FigureText(const FigureSpec& spec) {
  Json json = {{"format", "hazumi-figure"}, {"version", 1}, {"name", spec.name}};
  json["root"] = {{"name", spec.root_name}};
  if (!spec.root_links.empty()) json["root"]["links"] = ToJson(spec.root_links);
  json["joints"] = Json::array();
  for (const JointSpec& joint : spec.joints) json["joints"].push_back(ToJson(joint));
  if (spec.mirror) json["mirror"] = {{"from", spec.mirror->from}, {"to", spec.mirror->to}};
  return CompactJson(json);
}

Result<FigureSpec> LoadFigure(const std::string& path, std::vector<Warning>* warnings,
                              std::vector<Warning>* unknown) {
  const Result<std::string> text = ReadTextFile(path);
  if (!text.ok()) return text.error();
  return ParseFigure(text.value(), path, warnings, unknown);
}

Result<FigureSpec> ParseFigure(std::string_view text, const std::string& file_name,
                               std::vector<Warning>* warnings, std::vector<Warning>* unknown) {
  FirstError errors;
  const std::optional<Json> json = ParseJson(text, &errors);
  if (!json) return errors.In(file_name);
  FigureSpec spec = ReadFigure(*json, {"", &errors, warnings, unknown});
  if (!errors.ok()) return errors.In(file_name);
  return spec;
}

}  // namespace hazumi
