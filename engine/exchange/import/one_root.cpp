// X_R and X_C are the transforms of the root and of another branch in their common parent's frame.
// X_C = X_R (X_R^-1 X_C), so the branch has the transform X_R^-1 X_C in the root's frame, at rest
// and in each frame of a clip. The root must have no scale.

#include "engine/exchange/import/one_root.h"

#include <algorithm>
#include <numeric>

#include "engine/exchange/import/bone_order.h"

namespace hazumi {

namespace {

constexpr double kUnscaled = 1e-6;

bool IsUnscaled(const Bone& bone) {
  return (bone.rest_scale - Vec3::Ones()).cwiseAbs().maxCoeff() < kUnscaled;
}

Pose PoseAt(const Bone& bone, const BoneTrack& track, size_t frame) {
  Pose pose = bone.rest;
  if (!track.rotations.empty()) pose.R = track.rotations[frame].toRotationMatrix();
  if (!track.translations.empty()) pose.p = track.translations[frame];
  return pose;
}

// Track of the branch in the root's frame.
BoneTrack Below(const Bone& root, const BoneTrack& roots, const Bone& branch,
                const BoneTrack& branches, size_t num_frames) {
  BoneTrack track;
  track.scales = branches.scales;
  for (size_t f = 0; f < num_frames; ++f) {
    const Pose below = PoseAt(root, roots, f).Inverse() * PoseAt(branch, branches, f);
    Eigen::Quaterniond q(below.R);
    if (f > 0 && q.dot(track.rotations.back()) < 0.0) q.coeffs() = -q.coeffs();
    track.rotations.push_back(q.normalized());
    track.translations.push_back(below.p);
  }
  return track;
}

class Branches {
 public:
  Branches(const std::vector<char>& wanted, const Character& character)
      : character_(character), size_(wanted.begin(), wanted.end()) {
    for (size_t b = size_.size(); b-- > 1;) {
      const int parent = character.bones[b].parent;
      if (parent >= 0) size_[static_cast<size_t>(parent)] += size_[b];
    }
  }

  // Children of a bone that are wanted or have wanted bones below them.
  std::vector<int> Of(int above) const {
    std::vector<int> found;
    for (size_t b = 0; b < size_.size(); ++b) {
      if (character_.bones[b].parent == above && size_[b] > 0) found.push_back(static_cast<int>(b));
    }
    return found;
  }

  // Largest branch that moves from place to place and has no scale; -1: none.
  int Root(const std::vector<int>& branches) const {
    int root = -1;
    for (const int b : branches) {
      const auto travels = [b](const Clip& clip) {
        return !clip.tracks[static_cast<size_t>(b)].translations.empty();
      };
      const bool may = IsUnscaled(character_.bones[static_cast<size_t>(b)]) &&
                       std::any_of(character_.clips.begin(), character_.clips.end(), travels);
      if (may && (root < 0 || size_[static_cast<size_t>(b)] > size_[static_cast<size_t>(root)]))
        root = b;
    }
    return root;
  }

 private:
  const Character& character_;
  std::vector<int> size_;  // by bone: number of wanted bones at it and below it
};

void Hang(int branch, int root, Character* character) {
  const auto b = static_cast<size_t>(branch), r = static_cast<size_t>(root);
  Bone& bone = character->bones[b];
  for (Clip& clip : character->clips) {
    clip.tracks[b] = Below(character->bones[r], clip.tracks[r], bone, clip.tracks[b],
                           static_cast<size_t>(clip.num_frames));
  }
  bone.rest = character->bones[r].rest.Inverse() * bone.rest;
  bone.rotation_order.clear();
  bone.parent = root;
}

}  // namespace

std::optional<Character> WithOneRoot(const std::vector<char>& wanted, const Character& character) {
  const Branches branches(wanted, character);
  std::vector<int> found = branches.Of(-1);
  int common = -1;
  while (found.size() == 1 && !wanted[static_cast<size_t>(found[0])]) {
    common = found[0];
    found = branches.Of(common);
  }
  const bool is_bone = common >= 0 && character.bones[static_cast<size_t>(common)].is_joint;
  if (is_bone) return std::nullopt;  // it is the root itself
  const int root = found.size() > 1 ? branches.Root(found) : -1;
  if (root < 0) return std::nullopt;
  Character hung = character;
  const std::string& name = character.bones[static_cast<size_t>(root)].name;
  std::string others;
  for (const int branch : found) {
    if (branch == root) continue;
    others += (others.empty() ? "" : ", ") + character.bones[static_cast<size_t>(branch)].name;
    Hang(branch, root, &hung);
  }
  hung.warnings.push_back(
      {name, "is taken as the root of several; on it hang now, at a fixed distance: " + others});
  // Parents come first: the root takes the place of the first branch.
  std::vector<int> order(character.bones.size());
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin() + found[0], order.begin() + root, order.begin() + root + 1);
  Reorder(order, &hung);
  return hung;
}

}  // namespace hazumi
