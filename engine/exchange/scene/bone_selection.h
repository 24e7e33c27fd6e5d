#pragma once

#include <string>
#include <vector>

#include "engine/exchange/scene/scene_tree.h"

namespace hazumi {

// Which nodes of a scene are bones, those of one character. With a skin: those that carry weights,
// animated ones that carry meshes, what lies between. Without one the skeleton is the branch of the
// scene that is animated and branches, not what moves beside it (a camera, its target, a cube); in
// it the animated nodes that carry meshes or, if few of them do, all nodes, also those that keep
// still, but for the last of a chain whose name says that it is an end. In a scene without meshes
// in which nothing moves, all nodes count as animated: it is a skeleton at rest.
class BoneSelection {
 public:
  BoneSelection(const SceneTree& tree, const std::string& wanted);

  int top() const { return top_; }  // the lowest node above all bones, itself one; -1: none
  bool is_bone(int node) const { return is_bone_[static_cast<size_t>(node)] != 0; }
  // A bone for its own sake, not only because it lies between others.
  bool is_needed(int node) const { return is_needed_[static_cast<size_t>(node)] != 0; }
  // Characters, by the name of the node that each of them hangs on, and the one that is taken.
  // Empty unless there are several: branches of one node, which nothing moves and nothing weighs,
  // each of them with weights on several nodes, and no mesh on two of them. The one that moves
  // most, or has most bones, is taken.
  const std::vector<std::string>& characters() const { return characters_; }
  size_t taken() const { return taken_; }
  bool is_wanted() const { return is_wanted_; }
  // By node: beside the skeleton, or on what is.
  const std::vector<char>& is_apart() const { return is_apart_; }
  // Whether a weight or a mesh hangs on a node or below it.
  bool carries(int node) const { return carries_[static_cast<size_t>(node)] != 0; }
  bool IsAbove(int node, int other) const {
    return node <= other && other < end_[static_cast<size_t>(node)];
  }

 private:
  struct Branch {
    int node = 0;
    int num_bones = 0;  // that move or have children
    bool branches = false;
  };

  int size() const { return tree_.size(); }
  bool Moves(int node) const {
    return (tree_[node].is_animated || is_at_rest_) && !tree_.node(node).is_view;
  }
  bool IsEnd(int node) const;
  bool HasChild(int node) const { return num_children_[static_cast<size_t>(node)] > 0; }
  template <typename Condition>
  std::vector<int> All(Condition&& condition) const {
    std::vector<int> found;
    for (int i = 0; i < size(); ++i)
      if (condition(i)) found.push_back(i);
    return found;
  }

  bool IsSkeletonAtRest() const;
  void Count();
  int Meeting(const std::vector<int>& nodes) const;
  void TakeOneCharacter(const std::string& wanted);
  void AddCharacter(const std::string& name);
  bool HasMeshAcross(int group) const;
  void FindSkinned();
  void FindBeside(int skin_top);
  void FindBare();
  int SkeletonBelow(int group);
  bool IsGroup(int node) const;
  std::vector<Branch> BranchesOf(int group) const;
  Branch BranchAt(int node) const;
  static int Greatest(const std::vector<Branch>& branches);
  void SetApart(int node);
  void SetApartBut(int child, int group);
  void Mark();

  const SceneTree& tree_;
  std::vector<char> is_bone_, is_needed_, is_apart_, carries_;
  std::vector<int> num_children_;
  std::vector<int> end_;  // by node: the first one after all that hang below it
  std::vector<int> needed_;
  std::vector<std::string> characters_;
  size_t taken_ = 0;
  bool is_wanted_ = false;
  bool is_at_rest_ = false;
  int top_ = -1;
};

}  // namespace hazumi
