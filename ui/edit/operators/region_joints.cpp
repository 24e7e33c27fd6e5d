// Operators that add joints to a region or remove them. The root counts as a joint.

#include <algorithm>

#include "engine/body/figure_body.h"
#include "engine/project/checks/joint_names.h"
#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/regions.h"

namespace hazumi::edit {

namespace {

using enum ParameterKind;

const ParameterInfo kTheJoints = {"joints", kNames, false,
                                  "joints, with + behind the name all beyond too, or the root; "
                                  "default: the selected ones",
                                  Thing::kJointOrRoot};

// Hinges by index, and whether the root is included.
struct Moved {
  std::vector<bool> hinges;
  bool root = false;

  bool Has(const Moved& other) const {
    for (size_t j = 0; j < hinges.size(); ++j) {
      if (other.hinges[j] && !hinges[j]) return false;
    }
    return root || !other.root;
  }
  bool Meets(const Moved& other) const {
    for (size_t j = 0; j < hinges.size(); ++j) {
      if (other.hinges[j] && hinges[j]) return true;
    }
    return root && other.root;
  }
  void Remove(const Moved& other) {
    for (size_t j = 0; j < hinges.size(); ++j) {
      if (other.hinges[j]) hinges[j] = false;
    }
    if (other.root) root = false;
  }
};

Moved MovedBy(const std::vector<JointRef>& refs, const Figure& figure) {
  return {JointsOf(refs, figure), NameRoot(refs, figure)};
}

std::vector<JointRef> RefsOf(const Moved& moved, const Figure& figure) {
  std::set<std::string> names;
  for (size_t j = 0; j < moved.hinges.size(); ++j) {
    if (moved.hinges[j]) names.insert(figure.joints()[j].name);
  }
  std::vector<JointRef> refs;
  if (moved.root) refs.push_back({NameOfRoot(figure), false, {}});
  for (const std::string& name : JointNames(names, figure)) refs.push_back({name, false, {}});
  return refs;
}

// Removes joints from references. A reference that loses some joints is replaced by its remaining
// joints.
void Remove(const Moved& gone, const Figure& figure, std::vector<JointRef>* refs) {
  std::vector<JointRef> left;
  for (const JointRef& ref : *refs) {
    Moved moved = MovedBy({ref}, figure);
    if (!moved.Meets(gone)) {
      left.push_back(ref);
      continue;
    }
    moved.Remove(gone);
    for (JointRef& rest : RefsOf(moved, figure)) left.push_back(std::move(rest));
  }
  *refs = std::move(left);
}

// Removes muscles and friction of joints that the region no longer has.
void DropWhatIsGone(const Moved& gone, const Figure& figure, ProjectRegion* region) {
  for (ProjectDrive& drive : region->drives) {
    Remove({gone.hinges, false}, figure, &drive.joints);
    // Remove the root, which has no muscles.
    std::erase_if(drive.joints,
                  [&](const JointRef& ref) { return !ref.beyond && MeansRoot(ref.name, figure); });
  }
  std::erase_if(region->drives, [](const ProjectDrive& drive) { return drive.joints.empty(); });
  const Moved rest = MovedBy(region->joints, figure);
  std::erase_if(region->friction.joints, [&](const Named<double>& factor) {
    return !MovedBy({{factor.name, false, {}}}, figure).Meets(rest);
  });
}

Result<std::vector<JointRef>> Chosen(const Session& session, const Parameters& p) {
  std::vector<JointRef> refs;
  for (std::string& name : p.names("joints")) refs.push_back({std::move(name), false, {}});
  if (p.has("joints")) {
    Resolve(session.figure(), &refs);
    for (const JointRef& ref : refs) {
      if (FindJoints(session.figure(), ref.name) || MeansRoot(ref.name, session.figure())) continue;
      return Refusal("joints", "the figure has no joint \"" + ref.name + "\"");
    }
    return refs;
  }
  for (const std::string& name : SelectedNames(session)) refs.push_back({name, false, {}});
  if (refs.empty()) return Refusal("joints", "no joint is selected; select some");
  return refs;
}

Result<Done> AddJoints(Session* session, const Parameters& p) {
  const Result<std::vector<JointRef>> chosen = Chosen(*session, p);
  if (!chosen.ok()) return chosen.error();
  const Figure& figure = session->figure();
  return ChangeRegion(session, p, "Add joints to region", [&](Project*, ProjectRegion* region) {
    for (const JointRef& ref : chosen.value()) {
      const bool is_there = MovedBy(region->joints, figure).Has(MovedBy({ref}, figure));
      if (!is_there) region->joints.push_back(ref);
    }
    return Result<Done>(Done());
  });
}

Result<Done> RemoveJoints(Session* session, const Parameters& p) {
  const Result<std::vector<JointRef>> chosen = Chosen(*session, p);
  if (!chosen.ok()) return chosen.error();
  const Figure& figure = session->figure();
  const Moved gone = MovedBy(chosen.value(), figure);
  return ChangeRegion(session, p, "Take joints out of region",
                      [&](Project*, ProjectRegion* region) -> Result<Done> {
                        Remove(gone, figure, &region->joints);
                        if (region->joints.empty()) {
                          return Refusal("joints",
                                         "they are all that \"" + region->name +
                                             "\" has; remove the region, or leave a joint in it");
                        }
                        DropWhatIsGone(gone, figure, region);
                        return Done();
                      });
}

// By hinge: whether it is one of a twist, of cloth or of a finger.
std::vector<bool> SmallParts(const Figure& figure) {
  const FigureBody body(figure);
  std::vector<bool> small;
  for (const Joint& hinge : figure.joints()) {
    const BodyRole role = body.PlaceOf(hinge.group).role;
    small.push_back(role == BodyRole::kTwist || role == BodyRole::kCloth ||
                    role == BodyRole::kFinger);
  }
  return small;
}

}  // namespace

void LeaveOutSmallParts(const Figure& figure, std::vector<JointRef>* refs) {
  const Moved small = {SmallParts(figure), false};
  std::vector<JointRef> left;
  for (const JointRef& ref : *refs) {
    std::vector<JointRef> rest = {ref};
    const bool is_small = MovedBy({{ref.name, false, {}}}, figure).Meets(small);
    if (ref.beyond && !is_small) Remove(small, figure, &rest);
    left.insert(left.end(), rest.begin(), rest.end());
  }
  *refs = std::move(left);
}

double StartFriction(const ProjectRegion& region, const Figure& figure) {
  const std::vector<bool> moved = JointsOf(region, figure), small = SmallParts(figure);
  bool is_whole = region.contacts.scene && DrivesRoot(region, figure);
  for (int j = 0; j < figure.num_joints(); ++j)
    is_whole &= moved[j] || small[j] || figure.joints()[j].is_fixed();
  return is_whole ? kFallFriction : kLimpFriction;
}

std::vector<Operator> RegionJointOperators() {
  return {
      {"region.add_joints",
       "Add joints to region",
       "Lets more joints swing in a region, or the root turn.",
       {kOfRegion, kTheJoints, kDrag},
       AddJoints},
      {"region.remove_joints",
       "Take joints out of region",
       "Gives joints of a region, or the root's turn, back to their keys, with their muscles and "
       "friction there.",
       {kOfRegion, kTheJoints, kDrag},
       RemoveJoints}};
}

}  // namespace hazumi::edit
