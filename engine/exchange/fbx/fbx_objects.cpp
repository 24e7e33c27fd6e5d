#include "engine/exchange/fbx/fbx_objects.h"

#include <Eigen/Geometry>
#include <cstring>
#include <numbers>
#include <optional>

namespace hazumi {
namespace {

constexpr double kTicks = 46186158000.0;  // of FBX in a second
constexpr double kSlopeWeight = 1.0 / 3.0, kWeightOne = 9999.0;

enum KeyFlags : int64_t {
  kConstant = 0x2,
  kLinear = 0x4,
  kConstantNext = 0x100,  // with kConstant
  kWeightedRight = 0x1000000,
  kWeightedNextLeft = 0x2000000,
};

Mat3 About(int axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vec3::Unit(axis)).toRotationMatrix();
}

// Rotation by three angles in FBX's order of this number; XYZ (0) turns about X first.
Mat3 FromAngles(const Vec3& degrees, int order) {
  constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}};
  Mat3 R = Mat3::Identity();
  for (const int axis : kOrders[order >= 0 && order < 6 ? order : 0])
    R = About(axis, degrees[axis]) * R;
  return R;
}

Eigen::Matrix4d Moved(const Vec3& by) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topRightCorner<3, 1>() = by;
  return M;
}
Eigen::Matrix4d Linear(const Mat3& by) {
  Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
  M.topLeftCorner<3, 3>() = by;
  return M;
}
// A property of this name with so many numbers; null: none. Numbers follow four texts.
const FbxRecord* PropertyOf(const FbxRecord& record, std::string_view name, size_t count) {
  const FbxRecord* list = record.Find("Properties70");
  for (size_t i = 0; list && i < list->children.size(); ++i) {
    const FbxRecord& property = list->children[i];
    if (property.Text(0) == name && property.values.size() >= 4 + count) return &property;
  }
  return nullptr;
}

std::optional<Vec3> VectorOf(const FbxRecord& record, std::string_view name) {
  const FbxRecord* property = PropertyOf(record, name, 3);
  if (!property) return std::nullopt;
  return Vec3(property->values[4].number(), property->values[5].number(),
              property->values[6].number());
}

// A half of the number that holds both weights of a segment.
double WeightOf(double packed, bool is_next_left) {
  uint32_t bits = 0;
  const auto number = static_cast<float>(packed);
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  return static_cast<double>(is_next_left ? bits >> 16 : bits & 0xffff) / kWeightOne;
}

}  // namespace

Eigen::Matrix4d FbxModel::Transform(const Vec3& t, const Vec3& angles, const Vec3& scale) const {
  const Mat3 turn =
      FromAngles(pre, 0) * FromAngles(angles, order) * FromAngles(post, 0).transpose();
  return Moved(t + rotation_offset + rotation_pivot) * Linear(turn) *
         Moved(-rotation_pivot + scaling_offset + scaling_pivot) *
         Linear(scale.asDiagonal().toDenseMatrix()) * Moved(-scaling_pivot);
}

Eigen::Matrix4d FbxModel::Geometry() const {
  return Moved(geometric_T) * Linear(FromAngles(geometric_R, 0)) *
         Linear(geometric_S.asDiagonal().toDenseMatrix());
}

std::string FbxNameOf(const FbxRecord& record) {
  const std::string written = record.Text(1);
  const size_t zero = written.find('\0');
  if (zero != std::string::npos) return written.substr(0, zero);
  const size_t colons = written.find("::");
  return colons == std::string::npos ? written : written.substr(colons + 2);
}

double FbxNumberOf(const FbxRecord& record, std::string_view name, double otherwise) {
  const FbxRecord* property = PropertyOf(record, name, 1);
  return property ? property->values[4].number() : otherwise;
}

FbxModel FbxModelOf(const FbxRecord& record) {
  FbxModel model;
  model.name = FbxNameOf(record);
  const auto take = [&](std::string_view name, Vec3* to) {
    *to = VectorOf(record, name).value_or(*to);
  };
  take("Lcl Translation", &model.T);
  take("Lcl Rotation", &model.R);
  take("Lcl Scaling", &model.S);
  take("RotationOffset", &model.rotation_offset);
  take("RotationPivot", &model.rotation_pivot);
  take("ScalingOffset", &model.scaling_offset);
  take("ScalingPivot", &model.scaling_pivot);
  take("PreRotation", &model.pre);
  take("PostRotation", &model.post);
  take("GeometricTranslation", &model.geometric_T);
  take("GeometricRotation", &model.geometric_R);
  take("GeometricScaling", &model.geometric_S);
  model.order = static_cast<int>(FbxNumberOf(record, "RotationOrder", 0.0));
  return model;
}
FbxStack FbxStackOf(const FbxRecord& record) {
  return {FbxNameOf(record), FbxNumberOf(record, "LocalStart", 0.0) / kTicks,
          FbxNumberOf(record, "LocalStop", 0.0) / kTicks};
}
ScalarCurve FbxCurveOf(const FbxRecord& record) {
  const auto array = [&](std::string_view name) -> const FbxValue& {
    static const FbxValue kNone;
    const FbxRecord* found = record.Find(name);
    return found && !found->values.empty() ? found->values[0] : kNone;
  };
  const std::vector<int64_t>&times = array("KeyTime").wholes, &flags = array("KeyAttrFlags").wholes,
        &counts = array("KeyAttrRefCount").wholes;
  const std::vector<double>&values = array("KeyValueFloat").numbers,
        &data = array("KeyAttrDataFloat").numbers;
  ScalarCurve curve;
  if (times.size() != values.size()) return curve;
  size_t group = 0;
  int64_t left = counts.empty() ? 0 : counts[0];
  for (size_t i = 0; i < times.size(); ++i) {
    while (left <= 0 && group + 1 < counts.size()) left = counts[++group];
    --left;
    ScalarKey key;
    key.t = static_cast<double>(times[i]) / kTicks;
    key.v = values[i];
    const int64_t how = group < flags.size() ? flags[group] : kLinear;
    if (how & kConstant) {
      key.kind = how & kConstantNext ? ScalarKey::Kind::kStepAtOnce : ScalarKey::Kind::kStep;
    } else if (!(how & kLinear) && 4 * group + 3 < data.size() && i + 1 < times.size()) {
      const double d = static_cast<double>(times[i + 1] - times[i]) / kTicks;
      const double* slopes = data.data() + 4 * group;
      const double right = how & kWeightedRight ? WeightOf(slopes[2], false) : kSlopeWeight;
      const double left_weight = how & kWeightedNextLeft ? WeightOf(slopes[2], true) : kSlopeWeight;
      key.kind = ScalarKey::Kind::kBezier;
      key.behind = {right * d, slopes[0] * right * d};
      key.before = {left_weight * d, slopes[1] * left_weight * d};
    }
    curve.push_back(key);
  }
  return curve;
}

}  // namespace hazumi
