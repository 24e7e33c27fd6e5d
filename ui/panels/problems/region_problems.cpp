#include "ui/panels/problems/region_problems.h"

#include <algorithm>

#include "engine/project/checks/constraint_checks.h"
#include "engine/project/checks/joint_names.h"
#include "ui/panels/text/filled.h"

namespace hazumi::ui {

namespace {

Problem ProblemOf(const HeldTurn& turn, const ProjectRegion& region, const Figure& figure) {
  Problem problem;
  problem.text =
      Filled(Tr("%s: gravity and contacts move the body, but keys hold its turn: nothing supplies "
                "the %.0f N m that this takes in frame %d."),
             region.name.c_str(), turn.moment, turn.frame);
  problem.region = region.identity.id;
  problem.frame = turn.frame;
  problem.cures.push_back({"region.add_joints",
                           {{"region", region.name}, {"joints", {NameOfRoot(figure)}}},
                           problem.frame,
                           Tr("Let the whole body turn freely")});
  return problem;
}

Problem ProblemOf(const Constraint& constraint, int from) {
  Problem problem;
  problem.text = Filled(
      Tr("%s: from frame %d on no region moves its ends, so that it has no effect up to its last "
         "frame %d."),
      constraint.name.c_str(), from, constraint.last_frame);
  problem.frame = from;
  problem.cures.push_back({"constraint.set",
                           {{"constraint", constraint.name}, {"last", from}},
                           problem.frame,
                           Tr("End it there")});
  return problem;
}

}  // namespace

void AddRegionProblems(const std::vector<HeldTurn>& turns, edit::Session* session,
                       std::vector<Problem>* problems) {
  const std::vector<ProjectRegion>& regions = session->project().regions;
  for (const HeldTurn& turn : turns) {
    if (turn.region >= regions.size()) continue;  // region removed by the current edit
    problems->push_back(ProblemOf(turn, regions[turn.region], session->figure()));
  }
  for (const Constraint& constraint : session->animation()->constraints) {
    const std::optional<int> from = OutlastsFrom(constraint, *session->animation());
    if (from) problems->push_back(ProblemOf(constraint, *from));
  }
}

bool AnyOutlasts(const Animation& animation) {
  return std::any_of(animation.constraints.begin(), animation.constraints.end(),
                     [&](const Constraint& constraint) {
                       return OutlastsFrom(constraint, animation).has_value();
                     });
}

}  // namespace hazumi::ui
