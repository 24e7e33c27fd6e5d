#include "engine/exchange/assimp/clip_sampler.h"

#include <algorithm>
#include <cstring>

namespace hazumi {
namespace {

constexpr double kStillAngle = 1e-5;   // [rad]
constexpr double kStillLength = 1e-6;  // of the skeleton's size
constexpr double kStillScale = 1e-5;   // of the scale at rest

// Whether helper nodes of this name are parts of a node's transform.
bool Helps(const char* helper, const char* node) {
  const size_t length = std::strlen(node);
  return std::strncmp(helper, node, length) == 0 &&
         std::strncmp(helper + length, "_$AssimpFbx$_", 13) == 0;
}

Eigen::Matrix4d Compose(const MatrixParts& parts) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = parts.X.R * parts.scale.asDiagonal();
  matrix.topRightCorner<3, 1>() = parts.X.p;
  return matrix;
}

}  // namespace

ClipSampler::ClipSampler(const SceneTree& tree, const SceneSkeleton& skeleton)
    : tree_(tree),
      skeleton_(skeleton),
      matters_(tree.nodes.size(), 0),
      rest_(tree.nodes.size()),
      moved_(tree.nodes.size()) {
  for (const std::vector<int>& chain : skeleton.chains) {
    for (const int node : chain) {
      matters_[static_cast<size_t>(node)] = 1;
      rest_[static_cast<size_t>(node)] = Decompose(tree.nodes[static_cast<size_t>(node)].local);
    }
  }
}

void ClipSampler::AddChannel(const aiNodeAnim& channel, const ChannelSteps& steps) {
  const int node = tree_.Find(channel.mNodeName);
  if (node < 0 || !matters_[static_cast<size_t>(node)]) return;
  moved_[static_cast<size_t>(node)] = {&channel, steps};
  used_.push_back(&channel);
}

// assimp 5.2.5 splits an FBX node with a pre-rotation into helpers, but where only such simple
// parts are moved gives one channel, of the node itself, that holds all of them.
std::vector<int> ClipSampler::ActiveChain(size_t bone) const {
  const std::vector<int>& chain = skeleton_.chains[bone];
  std::vector<int> active;
  for (size_t i = 0; i < chain.size(); ++i) {
    const SceneNode& node = tree_.nodes[static_cast<size_t>(chain[i])];
    size_t helped = i;
    while (helped + 1 < chain.size() && tree_.nodes[static_cast<size_t>(chain[helped])].is_helper)
      ++helped;
    const bool is_contained =
        helped > i && moved_[static_cast<size_t>(chain[helped])].channel &&
        Helps(node.node->mName.C_Str(),
              tree_.nodes[static_cast<size_t>(chain[helped])].node->mName.C_Str());
    if (!is_contained) active.push_back(chain[i]);
  }
  return active;
}

bool ClipSampler::IsMoved(const std::vector<int>& chain) const {
  return std::any_of(chain.begin(), chain.end(),
                     [&](int i) { return moved_[static_cast<size_t>(i)].channel != nullptr; });
}

MatrixParts ClipSampler::NodeAt(int node, double tick) const {
  MatrixParts parts = rest_[static_cast<size_t>(node)];
  const Moved& moved = moved_[static_cast<size_t>(node)];
  if (!moved.channel) return parts;
  const ChannelValue value = SampleChannel(*moved.channel, moved.steps, tick);
  if (value.translation) parts.X.p = *value.translation;
  if (value.rotation) parts.X.R = value.rotation->toRotationMatrix();
  if (value.scale) parts.scale = *value.scale;
  return parts;
}

MatrixParts ClipSampler::ChainAt(const std::vector<int>& chain, double tick) const {
  if (chain.size() == 1) return NodeAt(chain[0], tick);
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  for (const int node : chain) {
    product = product * (moved_[static_cast<size_t>(node)].channel
                             ? Compose(NodeAt(node, tick))
                             : tree_.nodes[static_cast<size_t>(node)].local);
  }
  return Decompose(product);
}

BoneTrack ClipSampler::SampleBone(size_t bone, double start, double step, int num_frames) const {
  const std::vector<int> chain = ActiveChain(bone);
  BoneTrack track;
  if (!IsMoved(chain)) return track;
  const Bone& rest = skeleton_.bones[bone];
  const Eigen::Quaterniond rest_rotation(rest.rest.R);
  double angle = 0.0, length = 0.0, scale = 0.0;
  Eigen::Quaterniond previous = rest_rotation;
  for (int frame = 0; frame < num_frames; ++frame) {
    const MatrixParts parts = ChainAt(chain, start + frame * step);
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

std::vector<BoneTrack> ClipSampler::Sample(double start_tick, double ticks_per_frame,
                                           int num_frames) const {
  std::vector<BoneTrack> tracks;
  for (size_t i = 0; i < skeleton_.bones.size(); ++i)
    tracks.push_back(SampleBone(i, start_tick, ticks_per_frame, num_frames));
  return tracks;
}

}  // namespace hazumi
