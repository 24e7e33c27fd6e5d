#include "engine/project/figure_fields.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/figure/figure_builder.h"
#include "engine/project/checks/field_checks.h"
#include "engine/project/json/read_value.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

constexpr size_t kMostJoints = 10'000;

struct AxisName {
  const char* name;
  Vec3 axis;
};
const AxisName kAxisNames[] = {{"x", Vec3::UnitX()},   {"y", Vec3::UnitY()},
                               {"z", Vec3::UnitZ()},   {"-x", -Vec3::UnitX()},
                               {"-y", -Vec3::UnitY()}, {"-z", -Vec3::UnitZ()}};

void ReadAxisName(const Json& json, const Site& site, Vec3& axis) {
  const std::string& word = json.get_ref<const std::string&>();
  std::vector<std::string> words;
  for (const AxisName& entry : kAxisNames) {
    if (entry.name == word) {
      axis = entry.axis;
      return;
    }
    words.emplace_back(entry.name);
  }
  site.Report(Check::kUnknownChoice, {"axis " + Quoted(word), Suggestion(word, words)});
}

// "z", "-y", or a unit vector.
void ReadAxis(FieldReader& in, Vec3& axis) {
  const Json* json = in.FindRequired("axis");
  if (!json) return;
  const Site site = in.At("axis");
  if (json->is_string()) return ReadAxisName(*json, site, axis);
  ReadValue(*json, site, axis);
  CheckUnitVector(axis, site);
  if (axis.norm() > 0.0) axis.normalize();
}

void ReadPositive(FieldReader& in, const char* name, double& value) {
  in.Required({name}, value);
  CheckPositive(value, in.At(name));
}

void ReadNotNegative(FieldReader& in, const char* name, std::optional<double>& value) {
  in.Optional({name}, value);
  if (value) CheckNotNegative(*value, in.At(name));
}

void ReadColor(FieldReader& in, const char* name, std::string& color) {
  in.Required({name}, color);
  CheckColor(color, in.At(name));
}

void ReadTaperedCapsule(FieldReader& in, Look& look) {
  std::array<double, 2> radii{1.0, 1.0};
  in.Required({"from_m"}, look.from);
  in.Required({"to_m"}, look.to);
  in.Required({"radii_m"}, radii);
  for (size_t i = 0; i < 2; ++i) CheckPositive(radii[i], in.At("radii_m").Item(i));
  look.radius_from = radii[0];
  look.radius_to = radii[1];
}

void ReadEllipsoid(FieldReader& in, Look& look) {
  look.half_axes = Vec3::Ones();
  in.Required({"center_m"}, look.center);
  in.Required({"half_axes_m"}, look.half_axes);
  CheckPositive(look.half_axes, in.At("half_axes_m"));
}

Mat3 SymmetricMatrix(const std::array<double, 6>& m) {  // xx, yy, zz, xy, xz, yz
  Mat3 matrix;
  matrix << m[0], m[3], m[4], m[3], m[1], m[5], m[4], m[5], m[2];
  return matrix;
}

}  // namespace

static void Describe(FieldReader& in, Look& look) {
  in.Required({"shape"}, look.shape);
  if (look.shape == Look::Shape::kTaperedCapsule) {
    ReadTaperedCapsule(in, look);
  } else {
    ReadEllipsoid(in, look);
  }
  ReadColor(in, "color", look.color);
  in.Optional({"mirror_color"}, look.mirror_color);
  if (!look.mirror_color.empty()) CheckColor(look.mirror_color, in.At("mirror_color"));
}

// "plate", "wing" or {"lift": [...], "drag": [...]}.
static void ReadCoefficients(FieldReader& in, LinkSurface& surface) {
  const Json* json = in.Find("coefficients");
  if (!json) return;
  const Site site = in.At("coefficients");
  if (!json->is_object()) return ReadValue(*json, site, surface.kind);
  surface.kind = LinkSurface::Kind::kTable;
  FieldReader table(*json, site);
  for (auto [name, values] : {std::pair("lift", &surface.lift), std::pair("drag", &surface.drag)}) {
    table.Required({name}, *values);
    if (values->empty()) CheckNotEmpty("", table.At(name));
  }
  for (size_t i = 0; i < surface.drag.size(); ++i) {
    CheckNotNegative(surface.drag[i], table.At("drag").Item(i));
  }
}

static void Describe(FieldReader& in, LinkSurface& surface) {
  ReadPositive(in, "area_m2", surface.area);
  in.Required({"normal"}, surface.normal);
  CheckUnitVector(surface.normal, in.At("normal"));
  if (surface.normal.norm() > 0.0) surface.normal.normalize();
  in.Required({"center_m"}, surface.center);
  ReadCoefficients(in, surface);
}

static void Describe(FieldReader& in, LinkSpec& link) {
  in.Required({"name"}, link.name);
  in.Required({"from_m"}, link.from);
  in.Required({"to_m"}, link.to);
  ReadPositive(in, "radius_m", link.radius);
  ReadNotNegative(in, "mass_kg", link.mass);
  ReadNotNegative(in, "density_kg_m3", link.density);
  if (link.mass.has_value() == link.density.has_value()) {
    in.site().Report(Check::kNotOneOf, {"\"mass_kg\" and \"density_kg_m3\""});
  }
  if (in.Find("com_m")) in.Required({"com_m"}, link.com.emplace(Vec3::Zero()));
  std::optional<std::array<double, 6>> inertia;
  in.Optional({"inertia_kg_m2"}, inertia);
  if (inertia) link.inertia = SymmetricMatrix(*inertia);
  in.Optional({"look"}, link.looks);
  in.Optional({"surface"}, link.surface);
}

static void Describe(FieldReader& in, StrengthCurve& curve) {
  double angle_deg = 0.0, width_deg = 1.0;
  const auto read_rate = [&](const char* name, double* rate) {
    double rate_deg = *rate / kDegree;
    ReadPositive(in, name, rate_deg);
    *rate = rate_deg * kDegree;
  };
  in.Required({"curve"}, curve.form);
  ReadPositive(in, "torque_n_m", curve.torque);
  if (curve.form == StrengthCurve::Form::kConstant) return;
  in.Required({"best_angle_deg"}, angle_deg);
  ReadPositive(in, "width_deg", width_deg);
  curve.best_angle = angle_deg * kDegree;
  curve.width = width_deg * kDegree;
  if (curve.form == StrengthCurve::Form::kBell) return read_rate("fastest_deg_s", &curve.fastest);
  read_rate("rate_75_deg_s", &curve.rate_75);
  read_rate("rate_50_deg_s", &curve.rate_50);
  in.Optional({"lengthening_s"}, curve.lengthening);
  CheckNotNegative(curve.lengthening, in.At("lengthening_s"));
  if (curve.rate_50 > curve.rate_75) return;
  in.At("rate_50_deg_s")
      .Report(Check::kRange, {NumberText(curve.rate_75 / kDegree), NumberText(kLargestNumber),
                              NumberText(curve.rate_50 / kDegree)});
}

// A number, or a curve.
static void ReadStrengthOfASide(FieldReader& in, const char* number, const char* curve,
                                StrengthCurve* side) {
  const bool has_number = in.Find(number) != nullptr, has_curve = in.Find(curve) != nullptr;
  if (has_number == has_curve) {
    return in.site().Report(Check::kNotOneOf, {Quoted(number) + " and " + Quoted(curve)});
  }
  if (has_curve) return in.Required({curve}, *side);
  ReadPositive(in, number, side->torque);
}

static void Describe(FieldReader& in, JointStrength& strength) {
  ReadStrengthOfASide(in, "positive_n_m", "positive", &strength.positive);
  ReadStrengthOfASide(in, "negative_n_m", "negative", &strength.negative);
}

static void Describe(FieldReader& in, HingeSpec& hinge) {
  std::array<double, 2> limits_deg{0.0, 0.0};
  double rest_deg = 0.0;
  in.Optional({"name"}, hinge.name);
  ReadAxis(in, hinge.axis);
  in.Required({"limits_deg"}, limits_deg);
  in.Stated({"rest_deg"}, rest_deg);
  in.Optional({"strength"}, hinge.strength);
  hinge.lower = limits_deg[0] * kDegree;
  hinge.upper = limits_deg[1] * kDegree;
  hinge.rest = rest_deg * kDegree;
}

static void Describe(FieldReader& in, JointSpec& joint) {
  Vec3 orientation_deg = Vec3::Zero();
  in.Required({"name"}, joint.name);
  CheckNotEmpty(joint.name, in.At("name"));
  in.Required({"parent"}, joint.parent);
  in.Required({"offset_m"}, joint.offset);
  in.Optional({"orientation_deg"}, orientation_deg);
  joint.orientation = RotationFromAngles(orientation_deg);
  if (in.Find("role")) {
    joint.body.emplace();
    in.Required({"role"}, joint.body->role);
    in.Optional({"side"}, joint.body->side);
  }
  in.Required({"hinges"}, joint.hinges);
  in.Optional({"links"}, joint.links);
}

static void Describe(FieldReader& in, MirrorSpec& mirror) {
  in.Required({"from"}, mirror.from);
  in.Required({"to"}, mirror.to);
  CheckNotEmpty(mirror.from, in.At("from"));
  CheckNotEmpty(mirror.to, in.At("to"));
}

static void Describe(FieldReader& in, FigureSpec& spec) {
  in.Literal("format", "");
  in.Literal("version", 1);
  in.Optional({"name"}, spec.name);
  in.Nested({"root"}, spec, [](FieldReader& root, FigureSpec& figure) {
    root.Required({"name"}, figure.root_name);
    root.Optional({"links"}, figure.root_links);
  });
  in.FindRequired("root");
  in.Required({"joints"}, spec.joints);
  in.Optional({"mirror"}, spec.mirror);
}

static void CheckParents(const FigureSpec& spec, const Site& site) {
  std::vector<std::string> parents = {spec.root_name};
  for (const JointSpec& joint : WithMirroredTwins(spec).joints) parents.push_back(joint.name);
  for (size_t i = 0; i < spec.joints.size(); ++i) {
    const std::string& parent = spec.joints[i].parent;
    if (std::find(parents.begin(), parents.end(), parent) != parents.end()) continue;
    site.Field("joints").Item(i).Field("parent").Report(
        Check::kUnknownParent, {Quoted(parent), Suggestion(parent, parents)});
    return;
  }
}

static void CheckBuilds(const FigureSpec& spec, const Site& site) {
  const Result<Figure> figure = BuildFigure(spec);
  if (figure.ok()) return;
  Error error = figure.error();
  if (!site.place.empty()) error.place = site.Field(error.place).place;
  site.errors->Report(error);
}

bool ExpectFormat(const Json& json, const char* format, int newest, Check other_format,
                  const Site& site) {
  if (!json.is_object() || !json.contains("format") || json["format"] != format) {
    site.Report(other_format);
    return false;
  }
  int version = 0;
  FieldReader(json, site).Required({"version"}, version);
  const Site place = site.Field("version");
  if (version > newest) {
    place.Report(Check::kNewerFormat, {std::to_string(version), std::to_string(newest)});
  }
  if (version < 1) place.Report(Check::kUnknownFormat, {std::to_string(version)});
  return site.errors->ok();
}

FigureSpec ReadFigure(const Json& json, const Site& site) {
  FigureSpec spec;
  if (!ExpectFormat(json, "hazumi-figure", 1, Check::kNotAFigure, site)) return spec;
  ReadValue(json, site, spec);
  if (spec.joints.size() > kMostJoints) {
    site.Field("joints").Report(Check::kTooManyJoints, {std::to_string(spec.joints.size())});
  }
  if (site.errors->ok()) CheckParents(spec, site);
  if (site.errors->ok()) CheckBuilds(spec, site);
  return spec;
}

Mat3 RotationFromAngles(const Vec3& zyx_deg) {
  if (zyx_deg.isZero(0.0)) return Mat3::Identity();
  const Vec3 angles = zyx_deg * kDegree;
  return (Eigen::AngleAxisd(angles[0], Vec3::UnitZ()) *
          Eigen::AngleAxisd(angles[1], Vec3::UnitY()) * Eigen::AngleAxisd(angles[2], Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace hazumi
