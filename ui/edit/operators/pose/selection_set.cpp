// Joints that are selected together, by a name.

#include "engine/project/checks/joint_names.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

std::vector<JointRef> SelectedRefs(const Session& session) {
  std::vector<JointRef> refs;
  for (const std::string& name : SelectedNames(session)) refs.push_back({name, false, {}});
  return refs;
}

std::set<std::string> HingesOf(const std::vector<JointRef>& refs, const Figure& figure) {
  std::set<std::string> hinges;
  const std::vector<bool> is_meant = JointsOf(refs, figure);
  for (size_t j = 0; j < is_meant.size(); ++j) {
    if (is_meant[j]) hinges.insert(figure.joints()[j].name);
  }
  if (NameRoot(refs, figure)) hinges.insert(figure.root_name());
  return hinges;
}

Result<Done> SaveSet(Session* session, const Parameters& p) {
  const std::string name = p.text("name");
  if (name.empty()) return Refusal("name", "must not be empty");
  std::vector<JointRef> joints = SelectedRefs(*session);
  if (joints.empty()) return Refusal("", "nothing is selected; click on a joint");
  return session->Edit("Save selection set", [&](Project* project) -> Result<Done> {
    std::vector<ProjectSelectionSet>& sets = project->selection_sets;
    auto set =
        std::find_if(sets.begin(), sets.end(), [&](const auto& s) { return s.name == name; });
    if (set == sets.end()) set = sets.insert(set, {name, {}, {}});
    set->joints = std::move(joints);
    return Done();
  });
}

Result<Done> SelectSet(Session* session, const Parameters& p) {
  std::vector<ProjectSelectionSet> sets = session->project().selection_sets;
  const Result<ProjectSelectionSet*> set = EntryNamed(p.text("name"), "name", &sets);
  if (!set.ok()) return set.error();
  std::set<std::string> selected = HingesOf(set.value()->joints, session->figure());
  if (p.yes("add")) selected.merge(std::set<std::string>(session->selected_joints()));
  session->set_selected_joints(std::move(selected));
  return Done();
}

Result<Done> RemoveSet(Session* session, const Parameters& p) {
  return session->Edit("Remove selection set", [&](Project* project) -> Result<Done> {
    std::vector<ProjectSelectionSet>& sets = project->selection_sets;
    const Result<ProjectSelectionSet*> set = EntryNamed(p.text("name"), "name", &sets);
    if (!set.ok()) return set.error();
    sets.erase(sets.begin() + (set.value() - sets.data()));
    return Done();
  });
}

}  // namespace

std::vector<Operator> SelectionSetOperators() {
  return {{"select.save_set",
           "Save selection set",
           "Keeps in the project what is selected, by a name; a set of that name is replaced.",
           {{"name", kText, true, "its name"}},
           SaveSet},
          {"select.set",
           "Select set",
           "Selects the joints of a set.",
           {{"name", kText, true, "of a set", Thing::kSelectionSet},
            {"add", kYesNo, false, "true: what was selected stays so"}},
           SelectSet},
          {"select.remove_set",
           "Remove selection set",
           "Forgets a set; nothing else changes.",
           {{"name", kText, true, "of a set", Thing::kSelectionSet}},
           RemoveSet}};
}

}  // namespace hazumi::edit
