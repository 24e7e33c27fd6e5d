#include "engine/exchange/assimp/scene_skeleton.h"

#include <algorithm>
#include <unordered_set>

#include "engine/base/text.h"
#include "engine/base/utf8.h"

namespace hazumi {
namespace {

class Selection {
 public:
  explicit Selection(const SceneTree& tree)
      : tree_(tree), is_bone_(tree.nodes.size(), 0), is_apart_(tree.nodes.size(), 0) {
    FindCarriers();
    FindNeeded();
    if (needed_.empty()) return;
    top_ = Meeting(needed_);
    while (At(top_).is_helper && At(top_).parent >= 0) top_ = At(top_).parent;
    for (int node : needed_)
      for (; node != top_ && node >= 0; node = At(node).parent) Mark(node);
    is_bone_[static_cast<size_t>(top_)] = 1;
  }

  int top() const { return top_; }  // -1: there are no bones
  bool is_bone(int node) const { return is_bone_[static_cast<size_t>(node)] != 0; }
  const std::vector<char>& is_apart() const { return is_apart_; }
  // Whether a weight or a mesh hangs on a node or below it.
  bool carries(int node) const { return carries_[static_cast<size_t>(node)] != 0; }
  bool IsAbove(int node, int other) const {
    for (; other >= 0; other = At(other).parent)
      if (other == node) return true;
    return false;
  }

 private:
  const SceneNode& At(int node) const { return tree_.nodes[static_cast<size_t>(node)]; }
  void Mark(int node) {
    if (!At(node).is_helper) is_bone_[static_cast<size_t>(node)] = 1;
  }

  void FindCarriers() {
    carries_.resize(tree_.nodes.size());
    for (int i = static_cast<int>(tree_.nodes.size()) - 1; i >= 0; --i) {
      if (At(i).is_weighted || At(i).has_rigid_mesh) carries_[static_cast<size_t>(i)] = 1;
      if (carries(i) && At(i).parent >= 0) carries_[static_cast<size_t>(At(i).parent)] = 1;
    }
  }

  template <typename Condition>
  std::vector<int> All(Condition&& condition) const {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(tree_.nodes.size()); ++i)
      if (condition(i)) found.push_back(i);
    return found;
  }

  // The lowest node that is above all.
  int Meeting(const std::vector<int>& nodes) const {
    int a = nodes[0];
    for (int b : nodes)
      while (a != b) (a > b ? a : b) = At(std::max(a, b)).parent;
    return a;
  }

  void FindNeeded() {
    needed_ = All([&](int i) { return At(i).is_weighted; });
    const int skin_top = needed_.empty() ? -1 : Meeting(needed_);
    if (skin_top > 0) FindApart(skin_top);
    // What moves the skin as a whole is a part of its first bone's motion.
    const std::vector<int> movers = All([&](int i) {
      return At(i).is_animated && carries(i) && (skin_top < 0 || !IsAbove(i, skin_top)) &&
             !is_apart_[static_cast<size_t>(i)];
    });
    needed_.insert(needed_.end(), movers.begin(), movers.end());
    if (needed_.empty()) needed_ = All([&](int i) { return At(i).is_animated; });
  }

  // The scene's own child that a node hangs on, or is.
  int BranchOf(int node) const {
    while (At(node).parent > 0) node = At(node).parent;
    return node;
  }

  // What carries a mesh and moves on another branch than the skin.
  void FindApart(int skin_top) {
    const int branch = BranchOf(skin_top);
    if (At(0).is_animated || At(0).is_weighted) return;
    for (int i = 1; i < static_cast<int>(tree_.nodes.size()); ++i) {
      const bool moves = At(i).is_animated && carries(i) && BranchOf(i) != branch;
      const bool hangs = At(i).parent > 0 && is_apart_[static_cast<size_t>(At(i).parent)] != 0;
      if (moves || hangs) is_apart_[static_cast<size_t>(i)] = 1;
    }
  }

  const SceneTree& tree_;
  std::vector<char> is_bone_, is_apart_, carries_;
  std::vector<int> needed_;
  int top_ = -1;
};

class Builder {
 public:
  Builder(const SceneTree& tree, const Selection& selection, std::vector<Warning>* warnings)
      : tree_(tree), selection_(selection), warnings_(warnings) {}

  SceneSkeleton Build() {
    skeleton_.bone_of_node.assign(tree_.nodes.size(), -1);
    skeleton_.is_apart = selection_.is_apart();
    for (int i = selection_.top(); i < static_cast<int>(tree_.nodes.size()); ++i)
      if (selection_.is_bone(i)) Add(i);
    FindEnds();
    WarnOfRest();
    WarnOfOmissions();
    return std::move(skeleton_);
  }

 private:
  const SceneNode& At(int node) const { return tree_.nodes[static_cast<size_t>(node)]; }

  std::vector<int> ChainOf(int node) const {
    std::vector<int> chain = {node};
    for (int i = At(node).parent; i >= 0 && skeleton_.bone_of_node[static_cast<size_t>(i)] < 0;
         i = At(i).parent)
      chain.insert(chain.begin(), i);
    return chain;
  }

  std::string UniqueName(const aiString& written) {
    const std::string wanted = ValidUtf8(written.length ? written.C_Str() : "bone");
    std::string name = wanted;
    for (int i = 1; !names_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    if (name != wanted)
      warnings_->push_back({"bone " + wanted, "another bone has this name; renamed to " + name});
    return name;
  }

  void Add(int node) {
    Bone bone;
    const std::vector<int> chain = ChainOf(node);
    const int above = At(chain[0]).parent;
    bone.parent = above < 0 ? -1 : skeleton_.bone_of_node[static_cast<size_t>(above)];
    bone.name = UniqueName(At(node).node->mName);
    Eigen::Matrix4d rest = Eigen::Matrix4d::Identity();
    for (const int i : chain) rest = rest * At(i).local;
    const MatrixParts parts = Decompose(rest);
    bone.rest = parts.X;
    bone.rest_scale = parts.scale;
    const bool moves_all =
        node == selection_.top() &&
        std::any_of(chain.begin(), chain.end(), [&](int i) { return At(i).is_animated; });
    bone.is_joint = At(node).is_weighted || At(node).is_animated || moves_all;
    if (parts.is_sheared) sheared_.push_back(bone.name);
    if (parts.scale != Vec3::Ones()) scaled_.push_back(bone.name);
    skeleton_.bone_of_node[static_cast<size_t>(node)] = static_cast<int>(skeleton_.bones.size());
    skeleton_.size = std::max(skeleton_.size * (skeleton_.bones.empty() ? 0.0 : 1.0),
                              At(node).world.topRightCorner<3, 1>().norm());
    skeleton_.bones.push_back(std::move(bone));
    skeleton_.chains.push_back(chain);
  }

  // A node that hangs below a last bone and carries nothing says where the bone ends.
  void FindEnds() {
    std::vector<char> has_child(skeleton_.bones.size(), 0);
    for (const Bone& bone : skeleton_.bones)
      if (bone.parent >= 0) has_child[static_cast<size_t>(bone.parent)] = 1;
    for (int i = 0; i < static_cast<int>(tree_.nodes.size()); ++i) {
      const int b =
          At(i).parent < 0 ? -1 : skeleton_.bone_of_node[static_cast<size_t>(At(i).parent)];
      if (b < 0 || has_child[static_cast<size_t>(b)] || selection_.carries(i)) continue;
      Bone& bone = skeleton_.bones[static_cast<size_t>(b)];
      const Vec3 end = At(i).local.topRightCorner<3, 1>();
      if (!bone.end_site && end.norm() > 1e-6 * skeleton_.size) bone.end_site = end;
    }
  }

  static std::string Listed(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < names.size() && i < 6; ++i) text += (i ? ", " : "") + names[i];
    return names.size() > 6 ? text + " and " + std::to_string(names.size() - 6) + " more" : text;
  }

  void WarnOfRest() {
    if (!scaled_.empty()) warnings_->push_back({"bones", "scaled at rest: " + Listed(scaled_)});
    if (!sheared_.empty()) {
      warnings_->push_back({"bones",
                            "sheared at rest, which bones cannot be; the nearest "
                            "rotations were taken: " +
                                Listed(sheared_)});
    }
  }

  void WarnOfOmissions() {
    std::vector<std::string> left, apart;
    for (int i = 0; i < static_cast<int>(tree_.nodes.size()); ++i) {
      if (!At(i).is_animated || selection_.is_bone(i)) continue;
      const std::string name = ValidUtf8(At(i).node->mName.C_Str());
      if (skeleton_.is_apart[static_cast<size_t>(i)]) {
        apart.push_back(name);
      } else if (!selection_.IsAbove(i, selection_.top())) {
        left.push_back(name);
      }
    }
    if (!apart.empty()) {
      warnings_->push_back(
          {"nodes", "left out, because they move apart from the skeleton: " + Listed(apart)});
    }
    if (!left.empty()) {
      warnings_->push_back(
          {"bones", "left out, because they carry no mesh (controls, ends): " + Listed(left)});
    }
  }

  const SceneTree& tree_;
  const Selection& selection_;
  std::vector<Warning>* warnings_;
  SceneSkeleton skeleton_;
  std::unordered_set<std::string> names_;
  std::vector<std::string> scaled_, sheared_;
};

}  // namespace

int SceneSkeleton::Carrier(const SceneTree& tree, int node) const {
  for (; node >= 0; node = tree.nodes[static_cast<size_t>(node)].parent) {
    if (bone_of_node[static_cast<size_t>(node)] >= 0)
      return bone_of_node[static_cast<size_t>(node)];
  }
  return 0;
}

const Eigen::Matrix4d& SceneSkeleton::World(const SceneTree& tree, int bone) const {
  return tree.nodes[static_cast<size_t>(chains[static_cast<size_t>(bone)].back())].world;
}

Result<SceneSkeleton> FindSkeleton(const SceneTree& tree, const std::string& file,
                                   std::vector<Warning>* warnings) {
  const Selection selection(tree);
  if (selection.top() < 0) {
    return Error{ErrorCode::kSemantics, file, "",
                 "has neither a skin nor an animation, so that there is nothing to move; export "
                 "the character with its armature"};
  }
  return Builder(tree, selection, warnings).Build();
}

}  // namespace hazumi
