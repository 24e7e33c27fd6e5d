#include "ui/edit/operator.h"

#include <algorithm>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// Each gives the operators of one file.
std::vector<Operator> ConstraintOperators();
std::vector<Operator> DriveOperators();
std::vector<Operator> ExportOperators();
std::vector<Operator> FieldOperators();
std::vector<Operator> FigureOperators();
std::vector<Operator> FlightOperators();
std::vector<Operator> FillOperators();
std::vector<Operator> ForceOperators();
std::vector<Operator> GoalOperators();
std::vector<Operator> HeldObjectOperators();
std::vector<Operator> HolderOperators();
std::vector<Operator> ImportOperators();
std::vector<Operator> JointStateOperators();
std::vector<Operator> JumpOperators();
std::vector<Operator> KeyOperators();
std::vector<Operator> KeySelectionOperators();
std::vector<Operator> MediaOperators();
std::vector<Operator> ObjectOperators();
std::vector<Operator> PlacementOperators();
std::vector<Operator> PoseOperators();
std::vector<Operator> PoseBlendOperators();
std::vector<Operator> ReachOperators();
std::vector<Operator> RegionOperators();
std::vector<Operator> RegionJointOperators();
std::vector<Operator> RootOperators();
std::vector<Operator> SceneOperators();
std::vector<Operator> SelectedKeyOperators();
std::vector<Operator> SelectionSetOperators();
std::vector<Operator> SessionOperators();
std::vector<Operator> StartRateOperators();
std::vector<Operator> SwivelOperators();
std::vector<Operator> ThrowOperators();
std::vector<Operator> TimeOperators();

namespace {

std::vector<Operator> Collect() {
  std::vector<Operator> all;
  for (const auto& operators :
       {&ConstraintOperators, &DriveOperators,      &ExportOperators,      &FieldOperators,
        &FigureOperators,     &FlightOperators,     &FillOperators,        &ForceOperators,
        &GoalOperators,       &HeldObjectOperators, &HolderOperators,      &ImportOperators,
        &JointStateOperators, &JumpOperators,       &KeyOperators,         &KeySelectionOperators,
        &MediaOperators,      &ObjectOperators,     &PlacementOperators,   &PoseOperators,
        &PoseBlendOperators,  &ReachOperators,      &RegionOperators,      &RegionJointOperators,
        &RootOperators,       &SceneOperators,      &SelectedKeyOperators, &SelectionSetOperators,
        &SessionOperators,    &StartRateOperators,  &SwivelOperators,      &ThrowOperators,
        &TimeOperators}) {
    const std::vector<Operator> of_file = operators();
    all.insert(all.end(), of_file.begin(), of_file.end());
  }
  std::sort(all.begin(), all.end(), [](const Operator& a, const Operator& b) {
    return std::string_view(a.id) < std::string_view(b.id);
  });
  return all;
}

}  // namespace

const std::vector<Operator>& AllOperators() {
  static const std::vector<Operator> all = Collect();
  return all;
}

const Operator* FindOperator(const std::string& id) {
  for (const Operator& op : AllOperators()) {
    if (op.id == id) return &op;
  }
  return nullptr;
}

Result<Done> Put(Session* session, const std::string& label, Project project,
                 const std::string& drag) {
  return session->Edit(
      label,
      [&](Project* changed) -> Result<Done> {
        *changed = std::move(project);
        return Done();
      },
      drag);
}

}  // namespace hazumi::edit
