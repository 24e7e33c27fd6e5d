#include "ui/panels/properties/layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "ui/edit/fields/item_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/text/catalogue.h"

namespace hazumi::ui {

namespace {

constexpr int kSections = 7;

float Whole(double x) { return static_cast<float>(std::round(x)); }

bool IsSelected(const JointGroup& joint, const Figure& figure,
                const std::set<std::string>& selected) {
  for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
    if (selected.contains(figure.joints()[j].name)) return true;
  }
  return false;
}

std::string WithNumbers(const char* format, const std::vector<int>& numbers) {
  std::string text;
  size_t next = 0;
  for (const char* c = format; *c != '\0'; ++c) {
    text += *c == '#' ? std::to_string(numbers.at(next++)) : std::string(1, *c);
  }
  return text;
}

}  // namespace

PropertiesLayout LayOutProperties(const Rect& panel, double scale) {
  PropertiesLayout layout;
  const float size = Whole(28.0 * scale), gap = Whole(2.0 * scale);
  for (int i = 0; i < kSections; ++i) {
    layout.tabs.push_back(
        {panel.x, panel.y + gap + static_cast<float>(i) * (size + gap), size, size});
  }
  layout.content = {panel.x + size, panel.y, std::max(0.0f, panel.w - size), panel.h};
  return layout;
}

std::optional<Section> TabAt(const PropertiesLayout& layout, Point p) {
  for (size_t i = 0; i < layout.tabs.size(); ++i) {
    if (layout.tabs[i].Contains(p)) return static_cast<Section>(i);
  }
  return std::nullopt;
}

RowParts PartsOfRow(const Rect& row, float text, bool has_button, double scale) {
  const float gap = Whole(6.0 * scale), button = has_button ? row.h : 0.0f;
  const float least = Whole(60.0 * scale), column = Whole(0.4 * row.w);
  const bool is_below = text > std::max(column, row.w - gap - least - button);
  const float label = is_below ? column : std::max(column, std::ceil(text));
  const float y = is_below ? row.bottom() : row.y;
  RowParts parts;
  parts.label = {row.x, row.y, is_below ? row.w : label, row.h};
  parts.field = {row.x + label + gap, y, std::max(1.0f, row.w - label - gap - button), row.h};
  parts.button = {parts.field.right(), y, button, row.h};
  return parts;
}

std::optional<GroupIndex> ActiveJoint(const Figure& figure, const std::set<std::string>& selected,
                                      const std::string& active) {
  const std::optional<GroupIndex> wanted = figure.FindGroup(active);
  if (wanted && IsSelected(figure.group(*wanted), figure, selected)) return wanted;
  for (size_t i = 0; i < figure.groups().size(); ++i) {
    if (IsSelected(figure.groups()[i], figure, selected)) {
      return GroupIndex(static_cast<int>(i));
    }
  }
  return std::nullopt;
}

std::optional<size_t> ShownRegion(const Project& project, ItemId chosen, double frame) {
  const auto& regions = project.regions;
  const auto index = [&](auto is_meant) -> std::optional<size_t> {
    const auto found = std::find_if(regions.begin(), regions.end(), is_meant);
    if (found == regions.end()) return std::nullopt;
    return static_cast<size_t>(found - regions.begin());
  };
  if (const int there = IndexOf(chosen, regions); there >= 0) return there;
  const auto active =
      index([&](const auto& r) { return r.first_frame <= frame && frame <= r.last_frame; });
  if (active || regions.empty()) return active;
  return 0;
}

std::string ModelText(const RegionReport& report) {
  std::string text = WithNumbers(Tr("# of # joints"), {report.free_joints, report.all_joints});
  std::map<int, int, std::greater<>> counts;  // of groups, by their size
  for (const int size : report.islands) ++counts[size];
  for (const auto& [size, count] : counts) {
    text += ", " + WithNumbers(Tr(count == 1 ? "# group of #" : "# groups of #"), {count, size});
  }
  if (report.bodies > 0) text += ", " + WithNumbers(Tr("# bodies"), {report.bodies});
  return text;
}

std::vector<std::string> NamesOf(const std::vector<JointRef>& joints) {
  std::vector<std::string> names;
  names.reserve(joints.size());
  for (const JointRef& joint : joints) names.push_back(edit::NameOf(joint));
  return names;
}

std::vector<std::string> WithSelected(const std::vector<std::string>& joints, const Figure& figure,
                                      const std::set<std::string>& selected) {
  std::vector<std::string> all = joints;
  for (const std::string& name : edit::JointNames(selected, figure)) {
    if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
  }
  return all;
}

FieldState StateOfField(const ProjectCurve* curve, double frame, double shown, bool is_computed) {
  if (is_computed) return FieldState::kComputed;
  if (!curve || curve->keys.empty()) return FieldState::kPlain;
  const auto key = std::find_if(curve->keys.begin(), curve->keys.end(),
                                [&](const ProjectKey& k) { return k.frame == frame; });
  if (key == curve->keys.end()) return FieldState::kInterpolated;
  constexpr double kSame = 1e-4;  // degrees, of positions metres
  return std::abs(key->value - shown) < kSame ? FieldState::kKeyed : FieldState::kChanged;
}

}  // namespace hazumi::ui
