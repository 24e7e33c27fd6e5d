#include "engine/exchange/scene/bone_selection.h"

#include <algorithm>
#include <string_view>

#include "engine/base/text.h"
#include "engine/base/utf8.h"

namespace hazumi {

namespace {

constexpr int kFewBones = 3;      // of a skeleton that does not branch
constexpr double kOrigin = 1e-9;  // of a group's place
constexpr std::string_view kEnds[] = {"end", "nub", "tip", "top", "site", "effector"};

}  // namespace

BoneSelection::BoneSelection(const SceneTree& tree, const std::string& wanted)
    : tree_(tree),
      is_bone_(tree.nodes.size(), 0),
      is_needed_(tree.nodes.size(), 0),
      is_apart_(tree.nodes.size(), 0),
      carries_(tree.nodes.size(), 0),
      num_children_(tree.nodes.size(), 0),
      end_(tree.nodes.size(), 0) {
  Count();
  is_at_rest_ = IsSkeletonAtRest();
  needed_ = All([&](int i) { return tree_[i].is_weighted; });
  if (!needed_.empty()) TakeOneCharacter(wanted);
  needed_.empty() ? FindBare() : FindSkinned();
  if (!needed_.empty()) Mark();
}

// Nothing moves, there is no mesh, and some nodes lie apart from those that they hang on.
bool BoneSelection::IsSkeletonAtRest() const {
  const bool is_used =
      std::any_of(tree_.nodes.begin(), tree_.nodes.end(), [](const TreeNode& node) {
        return node.is_animated || node.is_weighted || node.has_rigid_mesh;
      });
  const auto is_apart = [](const SceneNode& node) {
    return node.parent >= 0 && node.local.topRightCorner<3, 1>().norm() > kOrigin;
  };
  const auto& nodes = tree_.scene.nodes;
  return !is_used && std::count_if(nodes.begin(), nodes.end(), is_apart) >= kFewBones;
}

void BoneSelection::Count() {
  for (int i = size() - 1; i >= 0; --i) {
    const int parent = tree_.node(i).parent;
    int& end = end_[static_cast<size_t>(i)];
    end = std::max(end, i + 1);
    if (tree_[i].is_weighted || tree_[i].has_rigid_mesh) carries_[static_cast<size_t>(i)] = 1;
    if (parent < 0) continue;
    if (carries(i)) carries_[static_cast<size_t>(parent)] = 1;
    ++num_children_[static_cast<size_t>(parent)];
    end_[static_cast<size_t>(parent)] = std::max(end_[static_cast<size_t>(parent)], end);
  }
}

// The lowest node that is above all.
int BoneSelection::Meeting(const std::vector<int>& nodes) const {
  int a = nodes[0];
  for (int b : nodes)
    while (a != b) (a > b ? a : b) = tree_.node(std::max(a, b)).parent;
  return a;
}

// Whether a mesh has weights on several branches of a group.
bool BoneSelection::HasMeshAcross(int group) const {
  const auto branch_of = [&](int node) {
    while (node != group && tree_.node(node).parent != group) node = tree_.node(node).parent;
    return node;
  };
  for (const SceneMesh& mesh : tree_.scene.meshes) {
    int branch = -1;
    for (const SceneMesh::Bind& bind : mesh.binds) {
      if (bind.weights.empty()) continue;
      const int own = branch_of(bind.node);
      if (branch >= 0 && own != branch) return true;
      branch = own;
    }
  }
  return false;
}

// By a name that no other has.
void BoneSelection::AddCharacter(const std::string& name) {
  const auto is_known =
      std::find(characters_.begin(), characters_.end(), name) != characters_.end();
  characters_.push_back(is_known ? name + " (" + std::to_string(characters_.size() + 1) + ")"
                                 : name);
}

// Leaves the weights of one character in `needed_`.
void BoneSelection::TakeOneCharacter(const std::string& wanted) {
  const int group = Meeting(needed_);
  if (tree_[group].is_weighted || tree_[group].is_animated || !IsGroup(group)) return;
  struct Found {
    int node = 0, num_weighted = 0, num_moved = 0;
  };
  std::vector<Found> found;
  for (int i = group + 1; i < end_[static_cast<size_t>(group)]; ++i) {
    if (tree_.node(i).parent == group) found.push_back({i});
    if (!tree_[i].is_weighted) continue;
    ++found.back().num_weighted;
    found.back().num_moved += Moves(i);
  }
  std::erase_if(found, [](const Found& one) { return one.num_weighted < kFewBones; });
  if (found.size() < 2 || HasMeshAcross(group)) return;
  for (const Found& one : found) {
    AddCharacter(ValidUtf8(tree_.node(one.node).name));
    const Found& best = found[taken_];
    const bool is_better = one.num_moved != best.num_moved ? one.num_moved > best.num_moved
                                                           : one.num_weighted > best.num_weighted;
    if (is_better) taken_ = characters_.size() - 1;
  }
  const auto named = std::find(characters_.begin(), characters_.end(), wanted);
  is_wanted_ = named != characters_.end();
  if (is_wanted_) taken_ = static_cast<size_t>(named - characters_.begin());
  for (size_t k = 0; k < found.size(); ++k)
    if (k != taken_) SetApart(found[k].node);
  std::erase_if(needed_, [&](int i) { return is_apart_[static_cast<size_t>(i)] != 0; });
}

// What moves the skin as a whole is a part of its first bone's motion.
void BoneSelection::FindSkinned() {
  const int skin_top = Meeting(needed_);
  if (skin_top > 0) FindBeside(skin_top);
  const std::vector<int> movers = All([&](int i) {
    return Moves(i) && carries(i) && !IsAbove(i, skin_top) && !is_apart_[static_cast<size_t>(i)];
  });
  needed_.insert(needed_.end(), movers.begin(), movers.end());
}

// What carries a mesh and moves on another branch of the scene than the skin.
void BoneSelection::FindBeside(int skin_top) {
  const auto branch_of = [&](int node) {
    while (tree_.node(node).parent > 0) node = tree_.node(node).parent;
    return node;
  };
  for (int i = 1; i < size(); ++i) {
    if (Moves(i) && carries(i) && branch_of(i) != branch_of(skin_top)) SetApart(i);
  }
}

void BoneSelection::SetApart(int node) {
  std::fill(is_apart_.begin() + node, is_apart_.begin() + end_[static_cast<size_t>(node)], 1);
}

void BoneSelection::SetApartBut(int child, int group) {
  for (int i = group + 1; i < end_[static_cast<size_t>(group)]; ++i)
    if (tree_.node(i).parent == group && i != child) SetApart(i);
}

void BoneSelection::FindBare() {
  const int skeleton = SkeletonBelow(0);
  const auto is_in = [&](int i) { return IsAbove(skeleton, i); };
  const std::vector<int> moved = All([&](int i) { return is_in(i) && Moves(i); });
  needed_ = moved;
  std::erase_if(needed_, [&](int i) { return !carries(i); });
  if (2 * needed_.size() >= moved.size() && !moved.empty()) return;
  if (moved.empty()) return;
  needed_ = All([&](int i) {
    return is_in(i) && !tree_.node(i).is_helper && !tree_.node(i).is_view && !IsEnd(i);
  });
}

// A last node that keeps still and is called an end says where a bone ends.
bool BoneSelection::IsEnd(int node) const {
  if (HasChild(node) || tree_[node].is_animated) return false;
  const std::string name = LowerCase(tree_.node(node).name);
  return std::any_of(std::begin(kEnds), std::end(kEnds),
                     [&](std::string_view end) { return name.ends_with(end); });
}

// From a group down to the node that holds the skeleton and nothing beside it. What is beside it on
// the way is set apart, if it can be told from it.
int BoneSelection::SkeletonBelow(int group) {
  while (IsGroup(group)) {
    const std::vector<Branch> branches = BranchesOf(group);
    const bool is_alone = branches.size() == 1;
    const int best = is_alone ? (tree_[group].is_animated ? -1 : 0) : Greatest(branches);
    if (best < 0) break;
    const int chosen = branches[static_cast<size_t>(best)].node;
    if (!is_alone) SetApartBut(chosen, group);
    group = chosen;
  }
  return group;
}

// Whether a node may only hold others together: it is at the origin.
bool BoneSelection::IsGroup(int node) const {
  return tree_[node].world.topRightCorner<3, 1>().norm() < kOrigin;
}

// The children of a node on or below which something moves.
std::vector<BoneSelection::Branch> BoneSelection::BranchesOf(int group) const {
  std::vector<char> moves(tree_.nodes.size(), 0);
  for (int i = size() - 1; i > group; --i) {
    if (Moves(i)) moves[static_cast<size_t>(i)] = 1;
    if (moves[static_cast<size_t>(i)]) moves[static_cast<size_t>(tree_.node(i).parent)] = 1;
  }
  std::vector<Branch> branches;
  for (int i = group + 1; i < size(); ++i) {
    if (tree_.node(i).parent == group && moves[static_cast<size_t>(i)])
      branches.push_back(BranchAt(i));
  }
  return branches;
}

BoneSelection::Branch BoneSelection::BranchAt(int node) const {
  Branch branch{node, 0, false};
  const int end = end_[static_cast<size_t>(node)];
  std::vector<int> num(static_cast<size_t>(end - node), 0);  // children that are bones, by node
  for (int i = end - 1; i >= node; --i) {
    const bool is_bone = Moves(i) || (HasChild(i) && !tree_.node(i).is_helper);
    branch.num_bones += is_bone ? 1 : 0;
    branch.branches = branch.branches || num[static_cast<size_t>(i - node)] > 1;
    if ((is_bone || HasChild(i)) && i > node)
      ++num[static_cast<size_t>(tree_.node(i).parent - node)];
  }
  return branch;
}

// The skeleton among single nodes, such as cameras and their targets: it branches, or has several
// bones. -1: there are others like it, as the legs beside a spine.
int BoneSelection::Greatest(const std::vector<Branch>& branches) {
  int best = -1;
  for (size_t i = 0; i < branches.size(); ++i) {
    if (branches[i].num_bones <= 1) continue;
    if (best >= 0) return -1;
    best = static_cast<int>(i);
  }
  if (best < 0) return -1;
  const Branch& found = branches[static_cast<size_t>(best)];
  return found.branches || found.num_bones >= kFewBones ? best : -1;
}

void BoneSelection::Mark() {
  for (const int node : needed_) is_needed_[static_cast<size_t>(node)] = 1;
  top_ = Meeting(needed_);
  while (tree_.node(top_).is_helper && tree_.node(top_).parent >= 0) top_ = tree_.node(top_).parent;
  for (int node : needed_) {
    for (; node != top_ && node >= 0; node = tree_.node(node).parent)
      if (!tree_.node(node).is_helper) is_bone_[static_cast<size_t>(node)] = 1;
  }
  is_bone_[static_cast<size_t>(top_)] = 1;
}

}  // namespace hazumi
