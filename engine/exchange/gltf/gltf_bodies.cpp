#include "engine/exchange/gltf/gltf_bodies.h"

namespace hazumi {

namespace {

nlohmann::ordered_json Written(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Numbers of a JSON that may be anything.
class Reader {
 public:
  explicit Reader(const nlohmann::json& json) : json_(json) {}

  bool ok() const { return is_ok_; }
  double Number(const char* name) {
    const nlohmann::json* value = Find(name);
    is_ok_ = is_ok_ && value && value->is_number();
    return is_ok_ ? value->get<double>() : 0.0;
  }
  Vec3 Vector(const char* name) {
    const nlohmann::json* value = Find(name);
    is_ok_ = is_ok_ && value && IsVector(*value);
    return is_ok_ ? VectorOf(*value) : Vec3(Vec3::Zero());
  }
  Mat3 Matrix(const char* name) {
    const nlohmann::json* rows = Find(name);
    is_ok_ = is_ok_ && rows && rows->is_array() && rows->size() == 3;
    Mat3 matrix = Mat3::Zero();
    for (int i = 0; is_ok_ && i < 3; ++i) {
      is_ok_ = IsVector((*rows)[i]);
      if (is_ok_) matrix.row(i) = VectorOf((*rows)[i]);
    }
    return matrix;
  }
  std::string Text(const char* name) {
    const nlohmann::json* value = Find(name);
    is_ok_ = is_ok_ && value && value->is_string();
    return is_ok_ ? value->get<std::string>() : "";
  }

 private:
  const nlohmann::json* Find(const char* name) const {
    const auto found = json_.is_object() ? json_.find(name) : json_.end();
    return json_.is_object() && found != json_.end() ? &*found : nullptr;
  }
  static bool IsVector(const nlohmann::json& value) {
    return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() &&
           value[2].is_number();
  }
  static Vec3 VectorOf(const nlohmann::json& value) {
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }

  const nlohmann::json& json_;
  bool is_ok_ = true;
};

}  // namespace

nlohmann::ordered_json GltfBody(const BoneBody& body) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(Written(body.inertia.row(i)));
  nlohmann::ordered_json capsules = nlohmann::ordered_json::array();
  for (const BoneBody::Capsule& capsule : body.capsules) {
    capsules.push_back({{"name", capsule.name},
                        {"from_m", Written(capsule.from)},
                        {"to_m", Written(capsule.to)},
                        {"radius_m", capsule.radius}});
  }
  return {{"mass_kg", body.mass},
          {"com_m", Written(body.com)},
          {"inertia_kg_m2", rows},
          {"capsules", capsules}};
}

std::optional<BoneBody> BodyFromGltf(const nlohmann::json& written) {
  Reader reader(written);
  BoneBody body = {
      reader.Number("mass_kg"), reader.Vector("com_m"), reader.Matrix("inertia_kg_m2"), {}};
  if (!reader.ok() || !written.contains("capsules") || !written["capsules"].is_array()) return {};
  for (const nlohmann::json& entry : written["capsules"]) {
    Reader capsule(entry);
    body.capsules.push_back({capsule.Text("name"), capsule.Vector("from_m"), capsule.Vector("to_m"),
                             capsule.Number("radius_m")});
    if (!capsule.ok()) return {};
  }
  return body;
}

}  // namespace hazumi
