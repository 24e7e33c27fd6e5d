#include "ui/panels/outliner/layout.h"

#include <algorithm>
#include <cctype>

#include "engine/base/text.h"
#include "engine/figure/sides.h"

namespace hazumi::ui {

namespace {

// The hinges of a row's joint, or the hinge or the root itself.
std::vector<std::string> HingesOf(const OutlinerRow& row, const Figure& figure) {
  if (row.kind == OutlinerRowKind::kHinge || row.kind == OutlinerRowKind::kRoot) return {row.name};
  const std::optional<GroupIndex> group = figure.FindGroup(row.name);
  std::vector<std::string> hinges;
  if (row.kind != OutlinerRowKind::kJoint || !group) return hinges;
  const JointGroup& joint = figure.group(*group);
  for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
    hinges.push_back(figure.joints()[j].name);
  }
  return hinges;
}

// Joints between it and the root.
int DepthOf(const JointGroup& joint, const Figure& figure) {
  int depth = 0;
  JointIndex parent = figure.joint(joint.first).parent;
  for (; parent.is_valid(); ++depth) {
    const JointGroup& above = figure.group(figure.joint(parent).group);
    parent = figure.joint(above.first).parent;
  }
  return depth;
}

std::string WithoutJoint(const std::string& hinge, const std::string& joint) {
  return hinge.starts_with(joint + "_") ? hinge.substr(joint.size() + 1) : hinge;
}

// Collects the rows.
class RowList {
 public:
  RowList(const Figure& figure, const SideState& state)
      : figure_(figure), sides_(figure), state_(state), search_(LowerCase(state.search)) {}

  void AddFigure() {
    const std::string& root = figure_.root_name();
    const size_t at = rows_.size();
    rows_.push_back({OutlinerRowKind::kRoot, root, root, 0, true, IsShown(root)});
    if (rows_[at].is_open) {
      for (const JointGroup& joint : figure_.groups()) AddJoint(joint);
    }
    if (!Matches(root)) DropIfAlone(at);
  }

  // All kinds that have a heading and an item.
  void AddItems(const Project& project) {
    ForEachItemList(
        [&]<typename Item>(ItemKind<Item> kind, const std::vector<Item>& items) {
          if constexpr (HeadingOf<Item>() != nullptr) AddItems(kind, items);
        },
        project);
  }

  void AddCamera() {
    if (Matches("camera")) rows_.push_back({OutlinerRowKind::kCamera, "Camera", "Camera"});
  }

  std::vector<OutlinerRow> Take() { return std::move(rows_); }

 private:
  bool Matches(const std::string& name) const {
    return search_.empty() || LowerCase(name).find(search_) != std::string::npos;
  }
  bool IsShown(const std::string& heading) const {
    return !search_.empty() || !state_.closed.contains(heading);
  }

  size_t BeginHeading(const char* heading) {
    rows_.push_back({OutlinerRowKind::kHeading, heading, heading, 0, true, IsShown(heading)});
    return rows_.size() - 1;
  }
  // A search leaves out headings under which nothing was found.
  void DropIfAlone(size_t heading) {
    if (!search_.empty() && rows_.size() == heading + 1) rows_.pop_back();
  }
  template <typename Item>
  void AddItems(ItemKind<Item> kind, const std::vector<Item>& items) {
    if (items.empty()) return;
    const char* const heading = HeadingOf<Item>();
    const size_t at = BeginHeading(heading);
    for (const Item& item : items) {
      if (!IsShown(heading) || !Matches(item.name)) continue;
      rows_.push_back({.kind = OutlinerRowKind::kItem,
                       .name = item.name,
                       .label = item.name,
                       .depth = 1,
                       .item = item.identity.id,
                       .thing = kind.kThing});
    }
    DropIfAlone(at);
  }

  void AddJoint(const JointGroup& joint) {
    const int depth = 1 + DepthOf(joint, figure_);
    const BodySide side = sides_.SideOf(figure_.joint(joint.first).group);
    std::vector<OutlinerRow> hinges;
    for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
      const std::string& name = figure_.joints()[j].name;
      if (!Matches(name)) continue;
      hinges.push_back({OutlinerRowKind::kHinge, name, WithoutJoint(name, joint.name), depth + 1,
                        false, false, side});
    }
    if (!Matches(joint.name) && hinges.empty()) return;
    // What is searched is a joint, if it is one, and not each of its hinges.
    const bool by_hinge = !search_.empty() && !Matches(joint.name);
    const bool is_open = by_hinge || state_.opened.contains(joint.name);
    rows_.push_back(
        {OutlinerRowKind::kJoint, joint.name, joint.name, depth, joint.size > 1, is_open, side});
    if (is_open) rows_.insert(rows_.end(), hinges.begin(), hinges.end());
  }

  const Figure& figure_;
  const FigureSides sides_;
  const SideState& state_;
  const std::string search_;
  std::vector<OutlinerRow> rows_;
};

// The rows that have joints in [first, last].
std::vector<std::string> JointsFrom(const std::vector<OutlinerRow>& rows, size_t first,
                                    size_t last) {
  std::vector<std::string> names;
  for (size_t i = first; i <= last; ++i) {
    if (IsSelectable(rows[i])) names.push_back(rows[i].name);
  }
  return names;
}

}  // namespace

bool IsSelectable(const OutlinerRow& row) {
  return row.kind == OutlinerRowKind::kRoot || row.kind == OutlinerRowKind::kJoint ||
         row.kind == OutlinerRowKind::kHinge;
}

std::vector<OutlinerRow> OutlinerRows(const Figure& figure, const Project& project,
                                      const SideState& state) {
  RowList list(figure, state);
  list.AddFigure();
  list.AddItems(project);
  list.AddCamera();
  return list.Take();
}

JointClick ClickOn(const std::vector<OutlinerRow>& rows, size_t row, const std::string& anchor,
                   ClickMode click, const std::set<std::string>& selected, const Figure& figure) {
  if (click == ClickMode::kToggle) {
    const bool is_on = ShareOf(rows[row], selected, figure) == Share::kAll;
    return {{rows[row].name}, is_on ? "remove" : "add"};
  }
  if (click == ClickMode::kOnly) return {{rows[row].name}, "replace"};
  const auto from =
      std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == anchor; });
  const size_t start = from == rows.end() ? row : static_cast<size_t>(from - rows.begin());
  return {JointsFrom(rows, std::min(start, row), std::max(start, row)), "add"};
}

Share ShareOf(const OutlinerRow& row, const std::set<std::string>& names, const Figure& figure) {
  const std::vector<std::string> hinges = HingesOf(row, figure);
  const auto count = std::count_if(hinges.begin(), hinges.end(),
                                   [&](const auto& name) { return names.contains(name); });
  if (count == 0) return Share::kNone;
  return count == static_cast<long>(hinges.size()) ? Share::kAll : Share::kSome;
}

}  // namespace hazumi::ui
