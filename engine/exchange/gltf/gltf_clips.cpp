#include "engine/exchange/gltf/gltf_clips.h"

#include <algorithm>

namespace hazumi {

namespace {

class ClipWriter {
 public:
  ClipWriter(const Clip& clip, GltfBuffer* buffer) : clip_(clip), buffer_(buffer) {}

  GltfJson Write(const std::vector<GltfMovedNode>& nodes) {
    for (const GltfMovedNode& moved : nodes) {
      node_ = moved.node;
      AddVectors("translation", moved.track->translations, moved.rest.p);
      AddRotations(moved.track->rotations, Eigen::Quaterniond(moved.rest.R).normalized());
      AddVectors("scale", moved.track->scales, moved.rest_scale);
    }
    if (channels_.empty()) return nullptr;
    return {{"name", clip_.name}, {"channels", channels_}, {"samplers", samplers_}};
  }

 private:
  void AddVectors(const char* path, const std::vector<Vec3>& values, const Vec3& rest) {
    std::vector<float> keys;
    keys.reserve(3 * values.size());
    for (const Vec3& v : values) {
      for (const double x : v) keys.push_back(static_cast<float>(x));
    }
    const Eigen::Vector3f still = rest.cast<float>();
    AddChannel(path, std::move(keys), {still.x(), still.y(), still.z()});
  }

  // All in the hemisphere of the one before, the first in that of the bone at rest.
  void AddRotations(const std::vector<Eigen::Quaterniond>& rotations,
                    const Eigen::Quaterniond& rest) {
    std::vector<float> keys;
    keys.reserve(4 * rotations.size());
    Eigen::Quaterniond last = rest;
    for (Eigen::Quaterniond q : rotations) {
      q.normalize();
      if (q.dot(last) < 0.0) q.coeffs() = -q.coeffs();
      for (const double x : q.coeffs()) keys.push_back(static_cast<float>(x));
      last = q;
    }
    const Eigen::Vector4f still = rest.coeffs().cast<float>();
    AddChannel("rotation", std::move(keys), {still.x(), still.y(), still.z(), still.w()});
  }

  // Nothing if the bone is at rest; two equal keys if it stands still elsewhere.
  void AddChannel(const char* path, std::vector<float> keys, const std::vector<float>& rest) {
    if (keys.empty()) return;
    const size_t width = rest.size();
    const bool moves =
        !std::equal(keys.begin() + static_cast<std::ptrdiff_t>(width), keys.end(), keys.begin());
    if (!moves && std::equal(rest.begin(), rest.end(), keys.begin())) return;
    if (!moves) keys.resize(std::min(keys.size(), 2 * width));
    const int output = buffer_->AddFloats(keys, static_cast<int>(width), GltfUse::kPlain);
    channels_.push_back(
        {{"sampler", samplers_.size()}, {"target", {{"node", node_}, {"path", path}}}});
    samplers_.push_back({{"input", Times(moves)}, {"interpolation", "LINEAR"}, {"output", output}});
  }

  // The accessor of all frames' times, or of the first and the last one.
  int Times(bool all) {
    int& accessor = all ? all_times_ : end_times_;
    if (accessor >= 0) return accessor;
    const int last = clip_.num_frames - 1;
    std::vector<float> times;
    for (int i = 0; i <= last; i += all ? 1 : std::max(last, 1)) {
      times.push_back(static_cast<float>(i * clip_.seconds_per_frame));
    }
    return accessor = buffer_->AddFloats(times, 1, GltfUse::kPlain, /*with_bounds=*/true);
  }

  const Clip& clip_;
  GltfBuffer* buffer_;
  GltfJson channels_ = GltfJson::array(), samplers_ = GltfJson::array();
  size_t node_ = 0;
  int all_times_ = -1, end_times_ = -1;
};

}  // namespace

GltfJson GltfAnimation(const std::vector<GltfMovedNode>& nodes, const Clip& clip,
                       GltfBuffer* buffer) {
  return ClipWriter(clip, buffer).Write(nodes);
}

std::array<double, 4> GltfQuaternion(const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond unit = q.normalized();
  return {unit.x(), unit.y(), unit.z(), unit.w()};
}

}  // namespace hazumi
