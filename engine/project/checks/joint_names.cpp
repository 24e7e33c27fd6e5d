#include "engine/project/checks/joint_names.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/project/checks/constraint_checks.h"
#include "engine/project/checks/document_checks.h"
#include "engine/project/checks/spans.h"
#include "engine/project/fields/project_fields.h"
#include "engine/project/items.h"
#include "engine/project/json/did_you_mean.h"

namespace hazumi {

namespace {

// Groups first: they are fewer and what is meant most often.
std::vector<std::string> AllNames(const Figure& figure) {
  std::vector<std::string> names;
  for (const JointGroup& group : figure.groups()) names.push_back(group.name);
  for (const Joint& joint : figure.joints()) names.push_back(joint.name);
  return names;
}

void CheckKeyed(const std::string& name, const Figure& figure, const Site& site) {
  if (!ExpectJoint(name, figure, site) || figure.FindJoint(name)) return;
  const JointGroup& group = figure.group(FindJoints(figure, name)->group);
  std::string hinges;
  for (int j = group.first.value(); j <= group.last().value(); ++j) {
    hinges += (hinges.empty() ? "" : ", ") + Quoted(figure.joints()[j].name);
  }
  site.Report(Check::kKeysOnGroup, {Quoted(name), std::to_string(group.size), hinges});
}

void CheckInRegion(const std::string& name, const Figure& figure, const std::vector<bool>& region,
                   const Site& site) {
  if (MeansRoot(name, figure)) return site.Report(Check::kFrictionOnRoot, {Quoted(name)});
  if (!ExpectJoint(name, figure, site)) return;
  const MeantJoints meant = *FindJoints(figure, name);
  const auto begin = region.begin();
  if (std::find(begin + meant.first.value(), begin + meant.end.value(), true) ==
      begin + meant.end.value()) {
    site.Report(Check::kFrictionNotInRegion, {Quoted(name)});
  }
}

void CheckRegionNames(const ProjectRegion& region, Method method, const Figure& figure,
                      const Site& site) {
  for (size_t i = 0; i < region.joints.size(); ++i) {
    const std::string name = Meant(region.joints[i], figure).name;
    const Site place = site.Field("joints").Item(i);
    if (MeansRoot(name, figure)) {
      if (method == Method::kPaper) return place.Report(Check::kRootInRegion, {Quoted(name)});
    } else if (!ExpectJoint(name, figure, place)) {
      return;
    }
  }
  const std::vector<bool> joints = JointsOf(region, figure);
  for (const auto& factor : region.friction.joints) {
    CheckInRegion(factor.name, figure, joints,
                  site.Field("friction").Field("joints").Field(factor.name));
  }
  CheckDriveNames(region, figure, site);
}

// Names of a list in which the root may be.
void CheckJointsOf(const std::vector<JointRef>& joints, const Figure& figure, const Site& site) {
  for (size_t i = 0; i < joints.size(); ++i) {
    const std::string name = Meant(joints[i], figure).name;
    if (!MeansRoot(name, figure)) ExpectJoint(name, figure, site.Field("joints").Item(i));
  }
}

// Hinges of all joints of which one is given.
std::vector<bool> WholeJoints(std::vector<bool> hinges, const Figure& figure) {
  for (const JointGroup& group : figure.groups()) {
    const auto begin = hinges.begin() + group.first.value(), end = begin + group.size;
    if (std::find(begin, end, true) != end) std::fill(begin, end, true);
  }
  return hinges;
}

// Reports joints that are filled twice in the same frames.
void CheckFills(const std::vector<ProjectFill>& fills, const Figure& figure, const Site& site) {
  for (size_t i = 0; i < fills.size(); ++i) {
    CheckJointsOf(fills[i].joints, figure, site.Item(i));
    if (!site.errors->ok()) return;
    const std::vector<bool> joints = WholeJoints(JointsOf(fills[i].joints, figure), figure);
    for (size_t k = 0; k < i; ++k) {
      const Span both = Common(SpanOf(fills[i]), SpanOf(fills[k]));
      if (both.is_empty()) continue;
      const std::vector<bool> others = WholeJoints(JointsOf(fills[k].joints, figure), figure);
      std::string twice;
      if (NameRoot(fills[i].joints, figure) && NameRoot(fills[k].joints, figure)) {
        twice = figure.root_name();
      }
      for (size_t j = 0; j < joints.size() && twice.empty(); ++j) {
        if (joints[j] && others[j]) twice = figure.group(figure.joints()[j].group).name;
      }
      if (twice.empty()) continue;
      site.Item(i).Report(Check::kFillsOverlap,
                          {Quoted(fills[k].name), Quoted(twice), std::to_string(both.first),
                           std::to_string(both.last)});
    }
  }
}

// Checks the fields of an item that name a joint (Field::thing), and of what it holds.
class JointFields {
 public:
  template <typename T>
  using RefTo = const T&;

  JointFields(const Figure& figure, Site site) : figure_(figure), site_(std::move(site)) {}

  template <typename T>
  void Required(const Field& field, const T& value) {
    const Site place = site_.Field(field.name);
    if constexpr (std::is_same_v<T, std::string>) {
      Check(field, value, place);
    } else if constexpr (requires { Describe(*this, value); }) {
      CheckJointFields(value, figure_, place);
    } else if constexpr (requires { Describe(*this, value[0]); }) {
      for (size_t i = 0; i < value.size(); ++i) CheckJointFields(value[i], figure_, place.Item(i));
    }
  }
  template <typename T>
  void Stated(const Field& field, const T& value) {
    Required(field, value);
  }
  template <typename T>
  void Optional(const Field& field, const T& value, const T& otherwise = T()) {
    if (!(value == otherwise)) Required(field, value);
  }
  template <typename T, typename Fields>
  void Nested(const Field& field, const T& value, Fields fields) {
    JointFields within(figure_, site_.Field(field.name));
    fields(within, value);
  }
  template <typename T>
  void Literal(const char*, const T&) {}
  template <typename... T>
  void OneOf(const std::array<const char*, sizeof...(T)>& names, const std::variant<T...>& value) {
    std::visit([&](const auto& of) { Required({.name = names[value.index()]}, of); }, value);
  }
  template <typename T, typename Fields>
  void List(const Field& field, const std::vector<T>& values, Fields fields) {
    for (size_t i = 0; i < values.size(); ++i) {
      JointFields within(figure_, site_.Field(field.name).Item(i));
      fields(within, values[i]);
    }
  }
  template <typename T, typename Fields>
  void OptionalList(const Field& field, const std::vector<T>& values, Fields fields) {
    List(field, values, fields);
  }

  template <typename Item>
  static void CheckJointFields(const Item& item, const Figure& figure, const Site& site) {
    JointFields fields(figure, site);
    Describe(fields, item);
  }

 private:
  void Check(const Field& field, const std::string& name, const Site& place) const {
    const bool may_be_root = field.thing == Thing::kJointOrRoot;
    if (!may_be_root && field.thing != Thing::kJoint) return;
    if (!may_be_root || !MeansRoot(name, figure_)) ExpectJoint(name, figure_, place);
  }

  const Figure& figure_;
  Site site_;
};

}  // namespace

bool ExpectJoint(const std::string& name, const Figure& figure, const Site& site) {
  if (FindJoints(figure, name)) return true;
  if (MeansRoot(name, figure)) {
    site.Report(Check::kRootNotAJoint, {Quoted(name)});
  } else {
    site.Report(Check::kUnknownJoint, {Quoted(name), Suggestion(name, AllNames(figure))});
  }
  return false;
}

std::optional<MeantJoints> FindJoints(const Figure& figure, const std::string& name) {
  if (const auto g = figure.FindGroup(name)) {
    const JointGroup& group = figure.group(*g);
    return MeantJoints{group.first, JointIndex(group.last().value() + 1), *g};
  }
  const auto j = figure.FindJoint(name);
  if (!j) return std::nullopt;
  return MeantJoints{*j, JointIndex(j->value() + 1), figure.joint(*j).group};
}

bool MeansRoot(const std::string& name, const Figure& figure) {
  return (name == "root" || name == figure.root_name()) && !FindJoints(figure, name);
}

JointRef Meant(const JointRef& ref, const Figure& figure) {
  const bool has_plus = ref.name.size() > 1 && ref.name.ends_with('+');
  if (ref.beyond || !has_plus || FindJoints(figure, ref.name) || MeansRoot(ref.name, figure)) {
    return ref;
  }
  return {ref.name.substr(0, ref.name.size() - 1), true, {}};
}

void Resolve(const Figure& figure, std::vector<JointRef>* refs) {
  for (JointRef& ref : *refs) ref = Meant(ref, figure);
}

std::string NameOfRoot(const Figure& figure) {
  for (const std::string& name : {figure.root_name(), std::string("root")}) {
    if (MeansRoot(name, figure)) return name;
  }
  return "";
}

bool NameRoot(const std::vector<JointRef>& refs, const Figure& figure) {
  return std::any_of(refs.begin(), refs.end(), [&](const JointRef& ref) {
    return MeansRoot(Meant(ref, figure).name, figure);
  });
}

bool DrivesRoot(const ProjectRegion& region, const Figure& figure) {
  return NameRoot(region.joints, figure);
}

std::vector<bool> JointsOf(const ProjectRegion& region, const Figure& figure) {
  return JointsOf(region.joints, figure);
}

std::vector<bool> JointsOf(const std::vector<JointRef>& refs, const Figure& figure) {
  std::vector<bool> joints(figure.joints().size());
  for (const JointRef& each : refs) {
    const JointRef ref = Meant(each, figure);
    // Everything lies beyond the root.
    if (ref.beyond && MeansRoot(ref.name, figure)) joints.assign(joints.size(), true);
    const auto meant = FindJoints(figure, ref.name);
    if (!meant) continue;
    const JointIndex end = ref.beyond ? figure.joint(meant->first).subtree_end : meant->end;
    std::fill(joints.begin() + meant->first.value(), joints.begin() + end.value(), true);
  }
  return joints;
}

void CheckNames(const Project& project, const Figure& figure, FirstError* errors) {
  const Site site{"", errors};
  for (const auto& joint : project.joints) {
    CheckKeyed(joint.name, figure, site.Field("joints").Field(joint.name));
  }
  for (size_t i = 0; i < project.regions.size(); ++i) {
    const ProjectRegion& region = project.regions[i];
    CheckRegionNames(region, region.method.value_or(project.solver.method), figure,
                     site.Field("regions").Item(i));
  }
  ForEachItemList(
      [&]<typename Item>(ItemKind<Item> kind, const std::vector<Item>& items) {
        if constexpr (std::is_same_v<Item, ProjectRegion> || std::is_same_v<Item, ProjectFill>) {
          return;
        }
        for (size_t i = 0; i < items.size(); ++i) {
          JointFields::CheckJointFields(items[i], figure, site.Field(kind.kList).Item(i));
        }
      },
      project);
  CheckConstraintNames(project, site.Field("constraints"));
  for (size_t i = 0; i < project.selection_sets.size(); ++i) {
    CheckJointsOf(project.selection_sets[i].joints, figure, site.Field("selection_sets").Item(i));
  }
  CheckFills(project.fills, figure, site.Field("fills"));
  for (size_t i = 0; i < project.goals.size(); ++i) {
    CheckJointsOf(project.goals[i].joints, figure, site.Field("goals").Item(i));
  }
}

}  // namespace hazumi
