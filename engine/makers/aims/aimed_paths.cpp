#include "engine/makers/aims/aimed_paths.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hazumi::makers {

std::vector<AimedHinges> PathsOf(const std::vector<AimGoal>& goals, const DynamicsRegion& region,
                                 const Figure& figure) {
  const std::vector<char> limp = LimpHinges(region, figure);
  std::vector<char> wanted(limp.size(), 0);
  for (const AimGoal& goal : goals) {
    if (goal.has_point()) wanted[static_cast<size_t>(goal.joint.value())] = 1;
    for (const auto& [j, angle] : goal.angles) wanted[static_cast<size_t>(j.value())] = 1;
  }
  std::vector<AimedHinges> paths;
  std::set<JointIndex> taken;
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!wanted[static_cast<size_t>(j)]) continue;
    const int end = figure.joint(JointIndex(j)).subtree_end.value();
    if (std::any_of(wanted.begin() + j + 1, wanted.begin() + end, [](char is) { return is; })) {
      continue;
    }
    AimedHinges hinges;
    size_t outermost = 0;
    for (JointIndex k(j); k.is_valid() && !taken.contains(k); k = figure.joint(k).parent) {
      hinges.path.push_back(k);
      hinges.moves.push_back(limp[static_cast<size_t>(k.value())]);
      if (hinges.moves.back()) outermost = hinges.path.size();
    }
    hinges.path.resize(outermost);
    hinges.moves.resize(outermost);
    std::reverse(hinges.path.begin(), hinges.path.end());
    std::reverse(hinges.moves.begin(), hinges.moves.end());
    taken.insert(hinges.path.begin(), hinges.path.end());
    if (!hinges.path.empty()) paths.push_back(std::move(hinges));
  }
  return paths;
}

std::vector<AimGoal> GoalsOf(const AimedHinges& hinges, const std::vector<AimGoal>& goals) {
  const auto is_in = [&](JointIndex j) {
    return std::find(hinges.path.begin(), hinges.path.end(), j) != hinges.path.end();
  };
  std::vector<AimGoal> own;
  for (AimGoal goal : goals) {
    std::erase_if(goal.angles, [&](const auto& angle) { return !is_in(angle.first); });
    if (goal.has_point() ? is_in(goal.joint) : !goal.angles.empty()) own.push_back(goal);
  }
  return own;
}

}  // namespace hazumi::makers
