#include "engine/exchange/scene/scene_skeleton.h"

#include <algorithm>
#include <unordered_set>

#include "engine/base/text.h"
#include "engine/base/utf8.h"
#include "engine/exchange/scene/bone_selection.h"

namespace hazumi {
namespace {

class Builder {
 public:
  Builder(const SceneTree& tree, const BoneSelection& selection, std::vector<Warning>* warnings)
      : tree_(tree), selection_(selection), warnings_(warnings) {}

  SceneSkeleton Build() {
    skeleton_.bone_of_node.assign(tree_.nodes.size(), -1);
    skeleton_.is_apart = selection_.is_apart();
    for (int i = selection_.top(); i < tree_.size(); ++i)
      if (selection_.is_bone(i)) Add(i);
    FindEnds();
    WarnOfRest();
    WarnOfOthers();
    WarnOfOmissions();
    return std::move(skeleton_);
  }

 private:
  std::vector<int> ChainOf(int node) const {
    std::vector<int> chain = {node};
    for (int i = tree_.node(node).parent;
         i >= 0 && skeleton_.bone_of_node[static_cast<size_t>(i)] < 0; i = tree_.node(i).parent)
      chain.insert(chain.begin(), i);
    return chain;
  }

  std::string UniqueName(const std::string& written) {
    const std::string wanted = ValidUtf8(written.empty() ? "bone" : written);
    std::string name = wanted;
    for (int i = 1; !names_.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
    if (name != wanted)
      warnings_->push_back({"bone " + wanted, "another bone has this name; renamed to " + name});
    return name;
  }

  void Add(int node) {
    Bone bone;
    const std::vector<int> chain = ChainOf(node);
    const int above = tree_.node(chain[0]).parent;
    bone.parent = above < 0 ? -1 : skeleton_.bone_of_node[static_cast<size_t>(above)];
    bone.name = UniqueName(tree_.node(node).name);
    bone.body = tree_.node(node).body;
    bone.place = tree_.node(node).place;
    bone.source.node = tree_.node(node).number;
    for (const int i : chain) {
      if (i != node) bone.source.above = bone.source.above * tree_.node(i).local;
    }
    const Eigen::Matrix4d rest = bone.source.above * tree_.node(node).local;
    const MatrixParts parts = Decompose(rest);
    bone.rest = parts.X;
    bone.rest_scale = parts.scale;
    const bool moves_all =
        node == selection_.top() &&
        std::any_of(chain.begin(), chain.end(), [&](int i) { return tree_[i].is_animated; });
    bone.is_joint = selection_.is_needed(node) || tree_[node].is_animated || moves_all;
    if (parts.is_sheared) sheared_.push_back(bone.name);
    if (parts.scale != Vec3::Ones()) scaled_.push_back(bone.name);
    skeleton_.bone_of_node[static_cast<size_t>(node)] = static_cast<int>(skeleton_.bones.size());
    skeleton_.size = std::max(skeleton_.size * (skeleton_.bones.empty() ? 0.0 : 1.0),
                              tree_[node].world.topRightCorner<3, 1>().norm());
    skeleton_.bones.push_back(std::move(bone));
    skeleton_.chains.push_back(chain);
  }

  // A node that hangs below a last bone and carries nothing says where the bone ends.
  void FindEnds() {
    std::vector<char> has_child(skeleton_.bones.size(), 0);
    for (const Bone& bone : skeleton_.bones)
      if (bone.parent >= 0) has_child[static_cast<size_t>(bone.parent)] = 1;
    for (int i = 0; i < tree_.size(); ++i) {
      const int b = tree_.node(i).parent < 0
                        ? -1
                        : skeleton_.bone_of_node[static_cast<size_t>(tree_.node(i).parent)];
      if (b < 0 || has_child[static_cast<size_t>(b)] || selection_.carries(i)) continue;
      Bone& bone = skeleton_.bones[static_cast<size_t>(b)];
      const Vec3 end = tree_.node(i).local.topRightCorner<3, 1>();
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

  void WarnOfOthers() {
    const std::vector<std::string>& all = selection_.characters();
    for (size_t k = 0; k < all.size(); ++k) {
      if (k == selection_.taken()) {
        skeleton_.chosen = all[k];
      } else {
        skeleton_.others.push_back(all[k]);
      }
    }
    if (all.empty() || selection_.is_wanted()) return;
    warnings_->push_back({"character", "\"" + skeleton_.chosen + "\" is taken, one of " +
                                           std::to_string(all.size()) +
                                           "; left out: " + Listed(skeleton_.others) +
                                           "; to take another, give its name"});
  }

  void WarnOfOmissions() {
    std::vector<std::string> left, apart;
    for (int i = 0; i < tree_.size(); ++i) {
      if (selection_.is_bone(i)) continue;
      const std::string name = ValidUtf8(tree_.node(i).name);
      const bool is_apart = skeleton_.is_apart[static_cast<size_t>(i)] != 0;
      if (is_apart && tree_[i].is_weighted) continue;  // another character
      if (is_apart && (tree_[i].is_animated || tree_[i].has_rigid_mesh)) {
        apart.push_back(name);
      } else if (!tree_[i].is_animated) {
        continue;
      } else if (!selection_.IsAbove(i, selection_.top())) {
        left.push_back(name);
      }
    }
    if (!apart.empty()) {
      warnings_->push_back(
          {"nodes", "left out, because they are no part of the skeleton: " + Listed(apart)});
    }
    if (!left.empty()) {
      warnings_->push_back(
          {"bones", "left out, because they carry no mesh (controls, ends): " + Listed(left)});
    }
  }

  const SceneTree& tree_;
  const BoneSelection& selection_;
  std::vector<Warning>* warnings_;
  SceneSkeleton skeleton_;
  std::unordered_set<std::string> names_;
  std::vector<std::string> scaled_, sheared_;
};

}  // namespace

int SceneSkeleton::Carrier(const SceneTree& tree, int node) const {
  for (; node >= 0; node = tree.node(node).parent) {
    if (bone_of_node[static_cast<size_t>(node)] >= 0)
      return bone_of_node[static_cast<size_t>(node)];
  }
  return 0;
}

const Eigen::Matrix4d& SceneSkeleton::World(const SceneTree& tree, int bone) const {
  return tree[chains[static_cast<size_t>(bone)].back()].world;
}

Result<SceneSkeleton> FindSkeleton(const SceneTree& tree, const std::string& wanted,
                                   const std::string& file, std::vector<Warning>* warnings) {
  const BoneSelection selection(tree, wanted);
  if (selection.top() < 0) {
    return Error{ErrorCode::kSemantics, file, "",
                 "has neither a skin nor an animation, so that there is nothing to move; export "
                 "the character with its armature"};
  }
  if (!wanted.empty() && !selection.is_wanted()) {
    std::string names;
    for (const std::string& name : selection.characters()) names += " \"" + name + "\"";
    return Error{
        ErrorCode::kSemantics, file, "character",
        "there is none called \"" + ValidUtf8(wanted) + "\"; " +
            (names.empty() ? "there is one alone: do not name any" : "name one of these:" + names)};
  }
  return Builder(tree, selection, warnings).Build();
}

}  // namespace hazumi
