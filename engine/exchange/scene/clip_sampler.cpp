#include "engine/exchange/scene/clip_sampler.h"

#include <algorithm>

namespace hazumi {
namespace {

constexpr double kStillAngle = 1e-5;   // [rad]
constexpr double kStillLength = 1e-6;  // of the skeleton's size
constexpr double kStillScale = 1e-5;   // of the scale at rest
// Of a frame: a step so much later counts as on it. Times of files are in single precision.
constexpr double kSlack = 0.02;

}  // namespace

ClipSampler::ClipSampler(const SceneTree& tree, const SceneSkeleton& skeleton)
    : tree_(tree),
      skeleton_(skeleton),
      matters_(tree.nodes.size(), 0),
      rest_(tree.nodes.size()),
      motion_(tree.nodes.size()) {
  for (const std::vector<int>& chain : skeleton.chains) {
    for (const int node : chain) {
      matters_[static_cast<size_t>(node)] = 1;
      rest_[static_cast<size_t>(node)] = Decompose(tree.node(node).local);
    }
  }
}

void ClipSampler::Add(int node, const NodeMotion& motion) {
  if (!matters_[static_cast<size_t>(node)]) return;
  motion_[static_cast<size_t>(node)] = &motion;
  used_.push_back(&motion);
}

// A motion of a node that has helpers holds what they do, too.
std::vector<int> ClipSampler::ActiveChain(size_t bone) const {
  const std::vector<int>& chain = skeleton_.chains[bone];
  std::vector<int> active;
  for (size_t i = 0; i < chain.size(); ++i) {
    size_t helped = i;
    while (helped + 1 < chain.size() && tree_.node(chain[helped]).is_helper) ++helped;
    const bool is_contained = helped > i && motion_[static_cast<size_t>(chain[helped])];
    if (!is_contained) active.push_back(chain[i]);
  }
  return active;
}

bool ClipSampler::IsMoved(const std::vector<int>& chain) const {
  return std::any_of(chain.begin(), chain.end(),
                     [&](int i) { return motion_[static_cast<size_t>(i)] != nullptr; });
}

MatrixParts ClipSampler::PartsAt(int node, const NodeValue& value) const {
  if (value.matrix) return Decompose(*value.matrix);
  MatrixParts parts = rest_[static_cast<size_t>(node)];
  if (value.translation) parts.X.p = *value.translation;
  if (value.rotation) parts.X.R = value.rotation->toRotationMatrix();
  if (value.scale) parts.scale = *value.scale;
  return parts;
}

Eigen::Matrix4d ClipSampler::NodeAt(int node, double t, double slack) const {
  const NodeMotion* motion = motion_[static_cast<size_t>(node)];
  if (!motion) return tree_.node(node).local;
  const NodeValue value = motion->At(t, slack);
  return value.matrix ? *value.matrix : Compose(PartsAt(node, value));
}

MatrixParts ClipSampler::ChainAt(const std::vector<int>& chain, double t, double slack) const {
  if (chain.size() == 1)
    return PartsAt(chain[0], motion_[static_cast<size_t>(chain[0])]->At(t, slack));
  return Decompose(ProductAt(chain, t, slack));
}

Eigen::Matrix4d ClipSampler::ProductAt(const std::vector<int>& nodes, double t,
                                       double slack) const {
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  for (const int node : nodes) product = product * NodeAt(node, t, slack);
  return product;
}

BoneTrack ClipSampler::SampleBone(size_t bone, const Times& times) const {
  const std::vector<int> chain = ActiveChain(bone);
  BoneTrack track;
  if (!IsMoved(chain)) return track;
  const std::vector<int> above(chain.begin(), chain.end() - 1);
  const bool is_moved_above = IsMoved(above);
  const Bone& rest = skeleton_.bones[bone];
  const Eigen::Quaterniond rest_rotation(rest.rest.R);
  double angle = 0.0, length = 0.0, scale = 0.0;
  Eigen::Quaterniond previous = rest_rotation;
  for (int frame = 0; frame < times.count; ++frame) {
    const double t = times.start + frame * times.step;
    const MatrixParts parts = ChainAt(chain, t, times.slack);
    if (is_moved_above) track.above.push_back(ProductAt(above, t, times.slack));
    Eigen::Quaterniond q(parts.X.R);
    q.normalize();
    if (q.dot(previous) < 0.0) q.coeffs() = -q.coeffs();  // the shorter way from frame to frame
    previous = q;
    track.rotations.push_back(q);
    track.translations.push_back(parts.X.p);
    track.scales.push_back(parts.scale);
    angle = std::max(angle, q.angularDistance(rest_rotation));
    length = std::max(length, (parts.X.p - rest.rest.p).norm());
    scale = std::max(scale, (parts.scale - rest.rest_scale).norm() / rest.rest_scale.norm());
  }
  if (angle < kStillAngle) track.rotations = {};
  if (length < kStillLength * skeleton_.size) track.translations = {};
  if (scale < kStillScale) track.scales = {};
  return track;
}

std::vector<BoneTrack> ClipSampler::Sample(double start, double seconds_per_frame,
                                           int num_frames) const {
  const Times times = {start, seconds_per_frame, kSlack * seconds_per_frame, num_frames};
  std::vector<BoneTrack> tracks;
  for (size_t i = 0; i < skeleton_.bones.size(); ++i) tracks.push_back(SampleBone(i, times));
  return tracks;
}

}  // namespace hazumi
